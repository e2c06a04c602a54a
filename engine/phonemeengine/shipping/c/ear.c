/* SPDX-License-Identifier: MIT */
/*
 * What stands here, in this order:
 *
 *     memory, and the file       arrays of a model, each size checked before it is believed
 *     arithmetic                 sums, Fourier transforms, the convolution
 *     resampling                 any rate to 44.1 kHz
 *     what a frame is            log mels, the network, vocal tracts; the front end, variables, rules; templates
 *     what is said of it         sensitivities, calming, visemes, confidence, intensity
 *     the recogniser             a stream of samples, cut into frames
 *     the mouth                  movements between the shapes of a table
 *
 * The reference is the Python engine, module by module; numbers are float32 where they are there, and double where
 * they are that. `const` tables aside there is nothing static, so recognisers share no state.
 */
#include "ear.h"
#include "ear_kernels.h"

#undef ear_open /* the macro, so that the function of this name can be written */

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define COUNT_OF(array) (sizeof(array) / sizeof *(array))

enum {
    RATE = 44100,
    WINDOW = 2048, /* samples of a frame */
    HOP = 441,     /* samples from one frame to the next */
    LEAD = WINDOW / 2 - HOP / 2,
    SHORT = 1024, /* samples that log mels look at, in the middle of a frame */
    BANDS = 40,
    CEPSTRA = 12,
    MOST_VISEMES = EAR_MOST_VISEMES,
    OLDEST_FRAME = offsetof(ear_frame, viseme_scores), /* bytes */
    MOST_FRAME = 4096,
    MOST_CHANNELS_IN = 64,
    MOST_LAYERS = 32,
    MOST_CHANNELS = 1024,
    MOST_DILATION = 256,
    MOST_WARPS = 8,
    MOST_AHEAD = 16,
    MOST_POINTS = 16,
    MOST_VARIABLES = 4096,
    MOST_RULES = 4096,
    MOST_MOVESTATES = 1000,
    MOST_SHAPES = 1000,
    MOST_TABLES = 16,
    MOST_NAME = 1 << 16,
    MOST_EVIDENCE = 640, /* of an answer against a phoneme, in parts of a nat of which 32 are one */
    MOST_COST = 450,     /* of a change */
    MOST_PAST = 5,       /* frames that the search looks ahead */
    MOVEMENTS = 64       /* that a mouth remembers */
};

static const double PI = 3.14159265358979323846;

/* ------------------------------------------------------------------------------------------------------------------
 * Words
 * ---------------------------------------------------------------------------------------------------------------- */

const char *ear_version(void)
{
    return EAR_VERSION;
}

const char *ear_error_text(int code)
{
    switch (code) {
    case EAR_OK:
        return "all is well";
    case EAR_NO_EAR_FILE:
        return "these bytes are no .ear file; make one with phonemeanalyser ship";
    case EAR_NEWER_FILE:
        return "this .ear file is of a newer version than this ear; take the ear.c that was shipped with it";
    case EAR_DAMAGED_FILE:
        return "this .ear file is damaged or cut off; copy it again, as bytes and not as text";
    case EAR_OUT_OF_MEMORY:
        return "there is not enough memory left; close something, or hand in memory";
    case EAR_TOO_LITTLE_MEMORY:
        return "the memory that was handed in is smaller than the function that ends in _size says; hand in more";
    case EAR_BAD_RATE:
        return "the sample rate must lie in 1000..768000 Hz; record at another one";
    case EAR_TOO_FEW_FRAMES:
        return "there is no room for all frames that may come; give room for EAR_MOST_FRAMES, or fewer samples at once";
    case EAR_NO_TABLE:
        return "the model has no mouth table of this number; ship the preset with it, or ask ear_table_find";
    case EAR_BAD_ARGUMENT:
        return "a pointer that is needed is NULL, or a number out of its range; pass what the function asks for";
    default:
        return "this is none of ear's results";
    }
}

float ear_frame_viseme_score(const ear_frame *frame, int viseme)
{
    return frame && viseme >= 0 && viseme < MOST_VISEMES ? frame->viseme_scores[viseme] : 0;
}

const char *ear_phoneme_name(int phoneme)
{
    static const char *const NAMES[EAR_PHONEMES] = {
        "silence", "unidentified", "sz", "sch", "m", "p", "i", "a", "e", "u", "o",
    };
    return phoneme >= 0 && phoneme < EAR_PHONEMES ? NAMES[phoneme] : "";
}

/* The visemes that a network tells apart, and how they go with phonemes. */
typedef struct {
    size_t n;
    const char *const *names;
    uint32_t allowed[EAR_PHONEMES]; /* by which a phoneme may be shown: a bit for each viseme */
    uint32_t usual[EAR_PHONEMES];   /* of which no more is known */
} viseme_set;

static const char *const VISEME_NAMES[EAR_VISEMES] = {
    "sil", "PP", "FF", "TH", "DD", "kk", "CH", "SS", "nn", "RR", "aa", "E", "ih", "oh", "ou",
};

#define BIT(viseme) (1u << (viseme))

/* Those of every file that brings none of its own; phonemes in the order of ear_phoneme_name. */
static const viseme_set STANDARD_VISEMES = {
    EAR_VISEMES,
    VISEME_NAMES,
    {
        BIT(EAR_VISEME_SIL),
        BIT(EAR_VISEME_FF) | BIT(EAR_VISEME_TH) | BIT(EAR_VISEME_DD) | BIT(EAR_VISEME_KK) | BIT(EAR_VISEME_NN)
            | BIT(EAR_VISEME_RR),
        BIT(EAR_VISEME_SS), BIT(EAR_VISEME_CH), BIT(EAR_VISEME_PP), BIT(EAR_VISEME_PP), BIT(EAR_VISEME_IH),
        BIT(EAR_VISEME_AA), BIT(EAR_VISEME_E), BIT(EAR_VISEME_OU), BIT(EAR_VISEME_OH),
    },
    {
        EAR_VISEME_SIL, EAR_NO_VISEME, EAR_VISEME_SS, EAR_VISEME_CH, EAR_VISEME_PP, EAR_VISEME_PP, EAR_VISEME_IH,
        EAR_VISEME_AA, EAR_VISEME_E, EAR_VISEME_OU, EAR_VISEME_OH,
    },
};

const char *ear_viseme_name(int viseme)
{
    return viseme >= 0 && viseme < EAR_VISEMES ? VISEME_NAMES[viseme] : "";
}

/* ------------------------------------------------------------------------------------------------------------------
 * Memory: an object and all its arrays lie in one block. It is laid out twice, first without a block, to count.
 * ---------------------------------------------------------------------------------------------------------------- */

enum { LINE = 64 }; /* bytes of a line of the cache, at which every array begins */

typedef struct {
    unsigned char *base; /* NULL while counting */
    size_t used;
} arena;

static void *take(arena *memory, size_t n, size_t size)
{
    /* aligned to lines of the cache: no array shares one with another */
    size_t at = (memory->used + LINE - 1) / LINE * LINE;
    memory->used = at + n * size;
    return memory->base ? memory->base + at : NULL;
}

static float *take_floats(arena *memory, size_t n)
{
    return take(memory, n, sizeof(float));
}

static size_t size_of(const arena *memory)
{
    return memory->used + LINE;
}

/* Begin in a block of the caller's, or in one that is allocated; `owned` is what to free. */
static int begin_arena(arena *memory, void *block, size_t size, size_t needed, void **owned)
{
    uintptr_t start;
    *owned = NULL;
    if (!block) {
        block = *owned = malloc(needed);
        if (!block)
            return EAR_OUT_OF_MEMORY;
    } else if (size < needed)
        return EAR_TOO_LITTLE_MEMORY;
    start = ((uintptr_t)block + LINE - 1) / LINE * LINE;
    memory->base = (unsigned char *)block + (start - (uintptr_t)block);
    memory->used = 0;
    return EAR_OK;
}

/* ------------------------------------------------------------------------------------------------------------------
 * The file: little-endian, 32 bits at a time
 *
 *     4 bytes    E A R and 26
 *     uint32     version
 *     uint32     bytes of the whole file
 *     uint32     CRC-32 of all that follows
 *     sections   each 4 letters, its bytes as uint32, and those
 * ---------------------------------------------------------------------------------------------------------------- */

enum { VERSION = 3, HEADER = 16 };

typedef struct {
    const unsigned char *at, *end;
    int failed; /* whether something was read that is not there, or impossible */
} reader;

static size_t left_in(const reader *in)
{
    return (size_t)(in->end - in->at);
}

static int has(reader *in, size_t n, size_t size)
{
    /* a division, not a product: n * size of a forged file could overflow, and seem small */
    if (in->failed || n > left_in(in) / size)
        in->failed = 1;
    return !in->failed;
}

static uint32_t u32_at(const unsigned char *at)
{
    return (uint32_t)at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16 | (uint32_t)at[3] << 24;
}

static uint32_t read_u32(reader *in)
{
    uint32_t value;
    if (!has(in, 1, 4))
        return 0;
    value = u32_at(in->at);
    in->at += 4;
    return value;
}

/* Return a whole number that lies in least..most; where it does not, the file is refused, and this is `least`. */
static uint32_t read_within(reader *in, uint32_t least, uint32_t most)
{
    uint32_t value = read_u32(in);
    if (in->failed || value < least || value > most) {
        in->failed = 1;
        return least;
    }
    return value;
}

static float read_f32(reader *in)
{
    uint32_t bits = read_u32(in);
    float value;
    memcpy(&value, &bits, sizeof value);
    /* written so that NaN fails as well */
    if (!(fabsf(value) <= FLT_MAX)) {
        in->failed = 1;
        return 0;
    }
    return value;
}

static double read_f64_within(reader *in, double least, double most)
{
    uint64_t bits = read_u32(in);
    double value;
    bits |= (uint64_t)read_u32(in) << 32;
    memcpy(&value, &bits, sizeof value);
    if (!(value >= least && value <= most)) {
        in->failed = 1;
        return least;
    }
    return value;
}

static const float *read_floats(reader *in, arena *memory, size_t n)
{
    float *values;
    size_t k;
    if (!has(in, n, 4))
        return NULL;
    values = take_floats(memory, n);
    for (k = 0; k < n; k++) {
        float value = read_f32(in);
        if (values)
            values[k] = value;
    }
    return values;
}

/* Numbers of half precision (IEEE 754 binary16). */
static float half_at(reader *in, const unsigned char *at)
{
    uint32_t half = (uint32_t)at[0] | (uint32_t)at[1] << 8, exponent = half >> 10 & 31, mantissa = half & 1023;
    uint32_t bits = (half & 0x8000u) << 16 | (exponent + 112) << 23 | mantissa << 13;
    float value;
    /* The bias of the exponent grows from 15 to 127, so 112 is added above; the ten bits of the mantissa move up by
     * 13. 31 stands for infinity and NaN; 0 for subnormal numbers, whose mantissa counts in steps of 2 to the -24. */
    if (exponent == 31)
        in->failed = 1;
    if (exponent == 0)
        return (half & 0x8000u ? -1.0f : 1.0f) * (float)mantissa / 16777216.0f;
    memcpy(&value, &bits, sizeof value);
    return value;
}

/* Read a matrix of halves, n_in rows of n_out, into tiles: of each tile all rows; columns beyond the last are 0. */
static void read_tiles(reader *in, float *tiles, size_t n_in, size_t n_out, size_t first_column)
{
    size_t row, column;
    if (!has(in, n_in * n_out, 2))
        return;
    for (row = 0; row < n_in; row++)
        for (column = 0; column < n_out; column++, in->at += 2) {
            float value = half_at(in, in->at);
            size_t place = first_column + column;
            if (tiles)
                tiles[(place / TILE * n_in + row) * TILE + place % TILE] = value;
        }
    if (n_in * n_out % 2 && has(in, 1, 2))
        in->at += 2;
}

static const char *read_text(reader *in, arena *memory)
{
    size_t n = read_within(in, 0, MOST_NAME), padded = (n + 3) / 4 * 4;
    char *text;
    if (!has(in, padded, 1))
        return NULL;
    text = take(memory, n + 1, 1);
    if (text) {
        memcpy(text, in->at, n);
        text[n] = 0;
    }
    in->at += padded;
    return text;
}

static const char *const *read_texts(reader *in, arena *memory, size_t n)
{
    const char **texts;
    size_t k;
    if (!has(in, n, 4))
        return NULL;
    texts = take(memory, n, sizeof *texts);
    for (k = 0; k < n; k++) {
        const char *text = read_text(in, memory);
        if (texts)
            texts[k] = text;
    }
    return texts;
}

