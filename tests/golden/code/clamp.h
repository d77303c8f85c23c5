/*
 * Packet clamp.
 * Source: Karpenko et al. 2023, fig. 9.
 * Written by mechc 0.0.0. SI units and radians.
 */
#ifndef MECHC_PACKET_CLAMP_H
#define MECHC_PACKET_CLAMP_H

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
 *   k = a*sin(alpha + beta)/(2*b*cos(alpha)*cos(beta))
 *
 *   a: m; 100 mm, in 50 mm .. 100 mm
 *   b: m; 250 mm, in 125 mm .. 250 mm
 *   alpha: rad; 12 deg, in 6 deg .. 12 deg
 *   beta: rad; 7 deg, in 3.5 deg .. 7 deg
 * NaN unless
 *   alpha + beta < pi/2
 * 9 operations. The second form computes k[0 .. n - 1];
 * its arrays must not overlap.
 */
double packet_clamp_k(double a, double b, double alpha, double beta);
void packet_clamp_k_n(
    size_t n,
    const double *MECHC_RESTRICT a,
    const double *MECHC_RESTRICT b,
    const double *MECHC_RESTRICT alpha,
    const double *MECHC_RESTRICT beta,
    double *MECHC_RESTRICT k);

/*
 * All parameters by name. The defaults are the values of the description, NAN where it has none:
 * copy them, set what is to differ, and pass the copy on. Each function below gives what the
 * one without _of gives for these values; one with _n_of takes the elements 0 .. n - 1 of an
 * array of structs, and its arrays must not overlap.
 */
typedef struct packet_clamp_parameters {
    double a; /* m; 100 mm, in 50 mm .. 100 mm */
    double b; /* m; 250 mm, in 125 mm .. 250 mm */
    double alpha; /* rad; 12 deg, in 6 deg .. 12 deg */
    double beta; /* rad; 7 deg, in 3.5 deg .. 7 deg */
} packet_clamp_parameters;

extern const packet_clamp_parameters packet_clamp_defaults;

double packet_clamp_k_of(const packet_clamp_parameters *p);
void packet_clamp_k_n_of(
    size_t n,
    const packet_clamp_parameters *MECHC_RESTRICT p,
    double *MECHC_RESTRICT k);

#ifdef __cplusplus
}
#endif

#endif
