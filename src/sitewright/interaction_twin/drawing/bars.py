"""Skills on a time axis: what a schedule is drawn from."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace

from sitewright.central_controller.proposal import ProposedStep
from sitewright.foundation.ids import ComponentId, RobotId
from sitewright.interaction_twin.labels import Kind, Labels
from sitewright.robot_team.skill import SkillCall


@dataclass(frozen=True, slots=True, kw_only=True)
class Bar:
    """One skill on the time axis of its robot.

    Attributes:
        starts_s: On the cell's clock, counted from the first skill of the run.
        step: Number in its proposal, whose fingerprint is beside it.
        is_done: False if the skill failed or its outcome was never known.
    """

    robot: RobotId
    call: SkillCall
    target: ComponentId
    starts_s: float
    duration_s: float
    is_done: bool = True
    step: int = 0
    fingerprint: str = ""

    @property
    def ends_s(self) -> float:
        """Return when the skill ended."""
        return self.starts_s + self.duration_s


def planned_bars(
    steps: Iterable[ProposedStep], *, target: ComponentId, fingerprint: str
) -> tuple[Bar, ...]:
    """Return the steps of a plan on the plan's own axis."""
    bars: list[Bar] = []
    starts_s = 0.0
    for step in steps:
        bars.append(
            Bar(
                robot=step.call.robot,
                call=step.call,
                target=target,
                starts_s=starts_s,
                duration_s=step.duration_s,
                step=step.number,
                fingerprint=fingerprint,
            )
        )
        starts_s += step.duration_s
    return tuple(bars)


def on_the_axis_of(plan: Iterable[Bar], ran: Iterable[Bar]) -> tuple[Bar, ...]:
    """Return what ran of a plan, shifted so that the first step that ran starts as planned."""
    starts_s = {(b.fingerprint, b.step): b.starts_s for b in plan}
    own = [b for b in ran if (b.fingerprint, b.step) in starts_s]
    if not own:
        return ()
    shift_s = own[0].starts_s - starts_s[own[0].fingerprint, own[0].step]
    return tuple(replace(b, starts_s=max(b.starts_s - shift_s, 0.0)) for b in own)


def robot_numbers(labels: Labels, bars: Iterable[Bar]) -> dict[RobotId, int]:
    """Return the number of every robot, from 1, in the order of the cell."""
    known = [RobotId(i) for i, label in labels.label_by_id.items() if label.kind is Kind.ROBOT]
    others = sorted({b.robot for b in bars} - set(known))
    return {robot: number for number, robot in enumerate((*known, *others), start=1)}
