/*
 * A "title" with * / and / * and """ and \.
 * Source: line one line two ? ?/ * / int x; \.
 * Written by mechc 0.0.0. SI units and radians.
 */
#ifndef MECHC_CLASS_H
#define MECHC_CLASS_H

#include <stddef.h>

#ifndef MECHC_RESTRICT
#if defined(__GNUC__) || defined(_MSC_VER)
#define MECHC_RESTRICT __restrict
#elif !defined(__cplusplus) && defined(__STDC_VERSION__) && __STDC_VERSION__ >= 199901L
#define MECHC_RESTRICT restrict
#else
#define MECHC_RESTRICT
#endif
#endif

#ifdef __cplusplus
extern "C" {
#endif

/*
 * The formula of the description:
 *
 *   k = NAN*sin(lambda)^2*β*sin_lambda/beta
 *   where sin_lambda = int
 *   where NAN = lambda + 2*int + 3*I + 4*n + 5*i + 6*np + 7*β + 8*beta + 9*beta_2 + 10*double + 11*l_A' + 12*k
 *
 *   lambda: m; 20 mm, in 10 mm .. 20 mm
 *   int_: m; int in the formula, 30 mm, in 15 mm .. 30 mm
 *   I_: m; I in the formula, 40 mm, in 20 mm .. 40 mm
 *   n: m; 50 mm, in 25 mm .. 50 mm
 *   i: m; 60 mm, in 30 mm .. 60 mm
 *   np: m; 70 mm, in 35 mm .. 70 mm
 *   beta_3: m; β in the formula, 80 mm, in 40 mm .. 80 mm
 *   beta: m; 90 mm, in 45 mm .. 90 mm
 *   beta_2: m; 100 mm, in 50 mm .. 100 mm
 *   double_: m; double in the formula, 110 mm, in 55 mm .. 110 mm
 *   l_A_prime: m; l_A' in the formula, 120 mm, in 60 mm .. 120 mm
 *   k: m; 130 mm, in 65 mm .. 130 mm
 * 28 operations. The second form computes k_2[0 .. n_2 - 1];
 * its arrays must not overlap.
 */
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
    double k);
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
    double *MECHC_RESTRICT k_2);

/*
 * The formula of the description:
 *
 *   k_n = I + np
 *
 *   I_: m; I in the formula, 40 mm, in 20 mm .. 40 mm
 *   np: m; 70 mm, in 35 mm .. 70 mm
 * 1 operation. The second form computes k_n[0 .. n - 1];
 * its arrays must not overlap.
 */
double class_k_n(double I_, double np);
void class_k_n_n(
    size_t n,
    const double *MECHC_RESTRICT I_,
    const double *MECHC_RESTRICT np,
    double *MECHC_RESTRICT k_n);

/*
 * The formula of the description:
 *
 *   int = β + 2*beta
 *
 *   beta_3: m; β in the formula, 80 mm, in 40 mm .. 80 mm
 *   beta: m; 90 mm, in 45 mm .. 90 mm
 * 2 operations. The second form computes int_[0 .. n - 1];
 * its arrays must not overlap.
 */
double class_int(double beta_3, double beta);
void class_int_n(
    size_t n,
    const double *MECHC_RESTRICT beta_3,
    const double *MECHC_RESTRICT beta,
    double *MECHC_RESTRICT int_);

/*
 * The formula of the description:
 *
 *   int_ = int*double
 *
 *   int_: m; int in the formula, 30 mm, in 15 mm .. 30 mm
 *   double_: m; double in the formula, 110 mm, in 55 mm .. 110 mm
 * 1 operation. The second form computes int_2[0 .. n - 1];
 * its arrays must not overlap.
 */
double class_int_(double int_, double double_);
void class_int_n_2(
    size_t n,
    const double *MECHC_RESTRICT int_,
    const double *MECHC_RESTRICT double_,
    double *MECHC_RESTRICT int_2);

/*
 * The formula of the description:
 *
 *   seven = 7
 *
 * 0 operations. The second form computes seven[0 .. n - 1];
 * its arrays must not overlap.
 */
double class_seven(void);
void class_seven_n(size_t n, double *MECHC_RESTRICT seven);

