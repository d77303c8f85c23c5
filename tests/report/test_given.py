"""What a report says is given."""

import pytest

import mechc
from good_mechanisms import compiled, loaded
from mechc.compilation import Compilation, compile_source
from mechc.report.languages.registry import locale
from mechc.report.roles import with_roles
from mechc.report.text.derivation import render
from mechc.source import Source
from small_mechanisms import drawn_four_bar

DRAWN = drawn_four_bar(
    "drive OA from 40 deg to 80 deg", "force F at B along x", "find k = M/F", a="(20 mm, 35 mm)"
)


def test_lengths_of_a_drawing_that_formulas_name_are_given_with_their_values():
    given = mechc.loads(DRAWN).emit("latex").split(r"\section*{Position}")[0]
    rows = [line.strip() for line in given.splitlines()]
    assert any(row.startswith("$AB$") and r"65\,\text{mm}" in row for row in rows)
    assert any(row.startswith("$CB$") and r"63.2456\,\text{mm}" in row for row in rows)
    assert sum(row.startswith("$OA$") for row in rows) == 1


def test_a_length_that_a_vector_is_written_with_stands_with_the_vector_alone():
    given = loaded("jansen_leg").emit("latex").split(r"\section*{Position}")[0]
    assert given.count("61.9") == 1 + given.count("k 61.9")


def test_a_radius_has_no_minus_and_a_rack_has_its_side():
    first, second = (
        line
        for line in loaded("d45_09_racks_pinion").emit("latex").splitlines()
        if "The rack at" in line and "item" in line
    )
    assert first.endswith("(radius $r$).")
    assert second.endswith("(radius $r$); along its guide the rack is on the left of $O$.")


def test_a_load_given_by_a_number_is_no_result_and_is_put_in():
    text = loaded("band_brake").emit("latex")
    given, found = text.split(r"\section*{Results}")
    assert any(r"$P$" in row and r"89\,\text{N}" in row for row in given.splitlines())
    assert r"\boxed{P=" not in found
    assert r"89\,\text{N}" in found.split(r"\section*{Numerical values}")[1]


def test_a_weight_has_its_value_and_is_put_in():
    numbers = loaded("wheelbarrow").emit("latex").split(r"\section*{Numerical values}")[1]
    assert r"W&=60\,\text{kg}\cdot 9.80665\,\text{m}/\text{s}^2=588.399\,\text{N}" in numbers
    assert r"588.399\,\text{N}" in numbers.split("P&=")[1]


def test_a_load_alone_is_still_a_result():
    text = mechc.loads(DRAWN.replace("find k = M/F", "let F = 20 N")).emit("latex")
    assert r"\boxed{F=" in text


TRUSS = """
mechanism truss
pivot A at (0 m, 0 m)
slider B along x
link AC
link CB
link AD
link DB
link CD
B at (4 m, 0 m)
D at (2 m, 0 m)
C at (2 m, 1.5 m)
force P at C along -y
let P = 12 kN
find N_AC
find R_A
"""


def test_a_force_in_a_rod_has_a_heading_of_its_own():
    text = mechc.loads(TRUSS).emit("latex")
    assert r"\textbf{Force in the rod $AC$:}" in text
    assert text.count(r"\textbf{Force at $A$:}") == 1
    assert "in one pose (" in text


def test_a_rod_has_two_pins_and_a_screw_has_one():
    given = loaded("screw_jack_with_collar").emit("latex").split(r"\section*{Velocities}")[0]
    assert r"Rigid link: $OE$." in given
    assert "Links with two pins" not in given
    crank = loaded("crank_slider").emit("latex")
    assert r"Links with two pins: $OA$ and $AB$." in crank


def test_a_stroke_that_is_not_the_range_of_its_parameter_is_given():
    """Extrema are looked for along the stroke, which the table of ranges does not show."""
    page, found = loaded("hoeken").emit("latex", language="uk"), compiled("hoeken")
    assert r"Узагальнена координата — $\varphi$, від $100^\circ$ до $260^\circ$." in page
    assert "The drive is φ, from 100° to 260°." in render(found.derivation, found.mechanism)
    assert "Ведуча координата" not in loaded("jansen_leg").emit("latex", language="uk")