/* The polynomial 0xedb88320 of zip and PNG, four bits at a time: 64 bytes of table instead of 1 KB. */
static uint32_t crc_of(const unsigned char *bytes, size_t n)
{
    static const uint32_t TABLE[16] = {
        0x00000000u, 0x1db71064u, 0x3b6e20c8u, 0x26d930acu, 0x76dc4190u, 0x6b6b51f4u, 0x4db26158u, 0x5005713cu,
        0xedb88320u, 0xf00f9344u, 0xd6d6a3e8u, 0xcb61b38cu, 0x9b64c2b0u, 0x86d3d2d4u, 0xa00ae278u, 0xbdbdf21cu,
    };
    uint32_t crc = 0xffffffffu;
    size_t k;
    for (k = 0; k < n; k++) {
        crc = TABLE[(crc ^ bytes[k]) & 15] ^ crc >> 4;
        crc = TABLE[(crc ^ (uint32_t)bytes[k] >> 4) & 15] ^ crc >> 4;
    }
    return ~crc;
}

/* ------------------------------------------------------------------------------------------------------------------
 * Arithmetic. Sums are kept in eight parts, so that compilers may work on several at a time.
 * ---------------------------------------------------------------------------------------------------------------- */

static float sum_of(const float *values, size_t n)
{
    float parts[PARTS] = {0}, rest = 0;
    size_t k, j;
    for (k = 0; k + PARTS <= n; k += PARTS)
        for (j = 0; j < PARTS; j++)
            parts[j] += values[k + j];
    for (; k < n; k++)
        rest += values[k];
    return sum_of_parts(parts) + rest;
}

/* The largest of values that are 0 or more. */
static float greatest_of(const float *values, size_t n)
{
    float parts[PARTS] = {0}, most = 0;
    size_t k, j;
    for (k = 0; k + PARTS <= n; k += PARTS)
        for (j = 0; j < PARTS; j++)
            parts[j] = values[k + j] > parts[j] ? values[k + j] : parts[j];
    for (; k < n; k++)
        most = values[k] > most ? values[k] : most;
    for (j = 0; j < PARTS; j++)
        most = parts[j] > most ? parts[j] : most;
    return most;
}

/* The largest absolute sample of a frame. */
static float peak_of(const float *window)
{
    float parts[PARTS] = {0};
    size_t k, j;
    for (k = 0; k < WINDOW; k += PARTS)
        for (j = 0; j < PARTS; j++) {
            float level = fabsf(window[k + j]);
            parts[j] = level > parts[j] ? level : parts[j];
        }
    return greatest_of(parts, PARTS);
}

/* Sign changes inside a frame; 0 counts as positive. */
static float zero_crossings_of(const float *window)
{
    int count = 0;
    size_t k;
    for (k = 1; k < WINDOW; k++)
        count += (window[k] < 0) != (window[k - 1] < 0);
    return (float)count;
}

/* The Fourier transform of real values, n a power of 2: Stockham's, of half as many complex ones, radix 4. */
typedef struct {
    size_t n;
    const float *cosines, *sines; /* of 2 pi k / n, k up to n: those of half the length are every second one */
} transform;

/* Room for a transform at work: two spectra of n / 2 complex values each. */
typedef struct {
    const kernels *by;
    float *real, *imaginary, *other_real, *other_imaginary;
} workspace;

static transform make_transform(arena *memory, size_t n)
{
    transform made;
    float *cosines = take_floats(memory, n), *sines = take_floats(memory, n);
    size_t k;
    /* each one in double, then rounded once: a recurrence would gather errors */
    for (k = 0; cosines && k < n; k++) {
        cosines[k] = (float)cos(2 * PI * (double)k / (double)n);
        sines[k] = (float)sin(2 * PI * (double)k / (double)n);
    }
    made.n = n;
    made.cosines = cosines;
    made.sines = sines;
    return made;
}

static workspace make_workspace(arena *memory, size_t n, const kernels *by)
{
    workspace made;
    made.by = by;
    made.real = take_floats(memory, n / 2 + 1);
    made.imaginary = take_floats(memory, n / 2 + 1);
    made.other_real = take_floats(memory, n / 2 + 1);
    made.other_imaginary = take_floats(memory, n / 2 + 1);
    return made;
}

static void swap_spectra(workspace *work)
{
    float *real = work->real, *imaginary = work->imaginary;
    work->real = work->other_real;
    work->imaginary = work->other_imaginary;
    work->other_real = real;
    work->other_imaginary = imaginary;
}

static void pass_of_2(
    const float *restrict xr, const float *restrict xi, float *restrict yr, float *restrict yi, size_t stride
)
{
    size_t q;
    for (q = 0; q < stride; q++) {
        yr[q] = xr[q] + xr[stride + q];
        yi[q] = xi[q] + xi[stride + q];
        yr[stride + q] = xr[q] - xr[stride + q];
        yi[stride + q] = xi[q] - xi[stride + q];
    }
}

/* Transform the complex values in `work`, n / 2 of them, in place. */
static void transform_complex(const transform *of, workspace *work)
{
    size_t length = of->n / 2, stride = 1;
    for (; length >= 4; length /= 4, stride *= 4) {
        work->by->pass_of_4(
            work->real, work->imaginary, work->other_real, work->other_imaginary, length / 4, stride, of->cosines,
            of->sines, 2 * stride
        );
        swap_spectra(work);
    }
    if (length == 2) {
        pass_of_2(work->real, work->imaginary, work->other_real, work->other_imaginary, stride);
        swap_spectra(work);
    }
}

/* Transform n real values; the first n_bins bins, at most n / 2, stand in `work` afterwards. */
static void transform_real(const transform *of, const float *values, size_t n_bins, workspace *work)
{
    size_t half = of->n / 2, k;
    /* Even samples become real parts, odd ones imaginary parts: half as many complex values, half the work. */
    for (k = 0; k < half; k++) {
        work->real[k] = values[2 * k];
        work->imaginary[k] = values[2 * k + 1];
    }
    transform_complex(of, work);
    work->real[half] = work->real[0]; /* the spectrum goes on where it began */
    work->imaginary[half] = work->imaginary[0];
    for (k = 0; k < n_bins; k++) {
        /* X[k] = E[k] + exp(-2 pi i k / n) O[k], with the transforms E and O of the even and the odd samples. Both
         * are of real values, so their spectra are mirrored, by which the sum and the difference part them again. */
        float even_r = 0.5f * (work->real[k] + work->real[half - k]);
        float even_i = 0.5f * (work->imaginary[k] - work->imaginary[half - k]);
        float odd_r = 0.5f * (work->imaginary[k] + work->imaginary[half - k]);
        float odd_i = 0.5f * (work->real[half - k] - work->real[k]);
        work->other_real[k] = even_r + odd_r * of->cosines[k] + odd_i * of->sines[k];
        work->other_imaginary[k] = even_i + odd_i * of->cosines[k] - odd_r * of->sines[k];
    }
    swap_spectra(work);
}

static void convolve(
    const kernels *by, const product *of, size_t lanes, const float *const *taps, size_t width_in, float *out,
    size_t width_out
)
{
    size_t lane, tap, n;
    for (lane = 0; lane < lanes; lane += n) {
        /* more lanes than three are worked on in groups, each with the same weights */
        const float *here[TAPS];
        n = lanes - lane < LANES_AT_ONCE ? lanes - lane : LANES_AT_ONCE;
        for (tap = 0; tap < of->n_taps; tap++)
            here[tap] = taps[tap] + lane * width_in;
        by->convolve[n - 1](of, here, width_in, out + lane * width_out, width_out);
    }
}

/* ------------------------------------------------------------------------------------------------------------------
 * The model
 * ---------------------------------------------------------------------------------------------------------------- */

/* Triangular filters: each a range of bins with their weights. */
typedef struct {
    uint32_t first, n;
    const float *weights;
} filter;

typedef struct {
    size_t n_warps;
    float floor; /* added to every power */
    const float *window;
    const filter *filters; /* BANDS of each warp */
    size_t n_bins;
    transform fourier;
} log_mels;

typedef struct {
    product sums;
    size_t n_out, width_in, width_out, dilation; /* widths: values from one lane to the next */
} layer;

typedef struct {
    size_t n_layers, width_heads;
    layer layers[MOST_LAYERS];
    product heads; /* phonemes in the first tile, visemes in the next */
    size_t n_visemes; /* 0 where it tells none apart */
} network;

enum { ZERO_CROSSINGS, VOLUME, NOTHING, BAND, KINDS_OF_VARIABLES };
enum { RAW, FILTERED, NORMALISED, MEL, SOURCES };
enum { SUM, MAXIMUM, MEAN };

typedef struct {
    uint32_t what, source, kind, first, stop;
    int32_t per; /* number of the variable that it is divided by, or -1 */
} variable;

typedef struct {
    size_t step, n_samples, n_bins, n_mel;
    int anti_aliased, normalises;
    float pre_emphasis, kept, fresh; /* of smoothing over time: the share that is kept, and that of what is new */
    float denoise;
    const float *window, *scale, *centre, *below, *above; /* window, below and above may be NULL */
    const filter *mel;
    transform fourier, whole, inverse;
    size_t n_variables;
    const variable *variables;
    int needs_raw;
} front_end;

typedef struct {
    uint32_t variable;
    float sign, limit;
} condition;

typedef struct {
    uint32_t phoneme, n;
    const uint32_t *conditions;
} rule;

typedef struct {
    size_t n_conditions, n_rules;
    const condition *conditions;
    const rule *rules; /* the last one has no condition */
} rules;

typedef struct {
    float silence_below;
    size_t n;
    uint32_t phonemes[EAR_PHONEMES];
    const float *means, *scale, *cosines; /* means count in spreads; cosines: a row for each cepstrum */
} templates;

typedef struct {
    uint32_t shape, row;
    double to_shape, to_rest;
    int closes;
} mouth_entry;

typedef struct {
    const char *name;
    size_t n_movestates, n_shapes, n_rows;
    const char *const *movestates, *const *shapes;
    const uint32_t *left_of; /* for each movestate of the right side that of the left; itself for all others */
    const float *rows;
    const uint32_t *is_loose;
    size_t n_looks; /* of the visemes, and one more where none is known */
    const mouth_entry *entries; /* [phoneme][look] */
    double loudness, minimum_opening, randomness;
} mouth_table;

enum { BY_RULES, BY_NETWORK, BY_TEMPLATES };

typedef struct {
    size_t n;                                         /* 0 where there is no search */
    uint32_t phonemes[EAR_PHONEMES];                  /* that it may find, silence first */
    int32_t against[EAR_PHONEMES][EAR_PHONEMES + 1]; /* each of them, by answer; the last answer says nothing */
    int32_t costs[EAR_PHONEMES][EAR_PHONEMES];        /* of a change from one to another */
} decoder;

struct ear_model {
    void *owned;
    const char *name;
    uint32_t recogniser, look_ahead;
    uint32_t is_calmed, least_hold;
    float hysteresis;
    float gain, slope; /* of the intensity */
    uint32_t successors[EAR_PHONEMES];
    float factors[EAR_PHONEMES];
    uint32_t has_sensitivities;
    size_t n_points;
    const float *curve_scores, *curve_shares;
    log_mels mels;
    viseme_set visemes;
    network net;
    front_end front;
    rules rules;
    templates templates;
    decoder decoder;
    size_t n_tables;
    mouth_table *tables[MOST_TABLES];
    const kernels *by;
};

static void read_preset(reader *in, arena *memory, ear_model *model)
{
    int k;
    model->name = read_text(in, memory);
    model->recogniser = read_within(in, BY_RULES, BY_TEMPLATES);
    model->look_ahead = read_within(in, 0, MOST_AHEAD);
    model->is_calmed = read_within(in, 0, 1);
    model->least_hold = read_within(in, 1, 1000);
    model->hysteresis = read_f32(in);
    model->gain = read_f32(in);
    model->slope = read_f32(in);
    for (k = 0; k < EAR_PHONEMES; k++)
        model->successors[k] = read_within(in, 0, EAR_PHONEMES - 1);
    model->has_sensitivities = read_within(in, 0, 1);
    for (k = 0; k < EAR_PHONEMES; k++)
        model->factors[k] = read_f32(in);
    model->n_points = read_within(in, 0, MOST_POINTS);
    model->curve_scores = read_floats(in, memory, model->n_points);
    model->curve_shares = read_floats(in, memory, model->n_points);
}

/* Which phonemes the search may find, what each answer says against them, and what changes cost. */
static void read_decoder(reader *in, arena *memory, ear_model *model)
{
    decoder *made = &model->decoder;
    size_t k, j;
    (void)memory;
    made->n = read_within(in, 1, EAR_PHONEMES);
    for (k = 0; k < made->n; k++)
        made->phonemes[k] = read_within(in, 0, EAR_PHONEMES - 1);
    for (k = 0; k < made->n; k++)
        for (j = 0; j < EAR_PHONEMES; j++)
            made->against[k][j] = (int32_t)read_within(in, 0, MOST_EVIDENCE);
    for (k = 0; k < made->n; k++)
        for (j = 0; j < made->n; j++)
            made->costs[k][j] = (int32_t)read_within(in, 0, MOST_COST);
}

static const filter *read_filters(reader *in, arena *memory, size_t n, size_t n_bins)
{
    filter *filters;
    size_t k;
    if (!has(in, n, 8))
        return NULL;
    filters = take(memory, n, sizeof *filters);
    for (k = 0; k < n; k++) {
        filter read;
        read.first = read_within(in, 0, (uint32_t)n_bins);
        read.n = read_within(in, 0, (uint32_t)n_bins - read.first);
        read.weights = read_floats(in, memory, read.n);
        if (filters)
            filters[k] = read;
    }
    return filters;
}

