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


def vice(*lines: str) -> str:
    """Return a vice whose screw and collar lock it: the jaw F presses back, a force P turns it."""
    return _text(
        "pivot O",
        "slider A along x",
        "link OH",
        "OH = 150 mm @ 90 deg",
        "screw A pitch 5 mm on OH",
        "force P at H along 180 deg",
        "force F at A along -x",
        "friction screw A 0.12 thread 20 mm",
        "friction collar A 0.15 mean 26 mm",
        "let P = 100 N",
        *lines,
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


def lever(*lines: str) -> str:
    """Return a lever OAB, its arms of 60 mm and 90 mm in line, with a force down at each end."""
    return _text(
        "pivot O",
        "link OAB",
        "OA = 60 mm @ 20 deg",
        "OB = 90 mm @ 200 deg",
        "force P at A along -y",
        "force F at B along -y",
        "find k = P/F",
        *lines,
    )


def gripper(*lines: str, push: str = "-y") -> str:
    """Return a lever OAJ by places, whose rod KA the slider K pushes at."""
    return _text(
        "mechanism drawn",
        "pivot O at (30 mm, 0 mm)",
        "slider K along y",
        "link KA",
        "link OAJ",
        "K at (0 mm, 10 mm)",
        "A at (20 mm, -15 mm)",
        "J at (12 mm, 60 mm)",
        f"force P at K along {push}",
        "force F at J along x",
        "find k = P/F",
        *lines,
    )


def boom(*lines: str) -> str:
    """Return a boom OC that a cylinder GC holds, at a right angle where it is 5 m long."""
    return _text(
        "param s = 5 m",
        "pivot O at (0 m, 0 m)",
        "pivot G at (3 m, 0 m)",
        "link OC",
        "telescope GC",
        "OC = 4 m",
        "GC = s",
        "assembly OCG cw",
        "actuator P between G and C",
        "torque T on OC",
        *lines,
    )


def jib(*lines: str) -> str:
    """Return a jib OBA by places, with a load W at A, that a cylinder CB raises."""
    return _text(
        'mechanism jib "Jib"',
        "pivot O at (0 m, 0 m)",
        "pivot C at (1 m, -0.5 m)",
        "link OBA",
        "telescope CB",
        "A at (4 m, 3 m)",
        "B at (2 m, 1.2 m)",
        "drive CB from 1.8 m to 2.4 m",
        "force W at A along -y",
        "actuator P between C and B",
        *lines,
    )


def wedges(*lines: str, along: str = "x") -> str:
    """Return a wedge WX of the angle beta along a guide, which lifts the slide AV at its face."""
    return _text(
        "param beta = 8 deg in 2 deg .. 30 deg",
        "param mu = 0.1",
        f"slide WX along {along}",
        "slide AV along y",
        "contact A on WX normal 90 deg - beta",
        "force P at W along x",
        "force F at V along -y",
        "friction slider W mu",
        "friction contact A mu",
        "find k = P / F",
        *lines,
    )


def movable_pulley(*lines: str) -> str:
    """Return a load F on a pulley K, in a rope from A that is alpha off the guide, over B to H."""
    return _text(
        "param alpha = 20 deg in 0 deg .. 60 deg",
        "pivot A",
        "pivot B",
        "slider K along y",
        "slider H along -y",
        "rope A, K along -90 deg + alpha, B along y, H along -y",
        "force P at H along -y",
        "force F at K along -y",
        *lines,
    )


def mirrored_rope(*lines: str) -> str:
    """Return a load F on K in ropes of both sides, each over a pulley B to a hand H."""
    return _text(
        "param alpha = 20 deg in 10 deg .. 60 deg",
        "pivot B",
        "slider K along y",
        "slider H along y",
        "rope K, B along 90 deg - alpha, H along -90 deg",
        "mirror across y sharing K",
        "force P at H along -y",
        "force F at K along -y",
        "find k = P/F",
        *lines,
    )


def gear_train(*lines: str) -> str:
    """Return two pairs of gears, on O1, O2 and O3, between a crank O1C and a drum O3D."""
    return _text(
        "pivot O1 at (0 mm, 0 mm)",
        "pivot O2 at (60 mm, 0 mm)",
        "pivot O3 at (130 mm, 0 mm)",
        "link O1C",
        "link O2E",
        "link O3D",
        "O1C = 100 mm @ 0 deg",
        "O2E = 50 mm @ 90 deg",
        "O3D = 80 mm @ 0 deg",
        "gear O1 20 mm, O2 40 mm",
        "gear O2 15 mm, O3 55 mm",
        "force P at C along -y",
        "force Q at D along -y",
        "find k = P/Q",
        *lines,
    )


def drawn_six_bar(*lines: str) -> str:
    """Return a drawn four-bar OABQ whose rocker QBC moves the slider K by the rod CK."""
    return _text(
        "mechanism watt",
        "pivot O at (0 mm, 0 mm)",
        "pivot Q at (220 mm, 40 mm)",
        "slider K along y",
        "link OA",
        "link AB",
        "link QBC",
        "link CK",
        "A at (40 mm, 60 mm)",
        "B at (200 mm, 190 mm)",
        "C at (330 mm, 120 mm)",
        "K at (330 mm, -100 mm)",
        "drive OA from 30 deg to 100 deg",
        "torque M on OA",
        "force F at K along y",
        "find k = M/F",
        *lines,
    )


def geared_lever(*lines: str, alpha: str = "30 deg") -> str:
    """Return a lever QC with a force down at C, turned by gears that lose a fiftieth.

    At 90 deg the force goes through its pivot, and the gears pass nothing on.
    """
    return _text(
        f"param alpha = {alpha}",
        "pivot O",
        "pivot Q",
        "link OB",
        "link QC",
        "gear O 30 mm, Q 60 mm",
        "OB = 10 mm @ 0 deg",
        "QC = 100 mm @ alpha",
        "torque M on OB",
        "force F at C along -y",
        "find k = M/F",
        "friction gear O 0.02",
        *lines,
    )


def lifter(*lines: str, at: str = "180 deg + phi", pushed: str = "280 deg + phi") -> str:
    """Return a lever AOJ that lifts the slide KW, with friction; at 0 deg its contact stands still.

    ``at`` and ``pushed`` are the directions of OA and OJ.
    """
    return _text(
        "param phi = 0 deg",
        "pivot O",
        "slide KW along y",
        "link AOJ",
        f"OA = 35 mm @ {at}",
        f"OJ = 90 mm @ {pushed}",
        "contact A on KW normal 168 deg",
        "force P at K along y",
        "force F at J along x",
        "friction contact A 0.12",
        "friction pin O 0.1 diameter 12 mm",
        "find k = P/F",
        *lines,
    )


def slotted_lever() -> str:
    """Return a crank CA, drawn in line with the slotted lever OE that its pin A moves.

    In the middle of the stroke the pin turns back in its slot.
    """
    return _text(
        "mechanism slot",
        "pivot O at (0 mm, 0 mm)",
        "pivot C at (0 mm, 150 mm)",
        "link CA",
        "link OE",
        "A at (0 mm, 200 mm)",
        "E at (0 mm, 350 mm)",
        "slot A in OE",
        "drive CA from 10 deg to 170 deg",
        "torque M on CA",
        "force F at E along x",
        "friction contact A 0.3",
        "friction pins 0.2 diameter 40 mm",
        "find k = M/F",
    )


def _text(*lines: str) -> str:
    return "\n".join((*lines, ""))


LOADED_COUPLER = """
param phi = 30 deg
param psi: angle
pivot O at (0 mm, 0 mm)
slider B along x through O
link OA
link ABC
OA = 60 mm @ phi
AB = 150 mm @ psi
AC = 80 mm @ psi
assembly B forward
torque M on OA
force F at C along -y
friction pin A 0.1 diameter 12 mm
find k = M/F
"""
"""How hard pin A is loaded depends on the friction in it alone, which is iterated."""
