/* Macros of other people: windows.h's and its relatives', and names that a program may well have. The system's headers
   first, as they could not stand them either. */
#include <errno.h>
#include <fcntl.h>
#include <float.h>
#include <limits.h>
#include <math.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <time.h>
#include <unistd.h>
#if defined(__x86_64__)
#include <cpuid.h>
#include <immintrin.h>
#endif
#define min(a, b) (((a) < (b)) ? (a) : (b))
#define max(a, b) (((a) > (b)) ? (a) : (b))
#define near
#define far
#define small char
#define hyper long
#define interface struct
#define pascal
#define cdecl
#define IN
#define OUT
#define CONST const
#define VOID void
#define ERROR 0
#define DELETE 1
#define TRUE 1
#define FALSE 0
#define STRICT 1
#define OPAQUE 2
#define TRANSPARENT 1
#define BLACKNESS 66
#define RELATIVE 2
#define ABSOLUTE 1
#define DIFFERENCE 11
#define NEAR
#define FAR
