"""Packet clamp.

Source: Karpenko et al. 2023, fig. 9.
Written by mechc 0.0.0. SI units and radians; floats and arrays alike.
"""

import numpy as np

DEFAULTS = {
    "a": 0.1,
    "b": 0.25,
    "alpha": 0.20943951023931953,
    "beta": 0.12217304763960307,
}
"""The values of the description, by argument, in SI and radians."""

RANGES = {
    "a": (0.05, 0.1),
    "b": (0.125, 0.25),
    "alpha": (0.10471975511965977, 0.20943951023931953),
    "beta": (0.061086523819801536, 0.12217304763960307),
}
"""The ranges of the description, from and to, in SI and radians."""


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
    return _in_blocks(_block_of_k, a, b, alpha, beta)


def _block_of_k(a, b, alpha, beta):
    _, sin_1 = _cos_sin(alpha + beta)
    cos_alpha, _ = _cos_sin(alpha)
    cos_beta, _ = _cos_sin(beta)
    k = a*sin_1/(2.0*b*cos_alpha*cos_beta)
    k = np.where(alpha + beta < np.pi/2.0, k, np.nan)
    return k


def _cos_sin(angle):
    """Return cosine and sine: of many angles by tangents, where NumPy has these as vector code.

    tan x gives the size of the cosine, tan x/2 has the sign of the sine; within 4 ulp.
    """
    if np.size(angle) < 512 or not _VECTOR_TANGENTS:
        return np.cos(angle), np.sin(angle)
    tangent, half = np.tan(angle), np.tan(0.5*angle)
    cosine = 1.0/np.sqrt(1.0 + tangent*tangent)
    return np.copysign(cosine, tangent*half), np.copysign(tangent*cosine, half)


def _has_vector_tangents():
    try:
        from numpy.lib.introspect import opt_func_info
    except ImportError:  # before NumPy 2
        return False
    found = opt_func_info("^tan$", "float64").get("tan", {}).get("dd", {})
    return not found.get("current", "baseline").startswith("baseline")


_VECTOR_TANGENTS = _has_vector_tangents()


def _in_blocks(function, *arguments):
    """Return a function's values: of many poses a block at a time, so that it fits the cache."""
    arguments = [np.asarray(each, dtype=float)[()] for each in arguments]
    wide = [i for i, each in enumerate(arguments) if each.ndim]
    many = wide and np.prod(np.broadcast_shapes(*(arguments[i].shape for i in wide))) > 8192
    with np.errstate(all="ignore"):
        if not many or len(wide) > 30:
            result = function(*arguments)
            return result if np.ndim(result) else float(result)
        blocks = np.nditer(
            [*(arguments[i] for i in wide), None],
            ["external_loop", "buffered"],
            [["readonly"]]*len(wide) + [["writeonly", "allocate"]],
            buffersize=8192,
        )
        with blocks:
            for *given, result in blocks:
                for i, each in zip(wide, given):
                    arguments[i] = each
                result[...] = function(*arguments)
            return blocks.operands[-1]


if __name__ == "__main__":
    print(f"k = {k(a=0.1, b=0.25, alpha=0.20943951023931953, beta=0.12217304763960307):.10g}")