/*
 * The intermediates of the pose. Returns 0 where all are there, 1 where the loops do not
 * close or a branch has ended on the way from the default pose, 2 where Newton's method
 * does not converge; what is not there is NaN.
 *
 *   lambda: m; 20 mm, in 10 mm .. 20 mm
 *   int_: m; int in the formula, 30 mm, in 15 mm .. 30 mm
 *   I_: m; I in the formula, 40 mm, in 20 mm .. 40 mm
 *   n: m; 50 mm, in 25 mm .. 50 mm
 *   i: m; 60 mm, in 30 mm .. 60 mm
 *   np: m; 70 mm, in 35 mm .. 70 mm
 *   beta_3: m; β in the formula, 80 mm, in 40 mm .. 80 mm
 *   beta: m; 90 mm, in 45 mm .. 90 mm
 *   beta_2: m; 100 mm, in 50 mm .. 100 mm
 *   double_: m; double in the formula, 110 mm, in 55 mm .. 110 mm
 *   l_A_prime: m; l_A' in the formula, 120 mm, in 60 mm .. 120 mm
 *   k: m; 130 mm, in 65 mm .. 130 mm
 *   sin_lambda_out: sin_lambda, in rad
 *   NAN_out: NAN, in rad
 *
 * The second form computes the elements 0 .. n_2 - 1; its arrays must not overlap.
 */
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
    double *NAN_out);
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
    int *MECHC_RESTRICT status);

/*
 * All parameters by name. The defaults are the values of the description, NAN where it has none:
 * copy them, set what is to differ, and pass the copy on. Each function below gives what the
 * one without _of gives for these values; one with _n_of takes the elements 0 .. n - 1 of an
 * array of structs, and its arrays must not overlap.
 */
typedef struct class_parameters {
    double lambda; /* m; 20 mm, in 10 mm .. 20 mm */
    double int_; /* m; int in the formula, 30 mm, in 15 mm .. 30 mm */
    double I_; /* m; I in the formula, 40 mm, in 20 mm .. 40 mm */
    double n; /* m; 50 mm, in 25 mm .. 50 mm */
    double i; /* m; 60 mm, in 30 mm .. 60 mm */
    double np; /* m; 70 mm, in 35 mm .. 70 mm */
    double beta_3; /* m; β in the formula, 80 mm, in 40 mm .. 80 mm */
    double beta; /* m; 90 mm, in 45 mm .. 90 mm */
    double beta_2; /* m; 100 mm, in 50 mm .. 100 mm */
    double double_; /* m; double in the formula, 110 mm, in 55 mm .. 110 mm */
    double l_A_prime; /* m; l_A' in the formula, 120 mm, in 60 mm .. 120 mm */
    double k; /* m; 130 mm, in 65 mm .. 130 mm */
} class_parameters;

extern const class_parameters class_defaults;

double class_k_of(const class_parameters *p);
void class_k_n_of(size_t n, const class_parameters *MECHC_RESTRICT p, double *MECHC_RESTRICT k);
double class_k_n_of_2(const class_parameters *p);
void class_k_n_n_of(size_t n, const class_parameters *MECHC_RESTRICT p, double *MECHC_RESTRICT k_n);
double class_int_of(const class_parameters *p);
void class_int_n_of(size_t n, const class_parameters *MECHC_RESTRICT p, double *MECHC_RESTRICT int_);
double class_int_of_2(const class_parameters *p);
void class_int_n_of_2(
    size_t n,
    const class_parameters *MECHC_RESTRICT p,
    double *MECHC_RESTRICT int_2);
double class_seven_of(const class_parameters *p);
void class_seven_n_of(
    size_t n,
    const class_parameters *MECHC_RESTRICT p,
    double *MECHC_RESTRICT seven);
int class_pose_of(const class_parameters *p, double *sin_lambda_out, double *NAN_out);
void class_pose_n_of(
    size_t n,
    const class_parameters *MECHC_RESTRICT p,
    double *MECHC_RESTRICT sin_lambda_out,
    double *MECHC_RESTRICT NAN_out,
    int *MECHC_RESTRICT status);

#ifdef __cplusplus
}
#endif

#endif
