/* SPDX-License-Identifier: MIT */
/*
 * The sums in which nearly all time is spent: plain C99, which is the reference, and the same by hand for NEON, SSE2,
 * WebAssembly and AVX2. ear.c includes this file; programs need only ear.h. EAR_PLAIN, if defined, leaves vectors out,
 * and EAR_NO_AVX2 those of eight.
 *
 * Four at a time, SSE2 and WebAssembly add in the order of the reference, to the last bit. NEON and AVX2 multiply and
 * add in one rounding, so their results differ by roundings.
 *
 * Everything is written out, since compilers unroll loops only at -O3, and keep arrays of sums in memory otherwise.
 */
#ifndef EAR_KERNELS_H
#define EAR_KERNELS_H

#include <stddef.h>

enum {
    TILE = 32, /* outputs of a layer whose weights lie side by side */
    TAPS = 3,
    PARTS = 8, /* in which a sum is kept */
    ROWS = 4,  /* of `blend` */
    LANES_AT_ONCE = 3
};

/*
 * The convolution of a layer at one frame, for some lanes (vocal tracts) at once: out = bias + the weighted sum of the
 * values at its taps. Weights lie in tiles of 32 outputs, all inputs of all taps one after the other, so they are
 * read in one go, once for all lanes.
 */
typedef struct {
    const float *weights, *bias;
    size_t n_taps, n_in, n_tiles;
} product;

typedef void convolution(const product *of, const float *const *taps, size_t width_in, float *out, size_t width_out);

/* One way to compute. */
typedef struct {
    const char *name;
    int is_exact; /* to the last bit as the reference */
    float (*dot)(const float *a, const float *b, size_t n);
    float (*blend)(const float *values, const float *rows, size_t n, const float *shares); /* with ROWS rows of n */
    void (*pass_of_4)(
        const float *xr, const float *xi, float *yr, float *yi, size_t m, size_t stride, const float *cosines,
        const float *sines, size_t turn
    );
    convolution *convolve[LANES_AT_ONCE]; /* by lanes */
    void (*rectify)(float *values, const float *added, size_t n); /* then add, unless that is NULL; n: whole tiles */
} kernels;

/* -- Plain C99: constant counts and local sums, of which compilers make vectors by themselves. -- */

static float sum_of_parts(const float *parts)
{
    return ((parts[0] + parts[4]) + (parts[1] + parts[5])) + ((parts[2] + parts[6]) + (parts[3] + parts[7]));
}

/* One running sum would wait for each addition before the next; eight independent ones fill a vector or the pipeline,
 * and round less. C forbids compilers to reorder a sum by themselves. */
static float dot_plain(const float *a, const float *b, size_t n)
{
    float parts[PARTS] = {0}, rest = 0;
    size_t k, j;
    for (k = 0; k + PARTS <= n; k += PARTS)
        for (j = 0; j < PARTS; j++)
            parts[j] += a[k + j] * b[k + j];
    for (; k < n; k++)
        rest += a[k] * b[k];
    return sum_of_parts(parts) + rest;
}

/* The dot products with four rows that lie one after the other, each by its share. */
static float blend_plain(const float *values, const float *rows, size_t n, const float *shares)
{
    float sum = 0;
    size_t row;
    for (row = 0; row < ROWS; row++)
        sum += shares[row] * dot_plain(values, rows + row * n, n);
    return sum;
}

#define EACH_OF_1(what) what(0)
#define EACH_OF_2(what) what(0) what(1)
#define EACH_OF_3(what) what(0) what(1) what(2)

#define PLAIN_SUMS(l) float sums##l[TILE];
#define PLAIN_BEGIN(l) sums##l[j] = of->bias[tile * TILE + j];
#define PLAIN_VALUES(l) const float a##l = values[l * width_in + k], b##l = values[l * width_in + k + 1];
#define PLAIN_ADD(l) sums##l[j] = (sums##l[j] + w[j] * a##l) + w[TILE + j] * b##l;
#define PLAIN_ADD_ONE(l) sums##l[j] += w[j] * values[l * width_in + k];
#define PLAIN_END(l) out[l * width_out + tile * TILE + j] = sums##l[j];

