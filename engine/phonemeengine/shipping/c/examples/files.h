/* SPDX-License-Identifier: MIT */
/* Reads files for the examples, or ends the program with a sentence. */
#ifndef FILES_H
#define FILES_H

#include <stdio.h>
#include <stdlib.h>

static void fail(const char *name, const char *why)
{
    fprintf(stderr, "%s: %s\n", name, why);
    exit(1);
}

static unsigned char *read_file(const char *name, size_t *n)
{
    FILE *file = fopen(name, "rb");
    unsigned char *bytes = NULL;
    size_t room = 0;
    if (!file)
        fail(name, "this file cannot be opened; check its name");
    for (*n = 0; !feof(file) && !ferror(file); *n += fread(bytes + *n, 1, room - *n, file))
        if (*n == room && !(bytes = realloc(bytes, room = 2 * room + (1 << 16))))
            fail(name, "there is not enough memory for this file");
    if (ferror(file))
        fail(name, "this file cannot be read to its end");
    fclose(file);
    return bytes;
}

#endif