def test_radians_that_were_written_have_degrees_beside_them():
    """Formulas put degrees in: 1.2 rad is met as 68.7549°, and what follows is in degrees."""
    found = compiled("claw_closed")
    text, page = render(found.derivation, found.mechanism), loaded("claw_closed").emit("latex")
    assert "φ = 1.2 rad (68.7549°), range 1 rad … 2 rad" in text
    assert r"$1.2\,\text{rad}$ $(68.7549^\circ)$" in page  # a narrow column may part them
    assert "γ = arcsin(sin 79.4982°) = 79.4982°" in text


WHEELS = {
    "en": (
        r"The wheel of radius $\frac{mz_S}{2}$ on $O$ is fixed to $OS$.",
        r"The wheel on $A$ is fixed to $AP$.",
        r"The wheel of radius $\frac{mz_R}{2}$ on $O$ is fixed to the ground.",
    ),
    "uk": (
        r"Колесо радіуса $\frac{mz_S}{2}$ з віссю $O$ закріплене на ланці $OS$.",
        r"Колесо з віссю $A$ закріплене на ланці $AP$.",
        r"Колесо радіуса $\frac{mz_R}{2}$ з віссю $O$ нерухоме.",
    ),
    "ru": (
        r"Колесо радиуса $\frac{mz_S}{2}$ с осью $O$ закреплено на звене $OS$.",
        r"Колесо с осью $A$ закреплено на звене $AP$.",
        r"Колесо радиуса $\frac{mz_R}{2}$ с осью $O$ неподвижно.",
    ),
}


@pytest.mark.parametrize("language", WHEELS)
def test_of_two_wheels_about_one_axis_the_radius_says_which_one_is_meant(language):
    page = loaded("planetary_gear").emit("latex", language=language)
    assert all(rf"\item {sentence}" in page for sentence in WHEELS[language])


FOLLOWING = """
mechanism m
param a = 30 mm
param phi = 20 deg in 5 deg .. 40 deg
param L = 2*a {moved}
param e = a/4
pivot O
link OAB
OA = L @ phi
OB = a @ phi
force P at A along perp OA
force F at B along perp OA
drive phi
find k = P/F
"""


@pytest.mark.parametrize(
    ("moved", "shown"), [("", r"$2a$ $= 60\,\text{mm}$ &"), ("*cos(phi)", r"\cos\varphi$ &")]
)
def test_what_follows_from_given_values_has_its_own_unless_it_is_among_the_numbers(moved, shown):
    """k = a/L is a number, or L stands among the numbers; nothing has e, whatever L is."""
    page = mechc.loads(FOLLOWING.format(moved=moved), "m.mech").emit("latex")
    (of_l,) = (row for row in page.splitlines() if row.strip().startswith("$L$ &"))
    assert shown in of_l
    assert r"$\frac{a}{4}$ $= 7.5\,\text{mm}$" in page


@pytest.mark.parametrize(
    ("language", "kinds"),
    [
        ("uk", ["guide", "face", "gear", "belt", "rack", "screw", "collar", "rope"]),
        ("ru", ["guide", "face", "gear", "belt", "rack", "collar", "rope"]),
    ],
)
def test_shortened_indices_are_explained_where_friction_is_given(language, kinds):
    """The index of n_{B,напр} says nothing to who has not read what it stands for."""
    words = locale(language)
    for kind in kinds:
        assert f"«{words.subscripts[kind]}»" in words.given_friction[kind]


@pytest.mark.parametrize(
    ("language", "said"),
    [
        ("en", "A rope, band or belt runs through"),
        ("uk", "Гнучка ланка (канат, стрічка, пас) проходить через"),
        ("ru", "Гибкое звено (канат, лента, ремень) проходит через"),
    ],
)
def test_what_slides_around_a_drum_need_be_no_rope(language, said):
    assert said in loaded("band_brake").emit("latex", language=language)


def test_a_rope_over_pulleys_is_one():
    assert "A rope runs through" in loaded("block_and_tackle").emit("latex")


OBLIQUE = """
mechanism oblique
slider B along 80 deg
pivot O
link OAC
link AB
OA = 100 mm @ 47 deg
angle AOC = 33 deg
OC = 60 mm
AB = @ -30 deg
force P at C along y
force F at B along 80 deg
find k = P/F
"""