/* Two inputs for each time that sums are read and written. */
#define DEFINE_PLAIN_CONVOLUTION(NAME, EACH)                                                                            \
    static void NAME(                                                                                                   \
        const product *of, const float *const *taps, size_t width_in, float *out, size_t width_out                      \
    )                                                                                                                   \
    {                                                                                                                   \
        const float *w = of->weights;                                                                                   \
        size_t tile, tap, k, j;                                                                                         \
        (void)width_in;                                                                                                 \
        (void)width_out;                                                                                                \
        for (tile = 0; tile < of->n_tiles; tile++) {                                                                    \
            EACH(PLAIN_SUMS)                                                                                            \
            for (j = 0; j < TILE; j++) {                                                                                \
                EACH(PLAIN_BEGIN)                                                                                       \
            }                                                                                                           \
            for (tap = 0; tap < of->n_taps; tap++) {                                                                    \
                const float *values = taps[tap];                                                                        \
                for (k = 0; k + 2 <= of->n_in; k += 2, w += 2 * TILE) {                                                 \
                    EACH(PLAIN_VALUES)                                                                                  \
                    for (j = 0; j < TILE; j++) {                                                                        \
                        EACH(PLAIN_ADD)                                                                                 \
                    }                                                                                                   \
                }                                                                                                       \
                for (; k < of->n_in; k++, w += TILE)                                                                    \
                    for (j = 0; j < TILE; j++) {                                                                        \
                        EACH(PLAIN_ADD_ONE)                                                                             \
                    }                                                                                                   \
            }                                                                                                           \
            for (j = 0; j < TILE; j++) {                                                                                \
                EACH(PLAIN_END)                                                                                         \
            }                                                                                                           \
        }                                                                                                               \
    }

DEFINE_PLAIN_CONVOLUTION(convolve_1_plain, EACH_OF_1)
DEFINE_PLAIN_CONVOLUTION(convolve_2_plain, EACH_OF_2)
DEFINE_PLAIN_CONVOLUTION(convolve_3_plain, EACH_OF_3)

/* In place: the transform of the four values a, b, c, d, turned by exp(-2 pi i p / 4m) and its powers. */
#define TURN(V, ADD, SUB, MUL, of_r, of_i, c, s)                                                                        \
    {                                                                                                                   \
        const V turned = ADD(MUL(of_r, c), MUL(of_i, s));                                                               \
        of_i = SUB(MUL(of_i, c), MUL(of_r, s));                                                                         \
        of_r = turned;                                                                                                  \
    }

#define TRANSFORM_FOUR(V, ADD, SUB, MUL)                                                                                \
    {                                                                                                                   \
        const V sum_r = ADD(a_r, c_r), sum_i = ADD(a_i, c_i), odd_r = ADD(b_r, d_r), odd_i = ADD(b_i, d_i);             \
        const V difference_r = SUB(a_r, c_r), difference_i = SUB(a_i, c_i);                                             \
        const V turned_r = SUB(d_i, b_i), turned_i = SUB(b_r, d_r); /* i times the difference of b and d */             \
        a_r = ADD(sum_r, odd_r), a_i = ADD(sum_i, odd_i);                                                               \
        b_r = SUB(difference_r, turned_r), b_i = SUB(difference_i, turned_i);                                           \
        c_r = SUB(sum_r, odd_r), c_i = SUB(sum_i, odd_i);                                                               \
        d_r = ADD(difference_r, turned_r), d_i = ADD(difference_i, turned_i);                                           \
        TURN(V, ADD, SUB, MUL, b_r, b_i, c1, s1)                                                                        \
        TURN(V, ADD, SUB, MUL, c_r, c_i, c2, s2)                                                                        \
        TURN(V, ADD, SUB, MUL, d_r, d_i, c3, s3)                                                                        \
    }

#define LOAD_FOUR(V, LOAD, apart)                                                                                       \
    V a_r = LOAD(from_r), b_r = LOAD(from_r + (apart)), c_r = LOAD(from_r + 2 * (apart)), d_r = LOAD(from_r + 3 * (apart));\
    V a_i = LOAD(from_i), b_i = LOAD(from_i + (apart)), c_i = LOAD(from_i + 2 * (apart)), d_i = LOAD(from_i + 3 * (apart));

