"""A reach check in lines for people: who can do how much, and what nobody reaches."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator

from sitewright.foundation.ids import RobotId
from sitewright.interaction_twin.labels import Labels
from sitewright.interaction_twin.measures import counted, in_seconds
from sitewright.planning_twin.reachability.answer import GraspWay
from sitewright.planning_twin.reachability.report import ReachReport
from sitewright.planning_twin.reachability.verdict import Standing, TargetVerdict

WORDS = {
    Standing.BUILDABLE: "buildable",
    Standing.WAITING: "waits for what nobody builds",
    Standing.NOT_FOUND: "no way found",
    Standing.IMPOSSIBLE: "proven impossible",
}


def reach_lines(report: ReachReport, labels: Labels, *, is_all: bool = False) -> Iterator[str]:
    """Yield the summary, who does how much, and each target that cannot be built.

    Args:
        report: The check.
        labels: Names that people know.
        is_all: Also one line for each target that can be built, with its ways.
    """
    yield headline(report)
    yield from (f"  {line}" for line in robot_lines(report))
    yield from report.notes
    for verdict in report.verdicts:
        if is_all or verdict.standing is not Standing.BUILDABLE:
            yield from _target(report, verdict, labels, is_all=is_all)


def headline(report: ReachReport) -> str:
    """Return how much of the model can be built, in one line."""
    total, can = len(report.verdicts), report.count(Standing.BUILDABLE)
    noes = ", ".join(
        f"{count} {WORDS[s]}"
        for s in Standing
        if s is not Standing.BUILDABLE
        for count in (report.count(s),)
        if count
    )
    rest = f"; {noes}" if noes else ""
    return (
        f"{can} of {counted(total, 'target')} buildable ({100.0 * report.share:.0f} %){rest}. "
        f"No paths were searched. {in_seconds(report.seconds)}."
    )


def way_words(way: GraspWay) -> str:
    """Return a kind of grasp in words."""
    words = [f"onto face {way.face}"]
    if way.pitch_deg:
        words.append(f"leaning {way.pitch_deg:+.0f} deg")
    if abs(way.offset_m) > 1e-9:  # noqa: PLR2004 - not in the middle
        words.append(f"{way.offset_m * 1000:+.0f} mm off the middle")
    return ", ".join(words)


def robot_lines(report: ReachReport) -> Iterator[str]:
    """Yield, for each robot and end effector, how many targets and operations it reaches."""
    placed: dict[tuple[RobotId, str], list[bool]] = defaultdict(list)
    done: dict[tuple[RobotId, str], list[bool]] = defaultdict(list)
    for handling in report.answer.handlings:
        placed[handling.robot, handling.end_effector].append(bool(handling.ways))
    for operating in report.answer.operatings:
        done[operating.robot, operating.end_effector].append(bool(operating.ways))
    for (robot, tool), rows in placed.items():
        yield f"{robot} with {tool} places {sum(rows)} of {counted(len(rows), 'target')}"
    for (robot, tool), rows in done.items():
        yield f"{robot} with {tool} reaches {sum(rows)} of {counted(len(rows), 'operation')}"


def _target(
    report: ReachReport, verdict: TargetVerdict, labels: Labels, *, is_all: bool
) -> Iterator[str]:
    yield f"{labels.name(verdict.target)}: {WORDS[verdict.standing]}"
    for reason in verdict.reasons:
        yield f"    {reason}"
    if verdict.waits_for:
        yield f"    waits for {', '.join(map(labels.name, verdict.waits_for))}"
    if not is_all:
        return
    for handling in report.answer.handlings:
        if handling.target == verdict.target and handling.ways:
            kinds = counted(len(handling.ways), "kind")
            yield (
                f"    {handling.robot} with {handling.end_effector}: {kinds} of grasps, "
                f"first {way_words(handling.ways[0])}"
            )
    for operating in report.answer.operatings:
        if operating.target == verdict.target and operating.ways:
            who = f"{operating.robot} with {operating.end_effector}"
            yield f"    {operating.operation}: {who}, {', '.join(operating.ways)}"
