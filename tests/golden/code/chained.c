/*
 * chained.
 * Written by mechc 0.0.0. SI units and radians.
 */
#include "chained.h"

#include <math.h>

double chained_k(double a, double b, double phi)
{
    const double sin_phi = sin(phi);
    const double theta = asin(a*sin_phi/b);
    const double cos_phi = cos(phi);
    const double reach = a*cos_phi + cos_phi/sin_phi;
    const double phi_plus_theta = phi + theta;
    if (!(theta >= 0.0)) {
        return NAN;
    }
    return sin(phi_plus_theta)*reach*reach/cos(theta) - 3.0*sin_phi*cos(phi_plus_theta)/cos_phi;
}

void chained_k_n(
    size_t n,
    const double *MECHC_RESTRICT a,
    const double *MECHC_RESTRICT b,
    const double *MECHC_RESTRICT phi,
    double *MECHC_RESTRICT k)
{
    for (size_t i = 0; i < n; ++i) {
        k[i] = chained_k(a[i], b[i], phi[i]);
    }
}

double chained_P(double a, double b, double phi, double m, double M)
{
    const double sin_phi = sin(phi);
    const double theta = asin(a*sin_phi/b);
    const double cos_phi = cos(phi);
    const double reach = a*cos_phi + cos_phi/sin_phi;
    const double F = 10.0*m;
    const double phi_plus_theta = phi + theta;
    if (!(theta >= 0.0 && m > a)) {
        return NAN;
    }
    return (sin(phi_plus_theta)*reach*reach/cos(theta) - 3.0*sin_phi*cos(phi_plus_theta)/cos_phi)*F + a*M/(cos_phi*b*a);
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
    for (size_t i = 0; i < n; ++i) {
        P[i] = chained_P(a[i], b[i], phi[i], m[i], M[i]);
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
    const double theta = asin(a*sin_phi/b);
    const double cos_phi = cos(phi);
    const double reach = a*cos_phi + cos_phi/sin_phi;
    const double F = 10.0*m;
    const double phi_plus_theta = phi + theta;
    const double P = (sin(phi_plus_theta)*reach*reach/cos(theta) - 3.0*sin_phi*cos(phi_plus_theta)/cos_phi)*F + a*M/(cos_phi*b*a);
    const double w = a + b;
    if (!(theta >= 0.0 && m > a)) {
        return NAN;
    }
    return 2.0*P*w;
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
    for (size_t i = 0; i < n; ++i) {
        twice[i] = chained_twice(a[i], b[i], phi[i], m[i], M[i]);
    }
}