/*
 * One pass of Stockham's Fourier transform: `stride` transforms of length 4 m each lie interleaved, and twiddles are
 * `turn` values apart. It reads one array and writes another, so nothing is reordered by reversed bits; the inner loop
 * runs over neighbouring values. Radix 4 passes over memory half as often as radix 2, and to multiply by i is to
 * exchange parts.
 *
 * V is a value or a vector of WIDTH values, with what adds, subtracts, multiplies, reads, writes and repeats it.
 */
#define DEFINE_PASS(NAME, V, WIDTH, LOAD, STORE, SPLAT, ADD, SUB, MUL)                                                  \
    static void NAME(                                                                                                   \
        const float *xr, const float *xi, float *yr, float *yi, size_t m, size_t stride, const float *cosines,          \
        const float *sines, size_t turn                                                                                 \
    )                                                                                                                   \
    {                                                                                                                   \
        size_t p, q;                                                                                                    \
        for (p = 0; p < m; p++) {                                                                                       \
            const V c1 = SPLAT(cosines[p * turn]), s1 = SPLAT(sines[p * turn]);                                         \
            const V c2 = SPLAT(cosines[2 * p * turn]), s2 = SPLAT(sines[2 * p * turn]);                                 \
            const V c3 = SPLAT(cosines[3 * p * turn]), s3 = SPLAT(sines[3 * p * turn]);                                 \
            for (q = 0; q < stride; q += WIDTH) {                                                                       \
                const float *from_r = xr + stride * p + q, *from_i = xi + stride * p + q;                               \
                float *to_r = yr + 4 * stride * p + q, *to_i = yi + 4 * stride * p + q;                                 \
                LOAD_FOUR(V, LOAD, stride * m)                                                                          \
                TRANSFORM_FOUR(V, ADD, SUB, MUL)                                                                        \
                STORE(to_r, a_r), STORE(to_r + stride, b_r), STORE(to_r + 2 * stride, c_r), STORE(to_r + 3 * stride, d_r);\
                STORE(to_i, a_i), STORE(to_i + stride, b_i), STORE(to_i + 2 * stride, c_i), STORE(to_i + 3 * stride, d_i);\
            }                                                                                                           \
        }                                                                                                               \
    }

#define V1_LOAD(place) (*(place))
#define V1_STORE(place, value) (*(place) = (value))
#define V1_SPLAT(value) (value)
#define V1_ADD(a, b) ((a) + (b))
#define V1_SUB(a, b) ((a) - (b))
#define V1_MUL(a, b) ((a) * (b))

DEFINE_PASS(pass_of_4_plain, float, 1, V1_LOAD, V1_STORE, V1_SPLAT, V1_ADD, V1_SUB, V1_MUL)

static void rectify_plain(float *values, const float *added, size_t n)
{
    size_t k;
    for (k = 0; k < n; k++)
        values[k] = (values[k] > 0 ? values[k] : 0) + (added ? added[k] : 0);
}

static const kernels PLAIN_KERNELS = {
    "plain", 1, dot_plain, blend_plain, pass_of_4_plain, {convolve_1_plain, convolve_2_plain, convolve_3_plain},
    rectify_plain,
};

/* -- Vectors. A convolution keeps the sums of some vectors for each lane in registers from the first input to the
 * last, and a weight that was loaded serves all lanes, so three vocal tracts cost less than three times one. -- */

