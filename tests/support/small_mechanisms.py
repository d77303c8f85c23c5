"""Small mechanisms as texts: what they have in common is said here, what a test is about there.

Each takes its sizes, and lines of the test's own that come behind all others.
"""


def slider_crank(
    *lines: str,
    r: str = "50 mm",
    l: str = "200 mm",  # noqa: E741
    phi: str = "60 deg",
    drive: str = "from 0 deg to 360 deg",
    along: str = "-x",
) -> str:
    """Return a crank OA, r long at phi, whose rod AB of the length l moves the slider B along x."""
    return _text(
        f"param r = {r}",
        f"param l = {l}",
        f"param phi = {phi}",
        "pivot O at (0 mm, 0 mm)",
        "slider B along x through O",
        "link OA",
        "link AB",
        "OA = r @ phi",
        "AB = l",
        "assembly B forward",
        f"drive phi {drive}",
        "torque M on OA",
        f"force F at B along {along}",
        *lines,
    )


def follower(*lines: str) -> str:
    """Return a slider-crank whose pin A moves a rod AC and a rocker QC, which bear no load."""
    return slider_crank(
        "link AC",
        "AC = 90 mm",
        "pivot Q at (60 mm, 80 mm)",
        "link QC",
        "QC = 70 mm",
        "assembly ACQ cw",
        "find k = M / F",
        *lines,
        drive="from 40 deg to 80 deg",
    )


def four_bar(
    *lines: str,
    a: str = "40 mm",
    b: str = "120 mm",
    c: str = "80 mm",
    d: str = "100 mm",
    phi: str = "60 deg",
    drive: str = "from 0 deg to 360 deg",
    assembly: str = "cw",
    pivots: tuple[str, str] = ("O", "C"),
) -> str:
    """Return a crank OA, a coupler AB and a rocker CB of the lengths a, b, c; C is at (d, 0)."""
    first, second = pivots
    return _text(
        f"param a = {a}",
        f"param b = {b}",
        f"param c = {c}",
        f"param d = {d}",
        f"param phi = {phi}",
        f"pivot {first} at (0 mm, 0 mm)",
        f"pivot {second} at (d, 0 mm)",
        f"link {first}A",
        "link AB",
        f"link {second}B",
        f"{first}A = a @ phi",
        "AB = b",
        f"{second}B = c",
        f"assembly AB{second} {assembly}",
        *([f"drive phi {drive}"] if drive else []),
        f"torque M on {first}A",
        f"torque T on {second}B",
        *lines,
    )


def drawn_four_bar(*lines: str, a: str = "(20 mm, 34.6 mm)") -> str:
    """Return a crank OA, a coupler AB and a rocker CB by places, A where it is drawn."""
    return _text(
        "mechanism drawn",
        "pivot O at (0 mm, 0 mm)",
        "pivot C at (100 mm, 0 mm)",
        "link OA",
        "link AB",
        "link CB",
        f"A at {a}",
        "B at (80 mm, 60 mm)",
        "torque M on OA",
        *lines,
    )


def toggle(
    *lines: str,
    l: str = "200 mm",  # noqa: E741
    alpha: str = "10 deg",
    guide: str = "90 deg",
) -> str:
    """Return bars OB and BK, both l long and alpha off the guide of K, pushed by P at B."""
    return _text(
        f"param l = {l}",
        f"param alpha = {alpha}",
        "pivot O",
        f"slider K along {guide}",
        "link OB",
        "link BK",
        "OB = l @ 90 deg + alpha",
        "BK = l @ 90 deg - alpha",
        "force P at B along 0 deg",
        "force F at K along -90 deg",
        *lines,
    )


def _text(*lines: str) -> str:
    return "\n".join((*lines, ""))