@pytest.mark.parametrize(
    ("language", "unicode", "expected"),
    [
        ("en", True, ["∠(x, OA) = 47°", "∠AOC = 33°", "∠(x, AB) = −30°"]),
        ("en", False, ["angle(x, OA) = 47 deg", "angle AOC = 33 deg", "angle(x, AB) = -30 deg"]),
        ("en", True, ["The point B moves along a guide with the direction 80°."]),
        ("uk", True, ["Точка B рухається вздовж напрямної під кутом 80° до осі x."]),
        ("ru", True, ["Сила F приложена в точке B под углом 80° к оси x."]),
    ],
)
def test_a_derivation_has_the_angles_that_are_numbers(language, unicode, expected):
    compilation = compile_source(Source("m.mech", OBLIQUE))
    shown = render(compilation.reported, compilation.mechanism, unicode=unicode, language=language)
    given = " ".join(shown.partition("\n\n")[2].partition("\n\n")[0].split())
    assert all(line in given for line in expected)
    assert "P" not in given  # it acts along an axis


def test_a_derivation_gives_what_its_formulas_have_of_a_drawing():
    """Neither the coordinate of the pivot nor the length of the rod has a part in k."""
    source = DRAWN.replace("drive OA from 40 deg to 80 deg\n", "")
    source = source.replace("pivot C at (100 mm, 0 mm)", "slider B along x").replace(
        "link CB\n", ""
    )
    compilation = compile_source(Source("m.mech", source))
    shown = render(compilation.reported, compilation.mechanism)
    given = shown.partition("Given")[2].partition("Velocities")[0]
    assert "OA = " in given
    assert "φ_AB = " in given
    assert " AB = " not in given


@pytest.mark.parametrize(
    ("language", "sentence"),
    [
        ("en", "φ_OA is the direction of the vector OA, counter-clockwise from x."),
        ("uk", "φ_OA — кут від осі x до вектора OA проти годинникової стрілки."),
        ("ru", "φ_OA — угол от оси x до вектора OA против часовой стрелки."),
    ],
)
def test_a_direction_that_a_derivation_does_not_have_is_not_introduced(language, sentence):
    """Of the rod KA nothing is said: the couple turns the lever by itself."""
    source = """
        pivot O at (0 mm, 0 mm)
        slider K along y
        link KA
        link OA
        K at (0 mm, 10 mm)
        A at (20 mm, -15 mm)
        torque P on OA
        force F at A along 30 deg
        find k = P/F
    """
    compilation = compile_source(Source("m.mech", source))
    shown = render(compilation.reported, compilation.mechanism, language=language)
    assert sentence in " ".join(shown.split())
    assert "φ_KA" not in shown


def test_an_angle_in_radians_is_given_in_degrees_too():
    source = OBLIQUE.replace("@ 47 deg", "@ 0.4 rad").replace("AOC = 33 deg", "AOC = 0.5 rad")
    compilation = compile_source(Source("m.mech", source))
    english, ukrainian = (
        render(compilation.reported, compilation.mechanism, language=language)
        for language in ("en", "uk")
    )
    assert "∠(x, OA) = 0.4 rad (22.9183°)" in english
    assert "∠AOC = 0.5 rad (28.6479°)" in english
    assert "∠(x, OA) = 0,4 рад (22,9183°)" in ukrainian


def test_an_angle_of_a_drawing_is_given_once():
    text = mechc.loads(DRAWN.replace("drive OA from 40 deg to 80 deg\n", "")).emit("latex")
    (row,) = (line for line in text.splitlines() if line.startswith(r"$\varphi_{OA}$"))
    assert row.count(r"^\circ") == 1


def test_quantities_without_a_text_are_called_by_what_they_are():
    """The coefficient, the diameter, the rate and the free length; not what has a text."""
    source = Source(
        "spring.mech",
        """
        mechanism spring
        param c = 5 N/mm
        param l0 = 80 mm # of the spring at rest
        param f = 0.1
        pivot O at (0 mm, 0 mm)
        pivot Q at (0 mm, 100 mm)
        link OA
        A at (80 mm, 30 mm)
        force P at A along y
        spring c between Q and A free l0
        friction pins f diameter 12 mm
        find P
        """,
    )
    words = locale("en").roles
    mechanism = Compilation(source).mechanism
    shown = with_roles((*mechanism.parameters, *mechanism.literals), mechanism, words)
    labels = {p.name: p.label or p.about for p in shown}
    found = {name: labels[name] for name in ("c", "l0", "f", "d")}
    assert found == {
        "c": "rate of the spring",
        "l0": "of the spring at rest",
        "f": "coefficient of friction",
        "d": "diameter of the pin",
    }


