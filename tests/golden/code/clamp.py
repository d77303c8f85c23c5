"""Packet clamp.

Source: Karpenko et al. 2023, fig. 9.
Written by mechc 0.0.0. SI units and radians; floats and arrays alike.
"""

import numpy as np


def k(a, b, alpha, beta):
    """Return the force ratio P/F.

        k = a*sin(alpha + beta)/(2*b*cos(alpha)*cos(beta))

    NaN unless
        alpha + beta < pi/2

    Args:
        a: m; 100 mm, in 50 mm .. 100 mm
        b: m; 250 mm, in 125 mm .. 250 mm
        alpha: rad; 12 deg, in 6 deg .. 12 deg
        beta: rad; 7 deg, in 3.5 deg .. 7 deg

    Operations: 9
    """
    a = np.asarray(a, dtype=float)
    b = np.asarray(b, dtype=float)
    alpha = np.asarray(alpha, dtype=float)
    beta = np.asarray(beta, dtype=float)
    with np.errstate(all="ignore"):
        k = a*np.sin(alpha + beta)/(2.0*b*np.cos(alpha)*np.cos(beta))
        k = np.where(alpha + beta < np.pi/2.0, k, np.nan)
    return k if np.ndim(k) else float(k)


if __name__ == "__main__":
    print(f"k = {k(a=0.1, b=0.25, alpha=0.20943951023931953, beta=0.12217304763960307):.10g}")
