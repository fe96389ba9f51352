"""The guard before each step: only approved content starts, once, and from where it should."""

from __future__ import annotations

from dataclasses import dataclass

from sitewright.central_controller.approval import Approval, is_genuine
from sitewright.central_controller.cycle_state import CycleState
from sitewright.central_controller.fingerprint import check_code, fingerprint
from sitewright.central_controller.proposal import Proposal, ProposedStep
from sitewright.foundation.sentence import Sentence
from sitewright.robot_team.driver import Observation

START_TOLERANCE_RAD = 0.010


@dataclass(frozen=True, slots=True)
class Granted:
    """The step may start under this approval."""

    approval: Approval


@dataclass(frozen=True, slots=True, kw_only=True)
class Refused:
    """The step must not start.

    Attributes:
        needs_plan: A new proposal is needed; else a new approval of the same one is enough.
    """

    reason: str
    needs_plan: bool = False


def may_start(
    step: ProposedStep,
    proposal: Proposal,
    state: CycleState,
    observation: Observation,
    *,
    key: bytes,
    now_utc_ns: int,
) -> Granted | Refused:
    """Check approval, order and start posture of a step, from the objects in memory.

    The certificates on the sensed scene and the facts that the step relies on are checked by
    `StartCheck`; both must agree before a step starts.
    """
    refused = _content(step, proposal, state) or _order(step, state)
    if refused:
        return refused
    approval = state.approval
    if approval is None:
        return Refused(reason=Sentence("Step {step} is not approved.", step=step.number))
    void = _void(approval, step, state, key=key, now_utc_ns=now_utc_ns)
    if void:
        return Refused(reason=void)
    moved = _not_at_start(step, observation)
    return Refused(reason=moved, needs_plan=True) if moved else Granted(approval)


def _content(step: ProposedStep, proposal: Proposal, state: CycleState) -> Refused | None:
    if state.proposal is None:
        return Refused(reason=Sentence("There is no open proposal."), needs_plan=True)
    wanted, found = state.proposal.fingerprint, fingerprint(proposal)
    if found != wanted:
        return Refused(
            reason=Sentence(
                "What would run ({found}) is not what was proposed ({wanted}).",
                found=check_code(found),
                wanted=check_code(wanted),
            ),
            needs_plan=True,
        )
    if step not in proposal.steps:
        return Refused(
            reason=Sentence("Step {step} is not part of the proposal.", step=step.number),
            needs_plan=True,
        )
    if proposal.site_serial != state.site.serial:
        return Refused(
            reason=Sentence("The site changed after this plan was made."), needs_plan=True
        )
    return None


def _order(step: ProposedStep, state: CycleState) -> Refused | None:
    if state.flight is not None or state.question is not None:
        return Refused(reason=Sentence("Another step has not ended yet."))
    if step.number != state.done + 1:
        return Refused(
            reason=Sentence(
                "Step {step} is not next; step {next} is.", step=step.number, next=state.done + 1
            )
        )
    return None


def _void(
    approval: Approval, step: ProposedStep, state: CycleState, *, key: bytes, now_utc_ns: int
) -> str:
    """Return why an approval does not let a step start; empty if it does."""
    assert state.proposal is not None  # noqa: S101 -- `_content` looked
    if not is_genuine(approval, key):
        return Sentence("The approval was not given on this installation, or was changed.")
    if approval.fingerprint != state.proposal.fingerprint:
        return Sentence("The approval is about another plan.")
    if not approval.scope.covers(step.number):
        return Sentence("Step {step} is outside of what was approved.", step=step.number)
    if (approval.approval_id, step.number) in state.started:
        return Sentence("Step {step} was already started under this approval.", step=step.number)
    has_started = any(a == approval.approval_id for a, _ in state.started)
    if not has_started and now_utc_ns > approval.start_before_utc_ns:
        return Sentence("This approval was not started within 10 min. Approve again.")
    return ""


def _not_at_start(step: ProposedStep, observation: Observation) -> str:
    seen = set()
    for motion in step.motions:
        trajectory = motion.timed.trajectory
        if trajectory.robot in seen:
            continue
        seen.add(trajectory.robot)
        robot = observation.robots.get(trajectory.robot)
        if robot is None:
            return Sentence("Robot {robot} is not sensed.", robot=trajectory.robot)
        pairs = zip(robot.q_rad, trajectory.start_rad, strict=True)
        for joint, (is_rad, start_rad) in enumerate(pairs, start=1):
            if abs(is_rad - start_rad) > START_TOLERANCE_RAD:
                return Sentence(
                    "Robot {robot} is not where step {step} starts: joint {joint} is at "
                    "{is_rad:.3f}, the trajectory starts at {start_rad:.3f} (rad, m on a rail; "
                    "allowed {most_rad:.3f}). A new motion is needed.",
                    robot=trajectory.robot,
                    step=step.number,
                    joint=joint,
                    is_rad=is_rad,
                    start_rad=start_rad,
                    most_rad=START_TOLERANCE_RAD,
                )
    return ""
