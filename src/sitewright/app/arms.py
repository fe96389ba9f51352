"""How the arms of a cell were judged, for people."""

from __future__ import annotations

from collections.abc import Iterator

from sitewright.errors import Problem
from sitewright.planning_twin.motion import ArmVerdict, InverseKind, Kinematics
from sitewright.robot_team.cell import Cell

_CODE = "Q8"


def arm_problems(cell: Cell, kinematics: Kinematics) -> Iterator[Problem]:
    """Yield a warning for each robot whose inverse kinematics have no closed form."""
    for robot in cell.robot_by_id.values():
        verdict = kinematics.verdict(robot.description)
        if verdict.kind is InverseKind.ITERATIONS:
            yield Problem(
                code=_CODE,
                severity="W",
                where=robot.id,
                message=f"Its postures are searched by iterations, since {verdict.reason}.",
                fix="Nothing is wrong with that; but searching takes longer, and what it does not "
                "find is never called impossible.",
            )


def described(verdict: ArmVerdict) -> str:
    """Return one line about how an arm was judged."""
    joints = f"{verdict.joints} joints"
    if verdict.rails:
        joints += f", {verdict.rails} of them rails"
    if verdict.kind is InverseKind.ITERATIONS:
        return f"{joints}; {verdict.kind}, since {verdict.reason}"
    return f"{joints}; {verdict.kind}, {verdict.fk_error:.0e} off the URDF's own kinematics"
