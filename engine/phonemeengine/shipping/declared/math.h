/* SPDX-License-Identifier: MIT */
#define HUGE_VAL __builtin_huge_val()
#define HUGE_VALF __builtin_huge_valf()
#define NAN __builtin_nanf("")
double ceil(double), cos(double), exp(double), fabs(double), log(double), sin(double), sqrt(double);
float expf(float), fabsf(float), log10f(float), sqrtf(float);
