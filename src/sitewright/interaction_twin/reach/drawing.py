"""What the reach picture shows: fixtures, zones, stock, targets, operations and robots."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace

from sitewright.foundation.ids import ComponentId, OperationId, RobotId
from sitewright.foundation.pose import Pose, Vector
from sitewright.interaction_twin.labels import Labels
from sitewright.interaction_twin.reach.lines import WORDS
from sitewright.interaction_twin.reach.outline import Outline, outline_of
from sitewright.interaction_twin.reach.palette import (
    FIXTURE,
    FIXTURE_EDGE,
    FLOOR,
    ROBOT_COLOURS,
    STOCK,
    STOCK_EDGE,
    ZONE,
    ZONE_EDGE,
    Look,
    look_of,
)
from sitewright.planning_twin.reachability.answer import ReachSphere
from sitewright.planning_twin.reachability.report import ReachReport
from sitewright.robot_team.cell import Robot
from sitewright.robot_team.gripper import shape_at
from sitewright.robot_team.kinematics import link_poses, tip_pose

_FIXTURE = Look(FIXTURE, FIXTURE_EDGE, "")
_FLOOR = Look(FLOOR, FIXTURE_EDGE, "")
_STOCK = Look(STOCK, STOCK_EDGE, "")
_FLOOR_M, _WIDE_M2 = 0.05, 12.0
_ZONE = Look(ZONE, ZONE_EDGE, "")


@dataclass(frozen=True, slots=True, kw_only=True)
class Drawn:
    """One body with its looks.

    Attributes:
        label: Words beside it; empty if none.
        hint: What it says when it is pointed at.
        opacity: Of its fill.
    """

    outline: Outline
    look: Look
    label: str = ""
    hint: str = ""
    opacity: float = 1.0
    is_zone: bool = False

    @property
    def is_floor(self) -> bool:
        """Whether it lies under everything, and is wide."""
        (x, y, _), (far_x, far_y, top) = self.outline.low_m, self.outline.high_m
        return top <= _FLOOR_M and (far_x - x) * (far_y - y) > _WIDE_M2


@dataclass(frozen=True, slots=True, kw_only=True)
class DrawnRobot:
    """One robot: its links at home, its base, and where its wrist can be."""

    id: RobotId
    colour: str
    links: tuple[Outline, ...]
    world_T_base: Pose
    sphere: ReachSphere | None


@dataclass(frozen=True, slots=True, kw_only=True)
class Spotted:
    """One operation.

    Attributes:
        is_reached: Some robot reaches it.
    """

    id: OperationId
    at_m: Vector
    is_reached: bool
    hint: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Drawing:
    """Everything of a cell, the lowest first."""

    fixtures: tuple[Drawn, ...]
    zones: tuple[Drawn, ...]
    stock: tuple[Drawn, ...]
    targets: tuple[Drawn, ...]
    spots: tuple[Spotted, ...] = ()
    robots: tuple[DrawnRobot, ...] = ()
    places: Mapping[str, Vector] = field(default_factory=dict)


def drawing_of(report: ReachReport, labels: Labels) -> Drawing:
    """Return what is to be drawn of a reach check."""
    cell, bodies = report.question.cell, report.question.bodies
    placed: dict[str, Outline] = {
        b.id: outline_of(b.shape, b.world_T_body) for b in bodies if not b.docked
    }
    return Drawing(
        fixtures=tuple(_fixture(placed[f], f) for f in cell.fixture_by_id),
        zones=tuple(
            Drawn(outline=placed[z], look=_ZONE, hint=z, opacity=0.18, is_zone=True)
            for z in cell.zone_by_id
        ),
        stock=tuple(
            Drawn(outline=placed[i], look=_STOCK, hint=labels.name(i))
            for i in _pieces(report)
            if i in placed
        ),
        targets=tuple(_targets(report, labels, placed)),
        spots=tuple(_spots(report)),
        robots=tuple(_robots(report)),
        places={p: s.world_T_stock.position_m for p, s in cell.stock_place_by_id.items()},
    )


def _fixture(outline: Outline, name: str) -> Drawn:
    body = Drawn(outline=outline, look=_FIXTURE, hint=name)
    return replace(body, look=_FLOOR) if body.is_floor else body


def _pieces(report: ReachReport) -> list[ComponentId]:
    pieces = {p for t in report.question.targets for p in t.world_T_piece}
    return sorted(pieces)


def _targets(report: ReachReport, labels: Labels, placed: Mapping[str, Outline]) -> Iterator[Drawn]:
    for verdict in report.verdicts:
        name = labels.name(verdict.target)
        who = f" by {', '.join(verdict.robots)}" if verdict.robots else ""
        hint = "\n".join((f"{name}: {WORDS[verdict.standing]}{who}", *verdict.reasons))
        yield Drawn(outline=placed[verdict.target], look=look_of(verdict), label=name, hint=hint)


def _spots(report: ReachReport) -> Iterator[Spotted]:
    by_operation: dict[OperationId, list[RobotId]] = {}
    for operating in report.answer.operatings:
        found = by_operation.setdefault(operating.operation, [])
        if operating.ways:
            found.append(operating.robot)
    for target in report.question.targets:
        for spot in target.task.spots:
            who = by_operation.get(spot.operation, [])
            words = f"reached by {', '.join(who)}" if who else "reached by nobody"
            yield Spotted(
                id=spot.operation,
                at_m=spot.world_T_operation.position_m,
                is_reached=bool(who),
                hint=f"{spot.operation}: {words}",
            )


def _robots(report: ReachReport) -> Iterator[DrawnRobot]:
    spheres = {s.robot: s for s in report.answer.spheres}
    tools = report.question.cell.end_effector_by_id
    for number, robot in enumerate(report.question.cell.robot_by_id.values()):
        links = list(_links(robot))
        if robot.mounted is not None:
            tool = tools[robot.mounted]
            tip = robot.world_T_base @ tip_pose(robot.description, robot.home_q_rad)
            links.append(outline_of(shape_at(tool.description, tool.opens_to_m), tip))
        yield DrawnRobot(
            id=robot.id,
            colour=ROBOT_COLOURS[number % len(ROBOT_COLOURS)],
            links=tuple(links),
            world_T_base=robot.world_T_base,
            sphere=spheres.get(robot.id),
        )


def _links(robot: Robot) -> Iterator[Outline]:
    poses = link_poses(robot.description, robot.home_q_rad)
    for link in robot.description.links:
        if link.shape:
            yield outline_of(link.shape, robot.world_T_base @ poses[link.name])
