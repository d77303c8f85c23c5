/*
 * chained.
 * Written by mechc 0.0.0. SI units and radians.
 */
#ifndef MECHC_CHAINED_H
#define MECHC_CHAINED_H

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
 * The force ratio P/F:
 *
 *   k = sin(phi + theta)*reach^2/cos(theta) - 3*tan(phi)*cos(theta + phi)
 *   where theta = asin(a*sin(phi)/b)
 *   where reach = a*cos(phi) + cot(phi)
 *
 *   a: m; 100 mm, in 50 mm .. 100 mm
 *   b: m; 250 mm, in 125 mm .. 250 mm
 *   phi: rad; 40 deg, in 20 deg .. 40 deg
 * NaN unless
 *   theta >= 0
 * 25 operations. The second form computes k[0 .. n - 1];
 * its arrays must not overlap.
 */
double chained_k(double a, double b, double phi);
void chained_k_n(
    size_t n,
    const double *MECHC_RESTRICT a,
    const double *MECHC_RESTRICT b,
    const double *MECHC_RESTRICT phi,
    double *MECHC_RESTRICT k);

/*
 * The load P that balances the others, in N:
 *
 *   P = (sin(phi + theta)*reach^2/cos(theta) - 3*tan(phi)*cos(theta + phi))*F + sec(phi)*a*M/(b*a)
 *   where theta = asin(a*sin(phi)/b)
 *   where reach = a*cos(phi) + cot(phi)
 *   where F = 10*m
 *
 *   a: m; 100 mm, in 50 mm .. 100 mm
 *   b: m; 250 mm, in 125 mm .. 250 mm
 *   phi: rad; 40 deg, in 20 deg .. 40 deg
 *   m: kg; 3 kg, in 1.5 kg .. 3 kg
 *   M: N*m
 * NaN unless
 *   theta >= 0
 *   m > a
 * 30 operations. The second form computes P[0 .. n - 1];
 * its arrays must not overlap.
 */
double chained_P(double a, double b, double phi, double m, double M);
void chained_P_n(
    size_t n,
    const double *MECHC_RESTRICT a,
    const double *MECHC_RESTRICT b,
    const double *MECHC_RESTRICT phi,
    const double *MECHC_RESTRICT m,
    const double *MECHC_RESTRICT M,
    double *MECHC_RESTRICT P);

/*
 * The formula of the description, in N:
 *
 *   F = 10*m
 *
 *   m: kg; 3 kg, in 1.5 kg .. 3 kg
 * 1 operation. The second form computes F[0 .. n - 1];
 * its arrays must not overlap.
 */
double chained_F(double m);
void chained_F_n(size_t n, const double *MECHC_RESTRICT m, double *MECHC_RESTRICT F);

/*
 * The formula of the description, in N:
 *
 *   twice = 2*P*w
 *   where theta = asin(a*sin(phi)/b)
 *   where reach = a*cos(phi) + cot(phi)
 *   where F = 10*m
 *   where P = (sin(phi + theta)*reach^2/cos(theta) - 3*tan(phi)*cos(theta + phi))*F + sec(phi)*a*M/(b*a)
 *   where w = a + b
 *
 *   a: m; 100 mm, in 50 mm .. 100 mm
 *   b: m; 250 mm, in 125 mm .. 250 mm
 *   phi: rad; 40 deg, in 20 deg .. 40 deg
 *   m: kg; 3 kg, in 1.5 kg .. 3 kg
 *   M: N*m
 * NaN unless
 *   theta >= 0
 *   m > a
 * 33 operations. The second form computes twice[0 .. n - 1];
 * its arrays must not overlap.
 */
double chained_twice(double a, double b, double phi, double m, double M);
void chained_twice_n(
    size_t n,
    const double *MECHC_RESTRICT a,
    const double *MECHC_RESTRICT b,
    const double *MECHC_RESTRICT phi,
    const double *MECHC_RESTRICT m,
    const double *MECHC_RESTRICT M,
    double *MECHC_RESTRICT twice);

/*
 * The intermediates of the pose. Returns 0 where all are there, 1 where the loops do not
 * close or a branch has ended on the way from the default pose, 2 where Newton's method
 * does not converge; what is not there is NaN.
 *
 *   a: m; 100 mm, in 50 mm .. 100 mm
 *   b: m; 250 mm, in 125 mm .. 250 mm
 *   phi: rad; 40 deg, in 20 deg .. 40 deg
 *   theta_out: theta, in rad
 *   reach_out: reach, in rad
 *
 * The second form computes the elements 0 .. n - 1; its arrays must not overlap.
 */
int chained_pose(double a, double b, double phi, double *theta_out, double *reach_out);
void chained_pose_n(
    size_t n,
    const double *MECHC_RESTRICT a,
    const double *MECHC_RESTRICT b,
    const double *MECHC_RESTRICT phi,
    double *MECHC_RESTRICT theta_out,
    double *MECHC_RESTRICT reach_out,
    int *MECHC_RESTRICT status);

/*
 * All parameters by name. The defaults are the values of the description, NAN where it has none:
 * copy them, set what is to differ, and pass the copy on. Each function below gives what the
 * one without _of gives for these values; one with _n_of takes the elements 0 .. n - 1 of an
 * array of structs, and its arrays must not overlap.
 */
typedef struct chained_parameters {
    double a; /* m; 100 mm, in 50 mm .. 100 mm */
    double b; /* m; 250 mm, in 125 mm .. 250 mm */
    double phi; /* rad; 40 deg, in 20 deg .. 40 deg */
    double m; /* kg; 3 kg, in 1.5 kg .. 3 kg */
    double M; /* N*m */
} chained_parameters;

extern const chained_parameters chained_defaults;

double chained_k_of(const chained_parameters *p);
void chained_k_n_of(size_t n, const chained_parameters *MECHC_RESTRICT p, double *MECHC_RESTRICT k);
double chained_P_of(const chained_parameters *p);
void chained_P_n_of(size_t n, const chained_parameters *MECHC_RESTRICT p, double *MECHC_RESTRICT P);
double chained_F_of(const chained_parameters *p);
void chained_F_n_of(size_t n, const chained_parameters *MECHC_RESTRICT p, double *MECHC_RESTRICT F);
double chained_twice_of(const chained_parameters *p);
void chained_twice_n_of(
    size_t n,
    const chained_parameters *MECHC_RESTRICT p,
    double *MECHC_RESTRICT twice);
int chained_pose_of(const chained_parameters *p, double *theta_out, double *reach_out);
void chained_pose_n_of(
    size_t n,
    const chained_parameters *MECHC_RESTRICT p,
    double *MECHC_RESTRICT theta_out,
    double *MECHC_RESTRICT reach_out,
    int *MECHC_RESTRICT status);

#ifdef __cplusplus
}
#endif

#endif
