/* How much stack a call takes: it runs on a thread whose stack was painted, and the paint that is left is counted.
     static void call(void *context);
     CHECK_LE(test_stack(call, &context), 32768);
   What the compiler's sanitizers add counts as well: TEST_STACK_LIMIT is the bound that a build is held to. */
#ifndef MS_TEST_STACK_H
#define MS_TEST_STACK_H
#include <pthread.h>
#include <stdlib.h>
#include <string.h>

#ifndef __has_feature
#define MS_TEST_HAS_FEATURE(x) 0
#else
#define MS_TEST_HAS_FEATURE(x) __has_feature(x)
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || MS_TEST_HAS_FEATURE(address_sanitizer) || \
    MS_TEST_HAS_FEATURE(thread_sanitizer)
#define TEST_STACK_LIMIT 0 /* not checked: padding of the sanitizer */
#elif defined(__OPTIMIZE__)
#define TEST_STACK_LIMIT 32768
#else
#define TEST_STACK_LIMIT 65536
#endif

typedef struct test_stack_job {
    void (*run)(void *context);
    void *context;
} test_stack_job;

static void *test_stack_thread(void *argument)
{
    test_stack_job *job = (test_stack_job *)argument;
    if (job->run) job->run(job->context);
    return NULL;
}

/* Bytes of a stack of 1 MB that are no longer painted; what the thread itself needs included. 0: no such thread. */
static size_t test_stack_of(test_stack_job job)
{
    enum { SIZE = 1 << 20 };
    unsigned char *stack = NULL;
    pthread_attr_t attributes;
    pthread_t thread;
    size_t left = 0;
    if (posix_memalign((void **)&stack, 65536, SIZE) != 0) return 0;
    memset(stack, 0xA5, SIZE);
    pthread_attr_init(&attributes);
    if (pthread_attr_setstack(&attributes, stack, SIZE) == 0 &&
        pthread_create(&thread, &attributes, test_stack_thread, &job) == 0) {
        pthread_join(thread, NULL);
        while (left < SIZE && stack[left] == 0xA5) ++left;
    } else {
        left = SIZE;
    }
    pthread_attr_destroy(&attributes);
    free(stack);
    return SIZE - left;
}

/* Bytes that run(context) takes beyond an empty thread. */
static size_t test_stack(void (*run)(void *context), void *context)
{
    test_stack_job empty = {NULL, NULL}, job;
    size_t with, without = test_stack_of(empty);
    job.run = run;
    job.context = context;
    with = test_stack_of(job);
    return with > without ? with - without : 0;
}
#endif
