"""Descriptions of any size: scissors, chains of four-bars and chains of ternary couplers.

Each function returns the text of a ``.mech`` file. The benchmarks measure growth on
them; the tests use the small ones.
"""

from collections.abc import Iterable

NEWLINE = "\n"


def _joined(lines: Iterable[str]) -> str:
    return NEWLINE.join(lines) + NEWLINE


def scissor(n: int) -> str:
    """Return a scissor lift of ``n`` equal stages; k = n*cot(theta).

    >>> print(scissor(1).splitlines()[0])
    mechanism scissor_1 "Scissor lift, one stage"
    """
    return _joined(
        [
            f'mechanism scissor_{n} "Scissor lift, {_stages(n)}"',
            'source "Virtual work: n stages rise 2n·l·sin θ on a span of 2l·cos θ"',
            "",
            "param l     = 500 mm                     # half a bar",
            "param theta = 30 deg in 5 deg .. 75 deg  # bars against the base",
            "",
            "pivot A0",
            "slider B0 along 180 deg",
            *_bars(n),
            "",
            *(line for i in range(n) for line in _equal_stage(i)),
            "",
            "force P at B0 along 180 deg",
            "# The platform hands half of its load F to either pin.",
            f"force F at A{n} along -90 deg times 1/2",
            f"force E = F at B{n} along -90 deg times 1/2",
            "",
            "find k = P/F",
            f"expect k = {f'{n}*' if n > 1 else ''}cot(theta)",
        ]
    )


def _stages(n: int) -> str:
    words = {1: "one stage", 2: "two stages", 3: "three stages", 4: "four stages"}
    return words.get(n, f"{n} stages")


def _bars(n: int) -> list[str]:
    return [
        line
        for i in range(n)
        for line in (f"link A{i}C{i + 1}B{i + 1}", f"link B{i}C{i + 1}A{i + 1}")
    ]


def _equal_stage(i: int) -> tuple[str, ...]:
    return (
        f"A{i}C{i + 1} = l @ theta",
        f"A{i}B{i + 1} = 2*l @ theta",
        f"B{i}C{i + 1} = l @ 180 deg - theta",
        f"B{i}A{i + 1} = 2*l @ 180 deg - theta",
    )


def uneven_scissor(n: int) -> str:
    """Return a scissor lift whose ``n`` stages all differ.

    Bars of one set lean at alpha, of the other at beta; their arms ``a0 …`` and
    ``b0 … bn`` are free, and each cell between two stages is a parallelogram. The last
    bar of the first set ends at its middle pin.
    """
    arms = [f"param a{i} = {300 + 17 * i} mm" for i in range(n)]
    arms += [f"param b{i} = {310 + 13 * i} mm" for i in range(n + 1)]
    return _joined(
        [
            f'mechanism uneven_scissor_{n} "Scissor lift, {n} different stages"',
            *arms,
            "param alpha = 30 deg in 5 deg .. 75 deg",
            "param beta = 40 deg in 5 deg .. 75 deg",
            "pivot A0",
            "slider B0 along 180 deg",
            *_bars(n - 1),
            f"link A{n - 1}C{n}",
            f"link B{n - 1}C{n}A{n}",
            *(line for i in range(n) for line in _uneven_stage(i, n)),
            "force P at B0 along 180 deg",
            f"force F at A{n} along -90 deg",
            "find k = P / F",
        ]
    )


def uneven_expectation(n: int) -> str:
    """Return the lines that say what k of :func:`uneven_scissor` is."""
    sum_a = " + ".join(f"a{i}" for i in range(n))
    sum_b = " + ".join(f"b{i}" for i in range(1, n + 1))
    return _joined(
        [
            f"let rise = b0*({sum_a}) + a0*({sum_b})",
            "expect k = cos(alpha)*cos(beta)*rise/(a0*b0*sin(alpha + beta))",
        ]
    )


def _uneven_stage(i: int, n: int) -> list[str]:
    lines = [
        f"A{i}C{i + 1} = a{i} @ alpha",
        f"B{i}C{i + 1} = b{i} @ 180 deg - beta",
        f"B{i}A{i + 1} = b{i} + b{i + 1} @ 180 deg - beta",
    ]
    return [*lines, f"A{i}B{i + 1} = a{i} + a{i + 1} @ alpha"] if i < n - 1 else lines


