"""A "title" with */ and /* and \"\"\" and \\.

Source: line one line two ??/ */ int x; \\.
Written by mechc 0.0.0. SI units and radians; floats and arrays alike.
"""

import numpy as np

DEFAULTS = {
    "lambda_": 0.02,
    "int_": 0.03,
    "I": 0.04,
    "n": 0.05,
    "i": 0.06,
    "np_": 0.07,
    "beta_3": 0.08,
    "beta": 0.09,
    "beta_2": 0.1,
    "double": 0.11,
    "l_A_prime": 0.12,
    "k": 0.13,
}
"""The values of the description, by argument, in SI and radians."""

RANGES = {
    "lambda_": (0.01, 0.02),
    "int_": (0.015, 0.03),
    "I": (0.02, 0.04),
    "n": (0.025, 0.05),
    "i": (0.03, 0.06),
    "np_": (0.035, 0.07),
    "beta_3": (0.04, 0.08),
    "beta": (0.045, 0.09),
    "beta_2": (0.05, 0.1),
    "double": (0.055, 0.11),
    "l_A_prime": (0.06, 0.12),
    "k": (0.065, 0.13),
}
"""The ranges of the description, from and to, in SI and radians."""


def k(lambda_, int_, I, n, i, np_, beta_3, beta, beta_2, double, l_A_prime, k):
    """Return the formula of the description.

        k = NAN*sin(lambda)^2*β*sin_lambda/beta
        where sin_lambda = int
        where NAN = lambda + 2*int + 3*I + 4*n + 5*i + 6*np + 7*β + 8*beta + 9*beta_2 + 10*double + 11*l_A' + 12*k

    Args:
        lambda_: m; lambda in the formula, 20 mm, in 10 mm .. 20 mm
        int_: m; int in the formula, 30 mm, in 15 mm .. 30 mm
        I: m; 40 mm, in 20 mm .. 40 mm
        n: m; 50 mm, in 25 mm .. 50 mm
        i: m; 60 mm, in 30 mm .. 60 mm
        np_: m; np in the formula, 70 mm, in 35 mm .. 70 mm
        beta_3: m; β in the formula, 80 mm, in 40 mm .. 80 mm
        beta: m; 90 mm, in 45 mm .. 90 mm
        beta_2: m; 100 mm, in 50 mm .. 100 mm
        double: m; 110 mm, in 55 mm .. 110 mm
        l_A_prime: m; l_A' in the formula, 120 mm, in 60 mm .. 120 mm
        k: m; 130 mm, in 65 mm .. 130 mm

    Operations: 28
    """
    return _in_blocks(_block_of_k, lambda_, int_, I, n, i, np_, beta_3, beta, beta_2, double, l_A_prime, k)


def _block_of_k(lambda_, int_, I, n, i, np_, beta_3, beta, beta_2, double, l_A_prime, k):
    sin_lambda = int_
    NAN = lambda_ + 2.0*int_ + 3.0*I + 4.0*n + 5.0*i + 6.0*np_ + 7.0*beta_3 + 8.0*beta + 9.0*beta_2 + 10.0*double + 11.0*l_A_prime + 12.0*k
    _, t1 = _cos_sin(lambda_)
    result = NAN*t1*t1*beta_3*sin_lambda/beta
    return result


def k_n(I, np_):
    """Return the formula of the description.

        k_n = I + np

    Args:
        I: m; 40 mm, in 20 mm .. 40 mm
        np_: m; np in the formula, 70 mm, in 35 mm .. 70 mm

    Operations: 1
    """
    return _in_blocks(_block_of_k_n, I, np_)


def _block_of_k_n(I, np_):
    k_n = I + np_
    return k_n


def int_2(beta_3, beta):
    """Return the formula of the description.

        int = β + 2*beta

    Args:
        beta_3: m; β in the formula, 80 mm, in 40 mm .. 80 mm
        beta: m; 90 mm, in 45 mm .. 90 mm

    Operations: 2
    """
    return _in_blocks(_block_of_int_2, beta_3, beta)


