#pragma once
#include "stdlib.h"
CRT void *_aligned_malloc(size_t, size_t);
CRT void _aligned_free(void *);