def four_bar_chain(n: int) -> str:
    """Return ``n`` four-bars in series: each rocker carries the crank of the next."""
    stages = range(1, n + 1)
    rockers = [f"link O{i}B{i}{f'A{i + 1}' if i < n else ''}" for i in stages]
    return _joined(
        [
            f'mechanism four_bar_chain_{n} "{n} four-bars in series"',
            *(line for i in stages for line in _four_bar_parameters(i)),
            *(f"pivot O{i}" for i in range(n + 1)),
            "link O0A1",
            *(f"link A{i}B{i}" for i in stages),
            *rockers,
            *(line for i in stages for line in _four_bar_vectors(i)),
            "torque M on O0A1",
            f"force F at B{n} along theta{n} - 90 deg",
            "find k = M / F",
        ]
    )


def _four_bar_parameters(i: int) -> tuple[str, ...]:
    return (
        f"param a{i} = {100 + i} mm",
        f"param c{i} = {150 + 2 * i} mm",
        f"param phi{i} = {70 + i % 7} deg in 40 deg .. 100 deg",
        f"param psi{i} = {15 - i % 5} deg in 5 deg .. 30 deg",
        f"param theta{i} = {100 + i % 11} deg in 80 deg .. 120 deg",
    )


def _four_bar_vectors(i: int) -> tuple[str, ...]:
    return (
        f"O{i - 1}A{i} = a{i} @ phi{i}",
        f"A{i}B{i} = @ psi{i}",
        f"O{i}B{i} = c{i} @ theta{i}",
    )


def closed_four_bar_chain(n: int) -> str:
    """Return ``n`` four-bars in series by their lengths, the crank of the first one driving.

    Each rocker carries the crank of the next; directions follow from closing the loops.
    """
    stages = range(1, n + 1)
    return _joined(
        [
            f'mechanism closed_four_bar_chain_{n} "{n} closed four-bars in series"',
            "param phi = 70 deg in 50 deg .. 90 deg",
            *(f"pivot O{i} at ({300 * i} mm, 0 mm)" for i in range(n + 1)),
            "link O0A1",
            *(f"link A{i}B{i}" for i in stages),
            *(f"link O{i}B{i}{f'A{i + 1}' if i < n else ''}" for i in stages),
            "O0A1 = 100 mm @ phi",
            *(line for i in stages for line in _closed_four_bar(i, n)),
            "drive phi from 50 deg to 90 deg",
            "torque M on O0A1",
            f"force F at B{n} along 180 deg",
            "find k = M/F",
        ]
    )


def frictional_four_bar_chain(n: int) -> str:
    """Return the same four-bars with friction in all of their pins."""
    friction = "friction pins 0.1 diameter 20 mm"
    return closed_four_bar_chain(n).replace("find k", f"{friction}{NEWLINE}find k")


def _closed_four_bar(i: int, n: int) -> list[str]:
    lengths = [f"A{i}B{i} = {290 + i} mm", f"O{i}B{i} = {120 + i} mm"]
    crank = [f"O{i}A{i + 1} = 100 mm", f"angle B{i}O{i}A{i + 1} = 355 deg"] if i < n else []
    return [*lengths, f"assembly A{i}B{i}O{i} cw", *crank]


def coupler_chain(n: int) -> str:
    """Return ``n`` ternary couplers in series, each held by a rod to the ground.

    Link ``ABC`` of a stage hangs with A on C of the stage before; the rod at B fixes
    its rotation. A written-out k doubles its length with every stage.
    """
    stages = range(1, n + 1)
    return _joined(
        [
            f'mechanism coupler_chain_{n} "{n} ternary couplers in series"',
            "param r = 80 mm",
            "param phi = 70 deg in 40 deg .. 100 deg",
            *(line for i in stages for line in _coupler_parameters(i)),
            *(f"pivot O{i}" for i in range(n + 1)),
            "link O0C0",
            *(line for i in stages for line in _coupler_links(i)),
            "O0C0 = r @ phi",
            *(line for i in stages for line in _coupler_vectors(i)),
            "torque M on O0C0",
            f"force F at C{n} along 90 deg",
            "find k = M / F",
        ]
    )


def _coupler_parameters(i: int) -> tuple[str, ...]:
    return (
        f"param b{i} = {200 + 3 * i} mm",
        f"param c{i} = {150 + 2 * i} mm",
        f"param psi{i} = {10 + i % 7} deg in 0 deg .. 20 deg",
        f"param sigma{i} = {50 - i % 9} deg in 30 deg .. 70 deg",
        f"param theta{i} = {100 + i % 11} deg in 80 deg .. 130 deg",
    )


def _coupler_links(i: int) -> tuple[str, ...]:
    return (f"link C{i - 1}B{i}C{i}", f"link O{i}B{i}")


def _coupler_vectors(i: int) -> tuple[str, ...]:
    return (
        f"C{i - 1}B{i} = b{i} @ psi{i}",
        f"C{i - 1}C{i} = c{i} @ sigma{i}",
        f"O{i}B{i} = @ theta{i}",
    )