static void read_log_mels(reader *in, arena *memory, ear_model *model)
{
    log_mels *mels = &model->mels;
    mels->n_warps = read_within(in, 1, MOST_WARPS);
    mels->floor = read_f32(in);
    mels->n_bins = read_within(in, 1, SHORT / 2);
    mels->window = read_floats(in, memory, SHORT);
    mels->filters = read_filters(in, memory, mels->n_warps * BANDS, mels->n_bins);
    mels->fourier = make_transform(memory, SHORT);
    if (mels->floor <= 0)
        in->failed = 1;
}

static size_t tiles_of(size_t n)
{
    return (n + TILE - 1) / TILE;
}

/* Read a bias into a row of whole tiles. */
static void read_bias(reader *in, float *row, size_t n)
{
    size_t k;
    for (k = 0; k < n; k++) {
        float value = read_f32(in);
        if (row)
            row[k] = value;
    }
}

static float *take_zeros(arena *memory, size_t n)
{
    float *values = take_floats(memory, n);
    if (values)
        memset(values, 0, n * sizeof *values);
    return values;
}

static void read_layer(reader *in, arena *memory, layer *made, size_t n_in, size_t width_in)
{
    size_t n_rows = TAPS * n_in;
    float *weights, *bias;
    made->n_out = read_within(in, 1, MOST_CHANNELS);
    made->dilation = read_within(in, 1, MOST_DILATION);
    if (!has(in, n_rows * made->n_out, 2))
        return;
    made->sums.n_taps = TAPS;
    made->sums.n_in = n_in;
    made->sums.n_tiles = tiles_of(made->n_out);
    made->width_in = width_in;
    made->width_out = made->sums.n_tiles * TILE;
    made->sums.weights = weights = take_zeros(memory, n_rows * made->width_out);
    made->sums.bias = bias = take_zeros(memory, made->width_out);
    read_tiles(in, weights, n_rows, made->n_out, 0);
    read_bias(in, bias, made->n_out);
}

static void read_heads(reader *in, arena *memory, network *net, size_t n_in, size_t n_visemes)
{
    float *weights, *bias;
    net->n_visemes = read_within(in, 0, 1) ? n_visemes : 0;
    net->heads.n_taps = 1;
    net->heads.n_in = n_in;
    net->heads.n_tiles = net->n_visemes ? 2 : 1;
    net->width_heads = net->heads.n_tiles * TILE;
    if (!has(in, n_in * EAR_PHONEMES, 2))
        return;
    net->heads.weights = weights = take_zeros(memory, n_in * net->width_heads);
    net->heads.bias = bias = take_zeros(memory, net->width_heads);
    read_tiles(in, weights, n_in, EAR_PHONEMES, 0);
    read_bias(in, bias, EAR_PHONEMES);
    if (net->n_visemes) {
        read_tiles(in, weights, n_in, net->n_visemes, TILE);
        read_bias(in, bias ? bias + TILE : NULL, net->n_visemes);
    }
}

static void read_network(reader *in, arena *memory, ear_model *model)
{
    network *net = &model->net;
    size_t k, n_in = BANDS, width_in = BANDS;
    net->n_layers = read_within(in, 1, MOST_LAYERS);
    for (k = 0; k < net->n_layers && !in->failed; k++) {
        layer *made = &net->layers[k];
        read_layer(in, memory, made, n_in, width_in);
        if (k && made->n_out != n_in)
            in->failed = 1;
        n_in = made->n_out;
        width_in = made->width_out;
    }
    if (!in->failed)
        read_heads(in, memory, net, n_in, model->visemes.n);
}

static void read_variables(reader *in, arena *memory, front_end *front)
{
    variable *variables;
    size_t k;
    front->n_variables = read_within(in, 1, MOST_VARIABLES);
    if (!has(in, front->n_variables, 24))
        return;
    front->variables = variables = take(memory, front->n_variables, sizeof *variables);
    for (k = 0; k < front->n_variables; k++) {
        variable read;
        size_t most;
        read.what = read_within(in, 0, KINDS_OF_VARIABLES - 1);
        read.source = read_within(in, RAW, MEL);
        read.kind = read_within(in, SUM, MEAN);
        most = read.source == MEL ? front->n_mel : front->n_bins;
        read.stop = read_within(in, 0, (uint32_t)most);
        read.first = read_within(in, 0, read.stop);
        read.per = (int32_t)read_within(in, 0, (uint32_t)front->n_variables) - 1;
        front->needs_raw |= read.what == BAND && read.source == RAW;
        if (variables)
            variables[k] = read;
    }
}

static int is_size_of_transform(size_t n)
{
    return n == 512 || n == 1024 || n == 2048;
}

static void read_front_end(reader *in, arena *memory, ear_model *model)
{
    front_end *front = &model->front;
    int windows, blurs;
    front->step = read_within(in, 1, 4);
    front->anti_aliased = (int)read_within(in, 0, 1);
    front->n_samples = WINDOW / front->step;
    if (!is_size_of_transform(front->n_samples)) {
        in->failed = 1;
        return;
    }
    front->n_bins = front->n_samples / 2;
    front->pre_emphasis = read_f32(in);
    front->kept = read_f32(in);
    front->fresh = read_f32(in);
    front->denoise = read_f32(in);
    front->normalises = (int)read_within(in, 0, 1);
    windows = (int)read_within(in, 0, 1);
    blurs = (int)read_within(in, 0, 1);
    front->n_mel = read_within(in, 0, 1000);
    front->window = windows ? read_floats(in, memory, front->n_samples) : NULL;
    front->scale = read_floats(in, memory, front->n_bins);
    front->centre = read_floats(in, memory, front->n_bins);
    front->below = blurs ? read_floats(in, memory, front->n_bins - 1) : NULL;
    front->above = blurs ? read_floats(in, memory, front->n_bins - 1) : NULL;
    front->mel = read_filters(in, memory, front->n_mel, front->n_bins);
    front->fourier = make_transform(memory, front->n_samples);
    if (front->anti_aliased && front->step > 1) {
        front->whole = make_transform(memory, WINDOW);
        front->inverse = make_transform(memory, front->n_samples);
    }
    read_variables(in, memory, front);
}

static const uint32_t *read_numbers(reader *in, arena *memory, size_t n, uint32_t most)
{
    uint32_t *numbers;
    size_t k;
    if (!has(in, n, 4))
        return NULL;
    numbers = take(memory, n, sizeof *numbers);
    for (k = 0; k < n; k++) {
        uint32_t value = read_within(in, 0, most);
        if (numbers)
            numbers[k] = value;
    }
    return numbers;
}

static void read_conditions(reader *in, arena *memory, ear_model *model)
{
    size_t k, n = read_within(in, 0, MOST_RULES);
    condition *conditions;
    if (!has(in, n, 12))
        return;
    model->rules.n_conditions = n;
    model->rules.conditions = conditions = take(memory, n, sizeof *conditions);
    for (k = 0; k < n; k++) {
        condition read;
        read.variable = read_within(in, 0, (uint32_t)model->front.n_variables - 1);
        read.sign = read_within(in, 0, 1) ? 1.0f : -1.0f;
        read.limit = read_f32(in);
        if (conditions)
            conditions[k] = read;
    }
}

static void read_rules(reader *in, arena *memory, ear_model *model)
{
    rule *all, last = {0, 1, NULL};
    size_t k, n;
    if (!model->front.n_variables) { /* they stand before the rules */
        in->failed = 1;
        return;
    }
    read_conditions(in, memory, model);
    n = read_within(in, 1, MOST_RULES);
    if (!has(in, n, 8))
        return;
    model->rules.n_rules = n;
    model->rules.rules = all = take(memory, n, sizeof *all);
    for (k = 0; k < n; k++) {
        last.phoneme = read_within(in, 0, EAR_PHONEMES - 1);
        last.n = read_within(in, 0, (uint32_t)model->rules.n_conditions);
        last.conditions = read_numbers(in, memory, last.n, last.n ? (uint32_t)model->rules.n_conditions - 1 : 0);
        if (all)
            all[k] = last;
    }
    if (last.n)
        in->failed = 1;
}

static void read_templates(reader *in, arena *memory, ear_model *model)
{
    templates *read = &model->templates;
    size_t k;
    read->silence_below = read_f32(in);
    read->n = read_within(in, 1, EAR_PHONEMES);
    for (k = 0; k < read->n; k++)
        read->phonemes[k] = read_within(in, EAR_SZ, EAR_O);
    read->means = read_floats(in, memory, read->n * CEPSTRA);
    read->scale = read_floats(in, memory, CEPSTRA);
    read->cosines = read_floats(in, memory, CEPSTRA * BANDS);
}

static void read_entries(reader *in, arena *memory, mouth_table *table)
{
    size_t k, n = EAR_PHONEMES * table->n_looks;
    mouth_entry *entries = take(memory, n, sizeof *entries);
    for (k = 0; k < n; k++) {
        mouth_entry read;
        read.shape = read_within(in, 0, (uint32_t)table->n_shapes - 1);
        read.row = read_within(in, 0, (uint32_t)table->n_rows - 1);
        read.to_shape = read_f64_within(in, 0, 1000);
        read.to_rest = read_f64_within(in, 0, 1000);
        read.closes = (int)read_within(in, 0, 1);
        if (entries)
            entries[k] = read;
    }
    table->entries = entries;
}

static void read_mouth_table(reader *in, arena *memory, ear_model *model)
{
    mouth_table counted, *table = take(memory, 1, sizeof *table);
    if (model->n_tables == MOST_TABLES) {
        in->failed = 1;
        return;
    }
    memset(&counted, 0, sizeof counted);
    counted.name = read_text(in, memory);
    counted.loudness = read_f64_within(in, 0, 1000);
    counted.minimum_opening = read_f64_within(in, 0, 1);
    counted.randomness = read_f64_within(in, 0, 1);
    counted.n_movestates = read_within(in, 0, MOST_MOVESTATES); /* none where a table is of drawings alone */
    counted.movestates = read_texts(in, memory, counted.n_movestates);
    counted.left_of = read_numbers(in, memory, counted.n_movestates, (uint32_t)counted.n_movestates - 1u);
    counted.n_shapes = read_within(in, 1, MOST_SHAPES);
    counted.n_rows = EAR_PHONEMES + counted.n_shapes;
    counted.shapes = read_texts(in, memory, counted.n_shapes);
    counted.rows = read_floats(in, memory, counted.n_rows * counted.n_movestates);
    counted.is_loose = read_numbers(in, memory, counted.n_rows, 1);
    counted.n_looks = model->visemes.n + 1;
    read_entries(in, memory, &counted);
    if (table)
        *table = counted;
    model->tables[model->n_tables++] = table;
}

/* Visemes of the file's own, which stand before all that counts them. */
static void read_visemes(reader *in, arena *memory, ear_model *model)
{
    viseme_set *set = &model->visemes;
    uint32_t every;
    int k;
    set->n = read_within(in, 1, MOST_VISEMES);
    set->names = read_texts(in, memory, set->n);
    every = (uint32_t)((1ull << set->n) - 1);
    for (k = 0; k < EAR_PHONEMES; k++)
        set->allowed[k] = read_within(in, 1, every);
    for (k = 0; k < EAR_PHONEMES; k++) {
        set->usual[k] = read_within(in, 0, EAR_NO_VISEME);
        if (set->usual[k] >= set->n && set->usual[k] != EAR_NO_VISEME)
            in->failed = 1;
    }
    if (model->net.n_layers || model->n_tables)
        in->failed = 1;
}

#define TAG(a, b, c, d) ((uint32_t)(a) | (uint32_t)(b) << 8 | (uint32_t)(c) << 16 | (uint32_t)(d) << 24)

typedef struct {
    uint32_t tag;
    void (*read)(reader *in, arena *memory, ear_model *model);
} section;

enum {
    PRESET_SECTION, MELS_SECTION, NETWORK_SECTION, FRONT_SECTION, RULES_SECTION, TEMPLATES_SECTION, MOUTH_SECTION,
    VISEMES_SECTION, DECODER_SECTION
};

static const section SECTIONS[] = {
    {TAG('P', 'R', 'S', 'T'), read_preset},      {TAG('M', 'E', 'L', 'S'), read_log_mels},
    {TAG('N', 'E', 'T', 'W'), read_network},     {TAG('F', 'R', 'N', 'T'), read_front_end},
    {TAG('R', 'U', 'L', 'E'), read_rules},       {TAG('T', 'M', 'P', 'L'), read_templates},
    {TAG('M', 'O', 'U', 'T'), read_mouth_table}, {TAG('V', 'I', 'S', 'M'), read_visemes},
    {TAG('D', 'E', 'C', 'O'), read_decoder},
};

