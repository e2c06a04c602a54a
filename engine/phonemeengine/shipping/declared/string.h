/* SPDX-License-Identifier: MIT */
#include <stddef.h>
int memcmp(const void *, const void *, size_t), strcmp(const char *, const char *);
void *memcpy(void *, const void *, size_t), *memmove(void *, const void *, size_t), *memset(void *, int, size_t);
