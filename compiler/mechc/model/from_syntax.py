"""The syntax tree to the mechanism: the model stage's table of contents."""

import re
from collections.abc import Sequence
from pathlib import PurePath

from ..base.frozen import replace
from ..diagnostics import Report
from ..diagnostics.model import doubts as doubt_words
from ..diagnostics.model import loads as load_words
from ..diagnostics.model import results as messages
from ..source import Span
from ..syntax import ast
from ..units import FORCE, TORQUE
from . import drawn, equivalent_rods, translations
from .doubts.beyond_ranges import beyond_ranges
from .doubts.remarks import doubts
from .forces import coefficients, friction
from .forces.force_pairs import inside_telescopes, spring_name
from .forces.loads import read_loads
from .forces.resultants import with_points_of_resultants
from .formulas.definitions import DefinedValues, in_file_order, read_definitions, spread_feeding
from .formulas.for_readers import for_readers
from .formulas.parameters import warn_unused
from .linkage import held
from .linkage.geometry import read_geometry
from .linkage.joints import declare_points, read_drawn, read_pivots, read_sliders, warn_idle
from .linkage.motion import check_drives, checked, read_assemblies, read_drives
from .linkage.symmetry import (
    check_axis_of_copies,
    check_shared_places,
    check_shared_vectors,
    check_turning_on_the_line,
    read_copies,
    read_mirror,
)
from .linkage.transmissions import read_arcs, read_joints, read_slides, read_telescopes
from .linkage.wheels import check_belts
from .mechanism import Find, LoadForm, Mechanism, Offset, Slider
from .names.literals import with_names
from .names.points import PointTable
from .names.scope import NameScope
from .results import reported
from .results.conditions_of_use import implied, read_expects, read_requires
from .results.finds import read_finds
from .results.reactions import (
    check_guides_of_copies,
    check_rods,
    warn_of_loads_on_pins,
    warn_of_shared_pivots,
)
from .statements import check_doubled, every, only, refuse_links_in_a_sheet, written_as_sheet

OF_FRICTION = (ast.Friction, ast.Motion, ast.Efficiency)
"""Statements about friction."""


def resolve(file: ast.File, report: Report) -> Mechanism:
    """Return the mechanism that a description describes, with everything checked.

    Lengths, forces … are in SI and angles in radians. As many errors as possible are
    reported before :class:`MechcError` is raised.
    """
    check_doubled(file, report)
    scope = _scope_of(file, report)
    _declare_names(file, scope)
    finds = read_finds(file, scope)
    _declare_lets(file, finds, scope)
    found = read_definitions(file, scope)
    mechanism = replace(_headed(file, report), finds=tuple(finds), spans=scope.points.places)
    mechanism = _with_forces(_built(mechanism, file, scope), file, scope)
    mechanism = _asked(mechanism, file, found, scope)
    report.stop_on_errors()
    mechanism = _laid_out(mechanism, report)
    if parts := every(file, ast.Reported):
        mechanism = replace(mechanism, reported=reported.checked(parts, mechanism, scope))
    report.stop_on_errors()
    warn_unused(found.parameters, scope)
    warn_idle(mechanism.joints, scope.points)
    _warn_lonely(scope.points)
    mechanism = for_readers(mechanism, file, report.source)
    _doubt(mechanism, scope)
    if scope.sheet:
        return mechanism
    return with_names(checked(mechanism, report), file, scope.constants.values())


def _scope_of(file: ast.File, report: Report) -> NameScope:
    """Return a scope in which the points of bodies and joints are declared, and no names yet."""
    points = PointTable(report)
    declare_points(file, points)
    is_sheet = written_as_sheet(file)
    if not is_sheet:
        refuse_links_in_a_sheet(file, report)
    scope = NameScope(report, points, is_sheet)
    scope.shared_sizes = coefficients.shared_sizes(file.statements)
    return scope


def _with_forces(mechanism: Mechanism, file: ast.File, scope: NameScope) -> Mechanism:
    """Return a mechanism with its loads and its friction, and what is said of them reported."""
    mechanism = _under_loads(mechanism, file, scope)
    if any(isinstance(s, OF_FRICTION) for s in file.statements):
        mechanism = replace(mechanism, friction=friction.read_friction(file, mechanism, scope))
    mechanism = replace(mechanism, loads=inside_telescopes(mechanism.loads, mechanism, scope))
    check_rods(mechanism, scope)
    warn_of_shared_pivots(mechanism, scope)
    warn_of_loads_on_pins(mechanism, scope)
    check_guides_of_copies(mechanism, scope)
    return mechanism


def _doubt(mechanism: Mechanism, scope: NameScope) -> None:
    """Report what is doubted of a mechanism, and of its values beyond their ranges."""
    report = scope.report
    for doubt in doubts(mechanism) if not scope.sheet else ():
        if doubt.code != "W266" or not report.has("W295", doubt.span):
            report.add(doubt)
    for doubt in beyond_ranges(mechanism, report):
        report.add(doubt)


def _headed(file: ast.File, report: Report) -> Mechanism:
    """Return a mechanism of which only the heading is known."""
    heading, note = only(file, ast.Heading), only(file, ast.SourceNote)
    is_translated = bool(every(file, ast.Translate))
    return Mechanism(
        name=heading.name.text if heading else name_of(report.source.name),
        title=heading.title if heading else "",
        source=note.text if note else "",
        translations=translations.read_translations(file, report) if is_translated else {},
        span=heading.span if heading else Span(0, 0),
    )


