/* Just enough of Microsoft's C headers to compile against: declarations alone, nothing links. */
#ifndef CRT_H
#define CRT_H
#include <stdarg.h>
#include <stddef.h>
#ifdef __cplusplus
#define CRT extern "C"
#else
#define CRT extern
#endif
#endif
