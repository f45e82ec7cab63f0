#pragma once
#include "crt.h"
CRT void *memcpy(void *, const void *, size_t);
CRT void *memmove(void *, const void *, size_t);
CRT void *memset(void *, int, size_t);
CRT int memcmp(const void *, const void *, size_t);
CRT size_t strlen(const char *);
CRT int strcmp(const char *, const char *);
CRT int strncmp(const char *, const char *, size_t);
CRT size_t strspn(const char *, const char *);
CRT size_t strcspn(const char *, const char *);
CRT char *strcpy(char *, const char *);
#ifdef __cplusplus
CRT const void *memchr(const void *, int, size_t);
CRT const char *strchr(const char *, int);
CRT const char *strrchr(const char *, int);
CRT const char *strstr(const char *, const char *);
inline char *strrchr(char *s, int c) { return (char *)strrchr((const char *)s, c); }
inline char *strchr(char *s, int c) { return (char *)strchr((const char *)s, c); }
inline void *memchr(void *s, int c, size_t n) { return (void *)memchr((const void *)s, c, n); }
#else
CRT void *memchr(const void *, int, size_t);
CRT char *strchr(const char *, int);
CRT char *strrchr(const char *, int);
CRT char *strstr(const char *, const char *);
#endif
