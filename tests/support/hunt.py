"""Hunt for false statements: random mechanisms of every kind, and all that can refute what is said.

``python tests/support/hunt.py --from 98000000 --count 3000 --workers 2`` makes a mechanism of each
seed, of the kinds in turn. Each line of the output is a statement that was refuted, a mechanism
that took too long, or the summary; the exit status is 1 where anything was refuted. With
``--kinds closed --from 98000007 --count 1`` one of them is looked at again, with ``--looks page``
by one of all means only; Ctrl-C ends it, with the summary of what there was.
"""

import argparse
import os
import signal
import sys
import tempfile
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager, suppress
from functools import partial
from itertools import islice
from multiprocessing import Pool
from pathlib import Path
from typing import NamedTuple

from hunted import KINDS, Hunted, made
from mechc.diagnostics import MechcError
from mechc.diagnostics.statics import BUGS
from mechc.model.parts.targets import WithFriction
from refuters import REFUTERS

SECONDS = 120
"""What a mechanism may take of a processor, with all that is looked at, however busy that is."""

FRESH = 10
"""Mechanisms after which a worker begins anew: formulas that are kept take memory."""

OFTEN = 100
"""Mechanisms after which it is said how many there were."""

MOST = 5
"""Statements of one kind that are told of a mechanism."""

LIMIT = "E817"
"""The code of more work than a compilation may do."""


class OutOfTime(BaseException):
    """Raised where a mechanism takes too long; nothing that is looked at catches it."""


class Outcome(NamedTuple):
    """What came of one mechanism: what was refuted, and what could not be looked at."""

    kind: str
    seed: int
    results: int = 0
    traits: tuple[str, ...] = ()
    refuted: tuple[str, ...] = ()
    refused: tuple[str, ...] = ()
    late: str = ""

    def lines(self) -> Iterator[str]:
        """Yield a line for each statement that was refuted, and for what took too long."""
        where = f"{self.kind} {self.seed}"
        yield from (f"{where}: {said}" for said in self.refuted)
        if self.late:
            yield f"{where}: out of time, {self.late}"


def outcome(
    kind: str, seed: int, seconds: float = SECONDS, looks: Iterable[str] = REFUTERS
) -> Outcome | None:
    """Return the outcome for the mechanism that a kind has for a seed; None where it has none."""
    description = made(kind, seed)
    if description is None:
        return None
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        # a C compiler that is out of time may still write there
        return looked_at(kind, Hunted(description, seed, Path(folder)), seconds, looks)


def _of_pair(pair: tuple[str, int], seconds: float, looks: Iterable[str]) -> Outcome | None:
    return outcome(*pair, seconds, looks)


def looked_at(
    kind: str, found: Hunted, seconds: float = SECONDS, looks: Iterable[str] = REFUTERS
) -> Outcome:
    """Return the verdict on a mechanism of all that can refute, or of some of that."""
    done = Outcome(kind, found.seed)
    try:
        with no_longer_than(seconds):
            for at in looks:
                done, refute = done._replace(late=at), REFUTERS[at]
                done = tried(done, at, lambda refute=refute: refute(found))
                if not found.is_compiled:
                    break
    except OutOfTime:
        return done
    late = "more work than is allowed" if LIMIT in done.refused else ""
    if found.is_compiled:
        done = done._replace(results=len(found.compilation.results), traits=traits(found))
    return done._replace(late=late)


def tried(done: Outcome, at: str, refute: Callable[[], Iterable[str]]) -> Outcome:
    """Return an outcome with what is refuted at one look; a description may be refused there."""
    try:
        found = [f"{at}: {said}" for said in islice(refute(), MOST)]
        return done._replace(refuted=(*done.refuted, *found))
    except MechcError as error:
        codes = {d.code for d in error.diagnostics if d.code.startswith("E")}
        if not codes & BUGS:
            return done._replace(refused=(*done.refused, *sorted(codes)))
        said = "; ".join(f"{d.code} {d.message}" for d in error.diagnostics if d.code in BUGS)
    except Exception as error:
        said = f"{type(error).__name__} {error}"
    return done._replace(refuted=(*done.refuted, " ".join(f"{at}: {said}".split())))


