"""Reads the approval policy of a project from its settings."""

from __future__ import annotations

from collections.abc import Mapping

from pydantic import BaseModel, ConfigDict, Field, ValidationError

from sitewright.app.project import SETTINGS, ProjectError
from sitewright.foundation.canonical import Json
from sitewright.interaction_twin.policy import ApprovalPolicy
from sitewright.interaction_twin.roles import Verb

_MM = 1000.0
_NEVER_TWO = (Verb.HOLD, Verb.ANSWER)


class _ApprovalTable(BaseModel):
    model_config = ConfigDict(extra="forbid")
    two_person: list[Verb] = []
    second_within_minutes: float = Field(default=10.0, gt=0.0, le=1_440.0)
    supervisor_below_mm: float = Field(default=0.0, ge=0.0, le=1_000.0)
    look_below_mm: float = Field(default=20.0, ge=0.0, le=1_000.0)
    prevent_self_review: bool = False
    pin: bool = False
    max_unstarted_minutes: float = Field(default=10.0, gt=0.0, le=60.0)
    step_by_step_first_n_of_type: int = Field(default=0, ge=0, le=1_000)


def policy_of(settings: Mapping[str, Json], *, has_users: bool = True) -> ApprovalPolicy:
    """Return the policy that ``[approval]`` of the settings states.

    Args:
        settings: Content of ``sitewright.toml``.
        has_users: People have tokens of their own, so that two can be told apart.

    Raises:
        ProjectError: It says what there is not, or asks for two people where there is one.
    """
    try:
        table = _ApprovalTable.model_validate(settings.get("approval", {}))
    except ValidationError as error:
        raise ProjectError(f"{SETTINGS}, [approval]: {error}") from error
    never = [v for v in table.two_person if v in _NEVER_TWO]
    if never:
        raise ProjectError(f"{SETTINGS}, [approval]: {never[0]} never waits for a second person.")
    rules = {
        "two_person": table.two_person,
        "prevent_self_review": table.prevent_self_review,
        "pin": table.pin,
    }
    rule = next((name for name, is_set in rules.items() if is_set), "")
    if rule and not has_users:
        raise ProjectError(
            f"{SETTINGS}, [approval]: {rule} needs people who can be told apart. "
            "Add them with `sitewright user`, and serve with --users."
        )
    return ApprovalPolicy(
        two_person=frozenset(table.two_person),
        second_within_s=table.second_within_minutes * 60.0,
        supervisor_below_m=table.supervisor_below_mm / _MM,
        look_below_m=table.look_below_mm / _MM,
        prevent_self_review=table.prevent_self_review,
        asks_pin=table.pin,
        max_unstarted_s=table.max_unstarted_minutes * 60.0,
        step_by_step_first_n_of_type=table.step_by_step_first_n_of_type,
    )
