"""Where the time of a run went: by cause on the wall clock, by robot on the cell's clock."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from enum import StrEnum
from itertools import pairwise

from sitewright.central_controller.events import (
    AlternativeChosen,
    AnyEvent,
    ApprovalGiven,
    ApprovalRefused,
    ApprovalRejected,
    DoneByHand,
    EpochOpened,
    LinkLost,
    ProposalMade,
    ProposalSuperseded,
    QuestionAnswered,
    RefusalMet,
    RunResumed,
    SkillIntent,
    SkillOutcome,
    SkillReissued,
    TargetRefused,
    TargetSelected,
    TargetWaits,
    ZoneDrawn,
    ZoneRemoved,
)
from sitewright.foundation.ids import RobotId
from sitewright.interaction_twin.drawing.bars import Bar
from sitewright.interaction_twin.report.content import RobotTime, Stamped
from sitewright.robot_team.skill import Skill

_NS = 1e9


class Cause(StrEnum):
    """What a stretch of time was spent on or waiting for."""

    WORK = "robots at work"
    DECISION = "waiting for a decision"
    ANSWER = "waiting for an answer about what happened"
    HELD = "held, or no process"
    PLANNING = "planning"
    PROOF = "proving motions again before they start"
    LINK = "reaching the cell"
    REST = "sensing and recording"


_ENDS: Mapping[Cause, tuple[type[AnyEvent], ...]] = {
    Cause.WORK: (SkillOutcome,),
    Cause.DECISION: (
        ApprovalGiven,
        ApprovalRefused,
        ApprovalRejected,
        AlternativeChosen,
        DoneByHand,
        ZoneDrawn,
        ZoneRemoved,
    ),
    Cause.ANSWER: (QuestionAnswered,),
    Cause.HELD: (RunResumed,),
    Cause.PLANNING: (
        TargetSelected,
        ProposalMade,
        ProposalSuperseded,
        RefusalMet,
        TargetRefused,
        TargetWaits,
    ),
    Cause.PROOF: (SkillIntent, SkillReissued),
    Cause.LINK: (EpochOpened, LinkLost),
}


def time_by_cause(history: Sequence[Stamped]) -> dict[Cause, float]:
    """Return the seconds between a run's first and last record by what ended each stretch."""
    found = dict.fromkeys(Cause, 0.0)
    for before, after in pairwise(history):
        found[_cause(after.event)] += (after.at_utc_ns - before.at_utc_ns) / _NS
    return {cause: spent_s for cause, spent_s in found.items() if spent_s > 0.0}


def _cause(event: AnyEvent) -> Cause:
    return next((c for c, kinds in _ENDS.items() if isinstance(event, kinds)), Cause.REST)


def robot_times(bars: Sequence[Bar]) -> tuple[RobotTime, ...]:
    """Return how each robot that did anything spent the time of the schedule."""
    edges = sorted({t for b in bars for t in (b.starts_s, b.ends_s)})
    held = {robot: _held(bars, robot) for robot in sorted({b.robot for b in bars})}
    times = {robot: [0.0] * 4 for robot in held}
    for start_s, end_s in pairwise(edges):
        middle_s = (start_s + end_s) / 2.0
        working = {b.robot for b in bars if b.starts_s <= middle_s < b.ends_s}
        for robot, spans in held.items():
            has_piece = any(a <= middle_s < b for a, b in spans)
            what = 3 if not working else 0 if robot in working else 1 if has_piece else 2
            times[robot][what] += end_s - start_s
    return tuple(
        RobotTime(robot=r, works_s=t[0], holds_s=t[1], waits_s=t[2], still_s=t[3])
        for r, t in times.items()
    )


def _held(bars: Iterable[Bar], robot: RobotId) -> list[tuple[float, float]]:
    """Return from when to when a robot had a piece, as its grasps and releases say."""
    spans: list[tuple[float, float]] = []
    since_s: float | None = None
    own = sorted((b for b in bars if b.robot == robot and b.is_done), key=lambda b: b.starts_s)
    for bar in own:
        if bar.call.skill == Skill.GRASP:
            since_s = bar.ends_s
        elif bar.call.skill in {Skill.RELEASE, Skill.SET_DOWN} and since_s is not None:
            spans.append((since_s, bar.starts_s))
            since_s = None
    return spans if since_s is None else [*spans, (since_s, float("inf"))]
