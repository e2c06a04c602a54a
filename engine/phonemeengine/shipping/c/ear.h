/* SPDX-License-Identifier: MIT */
/*
 * The runtime: recognises phonemes and visemes in speech, every 10 ms, and moves a mouth by them.
 *
 * C99; needs nothing but the standard library. A preset that was calibrated with PhonemeAnalyser comes as the bytes of
 * an .ear file (read it, link it in, download it: this library opens no file). An ear_model is made of them once; any
 * number of recognisers (type `ear`) share it, each for one stream of sound. Nothing is global, and nothing is allocated
 * after ear_open: ear_push may be called in an audio callback.
 *
 *     ear_model *model;
 *     ear *listener;
 *     ear_frame frames[EAR_MOST_FRAMES(480, 48000)];
 *     size_t n;
 *     ear_model_open(bytes, n_bytes, NULL, 0, &model);
 *     ear_open(model, 48000, NULL, 0, &listener);
 *     ear_push(listener, samples, 480, frames, sizeof frames / sizeof *frames, &n);
 *     for (k = 0; k < n; k++) printf("%s\n", ear_phoneme_name(frames[k].phoneme));
 *
 * Threads: an open model is only read, so recognisers of one model may run on threads of their own. A recogniser, and a
 * mouth, belongs to one thread at a time.
 *
 * Where a function takes `memory`, it may be NULL: then the memory is allocated, and freed by the close. Else it is
 * the caller's, at least as many bytes as the function that ends in _size says, aligned as malloc aligns, and stays
 * untouched until the object is closed.
 *
 * Results: a function of type int returns EAR_OK or another code of the list below, unless its comment says that it
 * returns a number. After an error, what it would have opened is NULL, and no frames were given. A text is UTF-8,
 * never NULL, and lasts as long as its model. A model, recogniser or mouth that is handed in must be open; the closes
 * take NULL, too, and do nothing then.
 *
 * Units: times are seconds, rates samples a second, intensities, confidences, scores and weights 0..1.
 */
#ifndef EAR_H
#define EAR_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#ifndef EAR_API
#define EAR_API
#endif

#define EAR_VERSION "0.9.0"

enum { EAR_PHONEMES = 11, EAR_VISEMES = 15, EAR_MOST_VISEMES = 32 /* of a model with its own */ };

/* What a frame can be. The numbers stand in ear_frame.phoneme. */
enum {
    EAR_SILENCE, EAR_UNIDENTIFIED, EAR_SZ, EAR_SCH, EAR_M, EAR_P, EAR_I, EAR_A, EAR_E, EAR_U, EAR_O
};

/* What lips and tongue show: the visemes of Oculus Lipsync, in ear_frame.viseme; or those of ear_model_viseme. */
enum {
    EAR_VISEME_SIL, EAR_VISEME_PP, EAR_VISEME_FF, EAR_VISEME_TH, EAR_VISEME_DD, EAR_VISEME_KK, EAR_VISEME_CH,
    EAR_VISEME_SS, EAR_VISEME_NN, EAR_VISEME_RR, EAR_VISEME_AA, EAR_VISEME_E, EAR_VISEME_IH, EAR_VISEME_OH,
    EAR_VISEME_OU,
    EAR_NO_VISEME = 255 /* unknown: the preset recognises no visemes, and the phoneme has several */
};

/* What a function returns; ear_error_text says it in a sentence. */
enum {
    EAR_OK = 0,
    EAR_NO_EAR_FILE = 1,       /* ear_model_size, ear_model_open */
    EAR_NEWER_FILE = 2,        /* the same: for a later version of this library */
    EAR_DAMAGED_FILE = 3,      /* the same */
    EAR_OUT_OF_MEMORY = 4,     /* the functions that open something, if memory is NULL */
    EAR_TOO_LITTLE_MEMORY = 5, /* the same, if it is not */
    EAR_BAD_RATE = 6,          /* ear_size, ear_open */
    EAR_TOO_FEW_FRAMES = 7,    /* ear_push and the like, ear_finish: `most` is too small; nothing was taken */
    EAR_NO_TABLE = 8,          /* ear_table_blend, ear_mouth_size, ear_mouth_open: no table of this number */
    EAR_BAD_ARGUMENT = 9       /* any: a pointer that is needed is NULL, or a number out of its range */
};

