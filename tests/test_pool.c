/* The pool that the benchmarks time with does every task once, whatever the counts, nested calls and late workers. */
#include "ms_pme.h"
#include "test.h"
#include "pool.h"

enum { MOST = 300 };

typedef struct work {
    const ms_parallel *parallel;
    int done[MOST], inner[MOST];
} work;

static void inner_task(void *context, int i) { __atomic_add_fetch(&((work *)context)->inner[i], 1, __ATOMIC_RELAXED); }

static void task(void *context, int i) { __atomic_add_fetch(&((work *)context)->done[i], 1, __ATOMIC_RELAXED); }

static void nesting_task(void *context, int i)
{
    work *w = (work *)context;
    task(context, i);
    w->parallel->run(w->parallel->user, 3, inner_task, w);
}

static void case_every_task_once(void)
{
    static const int threads[] = {1, 2, 3, 7};
    uint64_t seed = test_seed;
    int t, round, i;
    for (t = 0; t < 4; ++t) {
        pool p;
        ms_parallel parallel;
        pool_start(&p, threads[t]);
        CHECK_INT(p.threads, threads[t]);
        parallel = pool_parallel(&p);
        for (round = 0; round < 1000; ++round) {
            const int count = (int)(test_random_u64(&seed) % (round % 10 ? 5 : MOST)), nest = round % 7 == 0;
            work w;
            memset(&w, 0, sizeof w);
            w.parallel = &parallel;
            parallel.run(parallel.user, count, nest ? nesting_task : task, &w);
            for (i = 0; i < MOST; ++i)
                if (w.done[i] != (i < count))
                    TEST_FAIL("%d threads, %d tasks: task %d ran %d times", threads[t], count, i, w.done[i]);
            for (i = 0; i < 3; ++i) CHECK_INT(w.inner[i], nest ? count : 0);
        }
        pool_stop(&p);
    }
    TEST_NOTE("4000 calls");
}

static const test_case cases[] = {{"every task once", case_every_task_once}};
TEST_MAIN(cases)
