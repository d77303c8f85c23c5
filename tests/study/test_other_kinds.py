"""Whatever is said of ropes, bands, collars, wheels on arms and joined parts holds on sampling."""

from pathlib import Path

import pytest

from conclusions import refuted as followed
from friction_statements import refuted as refuted_with_friction
from mechc.compilation import Compilation, complete
from mechc.diagnostics import MechcError
from mechc.model.parts.targets import Efficiency, ForceAtJoint, WithFriction
from mechc.report.text.derivation import render
from mechc.report.text.stroke import to_table
from mechc.source import Source
from other_kinds import KINDS, of_two_lengths, other, put_toggle
from statements import missing, refuted


def compiled(text: str, folder: Path) -> Compilation | None:
    """Return a description compiled; None where a rope would push."""
    compilation = Compilation(Source("other.mech", text, folder=folder))
    try:
        return complete(compilation)
    except MechcError as error:
        if {d.code for d in error.diagnostics if d.code[0] == "E"} != {"E343"}:
            raise
        return None


def jams(compilation: Compilation) -> bool:
    """Return whether nothing moves at the values given: the free bodies have nothing to judge."""
    found = (result.locking for result in compilation.results)
    return any(locking is not None and locking.state == "jammed" for locking in found)


def hold(kind: str, seeds: range, folder: Path) -> int:
    """Try what is said of some mechanisms of a kind; return how many had a result."""
    put_toggle(folder)
    number = 0
    for seed in seeds:
        compilation = compiled(other(kind, seed), folder)
        if compilation is None:
            continue
        doubts = {"W602"} if jams(compilation) else {"W601", "W602"}
        assert not doubts & {d.code for d in compilation.report.diagnostics}, seed
        assert list(refuted_with_friction(compilation)) == [], seed
        for result in compilation.results:
            mechanism = compilation.pose.mechanism
            assert list(refuted(mechanism, result, seed)) == [], seed
            assert list(followed(None, mechanism, result, seed)) == [], seed
            if not isinstance(result.target, WithFriction | Efficiency | ForceAtJoint):
                assert list(missing(mechanism, result, seed)) == [], seed
        number += 1
    return number


def test_a_toggle_that_folds_has_no_zeros_of_rounding(tmp_path):
    """Beyond 90 degrees its ram rests on the fixed pin: k is 0 between two branch points.

    It comes to each of them from -9 and 9 mm, so that it jumps there.
    """
    text = of_two_lengths(other("joined", 91000108), tmp_path)
    compilation = Compilation(Source("fold.mech", text, folder=tmp_path))
    stroke = compilation.stroke(3)
    (part,) = stroke.zero_intervals
    assert (part.low, part.high) == tuple(b.drive for b in stroke.branches)
    jumps = [(s.drive, s.value, s.kind) for s in stroke.singular]
    assert jumps == [(end, "undetermined", "jump") for end in (part.low, part.high)]
    assert not any(part.low <= one.drive <= part.high for one in stroke.extrema)
    table = " ".join(to_table(stroke).split())
    assert "k = 0 at all places looked at, from phi = 105.558 deg to phi = 116.456 deg" in table
    page = " ".join(render(compilation.reported, compilation.mechanism, unicode=False).split())
    assert "k is 0 at all places looked at for 105.6 deg <= phi <= 116.5 deg" in page


@pytest.mark.parametrize("kind", KINDS)
def test_what_is_said_of_other_kinds_holds(kind, tmp_path):
    assert hold(kind, range(1), tmp_path) == 1


@pytest.mark.slow
@pytest.mark.parametrize("kind", KINDS)
def test_what_is_said_of_many_of_other_kinds_holds(kind, tmp_path):
    assert hold(kind, range(100, 115), tmp_path) > 5