enum { EAR_LOWEST_RATE = 1000, EAR_HIGHEST_RATE = 768000 };

/* What was recognised in 10 ms. Later versions may add to its end: see ear_open_sized. */
typedef struct {
    uint32_t number;            /* it lasts from number x 10 ms of the sound to 10 ms later */
    int32_t phoneme;            /* EAR_SILENCE to EAR_O, calmed as the preset says */
    int32_t viseme;             /* EAR_VISEME_SIL to EAR_VISEME_OU or one of the model's own, or EAR_NO_VISEME */
    float intensity;            /* how loud, 0..1; 0 in silence */
    float confidence;           /* the share of such answers that are right, 0..1; NaN where the preset has no such curve */
    float scores[EAR_PHONEMES]; /* how likely each phoneme is, before smoothing; all 0 with rules, which name one only */
    float viseme_scores[EAR_MOST_VISEMES]; /* the same of the model's visemes; all 0 where it tells none apart */
} ear_frame;

/* At least as many frames as come of n samples at a rate, at once. */
#define EAR_MOST_FRAMES(n, rate) ((size_t)(n) * 100 / (rate) + 2)
/* As many as ear_finish gives at most. */
enum { EAR_LAST_FRAMES = 32 };

typedef struct ear_model ear_model;
typedef struct ear ear;
typedef struct ear_mouth ear_mouth;

/* EAR_VERSION of the library, which a program that loads it may compare with that of its header. */
EAR_API const char *ear_version(void);
/* One sentence about a result, in English, static. */
EAR_API const char *ear_error_text(int code);
/* Names as in PhonemeAnalyser's files, such as "sch" and "FF"; "" for what is none. */
EAR_API const char *ear_phoneme_name(int phoneme);
EAR_API const char *ear_viseme_name(int viseme);

/* frame->viseme_scores[viseme], for languages that cannot read arrays in structures; 0 for what is none. */
EAR_API float ear_frame_viseme_score(const ear_frame *frame, int viseme);

/* -- A model: a preset, and what it knows. -- */

/* Check the bytes of an .ear file, and give how many bytes of memory its model needs. */
EAR_API int ear_model_size(const void *bytes, size_t n_bytes, size_t *size);
/* Open a model of these bytes, which are checked first, and not needed afterwards. */
EAR_API int ear_model_open(const void *bytes, size_t n_bytes, void *memory, size_t size, ear_model **model);
/* Close it after all that was opened with it. */
EAR_API void ear_model_close(ear_model *model);
/* The preset's name, UTF-8. */
EAR_API const char *ear_model_name(const ear_model *model);
/* Return for how many frames of 10 ms after a frame it waits before it says what that is. */
EAR_API int ear_model_look_ahead(const ear_model *model);
/* Return how many visemes it knows: EAR_VISEMES, or its own; and the name of each, in the order of ear_frame.viseme. */
EAR_API int ear_model_visemes(const ear_model *model);
EAR_API const char *ear_model_viseme(const ear_model *model, int viseme);

/* -- A recogniser of one stream: float of full scale +-1, or int16, at any rate of 1..768 kHz. -- */

/* Give how many bytes of memory a recogniser for a sample rate needs. */
EAR_API int ear_size(const ear_model *model, uint32_t rate, size_t *size);
/*
 * Open a recogniser for sound of a sample rate; the model stays open as long.
 * `frame_size` is sizeof(ear_frame) as your program knows it: the library writes frames of that size, so a program and
 * a library of other versions fit. What the library does not know is 0. The macro ear_open gives it; the function of
 * that name is for programs of before 0.9.0, whose frames end after `scores`.
 */
