/* The path of big-endian hosts, which copies weights through byte-wise readers instead of using them where they lie: it
   is the same text on any host, so that all tests of test_nn.c run over it here. */
#define MS_NN__BIG_ENDIAN 1
#include "test_nn.c"
