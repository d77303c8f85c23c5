/*
 * Packet clamp.
 * Source: Karpenko et al. 2023, fig. 9.
 * Written by mechc 0.0.0. SI units and radians.
 */
#include "clamp.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#if defined(__FAST_MATH__) || defined(_M_FP_FAST) || __FINITE_MATH_ONLY__ + 0
#ifndef MECHC_ALLOW_FAST_MATH
#error "NaN says where there is no pose: leave out -ffast-math, or define MECHC_ALLOW_FAST_MATH"
#endif
#endif

#define MECHC_PI 3.14159265358979323846

/*
 * sin(x + half*pi) for a half of 0.0 or 0.5, where the sine or the cosine of an angle is asked
 * for alone: the angle is reduced by half turns, and one polynomial serves. Its coefficients are
 * the best ones up to pi/2 (Remez's exchange, 2^-61); within 2.5 ulp, and NaN beyond 2^20 rad.
 */
static inline double mechc_sine(double x, double half)
{
    const double shifter = 6755399441055744.0; /* 1.5*2^52: the sum's last bit counts half turns */
    const double shifted = (half > 0.0 ? x*3.18309886183790671538e-01 + half : x*3.18309886183790671538e-01) + shifter;
    const double turns = shifted - shifter - half;
    const double beyond = x*1.71e302; /* infinite beyond 2^20, and infinity less itself is NaN */
    const double r = x - turns*3.14159265346825122834e+00 - turns*1.21542010126079319572e-10
        - (turns*4.04453249759190126308e-21 + (beyond - beyond));
    const double z = r*r, zz = z*z;
    const double s = r + z*r*(-1.66666666666666655691e-01 + z*8.33333333333319424042e-03
        + zz*(-1.98412698412091939515e-04 + z*2.75573192111328434194e-06
        + zz*(-2.50521068723907040075e-08 + z*1.60589396849816868426e-10
        + zz*(-7.64299093942738370811e-13 + z*2.72116911226383240937e-15))));
    uint64_t count, bits;
    double result;
    memcpy(&count, &shifted, sizeof count);
    memcpy(&bits, &s, sizeof bits);
    bits ^= count << 63; /* each half turn changes the sign */
    memcpy(&result, &bits, sizeof result);
    return result;
}

static inline double mechc_sin(double x)
{
    return mechc_sine(x, 0.0);
}

static inline double mechc_cos(double x)
{
    return mechc_sine(x, 0.5);
}

/* A number whose first bit is 1 where the value is NaN: without a comparison, for vector code. */
static inline uint64_t mechc_nan(double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    return 0x7ff0000000000000u - (bits & 0x7fffffffffffffffu);
}

/* The value where left < right, else NaN (all bits ones): by the sign, without a branch. */
static inline double mechc_if_less(double left, double right, double value)
{
    const double gap = left - right + 0.0; /* no zero is negative */
    uint64_t sign, bits;
    memcpy(&sign, &gap, sizeof sign);
    memcpy(&bits, &value, sizeof bits);
    bits |= (sign >> 63) - 1u;
    memcpy(&value, &bits, sizeof value);
    return value + (gap - gap);
}

double packet_clamp_k(double a, double b, double alpha, double beta)
{
    if (!(alpha + beta < MECHC_PI/2.0)) {
        return NAN;
    }
    return a*sin(alpha + beta)/(2.0*b*cos(alpha)*cos(beta));
}

static inline double packet_clamp_k_quick(double a, double b, double alpha, double beta)
{
    return mechc_if_less(alpha + beta, MECHC_PI/2.0, a*mechc_sin(alpha + beta)/(2.0*b*mechc_cos(alpha)*mechc_cos(beta)));
}

void packet_clamp_k_n(
    size_t n,
    const double *MECHC_RESTRICT a,
    const double *MECHC_RESTRICT b,
    const double *MECHC_RESTRICT alpha,
    const double *MECHC_RESTRICT beta,
    double *MECHC_RESTRICT k)
{
    size_t start, stop, i;
    for (start = 0; start < n; start = stop) {
        stop = n - start > 512 ? start + 512 : n;
        uint64_t missing = 0;
        for (i = start; i < stop; ++i) {
            const double value = packet_clamp_k_quick(a[i], b[i], alpha[i], beta[i]);
            missing |= mechc_nan(value);
            k[i] = value;
        }
        for (i = missing >> 63 ? start : stop; i < stop; ++i) {
            if (k[i] != k[i]) {
                k[i] = packet_clamp_k(a[i], b[i], alpha[i], beta[i]);
            }
        }
    }
}

const packet_clamp_parameters packet_clamp_defaults = {
    0.1, /* a */
    0.25, /* b */
    0.20943951023931953, /* alpha */
    0.12217304763960307 /* beta */
};

double packet_clamp_k_of(const packet_clamp_parameters *p)
{
    return packet_clamp_k(p->a, p->b, p->alpha, p->beta);
}

void packet_clamp_k_n_of(
    size_t n,
    const packet_clamp_parameters *MECHC_RESTRICT p,
    double *MECHC_RESTRICT k)
{
    for (size_t i = 0; i < n; ++i) {
        k[i] = packet_clamp_k_of(p + i);
    }
}
