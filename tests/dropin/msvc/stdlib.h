#pragma once
#include "crt.h"
CRT void *malloc(size_t);
CRT void *calloc(size_t, size_t);
CRT void *realloc(void *, size_t);
CRT void free(void *);
CRT int abs(int);
CRT void qsort(void *, size_t, size_t, int (*)(const void *, const void *));
CRT void *bsearch(const void *, const void *, size_t, size_t, int (*)(const void *, const void *));
CRT void exit(int);
CRT double strtod(const char *, char **);
CRT long strtol(const char *, char **, int);