@pytest.mark.parametrize(
    ("friction", "called"),
    [
        ("f diameter d", {"f": "coefficient of friction", "d": "diameter of the pin"}),
        ("f diameter d coulomb", {"f": "coefficient of friction", "d": "diameter of the pin"}),
        ("f diameter 2*d", {}),
        ("f/2 diameter d", {}),
        ("f diameter d + l0", {"c": "rate of the spring", "l0": "free length of the spring"}),
        ("f diameter l0", {"f": "coefficient of friction", "c": "rate of the spring"}),
    ],
)
def test_what_is_a_part_of_a_size_is_not_called_by_it(friction, called):
    """The radius r in ``diameter 2*r`` is no diameter, and 2c, not c, is the rate of a spring."""
    spring = "c" if "l0" in friction else "2*c"
    source = f"""
        mechanism spring
        param c = 5 N/mm
        param l0 = 80 mm
        param d = 12 mm
        param f = 0.1
        pivot O at (0 mm, 0 mm)
        pivot Q at (0 mm, 100 mm)
        link OA
        A at (80 mm, 30 mm)
        force P at A along y
        spring {spring} between Q and A free l0
        friction pins {friction}
        find P
        """
    mechanism = Compilation(Source("spring.mech", source)).mechanism
    shown = with_roles(mechanism.parameters, mechanism, locale("en").roles)
    assert {p.name: p.label for p in shown if p.label} == called


@pytest.mark.parametrize(
    ("size", "called"),
    [
        ("mean 26 mm", {"D_A": "mean diameter of the collar"}),
        ("mean d + 8 mm", {}),
        ("mean 2*b", {}),
    ],
)
def test_the_mean_diameter_of_a_collar_is_called_so(size, called):
    source = f"""
        mechanism screw
        param d = 18 mm
        param b = 13 mm
        pivot S at (-200 mm, 0 mm)
        slider A along x
        link SH
        A at (0 mm, 0 mm)
        H at (-200 mm, 60 mm)
        screw A pitch 4 mm on SH
        torque M on SH
        force F at A along -x
        friction screw A 0.12 thread d
        friction collar A 0.1 {size}
        find M/F
        """
    mechanism = Compilation(Source("screw.mech", source)).mechanism
    known = (*mechanism.parameters, *mechanism.literals)
    shown = with_roles(known, mechanism, locale("en").roles)
    labels = {p.name: p.label for p in shown if p.label}
    assert labels.items() >= called.items()
    assert ("mean diameter of the collar" in labels.values()) == bool(called)


def test_a_size_that_several_parts_share_is_called_after_none_of_them():
    """Two equal springs: their rate is c, and each free length has the spring's own name."""
    source = Source(
        "springs.mech",
        """
        mechanism springs
        pivot O at (0 mm, 0 mm)
        pivot Q at (0 mm, 100 mm)
        pivot R at (120 mm, 100 mm)
        link OAB
        A at (60 mm, 10 mm)
        B at (100 mm, 20 mm)
        spring 5 N/mm between Q and A free 150 mm
        spring 5 N/mm between R and B free 120 mm
        friction pin O 0.1 diameter 12 mm
        torque M on OAB
        find M
        """,
    )
    mechanism = Compilation(source).mechanism
    shown = with_roles(mechanism.literals, mechanism, locale("en").roles)
    labels = {p.name: p.label for p in shown if p.label}
    assert labels == {
        "c": "rate of the springs",
        "l_QA": "free length of the spring",
        "l_RB": "free length of the spring",
        "f_O": "coefficient of friction",
        "d_O": "diameter of the pin",
    }


@pytest.mark.parametrize("order", [(0, 1, 2), (2, 1, 0)])
def test_the_name_of_equal_diameters_does_not_depend_on_the_order_of_lines(order):
    pins = [f"friction pin {point} 0.1 diameter 20 mm" for point in "OAK"]
    lines = [
        "mechanism toggle",
        "param alpha = 20 deg",
        "pivot O",
        "slider K along y",
        "link OA",
        "link AK",
        "OA = 200 mm @ 90 deg + alpha",
        "AK = 200 mm @ 90 deg - alpha",
        "force P at A along 0 deg",
        "force F at K along -90 deg",
        "find k = P/F",
        *(pins[i] for i in order),
    ]
    compilation = Compilation(Source("toggle.mech", "\n".join(lines)))
    literals = {literal.name for literal in compilation.mechanism.literals}
    assert literals == {"f", "d", "len_OA", "len_AK"}


def test_coordinates_and_radii_that_are_numbers_are_called_so_in_a_table():
    text = mechc.load("watt_closed").emit("latex")
    assert "$x_{O_{2}}$ & coordinate of $O_{2}$ & " in text


