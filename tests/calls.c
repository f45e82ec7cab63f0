/* The runtime of tests/calls.sh: catches every public call of a header while its own tests run. The environment's CALLS
   says what for, one or several of:
     stack   what a call takes of the stack: it is painted below the caller's frame, and the paint that is gone says how
             deep
     traps   a host with floating-point exceptions unmasked (invalid, division by zero, overflow): which instruction
             trapped
     flush   a host that flushes subnormals to zero and reads them as zero: the tests must pass all the same
   A call lands in calls_enter with the function's name in r10 and the function itself in r11; it runs on the caller's
   own frame and returns to calls_leave. Public functions called by public functions are part of the outer one. x86-64,
   System V. */
#define _GNU_SOURCE
#include <pthread.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <ucontext.h>
#include <xmmintrin.h>

enum { DEEP = 1 << 20, NAMES = 512, EVERY = 300 };
#define PAINT 0xA9C37E5Du

typedef struct stack_use {
    const char *name;
    long calls, deepest;
} stack_use;

static stack_use use[NAMES];
static int uses;
static __thread int inside, painted;
static __thread void *home;
static __thread char *base, *bottom;
static __thread stack_use *current;
static __thread unsigned host; /* the caller's control of floating point */
enum { STACK = 1, TRAPS = 2, FLUSH = 4 };
static int mode;
static struct {
    const char *name;
    void *at;
} trap[NAMES];
static int traps;

__attribute__((noinline)) static void paint(void)
{
    volatile unsigned area[DEEP / 4];
    unsigned i;
    for (i = 0; i < DEEP / 4; ++i) area[i] = PAINT;
}

__attribute__((noinline)) static long measure(void)
{
    volatile unsigned area[DEEP / 4];
    long i;
    for (i = 0; i < DEEP / 4; ++i)
        if (area[i] != PAINT) break;
    return (long)(base - (char *)(size_t)&area[i]);
}

void calls_leave(void);
void *calls_begin(const char *name, void **slot);
void *calls_end(void);

/* NULL: run it, and leave it alone. */
void *calls_begin(const char *name, void **slot)
{
    int i;
    if (inside || mode == 0) return NULL;
    if (mode & STACK && bottom == NULL) {
        pthread_attr_t attributes;
        void *at = NULL;
        size_t size;
        pthread_getattr_np(pthread_self(), &attributes);
        pthread_attr_getstack(&attributes, &at, &size);
        pthread_attr_destroy(&attributes);
        bottom = (char *)at;
    }
    for (i = 0; i < uses && use[i].name != name; ++i) {}
    if (i == uses) {
        if (uses == NAMES) abort();
        use[uses++].name = name;
    }
    /* not on a thread with a stack of its own, and not every one of many calls */
    painted = mode & STACK && (size_t)((char *)slot - bottom) >= DEEP + 65536 &&
        !(use[i].calls > EVERY && (use[i].calls + 1) % EVERY);
    ++use[i].calls;
    if (mode == STACK && !painted) return NULL;
    inside = 1;
    current = &use[i];
    base = (char *)slot;
    home = *slot;
    host = _mm_getcsr();
    if (painted) paint();
    if (mode & TRAPS) _mm_setcsr((host & ~0x3fu) & ~0x680u); /* invalid, division by zero, overflow */
    if (mode & FLUSH) _mm_setcsr(_mm_getcsr() | 0x8040u);
    return (void *)(size_t)calls_leave;
}

void *calls_end(void)
{
    long deep = painted ? measure() : 0;
    _mm_setcsr(host);
    if (deep > current->deepest) current->deepest = deep;
    inside = 0;
    return home;
}

