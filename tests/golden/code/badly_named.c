/*
 * A "title" with * / and / * and """ and \.
 * Source: line one line two ? ?/ * / int x; \.
 * Written by mechc 0.0.0. SI units and radians.
 */
#include "badly_named.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#if defined(__FAST_MATH__) || defined(_M_FP_FAST) || __FINITE_MATH_ONLY__ + 0
#ifndef MECHC_ALLOW_FAST_MATH
#error "NaN says where there is no pose: leave out -ffast-math, or define MECHC_ALLOW_FAST_MATH"
#endif
#endif

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

/* A number whose first bit is 1 where the value is NaN: without a comparison, for vector code. */
static inline uint64_t mechc_nan(double value)
{
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    return 0x7ff0000000000000u - (bits & 0x7fffffffffffffffu);
}

double class_k(
    double lambda,
    double int_,
    double I_,
    double n,
    double i,
    double np,
    double beta_3,
    double beta,
    double beta_2,
    double double_,
    double l_A_prime,
    double k)
{
    const double sin_lambda = int_;
    const double NAN_ = lambda + 2.0*int_ + 3.0*I_ + 4.0*n + 5.0*i + 6.0*np + 7.0*beta_3 + 8.0*beta + 9.0*beta_2 + 10.0*double_ + 11.0*l_A_prime + 12.0*k;
    const double t1 = sin(lambda);
    return NAN_*t1*t1*beta_3*sin_lambda/beta;
}

static inline double class_k_quick(
    double lambda,
    double int_,
    double I_,
    double n,
    double i,
    double np,
    double beta_3,
    double beta,
    double beta_2,
    double double_,
    double l_A_prime,
    double k)
{
    const double sin_lambda = int_;
    const double NAN_ = lambda + 2.0*int_ + 3.0*I_ + 4.0*n + 5.0*i + 6.0*np + 7.0*beta_3 + 8.0*beta + 9.0*beta_2 + 10.0*double_ + 11.0*l_A_prime + 12.0*k;
    const double t1 = mechc_sin(lambda);
    return NAN_*t1*t1*beta_3*sin_lambda/beta;
}

void class_k_n_2(
    size_t n_2,
    const double *MECHC_RESTRICT lambda,
    const double *MECHC_RESTRICT int_,
    const double *MECHC_RESTRICT I_,
    const double *MECHC_RESTRICT n,
    const double *MECHC_RESTRICT i,
    const double *MECHC_RESTRICT np,
    const double *MECHC_RESTRICT beta_3,
    const double *MECHC_RESTRICT beta,
    const double *MECHC_RESTRICT beta_2,
    const double *MECHC_RESTRICT double_,
    const double *MECHC_RESTRICT l_A_prime,
    const double *MECHC_RESTRICT k,
    double *MECHC_RESTRICT k_2)
{
    size_t start, stop, i_2;
    for (start = 0; start < n_2; start = stop) {
        stop = n_2 - start > 512 ? start + 512 : n_2;
        uint64_t missing = 0;
        for (i_2 = start; i_2 < stop; ++i_2) {
            const double value = class_k_quick(lambda[i_2], int_[i_2], I_[i_2], n[i_2], i[i_2], np[i_2], beta_3[i_2], beta[i_2], beta_2[i_2], double_[i_2], l_A_prime[i_2], k[i_2]);
            missing |= mechc_nan(value);
            k_2[i_2] = value;
        }
        for (i_2 = missing >> 63 ? start : stop; i_2 < stop; ++i_2) {
            if (k_2[i_2] != k_2[i_2]) {
                k_2[i_2] = class_k(lambda[i_2], int_[i_2], I_[i_2], n[i_2], i[i_2], np[i_2], beta_3[i_2], beta[i_2], beta_2[i_2], double_[i_2], l_A_prime[i_2], k[i_2]);
            }
        }
    }
}

double class_k_n(double I_, double np)
{
    return I_ + np;
}

void class_k_n_n(
    size_t n,
    const double *MECHC_RESTRICT I_,
    const double *MECHC_RESTRICT np,
    double *MECHC_RESTRICT k_n)
{
    for (size_t i = 0; i < n; ++i) {
        k_n[i] = class_k_n(I_[i], np[i]);
    }
}

double class_int(double beta_3, double beta)
{
    return beta_3 + 2.0*beta;
}

void class_int_n(
    size_t n,
    const double *MECHC_RESTRICT beta_3,
    const double *MECHC_RESTRICT beta,
    double *MECHC_RESTRICT int_)
{
    for (size_t i = 0; i < n; ++i) {
        int_[i] = class_int(beta_3[i], beta[i]);
    }
}

double class_int_(double int_, double double_)
{
    return int_*double_;
}

void class_int_n_2(
    size_t n,
    const double *MECHC_RESTRICT int_,
    const double *MECHC_RESTRICT double_,
    double *MECHC_RESTRICT int_2)
{
    for (size_t i = 0; i < n; ++i) {
        int_2[i] = class_int_(int_[i], double_[i]);
    }
}

double class_seven(void)
{
    return 7.0;
}

void class_seven_n(size_t n, double *MECHC_RESTRICT seven)
{
    for (size_t i = 0; i < n; ++i) {
        seven[i] = class_seven();
    }
}

