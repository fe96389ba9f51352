"""What the cycle asks the runner to do next: a closed union of commands."""

from __future__ import annotations

from dataclasses import dataclass

from sitewright.central_controller.ports import Question
from sitewright.foundation.ids import CommandId, ComponentId
from sitewright.robot_team.skill import SkillCall


@dataclass(frozen=True, slots=True)
class Connect:
    """Connect to the cell and open a new epoch."""


@dataclass(frozen=True, slots=True)
class PlanNext:
    """Ask the planner for the next target's proposal."""

    exclude: frozenset[ComponentId]


@dataclass(frozen=True, slots=True)
class PlanSingle:
    """Ask the planner for the motion of a chosen call."""

    call: SkillCall


@dataclass(frozen=True, slots=True)
class AskApproval:
    """Ask for an approval that covers `step`."""

    step: int


@dataclass(frozen=True, slots=True)
class StartStep:
    """Check everything once more and write the intent."""

    step: int


@dataclass(frozen=True, slots=True)
class Execute:
    """Tell the driver."""

    command_id: CommandId


@dataclass(frozen=True, slots=True)
class Reconcile:
    """Ask the ledger, then the sensors, what became of a command."""

    command_id: CommandId


@dataclass(frozen=True, slots=True)
class Reissue:
    """Check everything once more and let the same command go out again."""

    command_id: CommandId


@dataclass(frozen=True, slots=True)
class RaiseQuestion:
    """Put the unknown outcome to a person."""

    command_id: CommandId


@dataclass(frozen=True, slots=True)
class AskPerson:
    """Wait for the answer to an open question."""

    question: Question


@dataclass(frozen=True, slots=True)
class Sense:
    """Look at the effects of an ended skill and compare with what was expected."""

    command_id: CommandId


@dataclass(frozen=True, slots=True)
class HoldRun:
    """Stop and leave the run open."""

    reason: str
    exit_code: int


@dataclass(frozen=True, slots=True)
class FinishRun:
    """Nothing is left to do."""


@dataclass(frozen=True, slots=True)
class Stop:
    """The run stands; leave the loop."""


Command = (
    Connect
    | PlanNext
    | PlanSingle
    | AskApproval
    | StartStep
    | Execute
    | Reconcile
    | Reissue
    | RaiseQuestion
    | AskPerson
    | Sense
    | HoldRun
    | FinishRun
    | Stop
)
