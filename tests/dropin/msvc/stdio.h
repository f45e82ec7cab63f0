#pragma once
#include "crt.h"
typedef struct FILE FILE;
CRT FILE *fopen(const char *, const char *);
CRT int fclose(FILE *);
CRT int fflush(FILE *);
CRT size_t fread(void *, size_t, size_t, FILE *);
CRT size_t fwrite(const void *, size_t, size_t, FILE *);
CRT int fseek(FILE *, long, int);
CRT long ftell(FILE *);
CRT int feof(FILE *);
CRT int ferror(FILE *);
CRT int remove(const char *);
CRT int rename(const char *, const char *);
CRT int snprintf(char *, size_t, const char *, ...);
CRT int printf(const char *, ...);
CRT int _fileno(FILE *);
#define SEEK_SET 0
#define SEEK_CUR 1
#define SEEK_END 2
