/* The part of windows.h that breaks other people's code. */
#pragma once
#include "crt.h"
#define min(a, b) (((a) < (b)) ? (a) : (b))
#define max(a, b) (((a) > (b)) ? (a) : (b))
#define near
#define far
#define small char
#define IN
#define OUT
#define CONST const
#define VOID void
#define ERROR 0
#define interface struct
#define DELETE 0x00010000
#define TRUE 1
#define FALSE 0
#define NO_ERROR 0
#define STRICT 1
#define pascal
#define cdecl
#define hyper __int64
CRT __declspec(dllimport) int __stdcall MoveFileExA(const char *from, const char *to, unsigned long flags);