def traits(found: Hunted) -> tuple[str, ...]:
    """Return the heading that a mechanism is counted under in the summary."""
    made = found.compilation
    has_friction = any(isinstance(r.target, WithFriction) for r in made.results)
    return (
        "closed" if found.is_closed else "open",
        *["with friction"] * has_friction,
        *["with a drive"] * (made.pose.mechanism.drive is not None),
    )


@contextmanager
def no_longer_than(seconds: float) -> Iterator[None]:
    """Raise OutOfTime in what is done inside where it takes too long."""

    def stop(*_: object) -> None:
        raise OutOfTime

    before = signal.signal(signal.SIGPROF, stop)
    signal.setitimer(signal.ITIMER_PROF, seconds)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.signal(signal.SIGPROF, before)


def summary(outcomes: Sequence[Outcome]) -> Iterator[str]:
    """Yield what there was, and how much of it could be looked at."""
    solved = [one for one in outcomes if one.results]
    number = sum(one.results for one in solved)
    late = [f"{one.kind} {one.seed}" for one in outcomes if one.late]
    yield f"{len(outcomes)} mechanisms, {len(solved)} of them with results, {number} in all"
    yield _counted("of which", (trait for one in solved for trait in one.traits))
    yield _counted("kinds", (one.kind for one in solved))
    yield _counted("refused", (code for one in outcomes for code in one.refused))
    yield f"out of time: {', '.join(late) or 'none'}"
    yield f"statements refuted: {sum(len(one.refuted) for one in outcomes)}"


def _counted(title: str, names: Iterable[str]) -> str:
    numbers = (f"{name} {number}" for name, number in Counter(names).most_common())
    return f"{title}: {', '.join(numbers) or 'none'}"


def _some_of(known: Iterable[str], names: str) -> list[str]:
    """Return the names between commas, all of which are known."""
    found = names.split(",")
    if unknown := [name for name in found if name not in known]:
        raise argparse.ArgumentTypeError(f"{unknown[0]!r}; there are {', '.join(known)}")
    return found


def main() -> int:
    """Hunt as the command line says; return the exit status."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--from", type=int, default=0, dest="first", metavar="SEED")
    parser.add_argument("--count", type=int, default=len(KINDS), metavar="N")
    parser.add_argument("--workers", type=int, default=1, metavar="N")
    parser.add_argument("--seconds", type=float, default=SECONDS, help="for each mechanism")
    for name, known in (("--kinds", KINDS), ("--looks", REFUTERS)):
        parser.add_argument(
            name, type=partial(_some_of, known), default=[*known], help="some of them, with commas"
        )
    asked = parser.parse_args()
    os.environ["MECHC_CACHE"] = ""
    signal.signal(signal.SIGINT, signal.default_int_handler)  # one in the background ignores it
    seeds = range(asked.first, asked.first + asked.count)
    kinds = [asked.kinds[seed % len(asked.kinds)] for seed in seeds]
    seen: list[Outcome] = []
    look = partial(_of_pair, seconds=asked.seconds, looks=asked.looks)
    with suppress(KeyboardInterrupt), Pool(asked.workers, maxtasksperchild=FRESH) as workers:
        for one in workers.imap(look, zip(kinds, seeds, strict=True)):
            if one is not None:
                seen.append(one)
                for line in one.lines():
                    print(line, flush=True)
            if len(seen) % OFTEN == 0:
                print(f"... {len(seen)} mechanisms", file=sys.stderr, flush=True)
    print(*summary(seen), sep="\n")
    return int(any(one.refuted for one in seen))


if __name__ == "__main__":
    sys.exit(main())
