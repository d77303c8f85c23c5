"""Which loads act together in a diagram of free bodies, for loads and results given by hand."""

import pytest

from mechc.base.frozen import replace
from mechc.formula.tree import ONE, Symbol
from mechc.model.mechanism import LoadForm, LoadRatio
from mechc.model.parts.friction import Friction, PinFriction
from mechc.model.result import Result
from mechc.statics.diagrams.load_cases import LoadCase, cases
from mechc.units import FORCE, NUMBER
from small_poses import HERE, force, lever

MECHANISM = replace(lever().mechanism, loads=(force("P", "A"), force("F", "B"), force("G", "B")))
BOTH = frozenset("FG")
FORM = Result("P", LoadForm("P"), FORCE, Symbol("F"), coefficients={"F": ONE, "G": ONE})
RATIO = Result("k", LoadRatio("P", "F"), NUMBER, ONE)


@pytest.mark.parametrize(
    ("given", "expected"),
    [
        # of no size: one by one, each as 1
        (
            {},
            [
                LoadCase("P", {"F": 1.0}, BOTH, "F", ("G",)),
                LoadCase("P", {"G": 1.0}, BOTH, "G", ("F",)),
            ],
        ),
        # what has a size acts first, the other one alone
        (
            {"F": 10.0},
            [
                LoadCase("P", {"F": 10.0}, BOTH, left_out=("G",)),
                LoadCase("P", {"G": 1.0}, BOTH, "G", ("F",)),
            ],
        ),
        # all have one: one case
        ({"F": 10.0, "G": 2.0}, [LoadCase("P", {"F": 10.0, "G": 2.0}, BOTH)]),
        # the size of what is sought is not taken
        ({"P": 5.0, "F": 1.0, "G": 2.0}, [LoadCase("P", {"F": 1.0, "G": 2.0}, BOTH)]),
    ],
)
def test_loads_of_a_linear_form_act_by_size_then_one_by_one(given, expected):
    assert cases(MECHANISM, [FORM], given) == expected


def test_a_load_that_is_tied_acts_with_the_others_and_never_alone():
    loads = (*MECHANISM.loads[:2], replace(MECHANISM.loads[2], tie=Symbol("F")))
    tied = replace(MECHANISM, loads=loads)
    assert cases(tied, [FORM], {}) == [LoadCase("P", {"F": 1.0}, BOTH, "F", ())]


def test_friction_alone_is_a_case_without_loads():
    """A clutch: nothing acts but the load that is sought, and friction stands against it."""
    alone = replace(MECHANISM, loads=MECHANISM.loads[:1])
    form = replace(FORM, coefficients={})
    assert cases(alone, [form], {}) == []
    clutch = replace(alone, friction=Friction((PinFriction("O", "", ONE, HERE),)))
    assert cases(clutch, [form], {}) == [LoadCase("P", {}, frozenset())]


@pytest.mark.parametrize(
    ("given", "expected"),
    [
        ({}, LoadCase("k", {"F": 1.0}, frozenset("F"), "F", ())),
        ({"F": 20.0}, LoadCase("k", {"F": 20.0}, frozenset("F"))),
        ({"P": 30.0}, LoadCase("k", {"F": 1.0}, frozenset("F"), "", (), ("P", 30.0))),
    ],
)
def test_a_ratio_is_at_the_size_of_either_load(given, expected):
    assert cases(MECHANISM, [RATIO], given) == [expected]
