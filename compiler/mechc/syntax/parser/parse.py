"""One logical line, or one YAML scalar, to its node, with the words for what went wrong."""

from collections.abc import Sequence

from ...diagnostics import Diagnostic, syntax
from ...source import Span
from ..fault import Fault
from ..vocabulary import IN_A_UNIT, ROUTE, points_of
from . import slips, statement_examples
from .grammar import Start, keywords, reading, spelling, statement_words, with_names
from .lalr import END, Refused, Token, span_of
from .tokens import check

NAMING = frozenset(
    {"PARAM", "LET", "FORCE", "TORQUE", "ACTUATOR", "WEIGHT", "DRIVE", "MECHANISM"}
    | {"SHEET", "TABLE", "LIST"}
)
"""After these words a name is given."""

OPERAND = frozenset({"NAME", "NUMBER", "LEFT"})

PLACE = "the place of a point is written {} at (20 mm, 35 mm)"
PLACED = PLACE.format("A")

SHARED = "points that links share are pins, A at (20 mm, 35 mm); on the ground they are pivots"

GEARS, SCREW = "gear O1 20 mm, O2 30 mm", "screw A pitch 5 mm on OB"

SAID_OTHERWISE = {
    "/": "a comment begins with '#'",
    "ground": "a pin on the ground is a pivot: pivot O",
    "fixed": "a pin on the ground is a pivot: pivot O",
    "rod": "a rod is a link of two points: link AB",
    "bar": "a bar is a link of two points: link AB",
    "crank": "a crank is a link of two points: link OA",
    "body": "a body is a link of its points: link OAB",
    **dict.fromkeys(("pin", "joint", "revolute"), SHARED),
    "point": PLACED,
    "node": PLACED,
    "motor": "a couple on a link is a torque: torque M on OA",
    "moment": "a couple on a link is a torque: torque M on OA",
    "cylinder": "a link of variable length is a telescope: telescope AB",
    "piston": "a point that the ground guides is a slider: slider B along x",
    "range": "a range stands behind its parameter: param a = 2 mm in 1 mm .. 5 mm",
    "chain": "a chain is a belt: belt O1 20 mm, O2 30 mm",
    "pulley": "a pulley leads a belt, belt O1 20 mm, O2 30 mm, or a rope, rope A, K along y",
    "symmetric": "a half is mirrored: mirror across 90 deg sharing K",
    "symmetry": "a half is mirrored: mirror across 90 deg sharing K",
    **dict.fromkeys(("import", "include"), 'what is used has a prefix: use "pin.mech" as pin'),
    **dict.fromkeys(("hinge", "support", "bearing"), "a pin on the ground is a pivot: pivot O"),
    **dict.fromkeys(("lever", "rocker", "coupler"), "a lever is a link of its points: link OAB"),
    **dict.fromkeys(("guide", "prismatic"), "what the ground guides is a slider: slider B along x"),
    "cam": "a cam touches: contact A on WX normal 80 deg",
    "mass": "a mass acts by its weight: weight W mass 2 kg at G",
    "input": "what moves is driven: drive phi from 10 deg to 80 deg",
    **dict.fromkeys(("result", "output", "solve"), "a result is asked for: find k = P/F"),
    **dict.fromkeys(
        ("assume", "constraint", "condition", "check", "ensure", "assert"),
        "a condition is: require a < 2 mm",
    ),
    **dict.fromkeys(("units", "unit"), "each number has its unit behind it: param a = 40 mm"),
    "title": 'a title stands behind the name: mechanism clamp "Toggle clamp"',
    **dict.fromkeys(("author", "description"), 'where it comes from is a source: source "Book"'),
    "end": "a description ends with its file: leave it out",
    **dict.fromkeys(("strut", "tie", "conrod"), "a rod is a link of two points: link AB"),
    **dict.fromkeys(
        ("beam", "frame", "plate", "triangle", "handle", "bellcrank", "shaft"),
        "a rigid body is a link of its points: link OAB",
    ),
    **dict.fromkeys(
        ("cable", "cord", "wire", "string", "band", "tape"),
        "what passes a pull on around pulleys or drums is a rope: rope A, K along -y, B along y",
    ),
    **dict.fromkeys(
        ("brake", "clutch"),
        "a brake is its friction: friction collar O 0.3 mean 100 mm thrust W, or of a band "
        "friction rope O 0.3 wrap 180 deg drum 200 mm on OC",
    ),
    **dict.fromkeys(("wheel", "sprocket", "pinion", "tooth"), "wheels stand in pairs: " + GEARS),
    "worm": "a screw moves a slider, screw A pitch 5 mm on OB; a worm wheel is a gear: " + GEARS,
    **dict.fromkeys(("nut", "thread", "lead"), "a nut is moved by a screw: " + SCREW),
    **dict.fromkeys(
        ("wedge", "plunger", "carriage"),
        "a body that only translates is a slide: slide WXY along x",
    ),
    **dict.fromkeys(("groove", "track"), "a pin slides in a slot: slot B in OC"),
    **dict.fromkeys(("rail", "block"), "what the ground guides is a slider: slider B along x"),
    "roller": "a roller in a guide is a slider, and has friction: friction roller A 0.1 axle 10 mm "
    "wheel 40 mm",
    "couple": "a couple on a link is a torque: torque M on OA",
    **dict.fromkeys(
        ("pressure", "distributed", "udl"),
        "a load spread over a link is: load Q intensity 5 N/mm on AB along -y",
    ),
    **dict.fromkeys(
        ("compute", "calculate", "determine", "show", "print"),
        "a result is asked for: find k = P/F",
    ),
    **dict.fromkeys(("plot", "draw"), "what a report holds is: report scheme, plot k over alpha"),
    **dict.fromkeys(
        ("set", "define", "const", "constant", "given", "variable", "parameter", "var"),
        "a quantity is a parameter, param a = 40 mm, and what follows from others a let",
    ),
    **dict.fromkeys(("function", "equation"), "a formula is a let: let p = 4*P/(pi*d^2)"),
    **dict.fromkeys(
        ("length", "vector", "direction"),
        "a vector is its length @ its direction: OA = 60 mm @ 30 deg",
    ),
    "coordinates": PLACED,
    "mu": "friction names its joint: friction slider K 0.1",
    **dict.fromkeys(
        ("branch", "configuration"), "which way a loop closes is an assembly: assembly ABC ccw"
    ),
}
"""What people call a thing, and how it is stated here."""

