/* A pool of threads that stays, as programs have one: for timing. (test.h's starts threads at each call and turns the
   order of the tasks round: it is for tests of order, and no pool to time with.) A header of ms_*.h stands before this
   one.

     pool p;
     pool_start(&p, 2);                   the calling thread takes part: one thread is started
     options.parallel = pool_parallel(&p);
     ...                                  time by the wall clock, here and for one thread
     pool_stop(&p);

   Tasks are taken in order. One caller at a time; a call from within a task runs on the calling thread. */
#ifndef MS_POOL_H
#define MS_POOL_H
#include <pthread.h>
#include <string.h>

#define POOL_MAX 64

typedef struct pool {
    int threads, running, stop;
    unsigned call; /* counts the calls: a worker that sees a new number looks for work */
    int busy;      /* workers that have not yet left the present call */
    int next, count;
    void (*task)(void *context, int index);
    void *context;
    pthread_mutex_t lock;
    pthread_cond_t work, done;
    pthread_t thread[POOL_MAX];
} pool;

static void pool__take(pool *p, int count, void (*task)(void *context, int index), void *context)
{
    for (;;) {
        const int i = __atomic_fetch_add(&p->next, 1, __ATOMIC_RELAXED);
        if (i >= count) return;
        task(context, i);
    }
}

static void *pool__thread(void *argument)
{
    pool *p = (pool *)argument;
    unsigned seen = 0;
    pthread_mutex_lock(&p->lock);
    for (;;) {
        void (*task)(void *context, int index);
        void *context;
        int count, spin;
        pthread_mutex_unlock(&p->lock);
        for (spin = 0; spin < 20000 && __atomic_load_n(&p->call, __ATOMIC_ACQUIRE) == seen &&
             !__atomic_load_n(&p->stop, __ATOMIC_RELAXED);
             ++spin) {}
        pthread_mutex_lock(&p->lock); /* a fork follows the last join within microseconds, or after a while */
        while (p->call == seen && !p->stop) pthread_cond_wait(&p->work, &p->lock);
        if (p->stop) break;
        seen = p->call;
        task = p->task;
        context = p->context;
        count = p->count;
        pthread_mutex_unlock(&p->lock);
        pool__take(p, count, task, context);
        pthread_mutex_lock(&p->lock);
        if (--p->busy == 0) pthread_cond_signal(&p->done);
    }
    pthread_mutex_unlock(&p->lock);
    return NULL;
}

static void pool__run(void *user, int count, void (*task)(void *context, int index), void *context)
{
    pool *p = (pool *)user;
    int i;
    pthread_mutex_lock(&p->lock);
    if (p->running || p->threads < 2) {
        pthread_mutex_unlock(&p->lock);
        for (i = 0; i < count; ++i) task(context, i);
        return;
    }
    p->running = 1;
    p->task = task;
    p->context = context;
    p->count = count;
    p->busy = p->threads - 1;
    __atomic_store_n(&p->next, 0, __ATOMIC_RELAXED);
    __atomic_add_fetch(&p->call, 1, __ATOMIC_RELEASE);
    pthread_cond_broadcast(&p->work);
    pthread_mutex_unlock(&p->lock);
    pool__take(p, count, task, context);
    pthread_mutex_lock(&p->lock);
    while (p->busy > 0) pthread_cond_wait(&p->done, &p->lock);
    p->running = 0;
    pthread_mutex_unlock(&p->lock);
}

static void pool_start(pool *p, int threads)
{
    int i;
    memset(p, 0, sizeof *p);
    pthread_mutex_init(&p->lock, NULL);
    pthread_cond_init(&p->work, NULL);
    pthread_cond_init(&p->done, NULL);
    p->threads = 1;
    for (i = 1; i < threads && i < POOL_MAX; ++i)
        if (pthread_create(&p->thread[i], NULL, pool__thread, p) == 0) p->threads = i + 1;
        else break;
}

static void pool_stop(pool *p)
{
    int i;
    pthread_mutex_lock(&p->lock);
    __atomic_store_n(&p->stop, 1, __ATOMIC_RELAXED);
    pthread_cond_broadcast(&p->work);
    pthread_mutex_unlock(&p->lock);
    for (i = 1; i < p->threads; ++i) pthread_join(p->thread[i], NULL);
    pthread_mutex_destroy(&p->lock);
    pthread_cond_destroy(&p->work);
    pthread_cond_destroy(&p->done);
}

static ms_parallel pool_parallel(pool *p)
{
    ms_parallel parallel;
    parallel.user = p;
    parallel.run = pool__run;
    return parallel;
}
#endif