#define DEFINE_CONVOLUTION(NAME, TARGET, EACH, BEGIN, VALUE, ADD, END, DONE, WIDTH)                                     \
    TARGET static void NAME(                                                                                            \
        const product *of, const float *const *taps, size_t width_in, float *out, size_t width_out                      \
    )                                                                                                                   \
    {                                                                                                                   \
        size_t at, tap, k;                                                                                              \
        (void)width_in;                                                                                                 \
        (void)width_out;                                                                                                \
        for (at = 0; at < of->n_tiles * TILE; at += 4 * WIDTH) {                                                        \
            const float *weights = of->weights + at / TILE * of->n_taps * of->n_in * TILE + at % TILE;                  \
            const float *bias = of->bias + at;                                                                          \
            float *to = out + at;                                                                                       \
            EACH(BEGIN)                                                                                                 \
            for (tap = 0; tap < of->n_taps; tap++) {                                                                    \
                const float *values = taps[tap];                                                                        \
                for (k = 0; k < of->n_in; k++, weights += TILE) {                                                       \
                    EACH(VALUE)                                                                                         \
                    ADD(EACH)                                                                                           \
                }                                                                                                       \
            }                                                                                                           \
            EACH(END)                                                                                                   \
        DONE                                                                                                            \
    }                                                                                                               \
    }

#if defined(EAR_PLAIN)
#elif defined(__aarch64__) || defined(_M_ARM64)
#include <arm_neon.h>
#define V4_NAME "NEON"
#define V4_IS_EXACT 0
#define V4 float32x4_t
#define V4_LOAD(place) vld1q_f32(place)
#define V4_STORE(place, value) vst1q_f32(place, value)
#define V4_SPLAT(value) vdupq_n_f32(value)
#define V4_ADD(a, b) vaddq_f32(a, b)
#define V4_SUB(a, b) vsubq_f32(a, b)
#define V4_MUL(a, b) vmulq_f32(a, b)
#define V4_MULTIPLY_ADD(sum, a, b) vfmaq_f32(sum, a, b)
#define V4_SET(a, b, c, d) four_of(a, b, c, d)
#define V4_LOW(a, b) vzip1q_f32(a, b)
#define V4_HIGH(a, b) vzip2q_f32(a, b)
#define V4_RECTIFY(value) vmaxnmq_f32(value, vdupq_n_f32(0))
static float32x4_t four_of(float a, float b, float c, float d)
{
    const float values[4] = {a, b, c, d};
    return vld1q_f32(values); /* MSVC has no other way */
}
#elif defined(__SSE2__) || defined(_M_X64)
#include <immintrin.h>
#define V4_NAME "SSE2"
#define V4_IS_EXACT 1
#define V4 __m128
#define V4_LOAD(place) _mm_loadu_ps(place)
#define V4_STORE(place, value) _mm_storeu_ps(place, value)
#define V4_SPLAT(value) _mm_set1_ps(value)
#define V4_ADD(a, b) _mm_add_ps(a, b)
#define V4_SUB(a, b) _mm_sub_ps(a, b)
#define V4_MUL(a, b) _mm_mul_ps(a, b)
#define V4_MULTIPLY_ADD(sum, a, b) _mm_add_ps(sum, _mm_mul_ps(a, b))
#define V4_SET(a, b, c, d) _mm_setr_ps(a, b, c, d)
#define V4_LOW(a, b) _mm_unpacklo_ps(a, b)
#define V4_HIGH(a, b) _mm_unpackhi_ps(a, b)
#define V4_RECTIFY(value) _mm_max_ps(value, _mm_setzero_ps())
#elif defined(__wasm_simd128__)
#include <wasm_simd128.h>
#define V4_NAME "WebAssembly"
#define V4_IS_EXACT 1
#define V4 v128_t
#define V4_LOAD(place) wasm_v128_load(place)
#define V4_STORE(place, value) wasm_v128_store(place, value)
#define V4_SPLAT(value) wasm_f32x4_splat(value)
#define V4_ADD(a, b) wasm_f32x4_add(a, b)
#define V4_SUB(a, b) wasm_f32x4_sub(a, b)
#define V4_MUL(a, b) wasm_f32x4_mul(a, b)
#define V4_MULTIPLY_ADD(sum, a, b) wasm_f32x4_add(sum, wasm_f32x4_mul(a, b))
#define V4_SET(a, b, c, d) wasm_f32x4_make(a, b, c, d)
#define V4_LOW(a, b) wasm_i32x4_shuffle(a, b, 0, 4, 1, 5)
#define V4_HIGH(a, b) wasm_i32x4_shuffle(a, b, 2, 6, 3, 7)
#define V4_RECTIFY(value) wasm_f32x4_pmax(wasm_f32x4_splat(0), value)
#endif

