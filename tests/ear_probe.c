/*
 * Listens with .ear files that may be damaged: reads their size as uint32 and their bytes from the standard input, one
 * after the other, and writes a line with the result of each. Built with the sanitizers, it ends with their report
 * where anything is undefined; frames that no ear may give end it as well.
 */
#include "ear.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 3000, ROUNDS = 4 };

static const uint32_t RATES[] = {44100, 48000, 1000, 768000, 16000, 44101, 11025, 1, 0, 768001};

static void expect(int holds, const char *what)
{
    if (!holds) {
        fprintf(stderr, "%s\n", what);
        abort();
    }
}

/* Return sound of all kinds: noise, silence, what is no number, what is too large and too small. */
static float sample_at(size_t k, int round)
{
    const float noise = (float)((k * 2654435761u >> 8) % 2000) / 1000 - 1;
    switch (round) {
    case 0:
        return noise;
    case 1:
        return k % 7 ? noise * 1e-39f : NAN;
    case 2:
        return k % 5 ? k % 3 ? INFINITY : -INFINITY : 3e38f;
    default:
        return k % 2 ? 1e6f : -1e6f;
    }
}

static void check(const ear_frame *frames, size_t n, uint32_t *next)
{
    size_t k;
    for (k = 0; k < n; k++) {
        expect(frames[k].number == (*next)++, "frames are counted");
        expect(frames[k].phoneme >= 0 && frames[k].phoneme < EAR_PHONEMES, "a phoneme is one of eleven");
        expect(
            (frames[k].viseme >= 0 && frames[k].viseme < EAR_VISEMES) || frames[k].viseme == EAR_NO_VISEME,
            "a viseme is one of fifteen, or none"
        );
    }
}

static void listen(const ear_model *model, uint32_t rate)
{
    static float samples[MOST];
    const size_t block = rate / 20 < MOST ? rate / 20 : MOST; /* 50 ms, or less */
    ear_frame *frames = NULL;
    ear *listener = NULL;
    size_t size = 0, most, n, k;
    uint32_t next = 0;
    void *memory;
    int round, result = ear_size(model, rate, &size);
    expect(result == (rate < 1000 || rate > 768000 ? EAR_BAD_RATE : EAR_OK), "rates from 1 to 768 kHz are heard");
    if (result != EAR_OK)
        return;
    memory = malloc(size);
    most = EAR_MOST_FRAMES(block, rate) + EAR_LAST_FRAMES;
    frames = calloc(most, sizeof *frames);
    expect(memory && frames, "there is memory");
    expect(ear_open(model, rate, memory, size - 1, &listener) == EAR_TOO_LITTLE_MEMORY, "an ear knows its size");
    expect(ear_open(model, rate, memory, size, &listener) == EAR_OK, "a model that opens can be listened with");
    for (round = 0; round < ROUNDS; round++) {
        for (k = 0; k < block; k++)
            samples[k] = sample_at(k, round);
        expect(ear_push(listener, samples, block, frames, most, &n) == EAR_OK, "sound is taken");
        check(frames, n, &next);
    }
    expect(ear_push(listener, samples, block, frames, 1, &n) == EAR_TOO_FEW_FRAMES, "too little room is refused");
    expect(ear_finish(listener, frames, most, &n) == EAR_OK, "a sound ends");
    check(frames, n, &next);
    ear_close(listener);
    free(memory);
    free(frames);
}

static void move(const ear_model *model, int table)
{
    int n = ear_table_movestates(model, table), k;
    float *weights = calloc((size_t)n, sizeof *weights);
    ear_mouth *mouth = NULL;
    expect(weights && ear_mouth_open(model, table, 7, NULL, 0, &mouth) == EAR_OK, "a table moves a mouth");
    for (k = 0; k < 200; k++) {
        int shape = ear_table_shape(model, table, k % 13 - 1, k % 17 - 1);
        ear_mouth_hear(mouth, k * 0.01, k % 13 - 1, k % 17 - 1, k % 3 ? 0.5f : NAN);
        ear_mouth_weights(mouth, k * 0.01 + (k % 5 ? 0.001 : 1), weights);
        expect(strlen(ear_table_shape_name(model, table, shape)) < 70000, "a shape has a name");
        expect(strlen(ear_table_movestate(model, table, k % (n + 2) - 1)) < 70000, "a movestate has a name");
    }
    ear_mouth_close(mouth);
    free(weights);
}

static int probe(const unsigned char *bytes, size_t n_bytes, unsigned number)
{
    ear_model *model = NULL;
    size_t size = 0;
    void *memory;
    int result = ear_model_size(bytes, n_bytes, &size), k;
    if (result != EAR_OK) {
        expect(ear_model_open(bytes, n_bytes, NULL, 0, &model) == result && !model, "what has no size does not open");
        return result;
    }
    memory = malloc(size);
    expect(memory != NULL, "there is memory");
    expect(ear_model_open(bytes, n_bytes, memory, size - 1, &model) == EAR_TOO_LITTLE_MEMORY, "a model knows its size");
    expect(ear_model_open(bytes, n_bytes, memory, size, &model) == EAR_OK, "what has a size opens");
    listen(model, RATES[number % (sizeof RATES / sizeof *RATES)]);
    for (k = -1; k < ear_table_count(model) + 1; k++)
        if (ear_table_movestates(model, k))
            move(model, k);
    expect(strlen(ear_model_name(model)) < 70000, "a model has a name");
    ear_model_close(model);
    free(memory);
    return result;
}

int main(void)
{
    unsigned char head[4];
    unsigned number = 0;
    while (fread(head, 1, 4, stdin) == 4) {
        size_t n_bytes = head[0] | (size_t)head[1] << 8 | (size_t)head[2] << 16 | (size_t)head[3] << 24;
        unsigned char *bytes = malloc(n_bytes ? n_bytes : 1);
        expect(bytes && fread(bytes, 1, n_bytes, stdin) == n_bytes, "all bytes come");
        printf("%d\n", probe(bytes, n_bytes, number++));
        fflush(stdout);
        free(bytes);
    }
    return 0;
}