def _built(mechanism: Mechanism, file: ast.File, scope: NameScope) -> Mechanism:
    """Add bodies, joints, and where they are."""
    pivots, places = read_pivots(file, scope)
    sliders, guides, guide_places = read_sliders(file, scope)
    drawn, fixed_places = read_drawn(file, scope)
    given = (place for place in (*places, *fixed_places) if isinstance(place, Offset))
    scope.points.located.update((place.head, place) for place in given)
    slides, telescopes = read_slides(file, scope), read_telescopes(file, scope)
    joints = read_joints(file, slides, scope)
    check_belts(joints, places, scope)
    geometry = read_geometry(file, scope)
    drives = read_drives(file, scope)
    assemblies = read_assemblies(file, scope)
    built = replace(
        mechanism,
        links=tuple(scope.points.links.values()),
        slides=slides,
        telescopes=telescopes,
        joints=(*pivots, *guides, *sliders, *joints),
        drive=next(iter(drives), None),
        held=tuple(drives[1:]),
        assemblies=tuple(assemblies),
        geometry=(*places, *fixed_places, *guide_places, *geometry),
        drawn=tuple(drawn),
    )
    arcs = read_arcs(file, slides, scope)
    return equivalent_rods.with_rods_for_circular_slots(built, arcs, scope) if arcs else built


def _under_loads(mechanism: Mechanism, file: ast.File, scope: NameScope) -> Mechanism:
    """Add the loads, and the halves or branches that they count on."""
    loads = read_loads(file, mechanism, scope)
    mirror = read_mirror(file, (*mechanism.each(Slider), *mechanism.slides), loads, scope)
    check_shared_vectors(mirror, mechanism.geometry, scope)
    copies = read_copies(file, scope)
    loaded = replace(mechanism, loads=tuple(loads), mirror=mirror, copies=copies)
    check_turning_on_the_line(loaded, scope)
    check_axis_of_copies(loaded, scope)
    check_shared_places(loaded, scope)
    return with_points_of_resultants(loaded)


def _asked(
    mechanism: Mechanism, file: ast.File, found: DefinedValues, scope: NameScope
) -> Mechanism:
    """Add parameters and formulas, once all is read that they may feed."""
    spread_feeding(found, scope)
    requires = read_requires(file, found, scope)
    expects = read_expects(file, mechanism.finds, found, scope)
    parameters, lets = in_file_order(found, file, scope)
    _check_asked(file, scope.report)
    return replace(
        mechanism,
        parameters=parameters,
        lets=lets,
        requires=tuple(requires),
        implied=() if scope.sheet else tuple(implied(found)),
        expects=tuple(expects),
    )


def _laid_out(mechanism: Mechanism, report: Report) -> Mechanism:
    """Return the mechanism with what its drawing gives, and fast what held drives would move."""
    if mechanism.drawn or any(drive.ends for drive in mechanism.drives):
        mechanism = drawn.with_drawn(mechanism, report)
    check_drives(mechanism, report)
    report.stop_on_errors()
    return held.with_held(mechanism, report) if mechanism.held else mechanism


def name_of(source: str) -> str:
    """Return a name for a description that has none: the stem of its file.

    >>> name_of("clamps/packet-clamp 2.mech"), name_of("<stdin>")
    ('packet_clamp_2', 'mechanism')
    """
    stem = re.sub(r"\W+", "_", PurePath(source).stem, flags=re.ASCII).strip("_")
    return stem if stem[:1].isalpha() and stem != "stdin" else "mechanism"


def _declare_names(file: ast.File, scope: NameScope) -> None:
    """Enter parameters and loads."""
    for statement in file.statements:
        match statement:
            case ast.Param(name=name):
                scope.declare(name, "parameter")
            case ast.Taken(name=name):
                scope.declare(name, "let")
            case ast.Brought(prefix=prefix):
                scope.brought[prefix] = statement
            case ast.Table(name=name):
                scope.declare(name, "table")
            case ast.Sizes(name=name):
                scope.declare(name, "list")
            case ast.Torque(name=name):
                scope.declare(name, "load", TORQUE)
            case _ if isinstance(statement, ast.NamedLoad):
                scope.declare(statement.name, "load", FORCE)
            case ast.Spring():
                scope.declare(ast.Name(spring_name(statement), statement.span), "load", FORCE)


def _declare_lets(file: ast.File, finds: Sequence[Find], scope: NameScope) -> None:
    """Enter the lets; one with a load's name gives that load its value, once.

    A load that is asked for has no value of the user's.
    """
    valued = {f.target.load: f.span for f in finds if isinstance(f.target, LoadForm)}
    for statement in every(file, ast.Let):
        name = statement.name
        entry = scope.entries.get(name.text)
        if entry is None or entry.kind != "load":
            scope.declare(name, "let")
        elif name.text in valued:
            scope.report.add(load_words.load_given_again(name.span, name.text, valued[name.text]))
        valued.setdefault(name.text, name.span)


def _check_asked(file: ast.File, report: Report) -> None:
    if not any(isinstance(s, ast.Find | ast.Let | ast.Taken) for s in file.statements):
        end = file.statements[-1].span.end if file.statements else 0
        report.add(messages.nothing_asked(Span(end, end), not file.statements))


def _warn_lonely(points: PointTable) -> None:
    """Warn of points that one link alone carries and at which nothing acts."""
    jointed = points.fixed | points.guided
    for point, links in points.carried.items():
        if len(links) == 1 and not points.used[point] and point not in jointed:
            report = points.report
            report.add(doubt_words.lonely_point(points.places[point], point, links[0].name))
