"""What a sheet takes from a mechanism: numbers that the drawing gives, and conditions of loops."""

from mechc.base.frozen import replace
from mechc.calculation.mechanism_results import solved
from mechc.formula.tree import ZERO, Symbol, number
from mechc.model.mechanism import Parameter, Require
from mechc.model.result import Definition
from mechc.pose.pose import Pose, PoseDefinition
from mechc.units import ANGLE, LENGTH, NUMBER
from small_poses import HERE, PARAMETERS, slider_crank

PSI = ("psi", Symbol("phi"))


def handed_on(*more: Parameter, requires: tuple[Require, ...] = ()) -> Pose:
    pose = slider_crank(definitions=[PSI])
    mechanism = replace(
        pose.mechanism, parameters=(*PARAMETERS, *more), requires=requires, literals=(LITERAL,)
    )
    return replace(pose, mechanism=mechanism)


LITERAL = Parameter("n_1", NUMBER, HERE, number(3))
DRAWN = Parameter("phi_AB", ANGLE, HERE, number(2), dependent=True)
LONG = Parameter("len_AB", LENGTH, HERE, number(5), dependent=True)


def test_definitions_of_the_pose_come_first_and_keep_their_order() -> None:
    assert solved(handed_on(), ()).definitions == (Definition(*PSI),)
    found = solved(handed_on(DRAWN, LONG), ())
    assert found.definitions == (
        Definition(*PSI),
        Definition("phi_AB", number(2)),
        Definition("len_AB", number(5)),
    )


def test_what_a_loop_defines_is_not_defined_twice() -> None:
    pose = handed_on(DRAWN)
    both = replace(pose, definitions=(*pose.definitions, PoseDefinition("phi_AB", number(2))))
    assert [d.name for d in solved(both, ()).definitions] == ["psi", "phi_AB"]


def test_angles_and_lengths_of_the_drawing_are_numbers_with_names() -> None:
    assert solved(handed_on(), ()).literals == (LITERAL,)
    assert solved(handed_on(DRAWN, LONG), ()).literals == (LITERAL, DRAWN, LONG)


def test_what_drives_is_a_parameter_and_no_number() -> None:
    found = solved(handed_on(replace(DRAWN, dependent=False)), ())
    assert (found.literals, found.definitions) == ((LITERAL,), (Definition(*PSI),))


def test_what_follows_or_is_open_is_no_number_of_the_drawing() -> None:
    follows, is_open = replace(DRAWN, value=Symbol("phi")), replace(LONG, value=None)
    found = solved(handed_on(follows, is_open, Parameter("beta", ANGLE, HERE, number(1))), ())
    assert (found.literals, found.definitions) == ((LITERAL,), (Definition(*PSI),))


def test_conditions_on_what_loops_give_go_along_with_their_unit() -> None:
    left, right = Require(Symbol("psi"), "<", ZERO, HERE), Require(ZERO, "<", Symbol("psi"), HERE)
    angle = replace(left, dimension=ANGLE)
    own = Require(Symbol("phi"), "<", ZERO, HERE)
    found = solved(handed_on(requires=(left, own, right, angle)), ()).requires
    assert [(r.left, r.right, r.unit) for r in found] == [
        (Symbol("psi"), ZERO, ""),
        (ZERO, Symbol("psi"), ""),
        (Symbol("psi"), ZERO, "deg"),
    ]
    assert {r.subject and r.subject.kind for r in found} == {"pose"}
    assert solved(handed_on(requires=(own,)), ()).requires == ()
