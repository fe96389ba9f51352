"""Older runs: schedules, what was sensed, who decided what."""

from __future__ import annotations

from typing import Literal

from typing_extensions import TypedDict

from sitewright.interaction_twin.wire.basics import Layer, Pose
from sitewright.interaction_twin.wire.state import RunEvent


class Bar(TypedDict):
    robot: str
    words: str
    target: str
    starts_s: float
    duration_s: float
    is_done: bool
    skill: str
    step: int
    fingerprint: str


class Schedule(TypedDict):
    run: str
    planned: list[Bar]
    actual: list[Bar]


class RunLine(TypedDict):
    id: str
    started_at_ms: int
    ended_at_ms: int
    ended: Literal["complete", "finished", "held", "open"]
    installed: int
    targets: int
    continues: str


class Runs(TypedDict):
    runs: list[RunLine]


class RunRecord(RunLine):
    events: list[RunEvent]
    planned: list[Bar]
    actual: list[Bar]


class SensedRobot(TypedDict):
    q_rad: list[float]
    mounted: str | None
    aperture_m: float
    gripped: str | None


class SensedChange(TypedDict):
    """What was sensed otherwise than before."""

    robots: dict[str, SensedRobot]
    pieces: dict[str, Pose]
    gone: list[str]


class Moment(SensedChange):
    n: int
    at_s: float


class Placing(TypedDict):
    """A piece was put in place of a target, or left it (null)."""

    n: int
    at_s: float
    target: str
    piece: str | None


class ReplayEvent(TypedDict):
    n: int
    at_s: float


class ReplaySkill(TypedDict):
    robot: str
    step: int
    fingerprint: str
    starts_s: float
    duration_s: float


class ReplayRecord(TypedDict):
    """A whole run; times are seconds of the cell since its first skill."""

    run: str
    duration_s: float
    start: SensedChange
    docks: dict[str, Pose]
    placed: dict[str, str]
    events: list[ReplayEvent]
    moments: list[Moment]
    placings: list[Placing]
    skills: list[ReplaySkill]


class GraphNode(TypedDict):
    id: str
    name: str
    layer: Layer
    type: str
    parents: list[str]
    order: int | None
    made_of: str | None


class Graph(TypedDict):
    nodes: list[GraphNode]
    comes_before: list[tuple[str, str]]


class AuditEntry(TypedDict):
    """Who decided what, when, and the text that was on the screen."""

    run: str
    n: int
    at_ms: int
    who: str
    kind: str
    role: str
    verb: str
    session: str
    second: str
    key: str
    language: str
    shown: list[str]
    words: str
    detail: dict[str, object]


class Audit(TypedDict):
    entries: list[AuditEntry]
