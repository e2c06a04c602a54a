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
    EAR_NO_EAR_FILE = 1,
    EAR_NEWER_FILE = 2,
    EAR_DAMAGED_FILE = 3,
    EAR_OUT_OF_MEMORY = 4,
    EAR_TOO_LITTLE_MEMORY = 5,
    EAR_BAD_RATE = 6,
    EAR_TOO_FEW_FRAMES = 7,
    EAR_NO_TABLE = 8,
    EAR_BAD_ARGUMENT = 9
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

/* -- A model: a preset, and what it knows. Its file's bytes are not needed once it is open. -- */

EAR_API int ear_model_size(const void *bytes, size_t n_bytes, size_t *size);
EAR_API int ear_model_open(const void *bytes, size_t n_bytes, void *memory, size_t size, ear_model **model);
EAR_API void ear_model_close(ear_model *model);
/* The preset's name, UTF-8. */
EAR_API const char *ear_model_name(const ear_model *model);
/* For how many frames of 10 ms after a frame it waits before it says what that is. */
EAR_API int ear_model_look_ahead(const ear_model *model);
/* The visemes that it tells apart, and their names, in the order of ear_frame.viseme: EAR_VISEMES, or its own. */
EAR_API int ear_model_visemes(const ear_model *model);
EAR_API const char *ear_model_viseme(const ear_model *model, int viseme);

/* -- A recogniser of one stream: float of full scale +-1, or int16, at any rate of 1..768 kHz. -- */

EAR_API int ear_size(const ear_model *model, uint32_t rate, size_t *size);
/*
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
 * Take the next samples, and give the frames that became known. Cut the sound as you like: the frames are the same.
 * `most` is the room in `frames`; EAR_MOST_FRAMES is always enough, and where it may not be, nothing is taken.
 * Samples that are no number, or beyond +-1e6, count as 0.
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
/* From the middle of a frame to when ear_push gives it: the mean, seconds. */
EAR_API double ear_latency(const ear *listener);

/* -- Mouth tables of the model: which shape of a face goes with a phoneme or viseme. -- */

EAR_API int ear_table_count(const ear_model *model);
/* The number of the table of a name, such as "arkit"; -1 where the model has none. */
EAR_API int ear_table_find(const ear_model *model, const char *name);
EAR_API const char *ear_table_name(const ear_model *model, int table);
/* The blend shapes that it moves, in the order of all weights. */
EAR_API int ear_table_movestates(const ear_model *model, int table);
EAR_API const char *ear_table_movestate(const ear_model *model, int table, int movestate);
/* The mouth shape of a phoneme or viseme, by number and by name, such as "B": for drawings and sprites. */
EAR_API int ear_table_shapes(const ear_model *model, int table);
EAR_API int ear_table_shape(const ear_model *model, int table, int phoneme, int viseme);
EAR_API const char *ear_table_shape_name(const ear_model *model, int table, int shape);

/*
 * The weights of a table's movestates for one frame, 1 for the whole movement: the shapes of all visemes, each by how
 * likely it is, and by the intensity but where lips meet; of the phonemes where the model tells no visemes apart. They
 * are continuous and not smoothed; `frame` is one of this header's.
 */
EAR_API int ear_table_blend(const ear_model *model, int table, const ear_frame *frame, float *weights);

/* -- A mouth: moves smoothly from shape to shape; equal seeds make equal mouths. -- */

EAR_API int ear_mouth_size(const ear_model *model, int table, size_t *size);
EAR_API int ear_mouth_open(
    const ear_model *model, int table, uint32_t seed, void *memory, size_t size, ear_mouth **mouth
);
EAR_API void ear_mouth_close(ear_mouth *mouth);
/* Take what is recognised from a time on, seconds of a clock of yours, which never goes back. */
EAR_API void ear_mouth_hear(ear_mouth *mouth, double time, int phoneme, int viseme, float intensity);
/* The weights of the movestates at a time, 1 for the whole movement; times never go back. */
EAR_API void ear_mouth_weights(ear_mouth *mouth, double time, float *weights);

#ifdef __cplusplus
}
#endif

#endif