def test_a_load_that_follows_from_another_one_is_given_in_a_terminal() -> None:
    """T = f · R of a claw is in the power equation; that of a weight is m·g, and stands there."""
    found = compiled("claw_closed")
    lines = render(found.derivation, found.mechanism).splitlines()
    assert "  T = f · R" in lines[: lines.index("Position")]
    plain = compiled("crank_rocker")
    assert "T = " not in render(plain.derivation, plain.mechanism)


def test_every_row_of_a_drawing_says_what_it_is() -> None:
    """Angles of links and places of guides have a text; what is open altogether has no row."""
    text = mechc.loads(
        """
        mechanism lift
        pivot A at (0 mm, 0 mm)
        pivot E at (-100 mm, 50 mm)
        slider K along x through (0 mm, 20 mm)
        link ABG
        link GK
        telescope EG
        B at (600 mm, -100 mm)
        G at (300 mm, -60 mm)
        K at (500 mm, 20 mm)
        drive AB from -20 deg to 20 deg
        actuator S between E and G
        weight W mass 500 kg at B
        find m = S/W
        """
    ).emit("latex")
    assert r"$\delta_{BAG}$ & angle $BAG$ & " in text
    assert "$y_{K_{0}}$ & coordinate of the guide of $K$ & " in text
    assert "$EG$ &" not in text


def test_a_derivative_is_called_so_once() -> None:
    text = mechc.load("steering_trapezium").emit("latex")
    assert text.count("erivative with respect to the driving coordinate: $") == 1


LETS = """
mechanism m
param a = 30 mm
param b = 40 mm
param phi = 0.3 rad
let c = a + b
let d = c + 1 cm in cm
let psi = phi + 10 deg
pivot O
link OAB
OA = c @ psi
OB = d @ psi
force P at A along psi + 90 deg
force F at B along psi - 90 deg
find k = P/F
"""


def test_what_follows_from_given_quantities_has_its_value_in_the_unit_it_uses():
    found = mechc.loads(LETS)._compilation
    assert [p.unit for p in found.mechanism.parameters] == ["mm", "mm", "rad", "mm", "cm", "deg"]
    with_values = render(found.derivation, found.mechanism)
    assert "c = a + b = 70 mm\n" in with_values
    assert "d = c + 1 cm = 8 cm\n" in with_values
    assert "ψ = φ + 10° = 27.1887°\n" in with_values
    assert "c = a + b\n" in render(found.derivation, found.mechanism, numbers=False)
    assert r"$c$ & $a+b$ $= 70\,\text{mm}$" in mechc.loads(LETS).emit("latex")


def test_loads_masses_and_components_say_what_they_are():
    source = """
    mechanism tongs
    param m = 5 kg
    param q = 2 kN/m
    param gamma = 40 deg
    pivot O
    slider C along y
    link OAB
    link CA
    OA = (120 mm, 250 mm)
    OB = (150 mm, -300 mm)
    CA = 200 mm @ -gamma
    weight W mass m at B
    force N at B along -x
    let N = 3 kN
    torque M on OAB
    let M = 2 kN*m
    load Q intensity q on CA along -y
    force P at C along y
    find P
    """
    given = mechc.loads(source).emit("latex").split(r"\section*{Velocities}")[0]
    rows = {row.split("&")[0].strip(): row for row in given.splitlines() if row.count("&") > 1}
    said = {"$N$": "force", "$M$": "couple", "$m$": "mass", "$q$": "intensity"}
    said["$y_{OA}$"] = "vertical component of the vector $OA$"
    for symbol, what in said.items():
        assert what in rows[symbol]


def test_in_the_terminal_components_say_what_they_are():
    """A parameter that is one component is called so, one that is a length besides is not."""
    source = """
    mechanism crank
    param b = 90 mm
    param d = 70 mm
    pivot O
    slider K along x
    link OAB
    link BK
    OA = (d, 10 mm)
    OB = (60 mm, b)
    BK = b @ -20 deg
    force P at A along -y
    force F at K along -x
    find k = P/F
    """
    found = compile_source(Source("crank.mech", source))
    assert isinstance(found, Compilation)
    text = render(found.derivation, found.mechanism)
    lines = [" ".join(line.split()) for line in text.splitlines()]
    assert "b = 90 mm" in lines
    assert "d = 70 mm horizontal component of the vector OA" in lines
    assert "x_OB = 60 mm horizontal component of the vector OB" in lines
