"""Reads the parameters of a command; a wrong one is refused before anything moves."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from sitewright.errors import CommandRefusedError
from sitewright.foundation.canonical import Json
from sitewright.foundation.pose import Pose
from sitewright.robot_team.skill import SkillCommand


def text(command: SkillCommand, key: str) -> str:
    """Return a parameter that is a name."""
    value = command.params.get(key)
    if not isinstance(value, str) or not value:
        raise _wrong(command, key, "a name")
    return value


def text_or_none(command: SkillCommand, key: str) -> str | None:
    """Return a parameter that is a name or null."""
    return None if command.params.get(key) is None else text(command, key)


def texts(command: SkillCommand, key: str) -> tuple[str, ...]:
    """Return a parameter that is a list of names; none is an empty list."""
    value = command.params.get(key, [])
    if isinstance(value, str) or not isinstance(value, Sequence):
        raise _wrong(command, key, "a list of names")
    return tuple(str(v) for v in value)


def number(command: SkillCommand, key: str, default: float | None = None) -> float:
    """Return a parameter that is a finite number not below zero."""
    return _number(command, key, command.params.get(key, default))


def fastener(command: SkillCommand) -> tuple[str, float]:
    """Return type and length of the fastener."""
    value = command.params.get("fastener")
    if not isinstance(value, Mapping) or not isinstance(value.get("type"), str):
        raise _wrong(command, "fastener", "an object with type, d_m and l_m")
    return str(value["type"]), _number(command, "fastener.l_m", value.get("l_m"))


def size(command: SkillCommand, key: str) -> tuple[float, float]:
    """Return a parameter of two lengths."""
    value = command.params.get(key)
    if isinstance(value, str) or not isinstance(value, Sequence) or len(value) != 2:  # noqa: PLR2004
        raise _wrong(command, key, "two lengths")
    return _number(command, key, value[0]), _number(command, key, value[1])


def pose(command: SkillCommand, key: str) -> Pose:
    """Return a parameter that is a pose."""
    return pose_of(command.params.get(key), f"{command.skill}: {key}")


def pose_of(value: Json, where: str) -> Pose:
    """Return the pose written as ``{"p_m": [..], "q_wxyz": [..]}``."""
    try:
        position, quaternion = _floats(value, "p_m"), _floats(value, "q_wxyz")
        x, y, z = position
        a, b, c, d = quaternion
        return Pose((x, y, z), (a, b, c, d))
    except (KeyError, TypeError, ValueError) as error:
        raise CommandRefusedError(f"{where} is not a pose: {value!r} ({error})") from error


def _floats(value: Json, key: str) -> list[float]:
    numbers = value[key] if isinstance(value, Mapping) else None
    if isinstance(numbers, str) or not isinstance(numbers, Sequence):
        raise TypeError(f"{key} is missing")
    return [float(n) for n in numbers if isinstance(n, int | float)]


def pose_json(pose: Pose) -> Json:
    """Return a pose as commands and reports write it."""
    return {"p_m": list(pose.position_m), "q_wxyz": list(pose.quaternion_wxyz)}


def declared_contacts(command: SkillCommand) -> tuple[tuple[str, str], ...] | None:
    """Return the pairs that the command declares as contacts; None if it says nothing."""
    value = command.params.get("contacts")
    if value is None:
        return None
    if isinstance(value, str) or not isinstance(value, Sequence):
        raise _wrong(command, "contacts", "a list of pairs of names")
    return tuple(_name_pair(command, pair) for pair in value)


def _name_pair(command: SkillCommand, pair: Json) -> tuple[str, str]:
    if isinstance(pair, str) or not isinstance(pair, Sequence) or len(pair) != 2:  # noqa: PLR2004
        raise _wrong(command, "contacts", "a list of pairs of names")
    return str(pair[0]), str(pair[1])


def _number(command: SkillCommand, key: str, value: Json) -> float:
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise _wrong(command, key, "a number")
    if not 0.0 <= float(value) < float("inf"):
        raise _wrong(command, key, "a finite number not below zero")
    return float(value)


def _wrong(command: SkillCommand, key: str, wanted: str) -> CommandRefusedError:
    got = command.params.get(key.split(".", maxsplit=1)[0])
    return CommandRefusedError(f"{command.skill}: {key} must be {wanted}, not {got!r}")
