"""Who may do what: roles, the verbs of decisions, and the lowest role for each."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum


class Role(StrEnum):
    """Roles from the lowest to the highest; each may do all that the ones before it may."""

    VIEWER = "viewer"
    """Looks, and may ask for a hold."""
    OPERATOR = "operator"
    """Approves, rejects, chooses, resumes."""
    SUPERVISOR = "supervisor"
    """Draws keep-out zones, overrides checks, completes by hand."""
    ADMIN = "admin"
    """Changes policy and users."""

    def may(self, needed: Role) -> bool:
        """Return whether this role covers another one."""
        order = tuple(Role)
        return order.index(self) >= order.index(needed)


class Verb(StrEnum):
    """What a person can decide."""

    APPROVE = "approve"
    REJECT = "reject"
    INSTEAD = "instead"
    NEW_MOTION = "new-motion"
    RESUME = "resume"
    ANSWER = "answer"
    MISMATCH = "mismatch"
    ZONE = "zone"
    MANUAL = "manual"
    HOLD = "hold"


NEEDED_ROLE: Mapping[Verb, Role] = {
    Verb.APPROVE: Role.OPERATOR,
    Verb.REJECT: Role.OPERATOR,
    Verb.INSTEAD: Role.OPERATOR,
    Verb.NEW_MOTION: Role.OPERATOR,
    Verb.RESUME: Role.OPERATOR,
    Verb.ANSWER: Role.OPERATOR,
    Verb.MISMATCH: Role.OPERATOR,
    Verb.ZONE: Role.SUPERVISOR,
    Verb.MANUAL: Role.SUPERVISOR,
    Verb.HOLD: Role.VIEWER,
}
"""The lowest role for each verb; a verb without an entry is a bug that a test finds."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Person:
    """Who is on the other side.

    Attributes:
        session: Id of the session, so that the audit tells two tablets of one user apart.
    """

    who: str
    role: Role
    session: str
