"""How the run stands, and its news."""

from __future__ import annotations

from typing import Literal, NotRequired

from typing_extensions import TypedDict

from sitewright.interaction_twin.wire.basics import Phase
from sitewright.interaction_twin.wire.plan import Edit


class RemovedZone(TypedDict):
    remove: str


class Option(TypedDict):
    """What a person can decide about a trouble."""

    id: str
    words: str
    verb: str
    zone: NotRequired[RemovedZone]


class Tried(TypedDict):
    """A change that was planned through on a copy of the site."""

    words: str
    steps: int
    duration_s: float


class Posture(TypedDict):
    """Where robots were when two bodies came too near, and what they carried."""

    q_rad: dict[str, list[float]]
    bodies: list[Edit]


class Trouble(TypedDict):
    target: str
    name: str
    reason: str
    verdict: str
    verdict_kind: str
    pair: list[str] | None
    pair_names: list[str]
    blockers: list[str]
    blocker_names: list[str]
    counter_proposals: list[Tried]
    rejected: list[str]
    options: list[Option]
    posture: Posture | None


class Question(TypedDict):
    question_id: str
    step: int
    target: str
    text: str
    answers: list[str]


class OpenPlan(TypedDict):
    fingerprint: str
    code: str
    target: str
    next_step: int
    steps: int
    is_single: bool


class RunningStep(TypedDict):
    step: int
    robot: str
    words: str
    started_at_ms: int
    duration_s: float
    fingerprint: str


class HeldRun(TypedDict):
    reason: str
    exit_code: int


class Progress(TypedDict):
    installed: int
    targets: int


class RunState(TypedDict):
    """How the run stands: ``GET /api/state``, and a message of the WebSocket."""

    type: Literal["state"]
    phase: Phase
    words: str
    run: str
    n: int
    scene_epoch: int
    open: OpenPlan | None
    running: RunningStep | None
    question: Question | None
    held: HeldRun | None
    trouble: list[Trouble]
    cell: Literal["live", "absent"]
    progress: Progress
    is_over: bool


class RunEvent(TypedDict):
    """A record of the journal, as the WebSocket tells it."""

    type: Literal["event"]
    run: str
    n: int
    at_ms: int
    kind: str
    words: str
    body: object


class CaughtUp(TypedDict):
    """Everything that was missed has come, up to this record."""

    type: Literal["caught-up"]
    run: str
    n: int
