"""Documents about one proposal."""

from __future__ import annotations

from typing import Literal, NotRequired

from typing_extensions import TypedDict

from sitewright.interaction_twin.wire.basics import Phase, Pose, StepStatus


class Edit(TypedDict):
    """A body hangs on a robot's tip from then on, or lies in the site (`on` is null)."""

    body: str
    on: str | None
    pose: Pose


class MotionRecord(TypedDict):
    trajectory_sha256: str
    robot: str
    starts_s: float
    duration_s: float
    closest_distance_m: float | None
    closest_pair: list[str]
    after: list[Edit]


class Held(TypedDict):
    """What hangs on a robot's tip."""

    piece: str


class Difference(TypedDict):
    """What one plan says and the one before it did not."""

    kind: Literal["target", "removed", "added", "motion"]
    words: str
    step: NotRequired[int]


class StepRecord(TypedDict):
    number: int
    skill: str
    robot: str
    robot_name: str
    arguments: list[str]
    words: str
    why: str
    is_done: bool
    status: StepStatus
    starts_s: float
    duration_s: float
    act_s: float
    closest_distance_m: float | None
    closest_pair: list[str]
    closest_names: list[str]
    flags: list[str]
    touches: list[str]
    may_touch: list[list[str]]
    holds_before: Held | None
    holds_after: Held | None
    motions: list[MotionRecord]


class Scope(TypedDict):
    kind: Literal["plan", "until", "step"]
    step: int


class Decided(TypedDict):
    who: str
    verb: str
    at_ms: int
    scope: NotRequired[Scope]
    reason: NotRequired[str]


class Proposal(TypedDict):
    """A plan; `decisions_allowed` says by verb true, or why not."""

    open: bool
    fingerprint: str
    code: str
    run: str
    target: str
    target_name: str
    title: str
    is_single: bool
    next_step: int
    status: Literal["waiting", "approved", "running", "done", "rejected", "superseded"]
    why: str
    notes: list[str]
    asked_at_ms: int
    decided: Decided | None
    duration_s: float
    closest_distance_m: float | None
    closest_pair: list[str]
    closest_names: list[str]
    before: list[tuple[int, int]]
    summary: list[str]
    previous_code: str
    differences: list[Difference]
    flagged: list[int]
    steps: list[StepRecord]
    decisions_allowed: dict[str, Literal[True] | str]


class NoProposal(TypedDict):
    """Nothing is open, and why."""

    open: None
    phase: Phase
    reason: str


class Call(TypedDict):
    skill: str
    robot: str
    arguments: list[str]


class OtherWay(Call):
    words: str
    duration_s: float
    price_s: float | None
    note: str


class NoWay(Call):
    words: str
    duration_s: float
    why_not: str


class OtherWays(TypedDict):
    fingerprint: str
    step: int
    feasible: list[OtherWay]
    infeasible: list[NoWay]


class Why(TypedDict):
    """Why a step is there; `document` is that of ``sitewright explain step``."""

    lines: list[str]
    document: dict[str, object]


class Effect(TypedDict):
    fact: str
    words: str


class ByHand(TypedDict):
    """What a person can vouch for at a target."""

    target: str
    name: str
    effects: list[Effect]
