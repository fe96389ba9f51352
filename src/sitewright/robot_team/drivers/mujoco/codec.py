"""Values of the driver port as JSON and back, for the socket, the log and the set-up file."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any, TypeVar

from pydantic import TypeAdapter, ValidationError

from sitewright.errors import BackendError
from sitewright.foundation.ids import CommandId, RobotId
from sitewright.robot_team.cell import Cell
from sitewright.robot_team.driver import Observation, SkillReport
from sitewright.robot_team.drivers.mujoco.simulation import Checkpoint
from sitewright.robot_team.piece import Piece
from sitewright.robot_team.skill import SkillCommand
from sitewright.robot_team.trajectory import Trajectory

_T = TypeVar("_T")
Plain = Any
"""JSON as the standard library reads it."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Setup:
    """What a cell process is started with.

    Attributes:
        real_time_factor: 0 runs as fast as it can; 1 is for watching.
    """

    cell: Cell
    pieces: tuple[Piece, ...]
    real_time_factor: float = 0.0


_SETUP: TypeAdapter[Setup] = TypeAdapter(Setup)
_CHECKPOINT: TypeAdapter[Checkpoint] = TypeAdapter(Checkpoint)
_OBSERVATION: TypeAdapter[Observation] = TypeAdapter(Observation)
_TRAJECTORIES: TypeAdapter[tuple[Trajectory, ...]] = TypeAdapter(tuple[Trajectory, ...])


def setup_to_json(setup: Setup) -> Plain:
    """Return the set-up as JSON; equal set-ups give equal JSON in every process."""
    data = _SETUP.dump_python(setup, mode="json")
    for robot in data["cell"]["robot_by_id"].values():
        robot["can"] = sorted(robot["can"])
    return data


def setup_from_json(data: Plain) -> Setup:
    """Return the set-up that was written."""
    return _read(_SETUP, data)


def checkpoint_to_json(checkpoint: Checkpoint) -> Plain:
    """Return a checkpoint as JSON; floats keep every bit."""
    return _CHECKPOINT.dump_python(checkpoint, mode="json")


def checkpoint_from_json(data: Plain) -> Checkpoint:
    """Return the checkpoint that was written."""
    return _read(_CHECKPOINT, data)


def observation_to_json(observation: Observation) -> Plain:
    """Return an observation as JSON."""
    return _OBSERVATION.dump_python(observation, mode="json")


def observation_from_json(data: Plain) -> Observation:
    """Return the observation that was written."""
    return _read(_OBSERVATION, data)


def command_to_json(command: SkillCommand) -> Plain:
    """Return a command as JSON."""
    return {
        "command_id": command.command_id,
        "epoch": command.epoch,
        "skill": command.skill,
        "robot": command.robot,
        "trajectories": _TRAJECTORIES.dump_python(command.trajectories, mode="json"),
        "params": _plain(command.params),
    }


def command_from_json(data: Plain) -> SkillCommand:
    """Return the command that was written."""
    try:
        return SkillCommand(
            command_id=CommandId(str(data["command_id"])),
            epoch=int(data["epoch"]),
            skill=str(data["skill"]),
            robot=RobotId(str(data["robot"])),
            trajectories=_read(_TRAJECTORIES, data["trajectories"]),
            params=dict(data["params"]),
        )
    except (KeyError, TypeError, ValueError) as error:
        raise BackendError(f"not a skill command: {error}") from error


def report_to_json(report: SkillReport) -> Plain:
    """Return a report as JSON."""
    return _plain(asdict(report))


def report_from_json(data: Plain) -> SkillReport:
    """Return the report that was written."""
    return SkillReport(
        is_done=bool(data["is_done"]),
        reason=str(data["reason"]),
        evidence=dict(data["evidence"]),
        duration_s=float(data["duration_s"]),
    )


def _plain(value: Plain) -> Plain:
    """Return nested mappings and sequences as dicts and lists."""
    if isinstance(value, Mapping):
        return {str(k): _plain(v) for k, v in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(v) for v in value]
    return value


def _read(adapter: TypeAdapter[_T], data: Plain) -> _T:
    try:
        return adapter.validate_python(data)
    except ValidationError as error:
        raise BackendError(f"the simulated cell got data that it cannot read: {error}") from error
