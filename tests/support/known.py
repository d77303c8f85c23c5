"""What a target reads, put together by hand."""

from typing import NamedTuple

from mechc.figure.figure import Figure
from mechc.model.mechanism import Mechanism
from mechc.pose.motion import Motion
from mechc.report.steps import Derivation
from mechc.routine.steps import Routine
from mechc.statics.diagrams.diagram import Diagram
from mechc.statics.verdict import Verdict


class Known(NamedTuple):
    mechanism: Mechanism
    derivation: Derivation
    routine: Routine
    verdict: Verdict
    version: str
    figure: Figure | None = None
    free_bodies: tuple[Diagram, ...] = ()
    motion: Motion | None = None
    used_mechanisms: tuple[()] = ()

    @property
    def reported(self) -> Derivation:
        return self.derivation
