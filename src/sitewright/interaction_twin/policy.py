"""Rules of a project about who may decide what, beside the roles."""

from __future__ import annotations

from dataclasses import dataclass

from sitewright.interaction_twin.roles import Verb


@dataclass(frozen=True, slots=True, kw_only=True)
class ApprovalPolicy:
    """``[approval]`` of ``sitewright.toml``.

    Attributes:
        two_person: Verbs that count only when two different people decide the same.
        second_within_s: So long the first of two waits for the second.
        supervisor_below_m: Steps that come nearer than this are for a supervisor to approve.
        look_below_m: Steps that come nearer than this are marked for a look.
    """

    two_person: frozenset[Verb] = frozenset()
    second_within_s: float = 600.0
    supervisor_below_m: float = 0.0
    look_below_m: float = 0.020