/* Return which sections a recogniser needs, a bit for each. */
static unsigned needs_of(uint32_t recogniser)
{
    static const unsigned NEEDS[] = {
        1u << FRONT_SECTION | 1u << RULES_SECTION,
        1u << MELS_SECTION | 1u << NETWORK_SECTION,
        1u << MELS_SECTION | 1u << TEMPLATES_SECTION,
    };
    return 1u << PRESET_SECTION | NEEDS[recogniser];
}

/* Read a section; returns its bit, 0 where it is none, or there twice. */
static unsigned read_section(reader *in, arena *memory, ear_model *model, unsigned seen)
{
    uint32_t tag = read_u32(in), n = read_u32(in);
    reader part = *in;
    unsigned k;
    if (!has(in, n, 1))
        return 0;
    in->at += n;
    part.end = in->at;
    for (k = 0; k < COUNT_OF(SECTIONS); k++)
        if (SECTIONS[k].tag == tag && (k == MOUTH_SECTION || !(seen >> k & 1))) {
            SECTIONS[k].read(&part, memory, model);
            return part.failed || part.at != part.end ? 0 : 1u << k;
        }
    return 0;
}

/* Check the bytes and lay out what they hold; without a base in `memory` only its size is found. */
static int read_model(const unsigned char *bytes, size_t n_bytes, arena *memory, ear_model *model)
{
    reader in = {NULL, NULL, 0};
    unsigned seen = 0;
    memset(model, 0, sizeof *model);
    model->visemes = STANDARD_VISEMES;
    take(memory, 1, sizeof *model);
    if (n_bytes < HEADER || memcmp(bytes, "EAR\x1a", 4) != 0)
        return EAR_NO_EAR_FILE;
    if (u32_at(bytes + 4) > VERSION)
        return EAR_NEWER_FILE;
    if (u32_at(bytes + 4) < 1)
        return EAR_DAMAGED_FILE;
    if (u32_at(bytes + 8) != n_bytes || u32_at(bytes + 12) != crc_of(bytes + HEADER, n_bytes - HEADER))
        return EAR_DAMAGED_FILE;
    in.at = bytes + HEADER;
    in.end = bytes + n_bytes;
    while (in.at < in.end) {
        unsigned found = read_section(&in, memory, model, seen);
        if (!found)
            return EAR_DAMAGED_FILE;
        seen |= found;
    }
    if ((seen & needs_of(model->recogniser)) != needs_of(model->recogniser))
        return EAR_DAMAGED_FILE;
    if (model->decoder.n && (model->recogniser != BY_RULES || model->look_ahead > MOST_PAST))
        return EAR_DAMAGED_FILE;
    if (model->recogniser == BY_TEMPLATES && model->mels.n_warps != 1)
        return EAR_DAMAGED_FILE;
    model->by = fastest_kernels();
    return EAR_OK;
}

int ear_model_size(const void *bytes, size_t n_bytes, size_t *size)
{
    arena counting = {NULL, 0};
    ear_model model;
    int result;
    if (!bytes || !size)
        return EAR_BAD_ARGUMENT;
    result = read_model(bytes, n_bytes, &counting, &model);
    *size = result == EAR_OK ? size_of(&counting) : 0;
    return result;
}

int ear_model_open(const void *bytes, size_t n_bytes, void *memory, size_t size, ear_model **model)
{
    arena laid;
    ear_model read;
    size_t needed;
    void *owned;
    int result;
    if (!model)
        return EAR_BAD_ARGUMENT;
    *model = NULL;
    result = ear_model_size(bytes, n_bytes, &needed);
    if (result != EAR_OK)
        return result;
    result = begin_arena(&laid, memory, size, needed, &owned);
    if (result != EAR_OK)
        return result;
    read_model(bytes, n_bytes, &laid, &read);
    read.owned = owned;
    *model = (ear_model *)laid.base;
    **model = read;
    return EAR_OK;
}

void ear_model_close(ear_model *model)
{
    if (model)
        free(model->owned);
}

const char *ear_model_name(const ear_model *model)
{
    return model->name;
}

int ear_model_look_ahead(const ear_model *model)
{
    return (int)model->look_ahead;
}

int ear_model_visemes(const ear_model *model)
{
    return (int)model->visemes.n;
}

const char *ear_model_viseme(const ear_model *model, int viseme)
{
    return viseme >= 0 && (size_t)viseme < model->visemes.n ? model->visemes.names[viseme] : "";
}

/* ------------------------------------------------------------------------------------------------------------------
 * Resampling: a low pass of windowed sinc (J. F. Kaiser, 1974), 100 dB down from nine tenths of the lower half rate
 * to the whole, evaluated where each new sample lies. The table holds it for equally many places between two samples
 * (phases). Where they are just those that occur, as from 48 kHz, it is exact, and of mirrored phases one is kept; else
 * it lies on cubics between four phases.
 * ---------------------------------------------------------------------------------------------------------------- */

enum {
    CROSSINGS = 64, /* of the sinc on each side */
    MOST_EXACT = 112 << 10, /* bytes of an exact table */
    USUAL_PHASES = 64,
    LEAST_PHASES = 4,
    AROUND = 1, /* phases before the first one, for the cubics; 2 follow the last one */
    CHUNK = 256
};

static const double ROLL_OFF = 0.95, KAISER_BETA = 10.06;

typedef struct {
    const kernels *by;
    uint32_t rate;
    size_t n_taps, n_phases, n_filled, first; /* first: of the samples in `seen` that the next output begins at */
    uint32_t remainder;                       /* where the next output lies behind that, in 44100ths of a sample */
    int is_exact;
    const float *table; /* [phase][tap] */
    float *seen;        /* n_taps + CHUNK samples */
    float *turned;      /* the same from the last to the first, for phases that are mirrored */
    uint64_t n_in, n_out;
} resampler;

static uint32_t greatest_divisor(uint32_t a, uint32_t b)
{
    while (b) {
        uint32_t rest = a % b;
        a = b;
        b = rest;
    }
    return a;
}

/* The modified Bessel function of the first kind and order 0. */
static double bessel_0(double x)
{
    double term = 1, sum = 1;
    int k;
    for (k = 1; term > 1e-12 * sum; k++) {
        term *= x / (2 * k) * (x / (2 * k));
        sum += term;
    }
    return sum;
}

/* Fill a phase: the taps of the low pass where the output lies `behind` samples after the middle of the left half. */
static void fill_phase(float *taps, size_t n_taps, double behind, double scale)
{
    /* The ideal low pass at `ROLL_OFF` times the lower half rate is a sinc; Kaiser's window, I0(beta sqrt(1 - (t /
     * T)^2)), ends it within CROSSINGS periods, and its beta of 10.06 sets the 100 dB. */
    double half = (double)n_taps / 2, total = 0;
    size_t k;
    for (k = 0; k < n_taps; k++) {
        double at = (double)k - (half - 1) - behind, x = PI * ROLL_OFF * at / scale, inside = 1 - at * at / (half * half);
        double sinc = fabs(x) < 1e-9 ? 1 : sin(x) / x;
        double value = inside > 0 ? sinc * bessel_0(KAISER_BETA * sqrt(inside)) : 0;
        taps[k] = (float)value;
        total += value;
    }
    for (k = 0; k < n_taps; k++) /* so that a constant stays what it is */
        taps[k] = (float)(taps[k] / total);
}

static void restart_resampler(resampler *of)
{
    of->n_filled = of->n_taps / 2 - 1; /* silence before the sound */
    of->first = 0;
    of->remainder = 0;
    of->n_in = of->n_out = 0;
    memset(of->seen, 0, (of->n_taps + CHUNK) * sizeof *of->seen);
    memset(of->turned, 0, (of->n_taps + CHUNK) * sizeof *of->turned);
}

static resampler make_resampler(arena *memory, uint32_t rate, const kernels *by)
{
    resampler made;
    /* Downwards the low pass has to end below the new half rate, so its crossings lie farther apart. */
    double scale = rate > RATE ? (double)rate / RATE : 1; /* input samples from one crossing to the next */
    size_t n_occurring = RATE / greatest_divisor(rate, RATE), n_kept, phase;
    float *table;
    memset(&made, 0, sizeof made);
    made.by = by;
    made.rate = rate;
    made.n_taps = 2 * (size_t)ceil(CROSSINGS * scale);
    /* From 48 kHz there are 44100 / 300 = 147 places, of which 74 are kept; from odd rates up to 44100. */
    made.is_exact = (n_occurring / 2 + 1) * made.n_taps * sizeof(float) <= MOST_EXACT;
    made.n_phases = (size_t)(USUAL_PHASES / scale + 0.5);
    made.n_phases = made.is_exact ? n_occurring : made.n_phases < LEAST_PHASES ? LEAST_PHASES : made.n_phases;
    n_kept = made.is_exact ? made.n_phases / 2 + 1 : made.n_phases + AROUND + 2;
    made.table = table = take_floats(memory, n_kept * made.n_taps);
    made.seen = take_floats(memory, made.n_taps + CHUNK);
    made.turned = take_floats(memory, made.n_taps + CHUNK);
    for (phase = 0; table && phase < n_kept; phase++) {
        double place = made.is_exact ? (double)phase : (double)phase - AROUND;
        fill_phase(table + phase * made.n_taps, made.n_taps, place / (double)made.n_phases, scale);
    }
    if (made.seen)
        restart_resampler(&made);
    return made;
}

static float resampled_exactly(const resampler *of, const float *here)
{
    /* The taps of phase p backwards are those of the phase n - p, so the second half of them is the first one,
     * applied to the samples from the last to the first. */
    size_t phase = (size_t)((uint64_t)of->remainder * of->n_phases / RATE), n = of->n_taps;
    if (phase <= of->n_phases / 2)
        return of->by->dot(here, of->table + phase * n, n);
    return of->by->dot(of->turned + CHUNK - of->first, of->table + (of->n_phases - phase) * n, n);
}

static float resampled_between(const resampler *of, const float *here)
{
    double place = (double)of->remainder * (double)of->n_phases / RATE;
    size_t phase = (size_t)place, n = of->n_taps;
    float f = (float)(place - (double)phase);
    const float *taps = of->table + phase * n; /* that before it, since AROUND stand in front */
    /* Lagrange's cubic through -1, 0, 1, 2 */
    const float shares[ROWS] = {
        -f * (f - 1) * (f - 2) / 6, (f + 1) * (f - 1) * (f - 2) / 2, -(f + 1) * f * (f - 2) / 2, (f + 1) * f * (f - 1) / 6,
    };
    return of->by->blend(here, taps, n, shares);
}

/* Give the next sample at 44.1 kHz; 0 where more have to come first. */
static int resample(resampler *of, float *sample)
{
    const float *here = of->seen + of->first;
    if (of->first + of->n_taps > of->n_filled)
        return 0;
    *sample = of->is_exact ? resampled_exactly(of, here) : resampled_between(of, here);
    /* whole numbers only: the place of an output never drifts, however long the sound is */
    of->remainder += of->rate % RATE;
    of->first += of->rate / RATE + of->remainder / RATE;
    of->remainder %= RATE;
    of->n_out++;
    return 1;
}

/* Take as many samples as there is room for; returns how many. */
static size_t feed_resampler(resampler *of, const float *samples, size_t n)
{
    /* What the next output no longer needs is dropped, the rest moves to the front; in `turned` to the back. */
    size_t all = of->n_taps + CHUNK, gone = of->first < of->n_filled ? of->first : of->n_filled, kept, k;
    kept = of->n_filled - gone;
    memmove(of->seen, of->seen + gone, kept * sizeof *of->seen);
    memmove(of->turned + all - kept, of->turned + all - of->n_filled, kept * sizeof *of->turned);
    of->first -= gone;
    n = n < all - kept ? n : all - kept;
    memcpy(of->seen + kept, samples, n * sizeof *samples);
    for (k = 0; k < n; k++)
        of->turned[all - 1 - kept - k] = samples[k];
    of->n_filled = kept + n;
    of->n_in += n;
    return n;
}

/* ------------------------------------------------------------------------------------------------------------------
 * The recogniser's memory
 * ---------------------------------------------------------------------------------------------------------------- */

typedef struct {
    uint32_t current, held, identified, steady;
} calming;

struct ear {
    const ear_model *model;
    void *owned;
    int resamples;
    resampler resampler;
    float *window;   /* the last WINDOW samples, of which `filled` have come */
    size_t filled;
    uint64_t n_received, n_framed;
    uint32_t next;   /* number of the next frame that is given */
    size_t frame_size;
    size_t n_early;  /* answers that are about frames before the first */
    float levels[MOST_AHEAD + 1], deficits[MOST_AHEAD + 1][EAR_PHONEMES];
    size_t level_at;
    /* the network: the history of each layer, [frame][lane][value], and the frame that came last */
    float *seen[MOST_LAYERS];
    size_t newest[MOST_LAYERS];
    float *found, *answers;
    double evidence[MOST_WARPS];
    /* the front end */
    workspace work;
    float *wave, *rebuilt, *magnitudes, *smoothed, *spectrum, *mel, *values;
    calming calm;
    int32_t courses[EAR_PHONEMES]; /* of the search: how good the best one is that ends in each phoneme, and its past */
    int is_over;                   /* whether the sound has ended */
    int32_t viseme_phoneme, viseme;
};