EAR_API int ear_open_sized(
    const ear_model *model, uint32_t rate, size_t frame_size, void *memory, size_t size, ear **listener
);
EAR_API int ear_open(const ear_model *model, uint32_t rate, void *memory, size_t size, ear **listener);
#define ear_open(model, rate, memory, size, listener)                                                                  \
    ear_open_sized(model, rate, sizeof(ear_frame), memory, size, listener)
EAR_API void ear_close(ear *listener);
/*
 * Take the next n samples, and give the frames that became known, and their number. Cut the sound as you like: the
 * frames are the same. `most` is the room in `frames`; EAR_MOST_FRAMES is always enough, and where it may not be,
 * nothing is taken. Samples that are no number, or beyond +-1e6, count as 0.
 */
EAR_API int ear_push(ear *listener, const float *samples, size_t n, ear_frame *frames, size_t most, size_t *n_frames);
/* The same with n samples of each of 1..64 channels, which lie interleaved; their mean is recognised. */
EAR_API int ear_push_channels(
    ear *listener, const float *samples, size_t n, unsigned channels, ear_frame *frames, size_t most, size_t *n_frames
);
EAR_API int ear_push_int16(
    ear *listener, const int16_t *samples, size_t n, unsigned channels, ear_frame *frames, size_t most, size_t *n_frames
);
/* The sound is over: give the last frames, at most EAR_LAST_FRAMES. Then the recogniser is as after ear_open. */
EAR_API int ear_finish(ear *listener, ear_frame *frames, size_t most, size_t *n_frames);
/* Forget the sound, and begin another one. */
EAR_API void ear_reset(ear *listener);
/* Return the time from the middle of a frame to when ear_push gives it: the mean, in seconds. */
EAR_API double ear_latency(const ear *listener);

/* -- Mouth tables of the model: which shape of a face goes with a phoneme or viseme. -- */

/* Return how many there are. A table is named by its number, from 0. */
EAR_API int ear_table_count(const ear_model *model);
/* Return the number of the table of a name, such as "arkit"; -1 where the model has none. */
EAR_API int ear_table_find(const ear_model *model, const char *name);
EAR_API const char *ear_table_name(const ear_model *model, int table);
/* Return how many blend shapes (movestates) it moves, 0 for what is no table; and the name of each, in the order of all
 * weights. */
EAR_API int ear_table_movestates(const ear_model *model, int table);
EAR_API const char *ear_table_movestate(const ear_model *model, int table, int movestate);
/* For drawings and sprites: return how many mouth shapes it has, 0 for what is no table; the number of the shape that goes
 * with a frame's phoneme and viseme, -1 for what is no table; and the name of a shape, such as "B". */
EAR_API int ear_table_shapes(const ear_model *model, int table);
EAR_API int ear_table_shape(const ear_model *model, int table, int phoneme, int viseme);
EAR_API const char *ear_table_shape_name(const ear_model *model, int table, int shape);

/*
 * Give the weights of a table's movestates for one frame, as many as ear_table_movestates says: the shapes of all
 * visemes, each by how likely it is, and by the intensity but where lips meet; of the phonemes where the model tells no
 * visemes apart. They are continuous and not smoothed; `frame` is one of this header's.
 */
EAR_API int ear_table_blend(const ear_model *model, int table, const ear_frame *frame, float *weights);

/* -- A mouth: moves smoothly from shape to shape; equal seeds make equal mouths. -- */

/* Give how many bytes of memory a mouth needs that moves by a table. */
EAR_API int ear_mouth_size(const ear_model *model, int table, size_t *size);
/* Open one; the model stays open as long. */
EAR_API int ear_mouth_open(
    const ear_model *model, int table, uint32_t seed, void *memory, size_t size, ear_mouth **mouth
);
EAR_API void ear_mouth_close(ear_mouth *mouth);
/* Take what is recognised from a time on, in seconds of a clock of yours, which never goes back. */
EAR_API void ear_mouth_hear(ear_mouth *mouth, double time, int phoneme, int viseme, float intensity);
/* Give the weights of the movestates at a time, as many as ear_table_movestates says; times never go back. */
EAR_API void ear_mouth_weights(ear_mouth *mouth, double time, float *weights);

#ifdef __cplusplus
}
#endif

#endif