HUMAN = {
    "NAME": "a name",
    "NUMBER": "a number",
    "STRING": 'a text in "quotes"',
    "COMPARISON": "a comparison",
    END: "the end",
    "LEFT": "'('",
    "RIGHT": "')'",
}


def parse(line: Sequence[Token], start: Start, end: int) -> object:
    """Return the tree of the tokens; ``end`` is where more was expected if they are too few.

    Raises :class:`Fault` with the first thing that does not fit.
    """
    line = with_names(line, start)
    check(line)
    if start == "statement" and line[0].type == "NAME" and not may_begin(line):
        raise Fault(unknown_statement(line))
    at = reading(start)
    for position, token in enumerate(line):
        try:
            at.feed(token)
        except Refused:
            allowed = allowed_after(line[:position], start)
            raise Fault(unexpected(line, position, allowed, start)) from None
    try:
        return at.feed(Token(END, "", end, end))
    except Refused:
        raise Fault(unfinished(line, allowed_after(line, start), end, start)) from None


def may_begin(line: Sequence[Token]) -> bool:
    """Return whether a line may begin with this name: a point's at its place, or a vector's."""
    points = points_of(line[0])
    return len(points) > 1 or (len(points) == 1 and line[1:2] != ["="])


def allowed_after(tokens: Sequence[Token], start: Start) -> set[str]:
    """Return the kinds of tokens that may follow tokens that fit.

    The parser that has refused a token can't be asked: it may have closed what was open
    before it found that the token does not fit.
    """
    at = reading(start)
    for token in tokens:
        at.feed(token)
    return at.accepted()


def unfinished(line: Sequence[Token], allowed: set[str], end: int, start: Start) -> Diagnostic:
    """Return the error about a statement that ends too early."""
    opened = [token for token in line if token.type == "LEFT"]
    if "RIGHT" in allowed and opened:
        return syntax.unclosed_bracket(span_of(innermost_open(line)), "(")
    if start == "statement" and len(line) == 1 and line[0].type == "NAME":
        return unknown_statement(line)
    hint = ROUTE if start == "route" else slips.unfinished(line, allowed)
    return syntax.unfinished_statement(Span(end, end), expected_words(allowed), hint)


def is_open(line: Sequence[Token]) -> bool:
    """Return whether a bracket is opened and not closed."""
    kinds = [token.type for token in line]
    return kinds.count("LEFT") > kinds.count("RIGHT")


def innermost_open(line: Sequence[Token]) -> Token:
    """Return the last bracket that is still open."""
    still: list[Token] = []
    for token in line:
        if token.type == "LEFT":
            still.append(token)
        elif token.type == "RIGHT":
            still.pop()
    return still[-1]