static size_t frames_kept(const layer *of)
{
    return (TAPS - 1) * of->dilation + 1;
}

static void lay_out_network(arena *memory, ear *made)
{
    const ear_model *model = made->model;
    const network *net = &model->net;
    size_t lanes = model->mels.n_warps, k;
    for (k = 0; k < net->n_layers; k++)
        made->seen[k] = take_floats(memory, frames_kept(&net->layers[k]) * lanes * net->layers[k].width_in);
    made->found = take_floats(memory, lanes * net->layers[net->n_layers - 1].width_out);
    made->answers = take_floats(memory, lanes * net->width_heads);
}

static void lay_out_front_end(arena *memory, ear *made)
{
    const front_end *front = &made->model->front;
    made->wave = take_floats(memory, WINDOW);
    made->rebuilt = take_floats(memory, WINDOW);
    made->magnitudes = take_floats(memory, front->n_bins);
    made->smoothed = take_floats(memory, front->n_bins);
    made->spectrum = take_floats(memory, front->n_bins);
    made->mel = take_floats(memory, front->n_mel);
    made->values = take_floats(memory, front->n_variables);
}

static void lay_out_ear(arena *memory, ear *made)
{
    const ear_model *model = made->model;
    take(memory, 1, sizeof *made);
    made->window = take_floats(memory, WINDOW);
    made->work = make_workspace(memory, model->recogniser == BY_RULES ? WINDOW : SHORT, model->by);
    if (model->recogniser == BY_NETWORK)
        lay_out_network(memory, made);
    else if (model->recogniser == BY_RULES)
        lay_out_front_end(memory, made);
    else
        made->wave = take_floats(memory, SHORT);
    if (model->recogniser == BY_NETWORK)
        made->wave = take_floats(memory, SHORT);
    if (made->resamples)
        made->resampler = make_resampler(memory, made->resampler.rate, model->by);
}

static void forget_network(ear *of)
{
    const ear_model *model = of->model;
    const float silent = log10f(model->mels.floor);
    size_t lanes = model->mels.n_warps, k, j;
    for (k = 0; k < model->net.n_layers; k++) {
        size_t n = frames_kept(&model->net.layers[k]) * lanes * model->net.layers[k].width_in;
        for (j = 0; j < n; j++)
            of->seen[k][j] = k ? 0 : silent;
        of->newest[k] = 0;
    }
    for (k = 0; k < MOST_WARPS; k++)
        of->evidence[k] = 0;
}

/* How good a course is stands above the bits of its past: four for the phoneme of each frame. */
enum { PAST = 1 << 4 * MOST_PAST };

static void begin_search(ear *of)
{
    const decoder *by = &of->model->decoder;
    size_t k;
    for (k = 0; k < by->n; k++) /* as if silence had been before */
        of->courses[k] = k ? -by->costs[0][k] * PAST : 0;
}

void ear_reset(ear *of)
{
    const ear_model *model = of->model;
    memset(of->window, 0, WINDOW * sizeof *of->window);
    of->filled = LEAD;
    of->n_received = of->n_framed = 0;
    of->next = 0;
    of->n_early = model->look_ahead;
    of->level_at = 0;
    of->calm.current = of->calm.identified = of->calm.steady = EAR_SILENCE;
    of->calm.held = model->least_hold;
    begin_search(of);
    of->is_over = 0;
    of->viseme_phoneme = of->viseme = -1;
    if (of->resamples)
        restart_resampler(&of->resampler);
    if (model->recogniser == BY_NETWORK)
        forget_network(of);
    else if (model->recogniser == BY_RULES)
        memset(of->smoothed, 0, model->front.n_bins * sizeof *of->smoothed);
}

static int begin_ear(const ear_model *model, uint32_t rate, ear *made)
{
    if (!model)
        return EAR_BAD_ARGUMENT;
    if (rate < EAR_LOWEST_RATE || rate > EAR_HIGHEST_RATE)
        return EAR_BAD_RATE;
    memset(made, 0, sizeof *made);
    made->model = model;
    made->resamples = rate != RATE;
    made->resampler.rate = rate;
    return EAR_OK;
}

int ear_size(const ear_model *model, uint32_t rate, size_t *size)
{
    arena counting = {NULL, 0};
    ear counted;
    int result = size ? begin_ear(model, rate, &counted) : EAR_BAD_ARGUMENT;
    if (result != EAR_OK)
        return result;
    lay_out_ear(&counting, &counted);
    *size = size_of(&counting);
    return EAR_OK;
}

int ear_open_sized(
    const ear_model *model, uint32_t rate, size_t frame_size, void *memory, size_t size, ear **listener
)
{
    arena laid;
    ear made;
    size_t needed;
    void *owned;
    int result;
    if (!listener)
        return EAR_BAD_ARGUMENT;
    *listener = NULL;
    if (frame_size < OLDEST_FRAME || frame_size > MOST_FRAME || frame_size % sizeof(float))
        return EAR_BAD_ARGUMENT;
    result = begin_ear(model, rate, &made);
    made.frame_size = frame_size;
    if (result == EAR_OK)
        result = ear_size(model, rate, &needed);
    if (result == EAR_OK)
        result = begin_arena(&laid, memory, size, needed, &owned);
    if (result != EAR_OK)
        return result;
    made.owned = owned;
    lay_out_ear(&laid, &made);
    ear_reset(&made);
    *listener = (ear *)laid.base;
    **listener = made;
    return EAR_OK;
}

int ear_open(const ear_model *model, uint32_t rate, void *memory, size_t size, ear **listener)
{
    return ear_open_sized(model, rate, OLDEST_FRAME, memory, size, listener);
}

void ear_close(ear *listener)
{
    if (listener)
        free(listener->owned);
}

double ear_latency(const ear *of)
{
    double held_back = of->resamples ? (double)of->resampler.n_taps / 2 / of->resampler.rate : 0;
    return held_back + ((double)WINDOW / 2 + (double)HOP / 2) / RATE + of->model->look_ahead * (double)HOP / RATE;
}

/* ------------------------------------------------------------------------------------------------------------------
 * The network: log mels with several vocal tracts, dilated convolutions, and which tract is sure
 * ---------------------------------------------------------------------------------------------------------------- */

/* The share of evidence that is left after 10 ms, of a memory of 10 s, and how much a frame tells. */
static const double EVIDENCE_KEPT = 0.99900049983337502, TRUST = 0.1;

/* Write the logarithms of the powers in the mel bands, BANDS of each warp, to `out`, `width` apart. */
static void measure_log_mels(ear *of, const float *window, float *out)
{
    /* the powers may take the place of the samples: the transform has copied them */
    const log_mels *mels = &of->model->mels;
    const float *middle = window + (WINDOW - SHORT) / 2;
    float *powers = of->wave;
    size_t k;
    for (k = 0; k < SHORT; k++)
        of->wave[k] = middle[k] * mels->window[k];
    transform_real(&mels->fourier, of->wave, mels->n_bins, &of->work);
    /* no root: the logarithm of a power is all that is asked for */
    for (k = 0; k < mels->n_bins; k++)
        powers[k] = of->work.real[k] * of->work.real[k] + of->work.imaginary[k] * of->work.imaginary[k];
    for (k = 0; k < mels->n_warps * BANDS; k++) {
        const filter *band = &mels->filters[k];
        out[k] = log10f(of->work.by->dot(powers + band->first, band->weights, band->n) + mels->floor);
    }
}

static float *frame_of(const ear *of, size_t number, size_t frame)
{
    return of->seen[number] + frame * of->model->mels.n_warps * of->model->net.layers[number].width_in;
}

/* Return where the next input of a layer belongs. */
static float *next_input(ear *of, size_t number)
{
    of->newest[number] = (of->newest[number] + 1) % frames_kept(&of->model->net.layers[number]);
    return frame_of(of, number, of->newest[number]);
}

/* Have a layer find what it can in its newest input; every layer but the first adds that to what came in. */
static void work_layer(ear *of, size_t number, float *out)
{
    const layer *here = &of->model->net.layers[number];
    /* A ring of 2 d + 1 frames, d the dilation: the history of a causal layer. Each frame is computed once
     * and kept for its later taps, so a new one costs one product for each layer. */
    size_t lanes = of->model->mels.n_warps, n = lanes * here->width_out, n_kept = frames_kept(here), k;
    const float *taps[TAPS];
    for (k = 0; k < TAPS; k++)
        taps[k] = frame_of(of, number, (of->newest[number] + n_kept - (TAPS - 1 - k) * here->dilation) % n_kept);
    convolve(of->model->by, &here->sums, lanes, taps, here->width_in, out, here->width_out);
    of->model->by->rectify(out, number ? taps[TAPS - 1] : NULL, n);
}

/* Turn scores into probabilities that sum to 1. */
static void soften(float *scores, size_t n)
{
    /* less the greatest: the quotients are the same, and expf cannot overflow */
    float most = scores[0], total = 0;
    size_t k;
    for (k = 1; k < n; k++)
        most = scores[k] > most ? scores[k] : most;
    for (k = 0; k < n; k++)
        total += scores[k] = expf(scores[k] - most);
    for (k = 0; k < n; k++)
        scores[k] /= total;
}

static size_t likeliest(const float *scores, size_t n)
{
    size_t best = 0, k;
    for (k = 1; k < n; k++)
        if (scores[k] > scores[best])
            best = k;
    return best;
}

/* Say how much each vocal tract counts: one with which the network was sure counts more; silence tells nothing. */
static void weigh_tracts(ear *of, const float *answers, size_t width, float *weights)
{
    size_t lanes = of->model->mels.n_warps, lane;
    /* The logarithms of each tract's greatest probabilities, older ones fading, are its evidence; to the power of
     * TRUST, and made to sum to 1, they are its weight. Double, since they are added up over 10 s. */
    double silent = 0, most = -DBL_MAX, total = 0, odds[MOST_WARPS];
    for (lane = 0; lane < lanes; lane++)
        silent += answers[lane * width + EAR_SILENCE];
    for (lane = 0; lane < lanes; lane++) {
        const float *shares = answers + lane * width;
        double sure = silent < (double)lanes / 2 ? log(shares[likeliest(shares, EAR_PHONEMES)]) : 0;
        of->evidence[lane] = EVIDENCE_KEPT * of->evidence[lane] + sure;
        most = of->evidence[lane] > most ? of->evidence[lane] : most;
    }
    for (lane = 0; lane < lanes; lane++)
        total += odds[lane] = exp(TRUST * (of->evidence[lane] - most));
    for (lane = 0; lane < lanes; lane++)
        weights[lane] = (float)(odds[lane] / total);
}

static void mix(const float *answers, size_t width, size_t lanes, const float *weights, float *out, size_t n)
{
    size_t lane, k;
    for (k = 0; k < n; k++)
        out[k] = 0;
    for (lane = 0; lane < lanes; lane++)
        for (k = 0; k < n; k++)
            out[k] += weights[lane] * answers[lane * width + k];
}

/* Say how likely phonemes and visemes are; returns whether there is an answer: the first ones are about nothing. */
static int ask_network(ear *of, const float *window, float *scores, float *visemes)
{
    const network *net = &of->model->net;
    size_t lanes = of->model->mels.n_warps, width = net->width_heads, k;
    const float *found[1];
    float weights[MOST_WARPS] = {1};
    /* each layer writes its answer to where the next one keeps its input, so nothing is copied */
    measure_log_mels(of, window, next_input(of, 0));
    for (k = 0; k < net->n_layers; k++)
        work_layer(of, k, k + 1 < net->n_layers ? next_input(of, k + 1) : of->found);
    if (of->n_early) {
        of->n_early--;
        return 0;
    }
    found[0] = of->found;
    convolve(
        of->model->by, &net->heads, lanes, found, net->layers[net->n_layers - 1].width_out, of->answers, width
    );
    for (k = 0; k < lanes; k++) {
        soften(of->answers + k * width, EAR_PHONEMES);
        if (net->n_visemes)
            soften(of->answers + k * width + TILE, net->n_visemes);
    }
    if (lanes > 1)
        weigh_tracts(of, of->answers, width, weights);
    mix(of->answers, width, lanes, weights, scores, EAR_PHONEMES);
    if (net->n_visemes)
        mix(of->answers + TILE, width, lanes, weights, visemes, net->n_visemes);
    return 1;
}

/* ------------------------------------------------------------------------------------------------------------------
 * The front end of the rules: waveform, spectrum, filters, variables
 * ---------------------------------------------------------------------------------------------------------------- */

