/* SPDX-License-Identifier: MIT */
/* What `ear.c` calls of the C library where there is none: WebAssembly without a system. The compiler brings the
 * mathematics. Blocks lie one behind the other, each after its size; who asks takes the first that is large enough. */
#include <stdlib.h>
#include <string.h>

#define PAGE 65536

typedef struct block {
    size_t size, used; /* bytes behind this head, a multiple of its own size */
    size_t unused[2];  /* what is behind it is aligned to 16 bytes */
} block;

extern unsigned char __heap_base[];
static block *end; /* behind the last one */

static block *behind(block *at) { return (block *)((unsigned char *)(at + 1) + at->size); }

void *malloc(size_t n)
{
    block *at = (block *)(((size_t)__heap_base + 15) & ~(size_t)15), *rest;
    size_t room = __builtin_wasm_memory_size(0) * PAGE, missing;
    if (n > (size_t)1 << 30)
        return NULL;
    n = (n + 15) & ~(size_t)15;
    for (end = end ? end : at; at < end; at = behind(at)) {
        while (!at->used && behind(at) < end && !behind(at)->used)
            at->size += sizeof(block) + behind(at)->size;
        if (!at->used && at->size >= n)
            break;
    }
    if (at == end) {
        missing = (size_t)(at + 1) + n;
        missing = missing > room ? (missing - room + PAGE - 1) / PAGE : 0;
        if (missing && __builtin_wasm_memory_grow(0, missing) == (size_t)-1)
            return NULL;
        at->size = n;
        end = behind(at);
    } else if (at->size > n) {
        rest = (block *)((unsigned char *)(at + 1) + n);
        rest->size = at->size - n - sizeof(block);
        rest->used = 0;
        at->size = n;
    }
    at->used = 1;
    return at + 1;
}

void free(void *place)
{
    if (place)
        ((block *)place - 1)->used = 0;
}

int strcmp(const char *a, const char *b)
{
    while (*a && *a == *b)
        a++, b++;
    return (unsigned char)*a - (unsigned char)*b;
}
