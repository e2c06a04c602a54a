/* SPDX-License-Identifier: MIT */
#include <stddef.h>
void *calloc(size_t, size_t), *malloc(size_t), *realloc(void *, size_t);
void free(void *);