/* Keep every step-th sample, after what lies above the new half rate was taken out of the frame's spectrum. */
static void decimate_without_aliases(ear *of, const float *window)
{
    const front_end *front = &of->model->front;
    size_t n = front->n_samples, half = n / 2, k;
    /* The frame is rebuilt from the lowest bins of its own transform: what lies above the new half rate is gone. */
    transform_real(&front->whole, window, half + 1, &of->work);
    of->work.real[half] = of->work.imaginary[half] = 0;
    /* The inverse transform: the bins as n / 2 complex values, even and odd samples in their two parts. */
    for (k = 0; k < half; k++) {
        float ar = of->work.real[k], ai = k ? of->work.imaginary[k] : 0;
        float br = of->work.real[half - k], bi = -of->work.imaginary[half - k];
        float dr = ar - br, di = ai - bi, c = front->inverse.cosines[k], s = front->inverse.sines[k];
        float odd_r = dr * c - di * s, odd_i = dr * s + di * c;
        of->work.other_real[k] = ai + bi + odd_r; /* both parts change places, which turns the transform around */
        of->work.other_imaginary[k] = ar + br - odd_i;
    }
    swap_spectra(&of->work);
    transform_complex(&front->inverse, &of->work);
    for (k = 0; k < half; k++) {
        of->wave[2 * k] = of->work.imaginary[k] / WINDOW;
        of->wave[2 * k + 1] = of->work.real[k] / WINDOW;
    }
}

static const float *waveform_of(ear *of, const float *window)
{
    const front_end *front = &of->model->front;
    size_t n = front->n_samples, k;
    float *wave = of->wave;
    if (front->step > 1 && front->anti_aliased)
        decimate_without_aliases(of, window);
    else
        for (k = 0; k < n; k++)
            wave[k] = window[k * front->step];
    if (front->pre_emphasis > 0) {
        /* backwards, since each value needs the one before it as it was */
        for (k = n - 1; k > 0; k--)
            wave[k] -= front->pre_emphasis * wave[k - 1];
        wave[0] -= front->pre_emphasis * wave[0];
    }
    for (k = 0; front->window && k < n; k++)
        wave[k] *= front->window[k];
    return wave;
}

static void measure_magnitudes(ear *of, const float *window)
{
    const front_end *front = &of->model->front;
    size_t k;
    transform_real(&front->fourier, waveform_of(of, window), front->n_bins, &of->work);
    for (k = 0; k < front->n_bins; k++)
        of->magnitudes[k] = sqrtf(
            of->work.real[k] * of->work.real[k] + of->work.imaginary[k] * of->work.imaginary[k]
        );
}

/* Smooth over time and frequency, and apply the pass filters and the scale, in one weight for each bin. */
static void shape_spectrum(ear *of)
{
    const front_end *front = &of->model->front;
    const float *smooth = of->magnitudes;
    size_t n = front->n_bins, k;
    if (front->kept > 0) {
        /* a recursive low pass of first order along time, for each bin on its own */
        for (k = 0; k < n; k++)
            of->smoothed[k] = front->kept * of->smoothed[k] + front->fresh * of->magnitudes[k];
        smooth = of->smoothed;
    }
    for (k = 0; k < n; k++)
        of->spectrum[k] = smooth[k] * front->centre[k];
    if (front->below) {
        /* blur, pass filters and scale are linear, so together they are three weights for each bin */
        for (k = 1; k < n; k++)
            of->spectrum[k] += front->below[k - 1] * smooth[k - 1];
        for (k = 0; k + 1 < n; k++)
            of->spectrum[k] += front->above[k] * smooth[k + 1];
    }
}

static float measured_on(const variable *of, const float *spectrum)
{
    size_t n = of->stop - of->first;
    float total;
    if (!n)
        return 0;
    if (of->kind == MAXIMUM)
        return greatest_of(spectrum + of->first, n);
    total = sum_of(spectrum + of->first, n);
    return of->kind == MEAN ? total / (float)n : total;
}

/* Measure the variables of one spectrum. */
static void measure_variables(ear *of, uint32_t source, const float *spectrum)
{
    const front_end *front = &of->model->front;
    size_t k;
    for (k = 0; k < front->n_variables; k++)
        if (front->variables[k].what == BAND && front->variables[k].source == source)
            of->values[k] = measured_on(&front->variables[k], spectrum);
}

/* The runtime does not measure the pitch: it reads 0, as NOTHING. */
static float measured_on_window(uint32_t what, const float *window, float level)
{
    switch (what) {
    case ZERO_CROSSINGS:
        return zero_crossings_of(window);
    case VOLUME:
        return level;
    default:
        return 0;
    }
}

static void measure_whole_frame(ear *of, const float *window, float level)
{
    const front_end *front = &of->model->front;
    size_t k;
    for (k = 0; k < front->n_variables; k++)
        if (front->variables[k].what != BAND)
            of->values[k] = measured_on_window(front->variables[k].what, window, level);
}

static void divide_all(float *values, size_t n, float by)
{
    const float least = 1e-37f; /* so that silence stays 0 */
    size_t k;
    by = by > least ? by : least;
    for (k = 0; k < n; k++)
        values[k] /= by;
}

static void measure_mel(ear *of)
{
    const front_end *front = &of->model->front;
    size_t k;
    for (k = 0; k < front->n_mel; k++)
        of->mel[k] = of->work.by->dot(of->spectrum + front->mel[k].first, front->mel[k].weights, front->mel[k].n);
    if (front->normalises)
        divide_all(of->mel, front->n_mel, greatest_of(of->mel, front->n_mel));
    measure_variables(of, MEL, of->mel);
}

static void divide_variables(ear *of)
{
    const front_end *front = &of->model->front;
    const float faintest = 1e-6f;
    size_t k;
    for (k = 0; k < front->n_variables; k++)
        if (front->variables[k].per >= 0) {
            float by = of->values[front->variables[k].per];
            of->values[k] /= by > faintest ? by : faintest;
        }
}

static void measure_frame(ear *of, const float *window, float level)
{
    const front_end *front = &of->model->front;
    float peak;
    size_t k;
    /* Each source of variables is measured at its place on the way: what is filtered before denoising and normalising
     * take its level away, the mel bands after denoising, what is normalised at the end. The peak before denoising is
     * the one after it, or nothing was left. */
    measure_magnitudes(of, window);
    shape_spectrum(of);
    measure_whole_frame(of, window, level);
    measure_variables(of, FILTERED, of->spectrum);
    peak = greatest_of(of->spectrum, front->n_bins);
    for (k = 0; front->denoise > 0 && k < front->n_bins; k++)
        of->spectrum[k] = of->spectrum[k] >= front->denoise ? of->spectrum[k] : 0;
    measure_mel(of);
    if (front->normalises)
        divide_all(of->spectrum, front->n_bins, peak);
    measure_variables(of, NORMALISED, of->spectrum);
    if (front->needs_raw) {
        for (k = 0; k < front->n_bins; k++)
            of->magnitudes[k] *= front->scale[k];
        measure_variables(of, RAW, of->magnitudes);
    }
    divide_variables(of);
}

/* ------------------------------------------------------------------------------------------------------------------
 * Rules: the first whose comparisons all hold names the phoneme
 * ---------------------------------------------------------------------------------------------------------------- */

/* By how much a comparison holds, and below 0 by how much it does not. Limits have the sign of the comparison. */
static float margin_of(const ear *of, uint32_t number)
{
    const condition *asked = &of->model->rules.conditions[number];
    return asked->sign * of->values[asked->variable] - asked->limit;
}

static uint32_t ask_rules(const ear *of)
{
    const rules *all = &of->model->rules;
    size_t k, c;
    for (k = 0; k < all->n_rules; k++) {
        for (c = 0; c < all->rules[k].n && margin_of(of, all->rules[k].conditions[c]) > 0; c++)
            ;
        if (c == all->rules[k].n)
            return all->rules[k].phoneme;
    }
    return EAR_UNIDENTIFIED;
}

/* By how much, as a share of them, limits would have to give way for each phoneme to be named by the rules. */
static void deficits_by_rules(const ear *of, float *deficits)
{
    const rules *all = &of->model->rules;
    /* A rule is as strong as its weakest comparison. To be named, its own comparisons must be made to hold, and the
     * strongest rule before it to fail; the greater of both is the cost. */
    float in_the_way = -HUGE_VALF;
    size_t k, c;
    for (k = 0; k < EAR_PHONEMES; k++)
        deficits[k] = HUGE_VALF;
    for (k = 0; k < all->n_rules; k++) {
        const rule *here = &all->rules[k];
        float strength = HUGE_VALF, cost;
        for (c = 0; c < here->n; c++) {
            float limit = fabsf(all->conditions[here->conditions[c]].limit);
            float share = margin_of(of, here->conditions[c]) / (limit > 1e-9f ? limit : 1e-9f);
            strength = share < strength ? share : strength;
        }
        cost = -strength > 0 ? -strength : 0;
        cost = cost > in_the_way ? cost : in_the_way;
        if (cost < deficits[here->phoneme])
            deficits[here->phoneme] = cost;
        in_the_way = strength > in_the_way ? strength : in_the_way;
    }
}

/* How far a phoneme is from giving way to another one, 0..1; 0.5 and below where another one is named. */
static float separation_of(const float *deficits, size_t phoneme)
{
    float nearest = HUGE_VALF, apart;
    size_t k;
    for (k = 0; k < EAR_PHONEMES; k++)
        if (k != phoneme && deficits[k] < nearest)
            nearest = deficits[k];
    apart = nearest - deficits[phoneme];
    if (apart == HUGE_VALF || apart == -HUGE_VALF)
        return apart > 0 ? 1 : 0;
    return 0.5f + 0.5f * apart / (1 + fabsf(apart));
}

/* ------------------------------------------------------------------------------------------------------------------
 * Templates: the phoneme whose mean cepstra are nearest; silence by level
 * ---------------------------------------------------------------------------------------------------------------- */

/* How fast a phoneme becomes unlikely with the squared distance, and silence with the level, dB. */
static const float SOFTNESS = 3.0f, RAMP = 1.5f;

static float limited(float value, float least, float most)
{
    return value < least ? least : value > most ? most : value;
}

static float squared_distance(const float *one, const float *other)
{
    float sum = 0;
    size_t k;
    for (k = 0; k < CEPSTRA; k++)
        sum += (one[k] - other[k]) * (one[k] - other[k]);
    return sum;
}

static void ask_templates(ear *of, const float *window, float *scores)
{
    const templates *known = &of->model->templates;
    float bands[BANDS], place[CEPSTRA], likenesses[EAR_PHONEMES], total = 0, loud;
    size_t k;
    measure_log_mels(of, window, bands);
    for (k = 0; k < CEPSTRA; k++)
        place[k] = of->work.by->dot(bands, known->cosines + k * BANDS, BANDS) * known->scale[k];
    /* distances count in spreads of each cepstrum: Mahalanobis's, with a diagonal covariance */
    for (k = 0; k < known->n; k++)
        likenesses[k] = -squared_distance(place, known->means + k * CEPSTRA) / SOFTNESS;
    soften(likenesses, known->n);
    /* powers of bands are added, not their decibels */
    for (k = 0; k < BANDS; k++)
        total += (float)exp(2.302585092994046 * bands[k]); /* 10 to that power */
    loud = 1 / (1 + expf(limited((known->silence_below - 10 * log10f(total)) / RAMP, -60, 60)));
    for (k = 0; k < EAR_PHONEMES; k++)
        scores[k] = 0;
    for (k = 0; k < known->n; k++)
        scores[known->phonemes[k]] = likenesses[k] * loud;
    scores[EAR_SILENCE] = 1 - loud;
}

/* ------------------------------------------------------------------------------------------------------------------
 * What is said of a frame
 * ---------------------------------------------------------------------------------------------------------------- */

static void apply_sensitivities(const ear_model *model, float *scores)
{
    float total = 0;
    size_t k;
    if (!model->has_sensitivities)
        return;
    for (k = 0; k < EAR_PHONEMES; k++)
        total += scores[k] *= model->factors[k];
    for (k = 0; k < EAR_PHONEMES; k++)
        scores[k] /= total;
}

static float deficit_of(const ear *of, uint32_t phoneme, const float *scores)
{
    float deficits[EAR_PHONEMES];
    if (of->model->recogniser == BY_RULES) {
        deficits_by_rules(of, deficits);
        return deficits[phoneme];
    }
    return scores[likeliest(scores, EAR_PHONEMES)] - scores[phoneme];
}

/* Hysteresis, the least time of a phoneme, and what follows it where nothing was recognised. */
static uint32_t calmed(ear *of, uint32_t raw, const float *scores)
{
    const ear_model *model = of->model;
    calming *calm = &of->calm;
    uint32_t wanted;
    if (!model->is_calmed)
        return raw;
    if (model->hysteresis > 0) {
        /* what stands stays while it is nearly as good as what is named */
        if (raw != calm->steady && !(deficit_of(of, calm->steady, scores) <= model->hysteresis))
            calm->steady = raw;
        raw = calm->steady;
    }
    if (raw != EAR_UNIDENTIFIED)
        calm->identified = raw;
    /* where nothing was identified: what likely follows the phoneme that was identified last */
    wanted = raw == EAR_UNIDENTIFIED ? model->successors[calm->identified] : raw;
    if (wanted != calm->current && calm->held >= model->least_hold) {
        calm->current = wanted;
        calm->held = 0;
    }
    calm->held += calm->held < UINT32_MAX;
    return calm->current;
}

