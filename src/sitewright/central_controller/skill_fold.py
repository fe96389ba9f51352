"""How the events of a skill, from intent to looked-at effects, change the cycle's state."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from sitewright.central_controller.cycle_state import CycleState, Flight, Phase
from sitewright.central_controller.events import (
    SkillIntent,
    SkillOutcome,
    SkillReconciled,
    SkillReissued,
)
from sitewright.central_controller.ports import Answer
from sitewright.central_controller.site_fold import places_after
from sitewright.foundation.sentence import Sentence
from sitewright.robot_team.driver import SkillReport

SkillEvent = SkillIntent | SkillOutcome | SkillReconciled | SkillReissued

_SAME_RAD = 0.010
_PHASE_BY_VERDICT: Mapping[str, Phase] = {"never": Phase.NEVER, "unknown": Phase.UNKNOWN}


def after_skill_event(  # noqa: PLR0911 -- one line per kind of event
    state: CycleState, event: SkillEvent
) -> CycleState:
    """Return the state after an event of a skill; repeated and late reports change nothing."""
    if isinstance(event, SkillIntent):
        started = state.started | {(event.approval_id, event.step)}
        return replace(state, flight=_flight(state, event), started=started)
    flight = state.flight
    if flight is None or flight.intent.command_id != event.command_id:
        return state  # a repeated or late report
    match event:
        case SkillReissued():
            return replace(state, flight=replace(flight, phase=Phase.STARTED))
        case SkillOutcome() if flight.phase is Phase.ENDED:
            return state
        case SkillOutcome(report=report, source=source):
            ended = replace(flight, phase=Phase.ENDED, report=report, source=source)
            return _robot_placed(replace(state, flight=ended, link_losses=0), ended)
        case SkillReconciled(verdict=verdict):
            phase = _PHASE_BY_VERDICT.get(verdict)
            if phase is None:
                return _stayed(_not_done(state, flight), flight)
            return replace(state, flight=replace(flight, phase=phase))


def _flight(state: CycleState, intent: SkillIntent) -> Flight:
    robot, site = intent.call.robot, state.site
    sensed = site.sensed.robots.get(robot) if site.sensed is not None else None
    known = robot in site.place_by_robot
    return Flight(
        intent=intent,
        start_q_rad=sensed.q_rad if sensed is not None else (),
        start_place=(site.place_by_robot[robot],) if known else (),
    )


def _stayed(state: CycleState, flight: Flight) -> CycleState:
    """Give a robot its place back if it is sensed where its motion should have started."""
    robot, sensed = flight.intent.call.robot, state.site.sensed
    now = sensed.robots.get(robot) if sensed is not None else None
    if now is None or not flight.start_place or len(now.q_rad) != len(flight.start_q_rad):
        return state
    pairs = zip(now.q_rad, flight.start_q_rad, strict=True)
    if any(abs(is_rad - was_rad) > _SAME_RAD for is_rad, was_rad in pairs):
        return state
    places = {**state.site.place_by_robot, robot: flight.start_place[0]}
    return replace(state, site=replace(state.site, place_by_robot=places))


def _robot_placed(state: CycleState, flight: Flight) -> CycleState:
    """Note where the robot is after its motion; nowhere known if it did not end well."""
    intent, report = flight.intent, flight.report
    places = dict(state.site.place_by_robot)
    if report is not None and report.is_done:
        places = places_after(places, intent.call.robot, intent.effects)
    elif intent.trajectories:
        places.pop(intent.call.robot, None)
    serial = state.site.serial + (0 if report is not None and report.is_done else 1)
    return replace(state, site=replace(state.site, place_by_robot=places, serial=serial))


def _not_done(state: CycleState, flight: Flight) -> CycleState:
    """The skill did not take place as planned: go on from what is sensed, with a new plan."""
    state = _robot_placed(state, replace(flight, report=None))
    return replace(without_proposal(state), flight=None)


def answered(state: CycleState, answer: Answer) -> CycleState:
    """Return the state after a person settled the open question."""
    flight, state = state.flight, replace(state, question=None)
    if flight is None:
        return state
    match answer:
        case Answer.DONE:
            done = SkillReport(is_done=True)
            ended = replace(flight, phase=Phase.ENDED, report=done, source="person")
            return _robot_placed(replace(state, flight=ended), ended)
        case Answer.NOT_DONE:
            return _stayed(_not_done(state, flight), flight)
        case Answer.PARTIAL:
            state = _stayed(_not_done(state, flight), flight)
            why = Sentence(
                "{spot} was left half done; rework it by hand.",
                spot=(flight.intent.call.arguments or (flight.intent.target,))[0],
            )
            rework = {**state.site.needs_rework, flight.intent.target: why}
            return replace(state, site=replace(state.site, needs_rework=rework))


def closed(state: CycleState, command_id: str) -> CycleState:
    """Return the state after a skill's effects were looked at: step done, or plan gone."""
    flight = state.flight
    if flight is None or flight.intent.command_id != command_id:
        return state
    state = replace(state, flight=None)
    if flight.report is not None and not flight.report.is_done:
        state = _stayed(state, flight)
    if state.proposal is None:
        return state
    done = flight.intent.step
    if done == len(state.proposal.steps):
        return without_proposal(state)
    return replace(state, done=done)


def without_proposal(state: CycleState) -> CycleState:
    """Return the state in which a new proposal must be made."""
    return replace(state, proposal=None, done=0, approval=None, why="")