#ifdef V4
static float sum_of_4(V4 low, V4 high)
{
    float sums[4];
    V4_STORE(sums, V4_ADD(low, high));
    return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

static float dot_4(const float *a, const float *b, size_t n)
{
    V4 low = V4_SPLAT(0), high = low;
    float rest = 0;
    size_t k;
    for (k = 0; k + PARTS <= n; k += PARTS) {
        low = V4_MULTIPLY_ADD(low, V4_LOAD(a + k), V4_LOAD(b + k));
        high = V4_MULTIPLY_ADD(high, V4_LOAD(a + k + 4), V4_LOAD(b + k + 4));
    }
    for (; k < n; k++)
        rest += a[k] * b[k];
    return sum_of_4(low, high) + rest;
}

#define V4_EACH_ROW(what) what(0) what(1) what(2) what(3)
#define V4_ROW_BEGIN(j) V4 low##j = V4_SPLAT(0), high##j = low##j;                                                      \
    float rest##j = 0;
#define V4_ROW_ADD(j)                                                                                                   \
    low##j = V4_MULTIPLY_ADD(low##j, x, V4_LOAD(rows + j * n + k));                                                     \
    high##j = V4_MULTIPLY_ADD(high##j, y, V4_LOAD(rows + j * n + k + 4));
#define V4_ROW_REST(j) rest##j += values[k] * rows[j * n + k];
#define V4_ROW_END(j) sum += shares[j] * (sum_of_4(low##j, high##j) + rest##j);

static float blend_4(const float *values, const float *rows, size_t n, const float *shares)
{
    float sum = 0;
    size_t k;
    V4_EACH_ROW(V4_ROW_BEGIN)
    for (k = 0; k + PARTS <= n; k += PARTS) {
        const V4 x = V4_LOAD(values + k), y = V4_LOAD(values + k + 4);
        V4_EACH_ROW(V4_ROW_ADD)
    }
    for (; k < n; k++) {
        V4_EACH_ROW(V4_ROW_REST)
    }
    V4_EACH_ROW(V4_ROW_END)
    return sum;
}

DEFINE_PASS(pass_of_4_wide, V4, 4, V4_LOAD, V4_STORE, V4_SPLAT, V4_ADD, V4_SUB, V4_MUL)

#define V4_EVERY(at, step) V4_SET((at)[0], (at)[step], (at)[2 * (step)], (at)[3 * (step)])
#define V4_STORE_MIXED(to, a, b, c, d)                                                                                  \
    {                                                                                                                   \
        const V4 ac = V4_LOW(a, c), bd = V4_LOW(b, d), ac_high = V4_HIGH(a, c), bd_high = V4_HIGH(b, d);                \
        V4_STORE(to, V4_LOW(ac, bd));                                                                                   \
        V4_STORE(to + 4, V4_HIGH(ac, bd));                                                                              \
        V4_STORE(to + 8, V4_LOW(ac_high, bd_high));                                                                     \
        V4_STORE(to + 12, V4_HIGH(ac_high, bd_high));                                                                   \
    }

/* The first pass, whose stride is 1: four values of p at once; m is a multiple of 4. */
static void first_pass_of_4(
    const float *xr, const float *xi, float *yr, float *yi, size_t m, const float *cosines, const float *sines,
    size_t turn
)
{
    size_t p;
    for (p = 0; p < m; p += 4) {
        const float *c = cosines + p * turn, *s = sines + p * turn, *from_r = xr + p, *from_i = xi + p;
        const V4 c1 = V4_EVERY(c, turn), s1 = V4_EVERY(s, turn);
        const V4 c2 = V4_EVERY(c + p * turn, 2 * turn), s2 = V4_EVERY(s + p * turn, 2 * turn);
        const V4 c3 = V4_EVERY(c + 2 * p * turn, 3 * turn), s3 = V4_EVERY(s + 2 * p * turn, 3 * turn);
        LOAD_FOUR(V4, V4_LOAD, m)
        TRANSFORM_FOUR(V4, V4_ADD, V4_SUB, V4_MUL)
        V4_STORE_MIXED(yr + 4 * p, a_r, b_r, c_r, d_r)
        V4_STORE_MIXED(yi + 4 * p, a_i, b_i, c_i, d_i)
    }
}

static void pass_of_4_4(
    const float *xr, const float *xi, float *yr, float *yi, size_t m, size_t stride, const float *cosines,
    const float *sines, size_t turn
)
{
    if (stride == 1)
        first_pass_of_4(xr, xi, yr, yi, m, cosines, sines, turn);
    else
        pass_of_4_wide(xr, xi, yr, yi, m, stride, cosines, sines, turn);
}

#define V4_VALUE(l) const V4 x##l = V4_SPLAT(values[l * width_in + k]);
#define V4_ADD_0(l) s##l##0 = V4_MULTIPLY_ADD(s##l##0, w0, x##l);
#define V4_ADD_1(l) s##l##1 = V4_MULTIPLY_ADD(s##l##1, w1, x##l);
/* Sums of four vectors for each of three lanes; of two where browsers would keep the others in memory. */
#ifdef __wasm_simd128__
#define V4_AT_ONCE 2
#define V4_BEGIN(l)                                                                                                     \
    V4 s##l##0 = V4_LOAD(bias), s##l##1 = V4_LOAD(bias + 4);
#define V4_ADD_ALL(EACH)                                                                                                \
    const V4 w0 = V4_LOAD(weights), w1 = V4_LOAD(weights + 4);                                                          \
    EACH(V4_ADD_0) EACH(V4_ADD_1)
#define V4_END(l)                                                                                                       \
    V4_STORE(to + l * width_out, s##l##0);                                                                              \
    V4_STORE(to + l * width_out + 4, s##l##1);
#else
#define V4_AT_ONCE 4
#define V4_BEGIN(l)                                                                                                     \
    V4 s##l##0 = V4_LOAD(bias), s##l##1 = V4_LOAD(bias + 4), s##l##2 = V4_LOAD(bias + 8), s##l##3 = V4_LOAD(bias + 12);
#define V4_ADD_2(l) s##l##2 = V4_MULTIPLY_ADD(s##l##2, w2, x##l);
#define V4_ADD_3(l) s##l##3 = V4_MULTIPLY_ADD(s##l##3, w3, x##l);
#define V4_ADD_ALL(EACH)                                                                                                \
    const V4 w0 = V4_LOAD(weights), w1 = V4_LOAD(weights + 4), w2 = V4_LOAD(weights + 8), w3 = V4_LOAD(weights + 12);   \
    EACH(V4_ADD_0) EACH(V4_ADD_1) EACH(V4_ADD_2) EACH(V4_ADD_3)
#define V4_END(l)                                                                                                       \
    V4_STORE(to + l * width_out, s##l##0);                                                                              \
    V4_STORE(to + l * width_out + 4, s##l##1);                                                                          \
    V4_STORE(to + l * width_out + 8, s##l##2);                                                                          \
    V4_STORE(to + l * width_out + 12, s##l##3);
#endif

DEFINE_CONVOLUTION(convolve_1_4, , EACH_OF_1, V4_BEGIN, V4_VALUE, V4_ADD_ALL, V4_END, , V4_AT_ONCE)
DEFINE_CONVOLUTION(convolve_2_4, , EACH_OF_2, V4_BEGIN, V4_VALUE, V4_ADD_ALL, V4_END, , V4_AT_ONCE)
DEFINE_CONVOLUTION(convolve_3_4, , EACH_OF_3, V4_BEGIN, V4_VALUE, V4_ADD_ALL, V4_END, , V4_AT_ONCE)

static void rectify_4(float *values, const float *added, size_t n)
{
    size_t k;
    for (k = 0; k < n; k += 4) {
        const V4 value = V4_LOAD(values + k);
        V4_STORE(values + k, added ? V4_ADD(V4_RECTIFY(value), V4_LOAD(added + k)) : V4_RECTIFY(value));
    }
}

static const kernels KERNELS_OF_4 = {
    V4_NAME, V4_IS_EXACT, dot_4, blend_4, pass_of_4_4, {convolve_1_4, convolve_2_4, convolve_3_4}, rectify_4,
};
#endif

#if !defined(EAR_PLAIN) && !defined(EAR_NO_AVX2) && (defined(__x86_64__) || defined(_M_X64))
#define HAS_AVX2_CODE 1
#if defined(_MSC_VER) && !defined(__clang__)
#include <intrin.h>
#define AVX2_TARGET
#else
#include <cpuid.h>
#ifdef _MSC_VER /* clang-cl, whose immintrin.h leaves out what it was not told to compile for */
#include <pmmintrin.h>
#include <avxintrin.h>
#include <fmaintrin.h>
#endif
#define AVX2_TARGET __attribute__((target("avx2,fma")))
#endif

#define V8_LOAD(place) _mm256_loadu_ps(place)
#define V8_MULTIPLY_ADD(sum, a, b) _mm256_fmadd_ps(a, b, sum)

AVX2_TARGET static float sum_of_8(__m256 values)
{
    __m128 sums = _mm_add_ps(_mm256_castps256_ps128(values), _mm256_extractf128_ps(values, 1));
    sums = _mm_hadd_ps(sums, sums);
    return _mm_cvtss_f32(_mm_hadd_ps(sums, sums));
}

AVX2_TARGET static float dot_8(const float *a, const float *b, size_t n)
{
    __m256 s0 = _mm256_setzero_ps(), s1 = s0, s2 = s0, s3 = s0;
    float rest = 0;
    size_t k;
    for (k = 0; k + 32 <= n; k += 32) {
        s0 = V8_MULTIPLY_ADD(s0, V8_LOAD(a + k), V8_LOAD(b + k));
        s1 = V8_MULTIPLY_ADD(s1, V8_LOAD(a + k + 8), V8_LOAD(b + k + 8));
        s2 = V8_MULTIPLY_ADD(s2, V8_LOAD(a + k + 16), V8_LOAD(b + k + 16));
        s3 = V8_MULTIPLY_ADD(s3, V8_LOAD(a + k + 24), V8_LOAD(b + k + 24));
    }
    for (; k + 8 <= n; k += 8)
        s0 = V8_MULTIPLY_ADD(s0, V8_LOAD(a + k), V8_LOAD(b + k));
    for (; k < n; k++)
        rest += a[k] * b[k];
    rest += sum_of_8(_mm256_add_ps(_mm256_add_ps(s0, s1), _mm256_add_ps(s2, s3)));
    _mm256_zeroupper();
    return rest;
}

AVX2_TARGET static float blend_8(const float *values, const float *rows, size_t n, const float *shares)
{
    __m256 s0 = _mm256_setzero_ps(), s1 = s0, s2 = s0, s3 = s0;
    const float *r1 = rows + n, *r2 = r1 + n, *r3 = r2 + n;
    float rest = 0;
    size_t k;
    for (k = 0; k + 8 <= n; k += 8) {
        const __m256 x = V8_LOAD(values + k);
        s0 = V8_MULTIPLY_ADD(s0, x, V8_LOAD(rows + k));
        s1 = V8_MULTIPLY_ADD(s1, x, V8_LOAD(r1 + k));
        s2 = V8_MULTIPLY_ADD(s2, x, V8_LOAD(r2 + k));
        s3 = V8_MULTIPLY_ADD(s3, x, V8_LOAD(r3 + k));
    }
    for (; k < n; k++)
        rest += values[k] * (shares[0] * rows[k] + shares[1] * r1[k] + shares[2] * r2[k] + shares[3] * r3[k]);
    s0 = _mm256_mul_ps(s0, _mm256_set1_ps(shares[0]));
    s1 = V8_MULTIPLY_ADD(s0, s1, _mm256_set1_ps(shares[1]));
    s2 = V8_MULTIPLY_ADD(s1, s2, _mm256_set1_ps(shares[2]));
    rest += sum_of_8(V8_MULTIPLY_ADD(s2, s3, _mm256_set1_ps(shares[3])));
    _mm256_zeroupper(); /* GCC forgets it at -Os, and then all that follows is slow */
    return rest;
}

#define V8_BEGIN(l)                                                                                                     \
    __m256 s##l##0 = V8_LOAD(bias), s##l##1 = V8_LOAD(bias + 8), s##l##2 = V8_LOAD(bias + 16);                          \
    __m256 s##l##3 = V8_LOAD(bias + 24);
#define V8_VALUE(l) const __m256 x##l = _mm256_set1_ps(values[l * width_in + k]);
#define V8_ADD_0(l) s##l##0 = V8_MULTIPLY_ADD(s##l##0, w0, x##l);
#define V8_ADD_1(l) s##l##1 = V8_MULTIPLY_ADD(s##l##1, w1, x##l);
#define V8_ADD_2(l) s##l##2 = V8_MULTIPLY_ADD(s##l##2, w2, x##l);
#define V8_ADD_3(l) s##l##3 = V8_MULTIPLY_ADD(s##l##3, w3, x##l);
#define V8_ADD_ALL(EACH)                                                                                                \
    const __m256 w0 = V8_LOAD(weights), w1 = V8_LOAD(weights + 8), w2 = V8_LOAD(weights + 16);                          \
    const __m256 w3 = V8_LOAD(weights + 24);                                                                            \
    EACH(V8_ADD_0) EACH(V8_ADD_1) EACH(V8_ADD_2) EACH(V8_ADD_3)
#define V8_END(l)                                                                                                       \
    _mm256_storeu_ps(to + l * width_out, s##l##0);                                                                      \
    _mm256_storeu_ps(to + l * width_out + 8, s##l##1);                                                                  \
    _mm256_storeu_ps(to + l * width_out + 16, s##l##2);                                                                 \
    _mm256_storeu_ps(to + l * width_out + 24, s##l##3);

DEFINE_CONVOLUTION(convolve_1_8, AVX2_TARGET, EACH_OF_1, V8_BEGIN, V8_VALUE, V8_ADD_ALL, V8_END, _mm256_zeroupper();, 8)
DEFINE_CONVOLUTION(convolve_2_8, AVX2_TARGET, EACH_OF_2, V8_BEGIN, V8_VALUE, V8_ADD_ALL, V8_END, _mm256_zeroupper();, 8)
DEFINE_CONVOLUTION(convolve_3_8, AVX2_TARGET, EACH_OF_3, V8_BEGIN, V8_VALUE, V8_ADD_ALL, V8_END, _mm256_zeroupper();, 8)

static const kernels KERNELS_OF_8 = {
    "AVX2", 0, dot_8, blend_8, pass_of_4_4, {convolve_1_8, convolve_2_8, convolve_3_8}, rectify_4,
};

/* Return whether processor and system have AVX2 and FMA; Intel's manual, volume 1, 14.7.1. */
static int has_avx2(void)
{
    /* the processor has FMA, the system lets xgetbv be asked; then bits 1 and 2 of the answer: the system saves the
     * registers of SSE and AVX when it changes programs */
    const unsigned fma_and_saved = 1u << 12 | 1u << 27, avx2 = 1u << 5;
#if defined(_MSC_VER) && !defined(__clang__)
    int first[4], seventh[4];
    __cpuid(first, 0);
    if (first[0] < 7)
        return 0;
    __cpuid(first, 1);
    __cpuidex(seventh, 7, 0);
    return ((unsigned)first[2] & fma_and_saved) == fma_and_saved && (_xgetbv(0) & 6) == 6
        && ((unsigned)seventh[1] & avx2);
#else
    unsigned a, b, c, d, state, above;
    if (!__get_cpuid(1, &a, &b, &c, &d) || (c & fma_and_saved) != fma_and_saved)
        return 0;
    __asm__("xgetbv" : "=a"(state), "=d"(above) : "c"(0));
    (void)above;
    return (state & 6) == 6 && __get_cpuid_count(7, 0, &a, &b, &c, &d) && (b & avx2);
#endif
}
#endif

/* Give what this processor does fastest. */
static const kernels *fastest_kernels(void)
{
#ifdef HAS_AVX2_CODE
    if (has_avx2())
        return &KERNELS_OF_8;
#endif
#ifdef V4
    return &KERNELS_OF_4;
#else
    return &PLAIN_KERNELS;
#endif
}

#endif
