#pragma once
#include "crt.h"
typedef long clock_t;
typedef long long time_t;
#define CLOCKS_PER_SEC 1000
CRT clock_t clock(void);
CRT time_t time(time_t *);
