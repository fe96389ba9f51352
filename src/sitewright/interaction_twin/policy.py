"""Rules of a project about who may decide what, beside the roles."""

from __future__ import annotations

from dataclasses import dataclass

from sitewright.central_controller.ports import START_WITHIN_S
from sitewright.interaction_twin.roles import Verb


@dataclass(frozen=True, slots=True, kw_only=True)
class ApprovalPolicy:
    """``[approval]`` of ``sitewright.toml``.

    Attributes:
        two_person: Verbs that count only when two different people decide the same.
        second_within_s: So long the first of two waits for the second.
        supervisor_below_m: Steps that come nearer than this are for a supervisor to approve.
        look_below_m: Steps that come nearer than this are marked for a look.
        prevent_self_review: Who chose an action, asked for a motion, drew a zone or vouched for
            work may not approve the plan that comes of it.
        asks_pin: Each decision at a page carries the PIN of who makes it.
        max_unstarted_s: An approval whose first step has not started after this is void.
        step_by_step_first_n_of_type: So many components of each type are approved one step at a
            time before a whole plan may be.
    """

    two_person: frozenset[Verb] = frozenset()
    second_within_s: float = 600.0
    supervisor_below_m: float = 0.0
    look_below_m: float = 0.020
    prevent_self_review: bool = False
    asks_pin: bool = False
    max_unstarted_s: float = START_WITHIN_S
    step_by_step_first_n_of_type: int = 0
