/* SPDX-License-Identifier: MIT */
/* Prints the mouth shapes of a WAV file as Rhubarb Lip Sync does: rhubarb_tsv preset.ear speech.wav > speech.tsv */
#include "../ear.h"
#include "wav.h"

enum { LEAST = 6 }; /* frames of 10 ms that a shape must last, unless lips close: A */

int main(int n_words, char **words)
{
    size_t n_bytes = 0, n_samples = 0, n = 0, n_last = 0, most, k;
    uint32_t rate = 0;
    unsigned char *bytes = n_words == 3 ? read_file(words[1], &n_bytes) : NULL;
    float *samples = bytes ? read_wav(words[2], &n_samples, &rate) : NULL;
    ear_model *model = NULL;
    ear *listener = NULL;
    ear_frame *frames;
    int error = samples ? ear_model_open(bytes, n_bytes, NULL, 0, &model) : EAR_BAD_ARGUMENT, table, shown = -1;
    if (!samples)
        fail("rhubarb_tsv", "name an .ear file and a WAV file");
    if (error || (error = ear_open(model, rate, NULL, 0, &listener)) != EAR_OK)
        fail(words[1], ear_error_text(error));
    most = EAR_MOST_FRAMES(n_samples, rate);
    frames = calloc(most + EAR_LAST_FRAMES, sizeof *frames);
    if (!frames || (error = ear_push(listener, samples, n_samples, frames, most, &n)) != EAR_OK)
        fail(words[2], ear_error_text(frames ? error : EAR_OUT_OF_MEMORY));
    ear_finish(listener, frames + n, EAR_LAST_FRAMES, &n_last);
    table = ear_table_find(model, "rhubarb");
    for (k = 0, n += n_last; k < n; k++) {
        int shape = ear_table_shape(model, table, frames[k].phoneme, frames[k].viseme), j = 1;
        while (k + j < n && ear_table_shape(model, table, frames[k + j].phoneme, frames[k + j].viseme) == shape)
            j++;
        if (shape != shown && (k == 0 || j >= LEAST || frames[k].phoneme == EAR_M || frames[k].phoneme == EAR_P)) {
            printf("%.2f\t%s\n", (double)k / 100, ear_table_shape_name(model, table, shape));
            shown = shape;
        }
        k += (size_t)j - 1;
    }
    printf("%.2f\t%s\n", (double)n_samples / rate, "X");
    return 0;
}
