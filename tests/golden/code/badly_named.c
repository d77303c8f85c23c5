/*
 * A "title" with * / and / * and """ and \.
 * Source: line one line two ? ?/ * / int x; \.
 * Written by mechc 0.0.0. SI units and radians.
 */
#include "badly_named.h"

#include <math.h>

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
    for (size_t i_2 = 0; i_2 < n_2; ++i_2) {
        k_2[i_2] = class_k(lambda[i_2], int_[i_2], I_[i_2], n[i_2], i[i_2], np[i_2], beta_3[i_2], beta[i_2], beta_2[i_2], double_[i_2], l_A_prime[i_2], k[i_2]);
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
