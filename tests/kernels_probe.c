/*
 * Compares what ear_kernels.h has for this processor with its plain C99: the same bits where it claims so, else sums
 * that differ by roundings. Prints a line for each, and returns 1 where one differs by more.
 */
#include "ear_kernels.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { MOST = 1 << 14, OUTPUTS = 3 * 96 };

static const float TOLERANCE = 2e-6f; /* of the sum of absolute products */

static float a[MOST], b[MOST], one[MOST], other[MOST], more_one[MOST], more_other[MOST];
static int failed;

static void fill(float *values, size_t n, unsigned seed)
{
    size_t k;
    for (k = 0; k < n; k++) {
        seed = seed * 1664525u + 1013904223u;
        values[k] = (float)(seed >> 8) / (1 << 23) - 1;
    }
}

static void compare(const kernels *tried, const char *what, size_t n, float scale)
{
    float worst = 0;
    size_t k;
    for (k = 0; k < n; k++)
        worst = fabsf(one[k] - other[k]) > worst ? fabsf(one[k] - other[k]) : worst;
    if (tried->is_exact ? memcmp(one, other, n * sizeof *one) != 0 : !(worst <= TOLERANCE * scale)) {
        printf("%s %s differs by %g\n", tried->name, what, (double)worst);
        failed = 1;
    }
}

static void try_sums(const kernels *tried)
{
    const float shares[ROWS] = {-0.0625f, 0.5625f, 0.5625f, -0.0625f};
    size_t n;
    for (n = 0; n < 300; n++) {
        one[0] = PLAIN_KERNELS.dot(a, b + n, n);
        other[0] = tried->dot(a, b + n, n);
        compare(tried, "dot", 1, (float)n + 1);
        one[0] = PLAIN_KERNELS.blend(a + 1, b, n, shares);
        other[0] = tried->blend(a + 1, b, n, shares);
        compare(tried, "blend", 1, (float)n + 1);
    }
}

static void try_convolutions(const kernels *tried)
{
    static const size_t SIZES[][2] = {{1, 1}, {3, 33}, {2, 7}, {3, 48}}; /* taps, inputs */
    const float *taps[TAPS] = {a, a + 1000, a + 500};
    size_t k, lanes;
    for (k = 0; k < sizeof SIZES / sizeof *SIZES; k++)
        for (lanes = 1; lanes <= LANES_AT_ONCE; lanes++) {
            const product of = {b, a + 5000, SIZES[k][0], SIZES[k][1], 3};
            memset(one, 0, sizeof one);
            memset(other, 0, sizeof other);
            PLAIN_KERNELS.convolve[lanes - 1](&of, taps, 64, one, 96);
            tried->convolve[lanes - 1](&of, taps, 64, other, 96);
            compare(tried, "convolution", OUTPUTS, (float)(SIZES[k][0] * SIZES[k][1] + 1));
            PLAIN_KERNELS.rectify(one, k % 2 ? a : NULL, 96);
            tried->rectify(other, k % 2 ? a : NULL, 96);
            compare(tried, "rectified", OUTPUTS, (float)(SIZES[k][0] * SIZES[k][1] + 1));
        }
}

static void try_passes(const kernels *tried)
{
    size_t stride;
    for (stride = 1; stride <= 64; stride *= 4) {
        const size_t m = 256 / 4 / stride;
        PLAIN_KERNELS.pass_of_4(a, b, one, more_one, m, stride, a + 300, b + 300, stride);
        tried->pass_of_4(a, b, other, more_other, m, stride, a + 300, b + 300, stride);
        compare(tried, "real part", 256, 8);
        memcpy(one, more_one, sizeof one);
        memcpy(other, more_other, sizeof other);
        compare(tried, "imaginary part", 256, 8);
    }
}

static void try_all(const kernels *tried)
{
    try_sums(tried);
    try_convolutions(tried);
    try_passes(tried);
    printf("%s %s\n", tried->name, tried->is_exact ? "to the last bit" : "but for roundings");
}

int main(void)
{
    fill(a, MOST, 1);
    fill(b, MOST, 2);
    try_all(&PLAIN_KERNELS);
#ifdef V4
    try_all(&KERNELS_OF_4);
#endif
    if (strcmp(fastest_kernels()->name, "AVX2") == 0)
        try_all(fastest_kernels());
    return failed;
}
