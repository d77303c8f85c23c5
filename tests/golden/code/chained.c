/*
 * chained.
 * Written by mechc 0.0.0. SI units and radians.
 */
#include "chained.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#if defined(__FAST_MATH__) || defined(_M_FP_FAST) || __FINITE_MATH_ONLY__ + 0
#ifndef MECHC_ALLOW_FAST_MATH
#error "NaN says where there is no pose: leave out -ffast-math, or define MECHC_ALLOW_FAST_MATH"
#endif
#endif

/* A root that leaves no trace of its failure but NaN: loops over it become vector code. */
#ifdef __GNUC__
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wredundant-decls"
#ifndef __cplusplus
double sqrt(double) __attribute__((const));
#elif defined(__GLIBC__)
extern "C" double sqrt(double) __THROW __attribute__((const));
#endif
#pragma GCC diagnostic pop
#endif

/*
 * sin(x + quarter*pi/2) without a branch, so that loops over it become vector code:
 * Cody and Waite's reduction in three parts and the polynomials of fdlibm (Sun
 * Microsystems, 1993), within 2.5 ulp. NaN beyond 2^20 rad, where the caller asks libm.
 * Sine and cosine of one angle share all but the last lines.
 */
static inline double mechc_circular(double x, uint64_t quarter)
{
    const double shifter = 6755399441055744.0; /* 1.5*2^52: the sum's last bits count quarters */
    const double shifted = x*6.36619772367581382433e-01 + shifter;
    const double turns = shifted - shifter;
    const double beyond = x*1.71e302; /* infinite beyond 2^20, and infinity less itself is NaN */
    const double r = x - turns*1.57079632673412561417e+00 - turns*6.07710050630396597660e-11
        - (turns*2.02226624879595063154e-21 + (beyond - beyond));
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

static inline double mechc_sin_of_pair(double x)
{
    return mechc_circular(x, 0u);
}

static inline double mechc_cos_of_pair(double x)
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

/* The value where left <= right, else NaN. */
static inline double mechc_if_no_more(double left, double right, double value)
{
    const double gap = right - left + 0.0;
    uint64_t sign, bits;
    memcpy(&sign, &gap, sizeof sign);
    memcpy(&bits, &value, sizeof bits);
    bits |= 0u - (sign >> 63);
    memcpy(&value, &bits, sizeof value);
    return value + (gap - gap);
}

double chained_k(double a, double b, double phi)
{
    const double sin_phi = sin(phi);
    const double p1 = a*sin_phi/b;
    const double theta = asin(p1);
    const double cos_phi = cos(phi);
    const double reach = a*cos_phi + cos_phi/sin_phi;
    const double t1 = sqrt((1.0 - p1)*(1.0 + p1));
    if (!(theta >= 0.0)) {
        return NAN;
    }
    return (sin_phi*t1 + cos_phi*p1)*reach*reach/t1 - 3.0*sin_phi*(cos_phi*t1 - p1*sin_phi)/cos_phi;
}

static inline double chained_k_quick(double a, double b, double phi)
{
    const double sin_phi = mechc_sin_of_pair(phi);
    const double p1 = a*sin_phi/b;
    const double theta = asin(p1);
    const double cos_phi = mechc_cos_of_pair(phi);
    const double reach = a*cos_phi + cos_phi/sin_phi;
    const double t1 = sqrt((1.0 - p1)*(1.0 + p1));
    return mechc_if_no_more(0.0, theta, (sin_phi*t1 + cos_phi*p1)*reach*reach/t1 - 3.0*sin_phi*(cos_phi*t1 - p1*sin_phi)/cos_phi);
}

void chained_k_n(
    size_t n,
    const double *MECHC_RESTRICT a,
    const double *MECHC_RESTRICT b,
    const double *MECHC_RESTRICT phi,
    double *MECHC_RESTRICT k)
{
    size_t start, stop, i;
    for (start = 0; start < n; start = stop) {
        stop = n - start > 512 ? start + 512 : n;
        uint64_t missing = 0;
        for (i = start; i < stop; ++i) {
            const double value = chained_k_quick(a[i], b[i], phi[i]);
            missing |= mechc_nan(value);
            k[i] = value;
        }
        for (i = missing >> 63 ? start : stop; i < stop; ++i) {
            if (k[i] != k[i]) {
                k[i] = chained_k(a[i], b[i], phi[i]);
            }
        }
    }
}

double chained_P(double a, double b, double phi, double m, double M)
{
    const double sin_phi = sin(phi);
    const double p1 = a*sin_phi/b;
    const double theta = asin(p1);
    const double cos_phi = cos(phi);
    const double reach = a*cos_phi + cos_phi/sin_phi;
    const double F = 10.0*m;
    const double t1 = sqrt((1.0 - p1)*(1.0 + p1));
    if (!(theta >= 0.0 && m > a)) {
        return NAN;
    }
    return ((sin_phi*t1 + cos_phi*p1)*reach*reach/t1 - 3.0*sin_phi*(cos_phi*t1 - p1*sin_phi)/cos_phi)*F + M/(cos_phi*b);
}

static inline double chained_P_quick(double a, double b, double phi, double m, double M)
{
    const double sin_phi = mechc_sin_of_pair(phi);
    const double p1 = a*sin_phi/b;
    const double theta = asin(p1);
    const double cos_phi = mechc_cos_of_pair(phi);
    const double reach = a*cos_phi + cos_phi/sin_phi;
    const double F = 10.0*m;
    const double t1 = sqrt((1.0 - p1)*(1.0 + p1));
    return mechc_if_less(a, m, mechc_if_no_more(0.0, theta, ((sin_phi*t1 + cos_phi*p1)*reach*reach/t1 - 3.0*sin_phi*(cos_phi*t1 - p1*sin_phi)/cos_phi)*F + M/(cos_phi*b)));
}

void chained_P_n(
    size_t n,
    const double *MECHC_RESTRICT a,
    const double *MECHC_RESTRICT b,
    const double *MECHC_RESTRICT phi,
    const double *MECHC_RESTRICT m,
    const double *MECHC_RESTRICT M,
    double *MECHC_RESTRICT P)
{
    size_t start, stop, i;
    for (start = 0; start < n; start = stop) {
        stop = n - start > 512 ? start + 512 : n;
        uint64_t missing = 0;
        for (i = start; i < stop; ++i) {
            const double value = chained_P_quick(a[i], b[i], phi[i], m[i], M[i]);
            missing |= mechc_nan(value);
            P[i] = value;
        }
        for (i = missing >> 63 ? start : stop; i < stop; ++i) {
            if (P[i] != P[i]) {
                P[i] = chained_P(a[i], b[i], phi[i], m[i], M[i]);
            }
        }
    }
}

double chained_F(double m)
{
    return 10.0*m;
}

void chained_F_n(size_t n, const double *MECHC_RESTRICT m, double *MECHC_RESTRICT F)
{
    for (size_t i = 0; i < n; ++i) {
        F[i] = chained_F(m[i]);
    }
}

double chained_twice(double a, double b, double phi, double m, double M)
{
    const double sin_phi = sin(phi);
    const double p1 = a*sin_phi/b;
    const double theta = asin(p1);
    const double cos_phi = cos(phi);
    const double reach = a*cos_phi + cos_phi/sin_phi;
    const double F = 10.0*m;
    const double t1 = sqrt((1.0 - p1)*(1.0 + p1));
    const double P = ((sin_phi*t1 + cos_phi*p1)*reach*reach/t1 - 3.0*sin_phi*(cos_phi*t1 - p1*sin_phi)/cos_phi)*F + M/(cos_phi*b);
    const double w = a + b;
    if (!(theta >= 0.0 && m > a)) {
        return NAN;
    }
    return 2.0*P*w;
}

static inline double chained_twice_quick(double a, double b, double phi, double m, double M)
{
    const double sin_phi = mechc_sin_of_pair(phi);
    const double p1 = a*sin_phi/b;
    const double theta = asin(p1);
    const double cos_phi = mechc_cos_of_pair(phi);
    const double reach = a*cos_phi + cos_phi/sin_phi;
    const double F = 10.0*m;
    const double t1 = sqrt((1.0 - p1)*(1.0 + p1));
    const double P = ((sin_phi*t1 + cos_phi*p1)*reach*reach/t1 - 3.0*sin_phi*(cos_phi*t1 - p1*sin_phi)/cos_phi)*F + M/(cos_phi*b);
    const double w = a + b;
    return mechc_if_less(a, m, mechc_if_no_more(0.0, theta, 2.0*P*w));
}

void chained_twice_n(
    size_t n,
    const double *MECHC_RESTRICT a,
    const double *MECHC_RESTRICT b,
    const double *MECHC_RESTRICT phi,
    const double *MECHC_RESTRICT m,
    const double *MECHC_RESTRICT M,
    double *MECHC_RESTRICT twice)
{
    size_t start, stop, i;
    for (start = 0; start < n; start = stop) {
        stop = n - start > 512 ? start + 512 : n;
        uint64_t missing = 0;
        for (i = start; i < stop; ++i) {
            const double value = chained_twice_quick(a[i], b[i], phi[i], m[i], M[i]);
            missing |= mechc_nan(value);
            twice[i] = value;
        }
        for (i = missing >> 63 ? start : stop; i < stop; ++i) {
            if (twice[i] != twice[i]) {
                twice[i] = chained_twice(a[i], b[i], phi[i], m[i], M[i]);
            }
        }
    }
}

int chained_pose(double a, double b, double phi, double *theta_out, double *reach_out)
{
    int status = 0;
    const double sin_phi = sin(phi);
    const double theta = asin(a*sin_phi/b);
    const double cos_phi = cos(phi);
    const double reach = a*cos_phi + cos_phi/sin_phi;
    *theta_out = theta;
    *reach_out = reach;
    if (theta != theta || reach != reach) {
        status = 1;
    }
    return status;
}

void chained_pose_n(
    size_t n,
    const double *MECHC_RESTRICT a,
    const double *MECHC_RESTRICT b,
    const double *MECHC_RESTRICT phi,
    double *MECHC_RESTRICT theta_out,
    double *MECHC_RESTRICT reach_out,
    int *MECHC_RESTRICT status)
{
    for (size_t i = 0; i < n; ++i) {
        status[i] = chained_pose(a[i], b[i], phi[i], theta_out + i, reach_out + i);
    }
}

const chained_parameters chained_defaults = {
    0.1, /* a */
    0.25, /* b */
    0.6981317007977318, /* phi */
    3.0, /* m */
    NAN /* M */
};

double chained_k_of(const chained_parameters *p)
{
    return chained_k(p->a, p->b, p->phi);
}

void chained_k_n_of(size_t n, const chained_parameters *MECHC_RESTRICT p, double *MECHC_RESTRICT k)
{
    for (size_t i = 0; i < n; ++i) {
        k[i] = chained_k_of(p + i);
    }
}

double chained_P_of(const chained_parameters *p)
{
    return chained_P(p->a, p->b, p->phi, p->m, p->M);
}

void chained_P_n_of(size_t n, const chained_parameters *MECHC_RESTRICT p, double *MECHC_RESTRICT P)
{
    for (size_t i = 0; i < n; ++i) {
        P[i] = chained_P_of(p + i);
    }
}

double chained_F_of(const chained_parameters *p)
{
    return chained_F(p->m);
}

void chained_F_n_of(size_t n, const chained_parameters *MECHC_RESTRICT p, double *MECHC_RESTRICT F)
{
    for (size_t i = 0; i < n; ++i) {
        F[i] = chained_F_of(p + i);
    }
}

double chained_twice_of(const chained_parameters *p)
{
    return chained_twice(p->a, p->b, p->phi, p->m, p->M);
}

void chained_twice_n_of(
    size_t n,
    const chained_parameters *MECHC_RESTRICT p,
    double *MECHC_RESTRICT twice)
{
    for (size_t i = 0; i < n; ++i) {
        twice[i] = chained_twice_of(p + i);
    }
}

int chained_pose_of(const chained_parameters *p, double *theta_out, double *reach_out)
{
    return chained_pose(p->a, p->b, p->phi, theta_out, reach_out);
}

void chained_pose_n_of(
    size_t n,
    const chained_parameters *MECHC_RESTRICT p,
    double *MECHC_RESTRICT theta_out,
    double *MECHC_RESTRICT reach_out,
    int *MECHC_RESTRICT status)
{
    for (size_t i = 0; i < n; ++i) {
        status[i] = chained_pose_of(p + i, theta_out + i, reach_out + i);
    }
}