def _block_of_int_2(beta_3, beta):
    int_ = beta_3 + 2.0*beta
    return int_


def int_(int_, double):
    """Return the formula of the description.

        int_ = int*double

    Args:
        int_: m; int in the formula, 30 mm, in 15 mm .. 30 mm
        double: m; 110 mm, in 55 mm .. 110 mm

    Operations: 1
    """
    return _in_blocks(_block_of_int_, int_, double)


def _block_of_int_(int_, double):
    int_2 = int_*double
    return int_2


def seven():
    """Return the formula of the description.

        seven = 7

    Operations: 0
    """
    return _in_blocks(_block_of_seven)


def _block_of_seven():
    seven = 7.0
    return seven


def pose(lambda_, int_, I, n, i, np_, beta_3, beta, beta_2, double, l_A_prime, k):
    """Return the intermediates by their names, and the status.

    Status 0: all are there; 1: the loops do not close, or a branch has ended on the way
    from the default pose. What is not there is NaN.

    sin_lambda, in rad
    NAN, in rad

    Args:
        lambda_: m; lambda in the formula, 20 mm, in 10 mm .. 20 mm
        int_: m; int in the formula, 30 mm, in 15 mm .. 30 mm
        I: m; 40 mm, in 20 mm .. 40 mm
        n: m; 50 mm, in 25 mm .. 50 mm
        i: m; 60 mm, in 30 mm .. 60 mm
        np_: m; np in the formula, 70 mm, in 35 mm .. 70 mm
        beta_3: m; β in the formula, 80 mm, in 40 mm .. 80 mm
        beta: m; 90 mm, in 45 mm .. 90 mm
        beta_2: m; 100 mm, in 50 mm .. 100 mm
        double: m; 110 mm, in 55 mm .. 110 mm
        l_A_prime: m; l_A' in the formula, 120 mm, in 60 mm .. 120 mm
        k: m; 130 mm, in 65 mm .. 130 mm
    """
    lambda_ = np.asarray(lambda_, dtype=float)
    int_ = np.asarray(int_, dtype=float)
    I = np.asarray(I, dtype=float)
    n = np.asarray(n, dtype=float)
    i = np.asarray(i, dtype=float)
    np_ = np.asarray(np_, dtype=float)
    beta_3 = np.asarray(beta_3, dtype=float)
    beta = np.asarray(beta, dtype=float)
    beta_2 = np.asarray(beta_2, dtype=float)
    double = np.asarray(double, dtype=float)
    l_A_prime = np.asarray(l_A_prime, dtype=float)
    k = np.asarray(k, dtype=float)
    with np.errstate(all="ignore"):
        sin_lambda = int_
        NAN = lambda_ + 2.0*int_ + 3.0*I + 4.0*n + 5.0*i + 6.0*np_ + 7.0*beta_3 + 8.0*beta + 9.0*beta_2 + 10.0*double + 11.0*l_A_prime + 12.0*k
    found = {
        'sin_lambda': sin_lambda,
        'NAN': NAN,
    }
    status = 0
    for each in [*map(np.isnan, found.values())]:
        status = np.maximum(status, each)
    found = {name: value if np.ndim(value) else float(value) for name, value in found.items()}
    return found, status if np.ndim(status) else int(status)


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
    print(f"k = {k(lambda_=0.02, int_=0.03, I=0.04, n=0.05, i=0.06, np_=0.07, beta_3=0.08, beta=0.09, beta_2=0.1, double=0.11, l_A_prime=0.12, k=0.13):.10g}")
    print(f"k_n = {k_n(I=0.04, np_=0.07):.10g}")
    print(f"int_2 = {int_2(beta_3=0.08, beta=0.09):.10g}")
    print(f"int_ = {int_(int_=0.03, double=0.11):.10g}")
    print(f"seven = {seven():.10g}")