def unexpected(line: Sequence[Token], position: int, allowed: set[str], start: Start) -> Diagnostic:
    """Return the error about a token that does not fit, as exact as it is known."""
    token = line[position]
    before = line[position - 1] if position else None
    span, text = span_of(token), str(token)
    if start == "statement" and begins_wrongly(line, position):
        return unknown_statement(line)
    lacks_name = allowed == {"NAME"} and text in keywords() and slips.lacks_name(line, position)
    if before is not None and before.type in NAMING and text in keywords() and not lacks_name:
        return syntax.reserved_word(span, text)
    if token.type == "RIGHT" and not is_open(line[:position]):
        return syntax.unclosed_bracket(span, ")")
    if line[0].type in ("PARAM", "LET") and position == 2 and token.type in OPERAND:
        is_glued = text.startswith(".") and before is not None and span_of(before).end == span.start
        hint = f"a name has no dot: write {before}_{text[1:].split()[0]}" if is_glued else ""
        return syntax.missing_equals(span, described(token), hint)
    hint = (
        statement_examples.example(line, allowed)
        if lacks_name
        else _in_a_value(line, position, allowed, start)
    )
    hint = hint or slips.hint_for(line, position, allowed)
    return syntax.unexpected_text(span, described(token), expected_words(allowed), hint)


def _in_a_value(line: Sequence[Token], position: int, allowed: set[str], start: Start) -> str:
    """Return a hint at what is written otherwise in a value of YAML, '' in a statement."""
    if start == "statement":
        return ""
    if start == "let_value" and line[position] == "in":
        return IN_A_UNIT
    if start == "route":
        return ROUTE
    is_formula = start in ("let_value", "condition")
    return (
        (slips.of_asking(line, position, allowed) if is_formula else "")
        or slips.of_decimals(line, position)
        or slips.in_scalar(line[position], allowed)
    )


def begins_wrongly(line: Sequence[Token], position: int) -> bool:
    """Return whether the line begins with a word that is neither a statement's nor a vector."""
    return position == 0 or (position == 1 and line[0].type == "NAME")


def unknown_statement(line: Sequence[Token]) -> Diagnostic:
    """Return the error about a line whose first word begins no statement."""
    word = str(line[0])
    hint = meant_by_assignment(line) if line[1:2] == ["="] else ""
    if len(points_of(word)) == 1 and not hint:
        hint = PLACE.format(word)
    if len(word) == 1 and line[1:2] == ["at"]:
        hint = PLACE.format(word.upper())
    if len(points_of(word)) > 1:
        hint = f"a vector is written {word} = length @ direction"
    if len(line) > 2 and line[1].type == "NAME" and line[2] == "=" and not points_of(word):
        hint = f"a value is declared by param, a formula is a let: param {line[1]} = …"
    if word.lower() in statement_words():
        hint = f"did you mean {word.lower()!r}?"
    hint = SAID_OTHERWISE.get(word.lower(), hint)
    return syntax.unknown_statement(span_of(line[0]), word, statement_words(), hint)


def meant_by_assignment(line: Sequence[Token]) -> str:
    """Return a hint at a line ``a = …``: a place, a result, the value of a load or parameter."""
    word, is_point = str(line[0]), len(points_of(line[0])) == 1
    if is_point and line[2:3] == ["("]:
        return PLACE.format(word)
    if any(len(points_of(token)) == 1 for token in line[2:] if token.type == "NAME"):
        return f"a result is asked for: find {word} = …; a formula is a let"
    if is_point:
        return f"a load has its value by a let: let {word} = …; a parameter is declared by param"
    if word[:2].isupper():
        return "points are capital letters with digits, as in OB1 = …; for a parameter write param"
    if "@" in line and len(points_of(word.upper())) == len(word) > 1:
        return f"points have capital letters: {word.upper()} = …"
    return f"a parameter is declared: param {word} = …"


def described(token: Token) -> str:
    """Return a token in words, as what was found."""
    match token.type:
        case "NUMBER":
            return f"the number {token}"
        case "STRING":
            return f"the text {token}"
        case "NAME":
            return f"the name '{token}'"
        case _ if str(token) in keywords():
            return f"the word '{token}'"
        case _:
            return f"'{token}'"


def expected_words(allowed: set[str]) -> list[str]:
    """Return words for what may stand here: an operand in two words, operators in one."""
    words: list[str] = []
    rest = set(allowed)
    if rest >= OPERAND:
        words.append("an expression")
        rest -= OPERAND | {"PLUS", "MINUS"}
    elif rest & slips.OPERATORS:
        words.append("an operator")
        rest -= slips.OPERATORS | {"LEFT"}
    signs = sorted(rest - HUMAN.keys(), key=lambda name: spelling().get(name, name))
    words += [HUMAN[name] for name in HUMAN if name in rest]
    return words + [f"'{spelling()[name]}'" for name in signs if name in spelling()]
