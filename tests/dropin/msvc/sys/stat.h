#pragma once
#include "../crt.h"
struct _stat {
    unsigned short st_mode;
    long st_size;
};
CRT int _stat(const char *, struct _stat *);
#define _S_IFMT 0xF000
#define _S_IFDIR 0x4000
#define _S_IFREG 0x8000
#define _S_IWRITE 0x0080
