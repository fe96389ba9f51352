"""Another feasible action is chosen, run and observed, and the plan is made anew from there."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

import pytest

from sitewright.app.execution import run_command
from sitewright.app.project import new_project, open_project
from sitewright.central_controller.events import (
    AlternativeChosen,
    AnyEvent,
    ApprovalGiven,
    ComponentInstalled,
    SkillOutcome,
)
from sitewright.central_controller.ports import (
    ApprovalAnswer,
    ApprovalRequest,
    Approve,
    DoInstead,
    Hold,
    Question,
    Scope,
    ScopeKind,
    Settled,
)
from sitewright.robot_team.drivers.mujoco.client import connect
from sitewright.robot_team.skill import Skill, SkillCall

BUFFER = "buffer-a"


@dataclass(slots=True)
class Foreman:
    """Approves step by step, but has the first lifted piece laid on the buffer."""

    asked_for: list[SkillCall] = field(default_factory=list)
    singles: list[SkillCall] = field(default_factory=list)

    def ask(self, request: ApprovalRequest) -> ApprovalAnswer:
        if request.is_single:
            self.singles += [s.call for s in request.proposal.steps]
            return Approve(fingerprint=request.fingerprint, who="foreman")
        if request.proposal.target != "support-1":
            return Hold(who="foreman", reason="enough for today")
        other = self._other(request)
        if other is not None:
            self.asked_for.append(other)
            return DoInstead(who="foreman", call=other)
        scope = Scope(ScopeKind.STEP, request.next_step)
        return Approve(fingerprint=request.fingerprint, who="foreman", scope=scope)

    def answer(self, question: Question) -> Settled | None:
        raise AssertionError(question.text)

    def _other(self, request: ApprovalRequest) -> SkillCall | None:
        planned = request.proposal.steps[request.next_step - 1].call
        carries_on = (planned.skill, planned.arguments) == (Skill.REACH, ("support-1",))
        is_at_buffer = bool(self.asked_for) and self.asked_for[-1].skill == Skill.REACH
        wanted = Skill.SET_DOWN if is_at_buffer else Skill.REACH
        if (self.asked_for and not is_at_buffer) or not (carries_on or is_at_buffer):
            return None
        calls = (a.call for a in request.alternatives() if not a.leads_nowhere)
        return next(c for c in calls if c.skill == wanted and BUFFER in c.arguments)


@pytest.mark.slow
def test_a_lifted_piece_is_laid_on_the_buffer_and_the_plan_is_made_anew(tmp_path: Path) -> None:
    project = open_project(new_project(tmp_path / "frame"))
    foreman, events = Foreman(), list[AnyEvent]()
    result = run_command(project, foreman, on_event=events.append)
    connect(result.folder / "cell", project.cell, ()).shutdown()

    assert [c.skill for c in foreman.asked_for] == [Skill.REACH, Skill.SET_DOWN]
    assert foreman.singles == foreman.asked_for
    chosen = [e for e in events if isinstance(e, AlternativeChosen)]
    assert len(chosen) == len(foreman.asked_for)
    outcomes = [e.report for e in events if isinstance(e, SkillOutcome)]
    assert all(report.is_done for report in outcomes)
    installed = [e for e in events if isinstance(e, ComponentInstalled)]
    assert [e.target for e in installed] == ["support-1"]
    approvals = [e for e in events if isinstance(e, ApprovalGiven)]
    assert len(approvals) >= len(outcomes)
