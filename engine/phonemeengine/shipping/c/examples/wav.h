/* SPDX-License-Identifier: MIT */
/* Reads WAV files of 16 bits for the examples. */
#ifndef WAV_H
#define WAV_H

#include "files.h"

#include <stdint.h>
#include <string.h>

static uint32_t number_at(const unsigned char *at, int n_bytes)
{
    return n_bytes ? at[0] | number_at(at + 1, n_bytes - 1) << 8 : 0;
}

/* Return the samples of a WAV file, mixed to mono, +-1; to be freed. */
static float *read_wav(const char *name, size_t *n_samples, uint32_t *rate)
{
    size_t n_bytes, at = 12, size, n_channels = 0, k, c;
    unsigned char *bytes = read_file(name, &n_bytes);
    float *samples;
    if (n_bytes < 12 || memcmp(bytes, "RIFF", 4) || memcmp(bytes + 8, "WAVE", 4))
        fail(name, "this is no WAV file; convert it to one");
    for (; n_bytes - at >= 8; at += size + size % 2) { /* chunks: a name, a size, and that number of bytes */
        const unsigned char *chunk = bytes + at;
        at += 8;
        size = number_at(chunk + 4, 4) < n_bytes - at ? number_at(chunk + 4, 4) : n_bytes - at;
        if (!memcmp(chunk, "fmt ", 4) && size >= 16 && number_at(chunk + 22, 2) == 16) {
            n_channels = number_at(chunk + 10, 2);
            *rate = number_at(chunk + 12, 4);
        } else if (!memcmp(chunk, "data", 4) && n_channels) {
            *n_samples = size / (2 * n_channels);
            samples = calloc(*n_samples + 1, sizeof *samples);
            for (k = 0; samples && k < *n_samples; k++)
                for (c = 0; c < n_channels; c++)
                    samples[k] += (float)(int16_t)number_at(chunk + 8 + 2 * (k * n_channels + c), 2)
                                / (32768.0f * (float)n_channels);
            free(bytes);
            return samples;
        }
        if (size >= n_bytes - at)
            break;
    }
    fail(name, "this WAV file holds no sound of 16 bits; convert it to that");
    return NULL;
}

#endif
