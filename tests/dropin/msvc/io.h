#pragma once
#include "crt.h"
CRT int _commit(int);
