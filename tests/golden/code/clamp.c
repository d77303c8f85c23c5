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
 * sin(x + quarter*pi/2) without a branch, so that loops over it become vector code:
 * Cody and Waite's reduction in four parts and the polynomials of fdlibm (Sun
 * Microsystems, 1993), within 2.5 ulp. NaN beyond 2^20 rad, where the caller asks libm.
 */
static inline double mechc_circular(double x, uint64_t quarter)
{
    const double shifter = 6755399441055744.0; /* 1.5*2^52: the sum's last bits count quarters */
    const double shifted = x*6.36619772367581382433e-01 + shifter;
    const double turns = shifted - shifter;
    const double beyond = x*1.71e302; /* infinite beyond 2^20, and infinity less itself is NaN */
    const double r = x - turns*1.57079632673412561417e+00 - turns*6.07710050630396597660e-11
        - (turns*2.02226624871116645580e-21 + (turns*8.47842766036889956997e-32 + (beyond - beyond)));
    const double z = r*r, zz = z*z;
    const double s = r + z*r*(-1.66666666666666324348e-01 + z*8.33333333332248946124e-03
        + zz*(-1.98412698298579493134e-04 + z*2.75573137070700676789e-06
        + zz*(-2.50507602534068634195e-08 + z*1.58969099521155010221e-10)));
    const double c = 1.0 - 0.5*z + zz*(4.16666666666666019037e-02
        - z*1.38888888888741095749e-03 + zz*(2.48015872894767294178e-05
        - z*2.75573143513906633035e-07 + zz*(2.08757232129817482790e-09
        - z*1.13596475577881948265e-11)));
    uint64_t count, sine, cosine, chosen;
    double result;
    memcpy(&count, &shifted, sizeof count);
    memcpy(&sine, &s, sizeof sine);
    memcpy(&cosine, &c, sizeof cosine);
    chosen = quarter ? cosine : sine; /* the other one in odd quarters */
    chosen ^= (sine ^ cosine) & (0u - (count & 1u));
    chosen ^= ((count + quarter) & 2u) << 62;
    memcpy(&result, &chosen, sizeof result);
    return result;
}

static inline double mechc_sin(double x)
{
    return mechc_circular(x, 0u);
}

static inline double mechc_cos(double x)
{
    return mechc_circular(x, 1u);
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
