"""What people decide by a command: the open plan by its check code, and the run."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from sitewright.app.serving.remote import Document, Remote
from sitewright.errors import ApprovalError

_DECISIONS = "/api/decisions"


@dataclass(frozen=True, slots=True, kw_only=True)
class Part:
    """How much of a plan is approved.

    Attributes:
        until: Up to this step.
        is_step: The next step alone.
    """

    until: int | None = None
    is_step: bool = False

    def scope(self, next_step: int) -> Document:
        """Return it as the interface takes it."""
        if self.is_step:
            return {"kind": "step", "step": next_step}
        return {"kind": "plan"} if self.until is None else {"kind": "until", "step": self.until}


def approve(project: Path, code: str, part: Part) -> Document:
    """Approve what a check code stands for: bound to its whole fingerprint.

    Returns:
        The server's answer with `proposal`, `scope`, and the `lines` that say what was approved.

    Raises:
        SitewrightError: Another plan is open, or the server refuses or is not there.
    """
    remote = Remote(project)
    proposal = _open_plan(remote, code)
    first, steps = proposal["next_step"], proposal["steps"]
    scope = part.scope(first)
    last = scope.get("step", len(steps))
    lines = [proposal["title"], *(_line(s) for s in steps if first <= s["number"] <= last)]
    body = {"verb": "approve", "scope": scope, "next_step": first, "shown": lines}
    told = remote.decide(_DECISIONS, {**body, "fingerprint": proposal["fingerprint"]})
    return {**told, "fingerprint": proposal["fingerprint"], "scope": scope, "lines": lines}


def reject(project: Path, code: str, *, reason: str, detail: str, step: int) -> Document:
    """Reject the plan that a check code stands for, or one of its steps.

    Raises:
        SitewrightError: Another plan is open, or the server refuses or is not there.
    """
    remote = Remote(project)
    proposal = _open_plan(remote, code)
    body = {"verb": "reject", "reason": reason, "detail": detail, "step": step}
    seen = {"fingerprint": proposal["fingerprint"], "shown": [proposal["title"]]}
    return {**remote.decide(_DECISIONS, {**body, **seen}), "fingerprint": proposal["fingerprint"]}


def hold(project: Path, reason: str) -> Document:
    """Ask for a hold: the cell first, the journal after.

    Raises:
        SitewrightError: The run stands already, or the server is not there.
    """
    return Remote(project).decide("/api/hold", {"reason": reason})


def resume(project: Path) -> Document:
    """Begin, or go on after a hold.

    Raises:
        SitewrightError: The run is under way, or the server refuses or is not there.
    """
    return Remote(project).decide(_DECISIONS, {"verb": "resume"})


def _open_plan(remote: Remote, code: str) -> Document:
    proposal = remote.get("/api/proposals/open")
    if "fingerprint" not in proposal:
        raise ApprovalError(f"No plan waits for a decision: {proposal['reason']}")
    wanted = code.strip().upper()
    if proposal["code"] != wanted:
        raise ApprovalError(
            f"The plan that is open is {proposal['code']}, not {wanted}. Look at it first: "
            f"`sitewright show {proposal['code']}`."
        )
    return proposal


def _line(step: Document) -> str:
    flags = f" [{'; '.join(str(f) for f in step['flags'])}]" if step["flags"] else ""
    return f"{step['number']}. {step['robot_name']} {step['words']}{flags}"