int class_pose(
    double lambda,
    double int_,
    double I_,
    double n,
    double i,
    double np,
    double beta_3,
    double beta,
    double beta_2,
    double double_,
    double l_A_prime,
    double k,
    double *sin_lambda_out,
    double *NAN_out)
{
    int status = 0;
    const double sin_lambda = int_;
    const double NAN_ = lambda + 2.0*int_ + 3.0*I_ + 4.0*n + 5.0*i + 6.0*np + 7.0*beta_3 + 8.0*beta + 9.0*beta_2 + 10.0*double_ + 11.0*l_A_prime + 12.0*k;
    *sin_lambda_out = sin_lambda;
    *NAN_out = NAN_;
    if (sin_lambda != sin_lambda || NAN_ != NAN_) {
        status = 1;
    }
    return status;
}

void class_pose_n(
    size_t n_2,
    const double *MECHC_RESTRICT lambda,
    const double *MECHC_RESTRICT int_,
    const double *MECHC_RESTRICT I_,
    const double *MECHC_RESTRICT n,
    const double *MECHC_RESTRICT i,
    const double *MECHC_RESTRICT np,
    const double *MECHC_RESTRICT beta_3,
    const double *MECHC_RESTRICT beta,
    const double *MECHC_RESTRICT beta_2,
    const double *MECHC_RESTRICT double_,
    const double *MECHC_RESTRICT l_A_prime,
    const double *MECHC_RESTRICT k,
    double *MECHC_RESTRICT sin_lambda_out,
    double *MECHC_RESTRICT NAN_out,
    int *MECHC_RESTRICT status)
{
    for (size_t i_2 = 0; i_2 < n_2; ++i_2) {
        status[i_2] = class_pose(lambda[i_2], int_[i_2], I_[i_2], n[i_2], i[i_2], np[i_2], beta_3[i_2], beta[i_2], beta_2[i_2], double_[i_2], l_A_prime[i_2], k[i_2], sin_lambda_out + i_2, NAN_out + i_2);
    }
}

const class_parameters class_defaults = {
    0.02, /* lambda */
    0.03, /* int_ */
    0.04, /* I_ */
    0.05, /* n */
    0.06, /* i */
    0.07, /* np */
    0.08, /* beta_3 */
    0.09, /* beta */
    0.1, /* beta_2 */
    0.11, /* double_ */
    0.12, /* l_A_prime */
    0.13 /* k */
};

double class_k_of(const class_parameters *p)
{
    return class_k(
        p->lambda,
        p->int_,
        p->I_,
        p->n,
        p->i,
        p->np,
        p->beta_3,
        p->beta,
        p->beta_2,
        p->double_,
        p->l_A_prime,
        p->k);
}

void class_k_n_of(size_t n, const class_parameters *MECHC_RESTRICT p, double *MECHC_RESTRICT k)
{
    for (size_t i = 0; i < n; ++i) {
        k[i] = class_k_of(p + i);
    }
}

double class_k_n_of_2(const class_parameters *p)
{
    return class_k_n(p->I_, p->np);
}

void class_k_n_n_of(size_t n, const class_parameters *MECHC_RESTRICT p, double *MECHC_RESTRICT k_n)
{
    for (size_t i = 0; i < n; ++i) {
        k_n[i] = class_k_n_of_2(p + i);
    }
}

double class_int_of(const class_parameters *p)
{
    return class_int(p->beta_3, p->beta);
}

void class_int_n_of(size_t n, const class_parameters *MECHC_RESTRICT p, double *MECHC_RESTRICT int_)
{
    for (size_t i = 0; i < n; ++i) {
        int_[i] = class_int_of(p + i);
    }
}

double class_int_of_2(const class_parameters *p)
{
    return class_int_(p->int_, p->double_);
}

void class_int_n_of_2(
    size_t n,
    const class_parameters *MECHC_RESTRICT p,
    double *MECHC_RESTRICT int_2)
{
    for (size_t i = 0; i < n; ++i) {
        int_2[i] = class_int_of_2(p + i);
    }
}

double class_seven_of(const class_parameters *p)
{
    (void)p;
    return class_seven();
}

void class_seven_n_of(
    size_t n,
    const class_parameters *MECHC_RESTRICT p,
    double *MECHC_RESTRICT seven)
{
    for (size_t i = 0; i < n; ++i) {
        seven[i] = class_seven_of(p + i);
    }
}

int class_pose_of(const class_parameters *p, double *sin_lambda_out, double *NAN_out)
{
    return class_pose(
        p->lambda,
        p->int_,
        p->I_,
        p->n,
        p->i,
        p->np,
        p->beta_3,
        p->beta,
        p->beta_2,
        p->double_,
        p->l_A_prime,
        p->k,
        sin_lambda_out,
        NAN_out);
}

void class_pose_n_of(
    size_t n,
    const class_parameters *MECHC_RESTRICT p,
    double *MECHC_RESTRICT sin_lambda_out,
    double *MECHC_RESTRICT NAN_out,
    int *MECHC_RESTRICT status)
{
    for (size_t i = 0; i < n; ++i) {
        status[i] = class_pose_of(p + i, sin_lambda_out + i, NAN_out + i);
    }
}
