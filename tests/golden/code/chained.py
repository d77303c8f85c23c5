"""chained.

Written by mechc 0.0.0. SI units and radians; floats and arrays alike.
"""

import numpy as np

DEFAULTS = {
    "a": 0.1,
    "b": 0.25,
    "phi": 0.6981317007977318,
    "m": 3.0,
}
"""The values of the description, by argument, in SI and radians."""

RANGES = {
    "a": (0.05, 0.1),
    "b": (0.125, 0.25),
    "phi": (0.3490658503988659, 0.6981317007977318),
    "m": (1.5, 3.0),
}
"""The ranges of the description, from and to, in SI and radians."""


def k(a, b, phi):
    """Return the force ratio P/F.

        k = sin(phi + theta)*reach^2/cos(theta) - 3*tan(phi)*cos(theta + phi)
        where theta = asin(a*sin(phi)/b)
        where reach = a*cos(phi) + cot(phi)

    NaN unless
        theta >= 0

    Args:
        a: m; 100 mm, in 50 mm .. 100 mm
        b: m; 250 mm, in 125 mm .. 250 mm
        phi: rad; 40 deg, in 20 deg .. 40 deg

    Operations: 25
    """
    return _in_blocks(_block_of_k, a, b, phi)


def _block_of_k(a, b, phi):
    cos_phi, sin_phi = _cos_sin(phi)
    p1 = a*sin_phi/b
    theta = np.arcsin(p1)
    reach = a*cos_phi + cos_phi/sin_phi
    t1 = np.sqrt((1.0 - p1)*(1.0 + p1))
    k = (sin_phi*t1 + cos_phi*p1)*reach*reach/t1 - 3.0*sin_phi*(cos_phi*t1 - p1*sin_phi)/cos_phi
    k = np.where(theta >= 0.0, k, np.nan)
    return k


def P(a, b, phi, m, M):
    """Return the load P that balances the others, in N.

        P = (sin(phi + theta)*reach^2/cos(theta) - 3*tan(phi)*cos(theta + phi))*F + sec(phi)*a*M/(b*a)
        where theta = asin(a*sin(phi)/b)
        where reach = a*cos(phi) + cot(phi)
        where F = 10*m

    NaN unless
        theta >= 0
        m > a

    Args:
        a: m; 100 mm, in 50 mm .. 100 mm
        b: m; 250 mm, in 125 mm .. 250 mm
        phi: rad; 40 deg, in 20 deg .. 40 deg
        m: kg; 3 kg, in 1.5 kg .. 3 kg
        M: N*m

    Operations: 30
    """
    return _in_blocks(_block_of_P, a, b, phi, m, M)


def _block_of_P(a, b, phi, m, M):
    cos_phi, sin_phi = _cos_sin(phi)
    p1 = a*sin_phi/b
    theta = np.arcsin(p1)
    reach = a*cos_phi + cos_phi/sin_phi
    F = 10.0*m
    t1 = np.sqrt((1.0 - p1)*(1.0 + p1))
    P = ((sin_phi*t1 + cos_phi*p1)*reach*reach/t1 - 3.0*sin_phi*(cos_phi*t1 - p1*sin_phi)/cos_phi)*F + M/(cos_phi*b)
    P = np.where(theta >= 0.0, P, np.nan)
    P = np.where(m > a, P, np.nan)
    return P


def F(m):
    """Return the formula of the description, in N.

        F = 10*m

    Args:
        m: kg; 3 kg, in 1.5 kg .. 3 kg

    Operations: 1
    """
    return _in_blocks(_block_of_F, m)


def _block_of_F(m):
    F = 10.0*m
    return F


def twice(a, b, phi, m, M):
    """Return the formula of the description, in N.

        twice = 2*P*w
        where theta = asin(a*sin(phi)/b)
        where reach = a*cos(phi) + cot(phi)
        where F = 10*m
        where P = (sin(phi + theta)*reach^2/cos(theta) - 3*tan(phi)*cos(theta + phi))*F + sec(phi)*a*M/(b*a)
        where w = a + b

    NaN unless
        theta >= 0
        m > a

    Args:
        a: m; 100 mm, in 50 mm .. 100 mm
        b: m; 250 mm, in 125 mm .. 250 mm
        phi: rad; 40 deg, in 20 deg .. 40 deg
        m: kg; 3 kg, in 1.5 kg .. 3 kg
        M: N*m

    Operations: 33
    """
    return _in_blocks(_block_of_twice, a, b, phi, m, M)


def _block_of_twice(a, b, phi, m, M):
    cos_phi, sin_phi = _cos_sin(phi)
    p1 = a*sin_phi/b
    theta = np.arcsin(p1)
    reach = a*cos_phi + cos_phi/sin_phi
    F = 10.0*m
    t1 = np.sqrt((1.0 - p1)*(1.0 + p1))
    P = ((sin_phi*t1 + cos_phi*p1)*reach*reach/t1 - 3.0*sin_phi*(cos_phi*t1 - p1*sin_phi)/cos_phi)*F + M/(cos_phi*b)
    w = a + b
    twice = 2.0*P*w
    twice = np.where(theta >= 0.0, twice, np.nan)
    twice = np.where(m > a, twice, np.nan)
    return twice


def pose(a, b, phi):
    """Return the intermediates by their names, and the status.

    Status 0: all are there; 1: the loops do not close, or a branch has ended on the way
    from the default pose. What is not there is NaN.

    theta, in rad
    reach, in rad

    Args:
        a: m; 100 mm, in 50 mm .. 100 mm
        b: m; 250 mm, in 125 mm .. 250 mm
        phi: rad; 40 deg, in 20 deg .. 40 deg
    """
    a = np.asarray(a, dtype=float)
    b = np.asarray(b, dtype=float)
    phi = np.asarray(phi, dtype=float)
    with np.errstate(all="ignore"):
        sin_phi = np.sin(phi)
        theta = np.arcsin(a*sin_phi/b)
        cos_phi = np.cos(phi)
        reach = a*cos_phi + cos_phi/sin_phi
    found = {
        'theta': theta,
        'reach': reach,
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
    print(f"k = {k(a=0.1, b=0.25, phi=0.6981317007977318):.10g}")
    print("P: no default for M")
    print(f"F = {F(m=3.0):.10g}")
    print("twice: no default for M")