/* Go on with the search by an answer of the rules; returns the phoneme of the frame `look_ahead` before. */
static uint32_t searched(ear *of, uint32_t answer)
{
    const decoder *by = &of->model->decoder;
    uint32_t look_ahead = of->model->look_ahead;
    int32_t next[EAR_PHONEMES] = {0}, past;
    size_t i, j, best = 0;
    for (i = 0; i < by->n; i++) { /* the phoneme of the frame before joins the past, and the oldest one leaves */
        past = (int32_t)((uint32_t)of->courses[i] % PAST);
        of->courses[i] -= past;
        of->courses[i] += (int32_t)(((uint32_t)past << 4 | by->phonemes[i]) % PAST);
    }
    for (j = 0; j < by->n; j++) {
        next[j] = of->courses[j];
        for (i = 0; i < by->n; i++) {
            int32_t entered = of->courses[i] - by->costs[i][j] * PAST;
            next[j] = entered > next[j] ? entered : next[j];
        }
        next[j] -= by->against[j][answer] * PAST;
        best = next[j] > next[best] ? j : best;
    }
    past = (int32_t)((uint32_t)next[best] % PAST);
    for (j = 0; j < by->n; j++) /* relative to the best one, so that numbers stay small */
        of->courses[j] = next[j] - (next[best] - past);
    return look_ahead ? (uint32_t)past >> 4 * (look_ahead - 1) & 15 : by->phonemes[best];
}

/* By how much another viseme of the same phoneme must be likelier to follow. */
static const float VISEME_MARGIN = 0.2f;

static int32_t followed_viseme(ear *of, int phoneme, const float *visemes)
{
    const viseme_set *set = &of->model->visemes;
    int best = -1, k;
    if (of->model->recogniser != BY_NETWORK || !of->model->net.n_visemes)
        return (int32_t)set->usual[phoneme];
    for (k = 0; (size_t)k < set->n; k++)
        if (set->allowed[phoneme] & BIT(k) && (best < 0 || visemes[k] > visemes[best]))
            best = k;
    if (phoneme != of->viseme_phoneme || visemes[best] > visemes[of->viseme] + VISEME_MARGIN) {
        of->viseme_phoneme = phoneme;
        of->viseme = best;
    }
    return of->viseme;
}

/* The share of answers with this score that are right; on straight lines between the points of the curve. */
static float confidence_of(const ear_model *model, double score)
{
    const float *x = model->curve_scores, *y = model->curve_shares;
    size_t n = model->n_points, k;
    if (!n)
        return NAN;
    if (score <= x[0])
        return y[0];
    for (k = 1; k < n; k++)
        if (score < x[k])
            return (float)(y[k - 1] + (score - x[k - 1]) * ((double)y[k] - y[k - 1]) / ((double)x[k] - x[k - 1]));
    return y[n - 1];
}

static float intensity_of(const ear_model *model, float level, int phoneme)
{
    float loud = level * model->gain, intensity;
    if (phoneme == EAR_SILENCE)
        return 0;
    intensity = log10f(loud > 1 ? loud : 1) * model->slope;
    return intensity < 1 ? intensity : 1;
}

/* Measure a window; returns whether a frame became known, which lies `look_ahead` frames before. */
static int hear_window(ear *of, const float *window, ear_frame *frame)
{
    const ear_model *model = of->model;
    float *visemes = frame->viseme_scores, level = peak_of(window), *deficits = of->deficits[of->level_at];
    uint32_t raw;
    memset(frame, 0, sizeof *frame);
    /* A ring of look_ahead + 1 levels: an answer is about a frame that lies so far back, and so is its loudness. */
    of->levels[of->level_at] = level;
    of->level_at = (of->level_at + 1) % (model->look_ahead + 1);
    if (model->recogniser == BY_NETWORK) {
        if (!ask_network(of, window, frame->scores, visemes))
            return 0;
    } else if (model->recogniser == BY_TEMPLATES)
        ask_templates(of, window, frame->scores);
    else
        measure_frame(of, window, level);
    if (model->recogniser != BY_RULES)
        apply_sensitivities(model, frame->scores);
    raw = model->recogniser == BY_RULES ? ask_rules(of) : (uint32_t)likeliest(frame->scores, EAR_PHONEMES);
    if (model->recogniser == BY_RULES && model->n_points)
        deficits_by_rules(of, deficits);
    if (model->decoder.n) {
        raw = searched(of, of->is_over ? EAR_PHONEMES : raw);
        if (of->n_early) {
            of->n_early--;
            return 0;
        }
    }
    frame->number = of->next++;
    frame->phoneme = (int32_t)calmed(of, raw, frame->scores);
    frame->viseme = followed_viseme(of, frame->phoneme, visemes);
    if (model->recogniser != BY_RULES)
        frame->confidence = confidence_of(model, frame->scores[frame->phoneme]);
    else
        frame->confidence = confidence_of(model, separation_of(of->deficits[of->level_at], (size_t)frame->phoneme));
    frame->intensity = intensity_of(model, of->levels[of->level_at], frame->phoneme);
    return 1;
}

/* ------------------------------------------------------------------------------------------------------------------
 * The recogniser: samples become frames
 * ---------------------------------------------------------------------------------------------------------------- */

/* What may come in: beyond the one nothing is sound, and below the other arithmetic may be slow. */
static const float LOUDEST = 1e6f, FAINTEST = 1e-20f;

static void make_clean(float *samples, size_t n)
{
    size_t k;
    for (k = 0; k < n; k++) {
        /* NaN fails both comparisons and becomes silence; numbers near 0 would become subnormal in products, on which
         * many processors are far slower */
        float level = fabsf(samples[k]);
        samples[k] = level <= LOUDEST && level >= FAINTEST ? samples[k] : 0;
    }
}

/* Where frames are given: `given` of `most`. */
typedef struct {
    ear_frame *frames;
    size_t given, most;
} output;

/* Write a frame in the size that the program knows. */
static void write_frame(const ear *of, const ear_frame *frame, void *frames, size_t at)
{
    size_t known = of->frame_size < sizeof *frame ? of->frame_size : sizeof *frame;
    unsigned char *place = (unsigned char *)frames + at * of->frame_size;
    memcpy(place, frame, known);
    memset(place + known, 0, of->frame_size - known);
}

static void hear_and_give(ear *of, const float *window, output *to)
{
    ear_frame frame;
    if (hear_window(of, window, &frame) && to->given < to->most)
        write_frame(of, &frame, to->frames, to->given++);
}

/* Recognise the window once it is full, and go on to the next one. */
static void hear_full_window(ear *of, output *to)
{
    if (of->filled < WINDOW)
        return;
    hear_and_give(of, of->window, to);
    of->n_framed++;
    of->filled -= HOP;
    memmove(of->window, of->window + HOP, of->filled * sizeof *of->window);
}

/* Take samples at 44.1 kHz. */
static void take_samples(ear *of, const float *samples, size_t n, output *to)
{
    of->n_received += n;
    while (n) {
        size_t room = WINDOW - of->filled, now = n < room ? n : room;
        memcpy(of->window + of->filled, samples, now * sizeof *samples);
        make_clean(of->window + of->filled, now);
        of->filled += now;
        samples += now;
        n -= now;
        hear_full_window(of, to);
    }
}

/* Give what the resampler has ready. */
static void take_resampled(ear *of, output *to, uint64_t most_out)
{
    float ready[CHUNK];
    size_t n = 0;
    while (of->resampler.n_out < most_out && resample(&of->resampler, &ready[n]))
        if (++n == CHUNK) {
            take_samples(of, ready, n, to);
            n = 0;
        }
    take_samples(of, ready, n, to);
}

static void resample_and_take(ear *of, const float *samples, size_t n, output *to)
{
    float clean[CHUNK];
    while (n) {
        size_t now = n < CHUNK ? n : CHUNK, taken = 0;
        memcpy(clean, samples, now * sizeof *samples);
        make_clean(clean, now);
        while (taken < now) {
            taken += feed_resampler(&of->resampler, clean + taken, now - taken);
            take_resampled(of, to, UINT64_MAX);
        }
        samples += now;
        n -= now;
    }
}

static int check_push(ear *of, const void *samples, size_t n, const output *to, size_t *n_frames)
{
    if (n_frames)
        *n_frames = 0;
    if (!of || !n_frames || (n && !samples) || (to->most && !to->frames))
        return EAR_BAD_ARGUMENT;
    return n > SIZE_MAX / 100 || to->most < EAR_MOST_FRAMES(n, of->resampler.rate) ? EAR_TOO_FEW_FRAMES : EAR_OK;
}

static void take_at_any_rate(ear *of, const float *samples, size_t n, output *to)
{
    (of->resamples ? resample_and_take : take_samples)(of, samples, n, to);
}

int ear_push(ear *of, const float *samples, size_t n, ear_frame *frames, size_t most, size_t *n_frames)
{
    output to = {frames, 0, most};
    int result = check_push(of, samples, n, &to, n_frames);
    if (result != EAR_OK)
        return result;
    take_at_any_rate(of, samples, n, &to);
    *n_frames = to.given;
    return EAR_OK;
}

/* Recognise the mean of interleaved channels, of which either floats or int16 are given. */
static int push_mean(
    ear *of, const float *floats, const int16_t *whole, size_t n, unsigned channels, output *to, size_t *n_frames
)
{
    const float full = 1.0f / 32768;
    float mono[CHUNK];
    size_t at, k, now;
    unsigned c;
    int result = check_push(of, floats ? (const void *)floats : (const void *)whole, n, to, n_frames);
    if (result != EAR_OK)
        return result;
    if (channels < 1 || channels > MOST_CHANNELS_IN)
        return EAR_BAD_ARGUMENT;
    for (at = 0; at < n; at += now) {
        now = n - at < CHUNK ? n - at : CHUNK;
        for (k = 0; k < now; k++) {
            const size_t first = (at + k) * channels;
            float sum = 0;
            for (c = 0; c < channels; c++)
                sum += floats ? floats[first + c] : (float)whole[first + c] * full;
            mono[k] = sum / (float)channels;
        }
        take_at_any_rate(of, mono, now, to);
    }
    *n_frames = to->given;
    return EAR_OK;
}

int ear_push_channels(
    ear *of, const float *samples, size_t n, unsigned channels, ear_frame *frames, size_t most, size_t *n_frames
)
{
    output to = {frames, 0, most};
    return push_mean(of, samples, NULL, n, channels, &to, n_frames);
}

int ear_push_int16(
    ear *of, const int16_t *samples, size_t n, unsigned channels, ear_frame *frames, size_t most, size_t *n_frames
)
{
    output to = {frames, 0, most};
    return push_mean(of, NULL, samples, n, channels, &to, n_frames);
}

/* Give the samples that the resampler still holds: as many as the sound has at 44.1 kHz. */
static void finish_resampling(ear *of, output *to)
{
    static const float SILENCE[CHUNK] = {0};
    resampler *from = &of->resampler;
    /* n_in * 44100 / rate, rounded up, in two parts so that 64 bits are enough for any length */
    uint64_t n_all = (from->n_in / from->rate) * RATE + (from->n_in % from->rate * RATE + from->rate - 1) / from->rate;
    while (from->n_out < n_all) {
        feed_resampler(from, SILENCE, CHUNK);
        take_resampled(of, to, n_all);
    }
}

/* Recognise the frames that reach beyond the end of the sound, as if silence followed. */
static void finish_frames(ear *of, output *to)
{
    /* every 10 ms that a sample lies in has a frame; silence fills their windows */
    uint64_t n_all = (of->n_received + HOP - 1) / HOP;
    while (of->n_framed < n_all) {
        memset(of->window + of->filled, 0, (WINDOW - of->filled) * sizeof *of->window);
        of->filled = WINDOW;
        hear_full_window(of, to);
    }
}

int ear_finish(ear *of, ear_frame *frames, size_t most, size_t *n_frames)
{
    output to = {frames, 0, most};
    size_t k;
    if (n_frames)
        *n_frames = 0;
    if (!of || !n_frames || (most && !frames))
        return EAR_BAD_ARGUMENT;
    if (most < EAR_LAST_FRAMES)
        return EAR_TOO_FEW_FRAMES;
    if (of->resamples)
        finish_resampling(of, &to);
    finish_frames(of, &to);
    memset(of->window, 0, WINDOW * sizeof *of->window);
    of->is_over = 1;
    for (k = 0; k < of->model->look_ahead; k++)
        hear_and_give(of, of->window, &to);
    *n_frames = to.given;
    ear_reset(of);
    return EAR_OK;
}

/* ------------------------------------------------------------------------------------------------------------------
 * Mouth tables
 * ---------------------------------------------------------------------------------------------------------------- */

static const mouth_table *table_of(const ear_model *model, int table)
{
    return table >= 0 && (size_t)table < model->n_tables ? model->tables[table] : NULL;
}

