"""The robots and end effectors that come with the package."""

from __future__ import annotations

from collections.abc import Iterable
from importlib.resources import files
from pathlib import Path

from sitewright.errors import TeamError, did_you_mean

BUILTIN_ROBOTS = ("abb-irb6700-200-260", "kuka-kr120-r2500-pro")
BUILTIN_END_EFFECTORS = (
    "builtin:nail-gun",
    "builtin:paint-head",
    "builtin:parallel-gripper",
    "builtin:screwdriver",
)


class UnknownModelError(TeamError):
    """A cell names a built-in model that does not exist."""

    def __init__(self, kind: str, name: str, *, known: Iterable[str]) -> None:
        self.name, self.known = name, tuple(known)
        super().__init__(
            f"There is no built-in {kind} {name!r}; known: {', '.join(self.known)}."
            f"{did_you_mean(name, self.known)}"
            ' Or give the path of your own: urdf = "folder/file.urdf".'
        )


def builtin_robot(name: str) -> Path:
    """Return the URDF of a built-in robot, e.g. ``kuka-kr120-r2500-pro``."""
    if name not in BUILTIN_ROBOTS:
        raise UnknownModelError("robot", name, known=BUILTIN_ROBOTS)
    return _folder(name) / "robot.urdf"


def builtin_end_effector(name: str) -> Path:
    """Return the URDF of a built-in end effector, e.g. ``builtin:nail-gun``."""
    if name not in BUILTIN_END_EFFECTORS:
        raise UnknownModelError("end effector", name, known=BUILTIN_END_EFFECTORS)
    return _folder(name.removeprefix("builtin:")) / "tool.urdf"


def _folder(name: str) -> Path:
    return Path(str(files("sitewright.robot_team.models"))) / name.replace("-", "_")
