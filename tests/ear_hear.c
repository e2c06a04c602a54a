/*
 * Hears what comes on the standard input as float32 at a rate, with the .ear file of a name, and writes the frames to
 * the standard output as they lie in memory: ear_hear PRESET RATE. For libraries of systems that are emulated.
 */
#include "ear.h"

#include <stdio.h>
#include <stdlib.h>
#ifdef _WIN32
#include <fcntl.h>
#include <io.h>
#endif

enum { MOST_BYTES = 1 << 23, BLOCK = 441, MOST = 64 };

int main(int n_words, char **words)
{
    static unsigned char bytes[MOST_BYTES];
    FILE *file = n_words == 3 ? fopen(words[1], "rb") : NULL;
    size_t n_bytes = file ? fread(bytes, 1, sizeof bytes, file) : 0, n, found;
    float samples[BLOCK];
    ear_frame frames[MOST];
    ear_model *model = NULL;
    ear *listener = NULL;
#ifdef _WIN32
    _setmode(0, _O_BINARY);
    _setmode(1, _O_BINARY);
#endif
    if (!file || ear_model_open(bytes, n_bytes, NULL, 0, &model) != EAR_OK
        || ear_open(model, (uint32_t)atol(words[2]), NULL, 0, &listener) != EAR_OK)
        return 1;
    while ((n = fread(samples, sizeof *samples, BLOCK, stdin)) > 0) {
        if (ear_push(listener, samples, n, frames, MOST, &found) != EAR_OK)
            return 2;
        fwrite(frames, sizeof *frames, found, stdout);
    }
    if (ear_finish(listener, frames, MOST, &found) != EAR_OK)
        return 3;
    fwrite(frames, sizeof *frames, found, stdout);
    ear_close(listener);
    ear_model_close(model);
    return 0;
}