/* Notes where, masks them for the rest of the call, and lets it go on. */
static void trapped(int number, siginfo_t *info, void *context)
{
    ucontext_t *c = (ucontext_t *)context;
    void *at = (void *)c->uc_mcontext.gregs[REG_RIP];
    int i;
    (void)number;
    (void)info;
    c->uc_mcontext.fpregs->mxcsr = (c->uc_mcontext.fpregs->mxcsr & ~0x3fu) | 0x1f80u;
    for (i = 0; i < traps && trap[i].at != at; ++i) {}
    if (i == traps && traps < NAMES) {
        trap[traps].name = current ? current->name : "(a task)";
        trap[traps++].at = at;
    }
}

__attribute__((constructor)) static void begin(void)
{
    const char *name = getenv("CALLS");
    struct sigaction action;
    if (name && strstr(name, "stack")) mode |= STACK;
    if (name && strstr(name, "traps")) mode |= TRAPS;
    if (name && strstr(name, "flush")) mode |= FLUSH;
    memset(&action, 0, sizeof action);
    action.sa_sigaction = trapped;
    action.sa_flags = SA_SIGINFO;
    if (mode & TRAPS) sigaction(SIGFPE, &action, NULL);
}

__attribute__((destructor)) static void report(void)
{
    const char *path = getenv("CALLS_REPORT");
    FILE *f = path ? fopen(path, "a") : NULL;
    int i;
    for (i = 0; f && i < uses; ++i) fprintf(f, "%s %ld %ld\n", use[i].name, use[i].deepest, use[i].calls);
    for (i = 0; f && i < traps; ++i) fprintf(f, "TRAP %s %p\n", trap[i].name, trap[i].at);
    if (f) fclose(f);
}

__asm__(
    ".text\n"
    ".globl calls_enter\n"
    "calls_enter:\n"
    "    push %rbp\n    mov %rsp, %rbp\n"
    "    push %rdi\n    push %rsi\n    push %rdx\n    push %rcx\n    push %r8\n    push %r9\n    push %rax\n    push %r11\n"
    "    sub $128, %rsp\n"
    "    movups %xmm0, (%rsp)\n    movups %xmm1, 16(%rsp)\n    movups %xmm2, 32(%rsp)\n    movups %xmm3, 48(%rsp)\n"
    "    movups %xmm4, 64(%rsp)\n    movups %xmm5, 80(%rsp)\n    movups %xmm6, 96(%rsp)\n    movups %xmm7, 112(%rsp)\n"
    "    mov %r10, %rdi\n    lea 8(%rbp), %rsi\n"
    "    and $-16, %rsp\n"
    "    call calls_begin\n"
    "    lea -192(%rbp), %rsp\n"
    "    movups (%rsp), %xmm0\n    movups 16(%rsp), %xmm1\n    movups 32(%rsp), %xmm2\n    movups 48(%rsp), %xmm3\n"
    "    movups 64(%rsp), %xmm4\n    movups 80(%rsp), %xmm5\n    movups 96(%rsp), %xmm6\n    movups 112(%rsp), %xmm7\n"
    "    test %rax, %rax\n    jz 1f\n    mov %rax, 8(%rbp)\n"
    "1:  add $128, %rsp\n"
    "    pop %r11\n    pop %rax\n    pop %r9\n    pop %r8\n    pop %rcx\n    pop %rdx\n    pop %rsi\n    pop %rdi\n"
    "    pop %rbp\n    jmp *%r11\n"
    ".globl calls_leave\n"
    "calls_leave:\n"
    "    push %rax\n" /* where the way home will stand */
    "    push %rbp\n    mov %rsp, %rbp\n"
    "    push %rax\n    push %rdx\n    sub $32, %rsp\n    movups %xmm0, (%rsp)\n    movups %xmm1, 16(%rsp)\n"
    "    and $-16, %rsp\n"
    "    call calls_end\n"
    "    mov %rax, 8(%rbp)\n"
    "    lea -48(%rbp), %rsp\n"
    "    movups (%rsp), %xmm0\n    movups 16(%rsp), %xmm1\n    add $32, %rsp\n    pop %rdx\n    pop %rax\n    pop %rbp\n"
    "    ret\n");
