"""Does a cell file fit together: ids, names, docks, bases?"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from itertools import combinations

from sitewright.errors import Problem, did_you_mean
from sitewright.foundation.pose import distance
from sitewright.robot_team.cell import Capability, StationKind
from sitewright.robot_team.formats.cell_file import CellFile, EndEffectorFile, RobotFile

_SAME_PLACE_M = 0.05
_BASE_DISTANCE_M = 0.30


def fit_problems(file: CellFile) -> Iterator[Problem]:
    """Yield everything that does not fit together, before any model is read."""
    yield from _duplicates(file)
    for robot in file.robot:
        yield from _robot(file, robot)
    for tool in file.end_effector:
        yield from _end_effector(file, tool)
    robots = [r.id for r in file.robot]
    for station in file.station:
        if station.robot is not None and station.robot not in robots:
            yield _unknown(f"station[{station.id}].robot", "robot", station.robot, robots)
    yield from _crowded_docks(file)
    yield from _crowded_bases(file)
    yield from _mounted_twice(file)


def problem(code: str, where: str, message: str, fix: str) -> Problem:
    """Return a problem that refuses the cell."""
    return Problem(code=code, severity="E", where=where, message=message, fix=fix)


def _duplicates(file: CellFile) -> Iterator[Problem]:
    things: Mapping[str, Iterable[str]] = {
        "robot": [r.id for r in file.robot],
        "end effector": [e.id for e in file.end_effector],
        "station": [s.id for s in file.station],
        "stock place": [s.id for s in file.stock_place],
        "fixture": [f.id for f in file.fixture],
        "zone": [z.id for z in file.zone],
    }
    kinds_of: dict[str, list[str]] = {}
    for kind, ids in things.items():
        for identity in ids:
            kinds_of.setdefault(identity, []).append(kind)
    for identity, kinds in sorted(kinds_of.items()):
        if len(kinds) > 1:
            message = f"The id {identity!r} is used by {len(kinds)} things: {', '.join(kinds)}."
            yield problem("D1", identity, message, "Give each its own id.")


def _robot(file: CellFile, robot: RobotFile) -> Iterator[Problem]:
    known = [e.id for e in file.end_effector]
    where = f"robot[{robot.id}]"
    for name in robot.end_effectors:
        if name not in known:
            yield _unknown(f"{where}.end_effectors", "end effector", name, known)
    if robot.mounted is not None and robot.mounted not in robot.end_effectors:
        message = f"{robot.mounted!r} is mounted but not among its end_effectors."
        yield problem("L2", where, message, "List it in end_effectors.")
    if len(robot.end_effectors) > 1 and Capability.TOOL_CHANGING not in (robot.can or ()):
        message = "It has several end effectors but cannot change them."
        yield problem("L2", where, message, 'Add "tool-changing" to `can`.')


def _end_effector(file: CellFile, tool: EndEffectorFile) -> Iterator[Problem]:
    where = f"end_effector[{tool.id}]"
    stations = [s.id for s in file.station if s.kind is StationKind.TOOL]
    if tool.station is not None and tool.station not in stations:
        yield _unknown(f"{where}.station", "tool station", tool.station, stations)
    users = [r for r in file.robot if tool.id in r.end_effectors]
    if not users:
        yield problem("L2", where, "No robot lists it.", "Add it to a robot's end_effectors.")
    is_shared = any(len(r.end_effectors) > 1 for r in users)
    if tool.station is None and (is_shared or not any(r.mounted == tool.id for r in users)):
        message = "It is not always mounted, and has no tool station to dock at."
        yield problem("L2", where, message, "Name a station of kind tool.")


def _crowded_docks(file: CellFile) -> Iterator[Problem]:
    docked = [e for e in file.end_effector if e.station is not None]
    for a, b in combinations(docked, 2):
        if a.station == b.station and distance(_dock(a), _dock(b)) < _SAME_PLACE_M:
            message = f"{a.id} and {b.id} dock at the same place of {a.station}."
            fix = "Give each its own station_T_mount."
            yield problem("L2", f"end_effector[{b.id}]", message, fix)


def _dock(tool: EndEffectorFile) -> tuple[float, float, float]:
    return tool.station_T_mount.p_m if tool.station_T_mount else (0.0, 0.0, 0.0)


def _crowded_bases(file: CellFile) -> Iterator[Problem]:
    for a, b in combinations(file.robot, 2):
        gap_m = distance(a.world_T_base.p_m, b.world_T_base.p_m)
        if gap_m < _BASE_DISTANCE_M:
            message = f"The bases of {a.id} and {b.id} are {gap_m:.2f} m apart."
            yield problem("L2", f"robot[{b.id}]", message, "Give each robot its own place.")


def _mounted_twice(file: CellFile) -> Iterator[Problem]:
    mounted = Counter(r.mounted for r in file.robot if r.mounted is not None)
    for name, count in sorted(mounted.items()):
        if count > 1:
            message = f"It is mounted on {count} robots."
            yield problem("L2", f"end_effector[{name}]", message, "Mount it on one.")


def _unknown(where: str, kind: str, name: str, known: Iterable[str]) -> Problem:
    there = sorted(known)
    listed = ", ".join(there) or "none"
    message = f"There is no {kind} {name!r}; known: {listed}.{did_you_mean(name, there)}"
    return problem("L1", where, message, "Correct the name.")
