/*
 * Packet clamp.
 * Source: Karpenko et al. 2023, fig. 9.
 * Written by mechc 0.0.0. SI units and radians.
 */
#include "clamp.h"

#include <math.h>

#define MECHC_PI 3.14159265358979323846

double packet_clamp_k(double a, double b, double alpha, double beta)
{
    if (!(alpha + beta < MECHC_PI/2.0)) {
        return NAN;
    }
    return a*sin(alpha + beta)/(2.0*b*cos(alpha)*cos(beta));
}

void packet_clamp_k_n(
    size_t n,
    const double *MECHC_RESTRICT a,
    const double *MECHC_RESTRICT b,
    const double *MECHC_RESTRICT alpha,
    const double *MECHC_RESTRICT beta,
    double *MECHC_RESTRICT k)
{
    for (size_t i = 0; i < n; ++i) {
        k[i] = packet_clamp_k(a[i], b[i], alpha[i], beta[i]);
    }
}