static const mouth_entry *entry_of(const mouth_table *table, int phoneme, int viseme)
{
    size_t sound = phoneme >= 0 && phoneme < EAR_PHONEMES ? (size_t)phoneme : EAR_UNIDENTIFIED;
    size_t none = table->n_looks - 1, look = viseme >= 0 && (size_t)viseme < none ? (size_t)viseme : none;
    return &table->entries[sound * table->n_looks + look];
}

int ear_table_count(const ear_model *model)
{
    return (int)model->n_tables;
}

int ear_table_find(const ear_model *model, const char *name)
{
    size_t k;
    for (k = 0; k < model->n_tables; k++)
        if (strcmp(model->tables[k]->name, name) == 0)
            return (int)k;
    return -1;
}

const char *ear_table_name(const ear_model *model, int table)
{
    const mouth_table *known = table_of(model, table);
    return known ? known->name : "";
}

int ear_table_movestates(const ear_model *model, int table)
{
    const mouth_table *known = table_of(model, table);
    return known ? (int)known->n_movestates : 0;
}

const char *ear_table_movestate(const ear_model *model, int table, int movestate)
{
    const mouth_table *known = table_of(model, table);
    return known && movestate >= 0 && (size_t)movestate < known->n_movestates ? known->movestates[movestate] : "";
}

int ear_table_shapes(const ear_model *model, int table)
{
    const mouth_table *known = table_of(model, table);
    return known ? (int)known->n_shapes : 0;
}

int ear_table_shape(const ear_model *model, int table, int phoneme, int viseme)
{
    const mouth_table *known = table_of(model, table);
    return known ? (int)entry_of(known, phoneme, viseme)->shape : -1;
}

const char *ear_table_shape_name(const ear_model *model, int table, int shape)
{
    const mouth_table *known = table_of(model, table);
    return known && shape >= 0 && (size_t)shape < known->n_shapes ? known->shapes[shape] : "";
}

static void add_shape(const mouth_table *table, const mouth_entry *entry, float share, float gain, float *weights)
{
    const float *row = table->rows + entry->row * table->n_movestates;
    size_t k;
    share *= entry->closes ? 1 : gain;
    for (k = 0; k < table->n_movestates; k++)
        weights[k] += share * row[k];
}

/* The first phoneme that a viseme may show. */
static int phoneme_of(const viseme_set *set, int viseme)
{
    int phoneme = 0;
    while (phoneme < EAR_PHONEMES && !(set->allowed[phoneme] & BIT(viseme)))
        phoneme++;
    return phoneme < EAR_PHONEMES ? phoneme : EAR_UNIDENTIFIED;
}

int ear_table_blend(const ear_model *model, int table, const ear_frame *frame, float *weights)
{
    const mouth_table *known = model ? table_of(model, table) : NULL;
    float gain;
    int k;
    if (!model || !frame || (known && known->n_movestates && !weights))
        return EAR_BAD_ARGUMENT;
    if (!known)
        return EAR_NO_TABLE;
    gain = (float)known->minimum_opening + (1 - (float)known->minimum_opening) * frame->intensity;
    for (k = 0; (size_t)k < known->n_movestates; k++)
        weights[k] = 0;
    if (model->recogniser == BY_NETWORK && model->net.n_visemes)
        for (k = 0; (size_t)k < model->visemes.n; k++) {
            const mouth_entry *entry = entry_of(known, phoneme_of(&model->visemes, k), k);
            add_shape(known, entry, frame->viseme_scores[k], gain, weights);
        }
    else if (model->recogniser != BY_RULES)
        for (k = 0; k < EAR_PHONEMES; k++)
            add_shape(known, entry_of(known, k, EAR_NO_VISEME), frame->scores[k], gain, weights);
    else
        add_shape(known, entry_of(known, frame->phoneme, EAR_NO_VISEME), 1, gain, weights);
    return EAR_OK;
}

/* ------------------------------------------------------------------------------------------------------------------
 * The mouth: each sound begins a movement along half a cosine, laid over those that still go on
 * ---------------------------------------------------------------------------------------------------------------- */

enum { TWISTER = 624 };

/* The Mersenne Twister MT19937 (M. Matsumoto and T. Nishimura, 1998), as Python's random has it. */
typedef struct {
    uint32_t state[TWISTER];
    size_t at;
} chance;

typedef struct {
    double start, duration, share;
    uint32_t row;
    int is_whole; /* full whatever the loudness */
} movement;

struct ear_mouth {
    const mouth_table *table;
    void *owned;
    chance chance;
    float *rows;
    movement movements[MOVEMENTS]; /* the oldest first */
    size_t n_movements;
    const mouth_entry *said;
    double loud_at, loudness, loud_target;
};

static void seed_chance(chance *of, uint32_t seed)
{
    uint32_t *state = of->state;
    size_t i = 1, k;
    /* init_by_array of the authors, with the seed as its only word, as Python seeds: the same seed moves both mouths
     * alike */
    state[0] = 19650218u;
    for (k = 1; k < TWISTER; k++)
        state[k] = 1812433253u * (state[k - 1] ^ state[k - 1] >> 30) + (uint32_t)k;
    for (k = 0; k < TWISTER; k++) {
        state[i] = (state[i] ^ (state[i - 1] ^ state[i - 1] >> 30) * 1664525u) + seed;
        if (++i == TWISTER) {
            state[0] = state[TWISTER - 1];
            i = 1;
        }
    }
    for (k = 0; k < TWISTER - 1; k++) {
        state[i] = (state[i] ^ (state[i - 1] ^ state[i - 1] >> 30) * 1566083941u) - (uint32_t)i;
        if (++i == TWISTER) {
            state[0] = state[TWISTER - 1];
            i = 1;
        }
    }
    state[0] = 0x80000000u;
    of->at = TWISTER;
}

static void renew_chance(chance *of)
{
    uint32_t *state = of->state;
    size_t k;
    for (k = 0; k < TWISTER; k++) {
        /* the recurrence over 624 and 397 words, and the matrix whose last row is 0x9908b0df */
        uint32_t bits = (state[k] & 0x80000000u) | (state[(k + 1) % TWISTER] & 0x7fffffffu);
        state[k] = state[(k + 397) % TWISTER] ^ bits >> 1 ^ (bits & 1 ? 0x9908b0dfu : 0);
    }
    of->at = 0;
}

static uint32_t draw_bits(chance *of)
{
    uint32_t bits;
    if (of->at == TWISTER)
        renew_chance(of);
    bits = of->state[of->at++];
    /* tempering: spreads each bit over the word */
    bits ^= bits >> 11;
    bits ^= bits << 7 & 0x9d2c5680u;
    bits ^= bits << 15 & 0xefc60000u;
    return bits ^ bits >> 18;
}

static double draw_within(chance *of, double low, double high)
{
    /* 53 random bits, as many as a double has: 27 times 2^26 and 26 */
    uint32_t most = draw_bits(of) >> 5, least = draw_bits(of) >> 6;
    return low + (high - low) * ((most * 67108864.0 + least) / 9007199254740992.0);
}

/* Write the shapes with the habits of one mouth; lips that meet do so in every mouth. */
static void make_rows(ear_mouth *of)
{
    const mouth_table *table = of->table;
    size_t n = table->n_movestates, row, k;
    float habits[MOST_MOVESTATES];
    for (k = 0; k < n; k++)
        habits[k] = (float)draw_within(&of->chance, -table->randomness, 0);
    for (k = 0; k < n; k++) { /* alike on both sides: a habit is no paralysis */
        float left = habits[table->left_of[k]];
        habits[k] = left + (habits[k] - left) / 4;
    }
    for (row = 0; row < table->n_rows; row++)
        for (k = 0; k < n; k++)
            of->rows[row * n + k] = table->rows[row * n + k] * (table->is_loose[row] ? 1 + habits[k] : 1);
}

static void lay_out_mouth(arena *memory, ear_mouth *made)
{
    take(memory, 1, sizeof *made);
    made->rows = take_floats(memory, made->table->n_rows * made->table->n_movestates);
}

static int begin_mouth(const ear_model *model, int table, ear_mouth *made)
{
    if (!model)
        return EAR_BAD_ARGUMENT;
    memset(made, 0, sizeof *made);
    made->table = table_of(model, table);
    return made->table ? EAR_OK : EAR_NO_TABLE;
}

int ear_mouth_size(const ear_model *model, int table, size_t *size)
{
    arena counting = {NULL, 0};
    ear_mouth counted;
    int result = size ? begin_mouth(model, table, &counted) : EAR_BAD_ARGUMENT;
    if (result != EAR_OK)
        return result;
    lay_out_mouth(&counting, &counted);
    *size = size_of(&counting);
    return EAR_OK;
}

int ear_mouth_open(
    const ear_model *model, int table, uint32_t seed, void *memory, size_t size, ear_mouth **mouth
)
{
    arena laid;
    ear_mouth made;
    size_t needed;
    void *owned;
    int result;
    if (!mouth)
        return EAR_BAD_ARGUMENT;
    *mouth = NULL;
    result = begin_mouth(model, table, &made);
    if (result == EAR_OK)
        result = ear_mouth_size(model, table, &needed);
    if (result == EAR_OK)
        result = begin_arena(&laid, memory, size, needed, &owned);
    if (result != EAR_OK)
        return result;
    made.owned = owned;
    lay_out_mouth(&laid, &made);
    seed_chance(&made.chance, seed);
    make_rows(&made);
    made.movements[0].start = -HUGE_VAL;
    made.movements[0].share = 1;
    made.movements[0].row = EAR_SILENCE;
    made.movements[0].is_whole = 1;
    made.n_movements = 1;
    made.said = entry_of(made.table, EAR_SILENCE, EAR_NO_VISEME);
    *mouth = (ear_mouth *)laid.base;
    **mouth = made;
    return EAR_OK;
}

void ear_mouth_close(ear_mouth *mouth)
{
    if (mouth)
        free(mouth->owned);
}

/* The loudness follows by the exact answer of a low pass of first order. */
static double loudness_at(const ear_mouth *of, double time)
{
    /* x(t) = target + (x0 - target) exp(-t / constant): right for any step, so the mouth moves alike at any frame
     * rate */
    double passed = time > of->loud_at ? time - of->loud_at : 0, constant = of->table->loudness;
    if (constant <= 0 || of->loudness == of->loud_target)
        return of->loud_target;
    return of->loud_target + (of->loudness - of->loud_target) * exp(-passed / constant);
}

static void set_loudness(ear_mouth *of, double time, double target)
{
    if (target == of->loud_target)
        return;
    of->loudness = loudness_at(of, time);
    of->loud_at = time;
    of->loud_target = target;
}

static void begin_movement(ear_mouth *of, double time, int phoneme, const mouth_entry *entry)
{
    double spread = of->table->randomness;
    double vary_time = draw_within(&of->chance, -spread, spread), vary_shape = draw_within(&of->chance, -2 * spread, 0);
    int closes = phoneme == EAR_SILENCE || entry->closes;
    movement *next;
    if (of->n_movements == MOVEMENTS)
        memmove(of->movements, of->movements + 1, --of->n_movements * sizeof *of->movements);
    next = &of->movements[of->n_movements++];
    next->start = time;
    next->duration = phoneme == EAR_SILENCE ? of->said->to_rest : entry->to_shape;
    next->duration *= closes ? 1 : 1 + vary_time;
    next->row = entry->row;
    next->is_whole = closes;
    next->share = closes ? 1 : 1 + vary_shape;
}

void ear_mouth_hear(ear_mouth *of, double time, int phoneme, int viseme, float intensity)
{
    const mouth_entry *entry = entry_of(of->table, phoneme, viseme);
    set_loudness(of, time, intensity > 0 ? intensity < 1 ? (double)intensity : 1.0 : 0.0);
    if (entry->row != of->said->row)
        begin_movement(of, time, phoneme, entry);
    of->said = entry;
}

void ear_mouth_weights(ear_mouth *of, double time, float *weights)
{
    const mouth_table *table = of->table;
    double gain = table->minimum_opening + (1 - table->minimum_opening) * loudness_at(of, time), left = 1;
    size_t n = table->n_movestates, at = of->n_movements, oldest = at, k;
    for (k = 0; k < n; k++)
        weights[k] = 0;
    /* From the newest movement to the oldest: each covers what is under it by the share to which it has come, half a
     * cosine from 0 to 1, so that speed is 0 at both ends. One that is through covers all, and what lies below has
     * ended. */
    while (at-- && left > 0) {
        const movement *here = &of->movements[at];
        double progress = here->duration > 0 ? (time - here->start) / here->duration : 1;
        double ease = progress >= 1 ? 1 : 0.5 - 0.5 * cos(PI * progress);
        float share;
        if (!(progress > 0))
            continue;
        share = (float)(left * ease * (here->is_whole ? here->share : here->share * gain));
        for (k = 0; k < n; k++)
            weights[k] += share * of->rows[here->row * n + k];
        left *= 1 - ease;
        oldest = at;
    }
    if (oldest < of->n_movements) { /* what has ended by now is forgotten */
        of->n_movements -= oldest;
        memmove(of->movements, of->movements + oldest, of->n_movements * sizeof *of->movements);
    }
}
