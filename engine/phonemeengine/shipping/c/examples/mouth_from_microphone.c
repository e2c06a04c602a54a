/* SPDX-License-Identifier: MIT */
/*
 * Moves a mouth by the speech of a microphone. The sound comes on the standard input as 32-bit floats at 44.1 kHz:
 *
 *     arecord -q -t raw -f FLOAT_LE -c 1 -r 44100 | ./mouth_from_microphone preset.ear
 *
 * `hear()` is what an audio library calls with each block (PortAudio, miniaudio, SDL, Core Audio, WASAPI): it neither
 * allocates nor waits. draw() is what a game does for each picture. Where the two run in threads of their own, hand
 * the frames over by a queue: a recogniser and a mouth each belong to one thread.
 */
#include "../ear.h"
#include "files.h"

#include <string.h>

enum { RATE = 44100, BLOCK = 882, MOST = EAR_MOST_FRAMES(BLOCK, RATE), WIDTH = 40 };

static void hear(ear *listener, ear_mouth *mouth, const float *samples, size_t n, ear_frame *newest)
{
    ear_frame frames[MOST];
    size_t n_frames = 0, k;
    ear_push(listener, samples, n, frames, MOST, &n_frames);
    for (k = 0; k < n_frames; k++) {
        *newest = frames[k];
        ear_mouth_hear(mouth, newest->number / 100.0, newest->phoneme, newest->viseme, newest->intensity);
    }
}

static void draw(ear_mouth *mouth, const ear_frame *newest, float *weights, int jaw)
{
    int k;
    ear_mouth_weights(mouth, newest->number / 100.0, weights);
    printf("%8.2f s  %-12s  ", newest->number / 100.0, ear_phoneme_name(newest->phoneme));
    for (k = 0; k < (int)(WIDTH * weights[jaw]); k++)
        putchar('#');
    putchar('\n');
}

int main(int n_words, char **words)
{
    size_t n_bytes = 0;
    unsigned char *bytes = n_words == 2 ? read_file(words[1], &n_bytes) : NULL;
    ear_model *model = NULL;
    ear *listener = NULL;
    ear_mouth *mouth = NULL;
    ear_frame newest = {0};
    float samples[BLOCK], *weights;
    int table, jaw = 0, error;
    if (!bytes)
        fail("mouth_from_microphone", "name an .ear file, and let sound come in");
    error = ear_model_open(bytes, n_bytes, NULL, 0, &model);
    if (error || (error = ear_open(model, RATE, NULL, 0, &listener)) != EAR_OK)
        fail(words[1], ear_error_text(error));
    table = ear_table_find(model, "arkit");
    if ((error = ear_mouth_open(model, table, 1, NULL, 0, &mouth)) != EAR_OK)
        fail(words[1], ear_error_text(error));
    weights = calloc((size_t)ear_table_movestates(model, table), sizeof *weights);
    while (strcmp(ear_table_movestate(model, table, jaw), "jawOpen") && jaw < ear_table_movestates(model, table))
        jaw++;
    while (weights && fread(samples, sizeof *samples, BLOCK, stdin) == BLOCK) {
        hear(listener, mouth, samples, BLOCK, &newest);
        draw(mouth, &newest, weights, jaw);
    }
    free(weights);
    ear_mouth_close(mouth);
    ear_close(listener);
    ear_model_close(model);
    free(bytes);
    return 0;
}
