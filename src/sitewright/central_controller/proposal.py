"""A proposal: what a person is asked to approve, and the fingerprint of exactly that."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from sitewright.foundation.canonical import Json
from sitewright.foundation.ids import ComponentId
from sitewright.planning_twin.motion import PlannedMotion
from sitewright.robot_team.skill import SkillCall


@dataclass(frozen=True, slots=True, kw_only=True)
class ProposedStep:
    """One skill call with all that a driver needs.

    Attributes:
        number: 1 for the first step of the proposal.
        params: As `sitewright.robot_team.driver` says for the skill.
        relies_on: Facts that must hold when it starts, as PDDL text in site ids.
        effects: Facts that it makes true or (with ``not``) false, likewise.
        duration_s: Motions plus the act of the end effector.
        contacts: Declared contacts of its motions, for people.
    """

    number: int
    call: SkillCall
    params: Mapping[str, Json]
    motions: tuple[PlannedMotion, ...]
    duration_s: float
    relies_on: tuple[str, ...] = ()
    effects: tuple[str, ...] = ()
    contacts: tuple[tuple[str, str], ...] = ()

    @property
    def closest_distance_m(self) -> float | None:
        """Smallest certified distance of its motions, declared contacts left out."""
        distances = [m.certificate.closest_distance_m for m in self.motions]
        return min(distances) if distances else None


@dataclass(frozen=True, slots=True, kw_only=True)
class Proposal:
    """A plan for one target (or one chosen step), ready to be approved.

    Attributes:
        site_serial: Counts changes of the site that no proposal predicted.
        context: Hashes of team, cell, model, domain and the software version.
    """

    run: str
    target: ComponentId
    steps: tuple[ProposedStep, ...]
    site_serial: int
    context: Mapping[str, str]
