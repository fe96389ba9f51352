"""Everything that says why a step of a proposal is as it is; words are made of it elsewhere."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from sitewright.central_controller.causes import CausalLink, way_to_purpose
from sitewright.central_controller.choosing import PieceOnSite
from sitewright.central_controller.doers import Doer
from sitewright.central_controller.ports import RefusalNote
from sitewright.central_controller.proposal import ProposedStep
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Pose
from sitewright.robot_team.skill import SkillCall


@dataclass(frozen=True, slots=True, kw_only=True)
class Stance:
    """How a robot stands when the step has ended.

    Attributes:
        world_T_tcp: Where the working point of its end effector is.
        lean_rad: Between a tool and the axis of its nail, screw or face; None without one.
        from_middle_m: Where a gripper holds its piece, along the piece; None without one.
        from_above_rad: Between the way that the gripper looks and straight down, likewise.
    """

    world_T_tcp: Pose
    lean_rad: float | None = None
    from_middle_m: float | None = None
    from_above_rad: float | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class StepReasons:
    """Why a step is as it is.

    Attributes:
        status: What became of it: ``open``, ``done``, ``not done`` or ``superseded``.
        act: What the step is about: itself, or the act that a move is for.
        doers: All robots of the cell, asked about the act.
        piece: The piece that is taken or placed; None if the act is about none.
        pieces: All pieces that were right for the target when the plan was made.
        stance: None if it cannot be told.
        refusals: Met while this plan was made.
    """

    run: str
    fingerprint: str
    target: ComponentId
    steps: tuple[ProposedStep, ...]
    number: int
    status: str
    links: tuple[CausalLink, ...]
    act: SkillCall
    doers: tuple[Doer, ...]
    piece: ComponentId | None = None
    pieces: tuple[PieceOnSite, ...] = ()
    stance: Stance | None = None
    refusals: tuple[RefusalNote, ...] = ()

    @property
    def step(self) -> ProposedStep:
        """The step itself."""
        return self.steps[self.number - 1]

    @property
    def needed_by(self) -> tuple[CausalLink, ...]:
        """What later steps need of this one."""
        return tuple(x for x in self.links if x.producer == self.number and x.consumer is not None)

    @property
    def lasting(self) -> tuple[str, ...]:
        """What it makes true that still is at the end of the plan."""
        return tuple(
            x.fact
            for x in self.links
            if x.producer == self.number and x.consumer is None and not x.fact.startswith("(not ")
        )

    @property
    def made_possible_by(self) -> tuple[CausalLink, ...]:
        """What this step needs, and who brings it about."""
        return tuple(x for x in self.links if x.consumer == self.number)

    @property
    def way_to_purpose(self) -> tuple[int, ...]:
        """Steps from this one to the nearest that does what the design asks for."""
        return way_to_purpose(self.links, self.number)

    @property
    def own_refusals(self) -> tuple[RefusalNote, ...]:
        """The refusals about what this step is about."""
        names = self._names()
        return tuple(n for n in self.refusals if names & words_of(n))

    @property
    def other_refusals(self) -> tuple[RefusalNote, ...]:
        """The other refusals of the plan."""
        own = self.own_refusals
        return tuple(n for n in self.refusals if n not in own)

    def _names(self) -> set[str]:
        """Return piece, spot or place of the act; the target if it names none."""
        named: Sequence[str] = self.act.arguments[:1] or (self.target,)
        return {*named, *((self.piece,) if self.piece is not None else ())}


def words_of(note: RefusalNote) -> set[str]:
    """Return the ids that a refusal names, as far as they stand alone in its sentence."""
    return {word.strip(":;,.()") for word in note.reason.split()}
