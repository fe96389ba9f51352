"""Everything that a page draws, as one JSON document: shapes once, poses in the world."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

from sitewright.building_model.component import Component, Layer
from sitewright.building_model.model import BuildingModel
from sitewright.building_model.shapes import UnsupportedGeometryError, shape_of
from sitewright.central_controller.site_state import SiteState
from sitewright.construction_graph.graph import ConstructionGraph, MaterialNode, Node, TargetNode
from sitewright.construction_graph.queries import leaves, missing_before
from sitewright.foundation.canonical import Json, canonical_json, sha256_hex
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Pose, Vector
from sitewright.foundation.shapes import Box, Shape
from sitewright.interaction_twin.labels import Labels
from sitewright.robot_team.cell import Cell, EndEffector, Robot
from sitewright.robot_team.description import Description
from sitewright.robot_team.driver import Observation

SCHEMA = "sitewright.page-scene/1"
_FOOT_M = 0.001
Triangles = tuple[Sequence[Vector], Sequence[tuple[int, int, int]]]
"""Corners (m) and triangles, counter-clockwise seen from outside."""


@dataclass(frozen=True, slots=True, kw_only=True)
class SceneSource:
    """What the document is made of.

    Attributes:
        graph: As folded and sensed now.
        observation: Sensed last, or as the design has it while nothing was sensed.
        active: Target that the open proposal is about.
        triangles: Faces of a shape.
    """

    project: str
    run: str
    model: BuildingModel
    cell: Cell
    graph: ConstructionGraph
    site: SiteState
    observation: Observation
    labels: Labels
    triangles: Callable[[Shape], Triangles]
    active: ComponentId | None = None


def scene_document(source: SceneSource) -> dict[str, Json]:
    """Return the document without its hash and epoch."""
    return _Scene(source).document()


def joint_names(cell: Cell) -> list[tuple[str, str]]:
    """Return owner and joint in the order of the binary frames: robots, then end effectors."""
    owners: list[Robot | EndEffector] = [
        *cell.robot_by_id.values(),
        *cell.end_effector_by_id.values(),
    ]
    return [(o.id, j.name) for o in owners for j in o.description.movable_joints]


def pose_json(pose: Pose) -> dict[str, Json]:
    """Return a pose as the interface writes it."""
    return {
        "p_m": [round(v, 7) for v in pose.position_m],
        "q_wxyz": [round(v, 9) for v in pose.quaternion_wxyz],
    }


def docked_at(cell: Cell, tool: EndEffector) -> Pose | None:
    """Return where an end effector's mount is in its dock; None if it has none."""
    station = cell.station_by_id.get(tool.station) if tool.station else None
    return None if station is None else station.world_T_station @ tool.station_T_mount


@dataclass
class _Scene:
    source: SceneSource
    _gid_by_shape: dict[Shape, str] = field(default_factory=dict)
    _geometries: dict[str, Json] = field(default_factory=dict)
    _free: frozenset[ComponentId] = field(init=False)

    def __post_init__(self) -> None:
        self._free = frozenset(leaves(self.source.graph))

    def document(self) -> dict[str, Json]:
        cell, source = self.source.cell, self.source
        parts: dict[str, Json] = {
            "schema": SCHEMA,
            "project": source.project,
            "run": source.run,
            "is_simulation": True,
            "ground_z_m": self._ground_z_m(),
            "clearance_m": cell.clearance_m,
            "robots": [self._robot(n, r) for n, r in enumerate(cell.robot_by_id.values(), 1)],
            "end_effectors": [self._tool(t) for t in cell.end_effector_by_id.values()],
            "joints": [{"of": o, "joint": j} for o, j in joint_names(cell)],
            "components": [self._component(c) for c in source.model.component_by_id.values()],
            "zones": [
                {**self._body(z.id, z.shape, z.world_T_zone), "by": "cell"}
                for z in cell.zone_by_id.values()
            ]
            + [
                {**self._body(z.id, (Box(z.size_m),), z.world_T_zone), "by": z.who}
                for z in source.site.zones.values()
            ],
            "fixtures": [
                self._body(f.id, f.shape, f.world_T_fixture) for f in cell.fixture_by_id.values()
            ],
            "stations": [
                {
                    "id": s.id,
                    "name": source.labels.name(s.id),
                    "kind": s.kind.value,
                    "robot": s.robot,
                    "world_T": pose_json(s.world_T_station),
                }
                for s in cell.station_by_id.values()
            ],
            "stock_places": [
                {
                    "id": p.id,
                    "name": source.labels.name(p.id),
                    "world_T": pose_json(p.world_T_stock),
                }
                for p in cell.stock_place_by_id.values()
            ],
        }
        return {**parts, "geometries": self._geometries}

    def _ground_z_m(self) -> float:
        """Return the top of the highest fixture that nothing of a robot's foot is below."""
        feet_m = min(
            (r.world_T_base.position_m[2] for r in self.source.cell.robot_by_id.values()),
            default=0.0,
        )
        tops = [
            max(f.world_T_fixture.apply(v)[2] for part in f.shape for v in part.vertices_m())
            for f in self.source.cell.fixture_by_id.values()
        ]
        return round(max((z for z in tops if z <= feet_m + _FOOT_M), default=feet_m), 6)

    # ---- robots ------------------------------------------------------------------------------

    def _robot(self, number: int, robot: Robot) -> Json:
        seen = self.source.observation.robots.get(robot.id)
        return {
            "id": robot.id,
            "name": self.source.labels.name(robot.id),
            "number": number,
            "world_T_base": pose_json(robot.world_T_base),
            "description": self._description(robot.description),
            "mounted": robot.mounted if seen is None else seen.mounted,
            "gripped": None if seen is None else seen.gripped,
            "q_rad": list(robot.home_q_rad if seen is None else seen.q_rad),
        }

    def _tool(self, tool: EndEffector) -> Json:
        robots = self.source.observation.robots.items()
        carrier = next((r for r, s in robots if s.mounted == tool.id), None)
        opening_m = 0.0 if carrier is None else self.source.observation.robots[carrier].aperture_m
        fingers = tool.description.movable_joints
        return {
            "id": tool.id,
            "name": self.source.labels.name(tool.id),
            "kind": tool.kind.value,
            "description": self._description(tool.description),
            "opens_to_m": tool.opens_to_m,
            "q": [opening_m / len(fingers) for _ in fingers],
            "on": carrier,
            "world_T_mount": None if carrier is not None else self._docked(tool),
        }

    def _docked(self, tool: EndEffector) -> Json:
        pose = docked_at(self.source.cell, tool)
        return None if pose is None else pose_json(pose)

    def _description(self, description: Description) -> Json:
        return {
            "root": description.root,
            "tip": description.tip,
            "links": [
                {"name": k.name, "geometry": self._geometry(k.shape)} for k in description.links
            ],
            "joints": [
                {
                    "name": j.name,
                    "kind": j.kind.value,
                    "parent": j.parent,
                    "child": j.child,
                    "parent_T_joint": pose_json(j.parent_T_joint),
                    "axis": list(j.axis),
                    "lower_rad": j.lower_rad,
                    "upper_rad": j.upper_rad,
                    "velocity_rad_s": j.velocity_rad_s,
                }
                for j in description.joints
            ],
        }

    # ---- bodies ------------------------------------------------------------------------------

    def _body(self, name: str, shape: Shape, world_T_body: Pose) -> dict[str, Json]:
        return {
            "id": name,
            "name": self.source.labels.name(name),
            "geometry": self._geometry(shape),
            "world_T": pose_json(world_T_body),
        }

    def _geometry(self, shape: Shape) -> str | None:
        if not shape:
            return None
        if shape not in self._gid_by_shape:
            corners, triangles = self.source.triangles(shape)
            content: Json = {
                "corners_m": [[round(v, 6) for v in corner] for corner in corners],
                "triangles": [list(t) for t in triangles],
            }
            gid = sha256_hex(canonical_json(content))[:16]
            self._gid_by_shape[shape], self._geometries[gid] = gid, content
        return self._gid_by_shape[shape]

    def _component(self, component: Component) -> Json:
        node = self.source.graph.node_by_id.get(component.id)
        geometry, note = self._shape(component)
        pose = self._pose(component, node)
        operations = component.operations
        return {
            "id": component.id,
            "name": self.source.labels.name(component.id),
            "layer": (component.layer if node is None else node.layer).value,
            "status": self._status(component, node),
            "type": component.type,
            "material": component.material,
            "group": component.group,
            "order": component.order,
            "geometry": geometry,
            "world_T": None if pose is None else pose_json(pose),
            "accessible": self._is_accessible(node),
            "parents": list(
                component.construction_parents if node is None else node.construction_parents
            ),
            "waits_for": self._waits_for(node),
            "stack": node.place or None if isinstance(node, MaterialNode) else None,
            "made_of": self._made_of(component),
            "operations": [
                {
                    "id": o.id,
                    "name": self.source.labels.name(o.id),
                    "process": o.process.value,
                    "done": o.id in self.source.site.done_operations,
                }
                for o in operations
            ],
            "deviation": self._deviation(component.id),
            "note": note or self._note(component.id),
        }

    def _shape(self, component: Component) -> tuple[str | None, str]:
        try:
            return self._geometry(shape_of(component)), ""
        except (UnsupportedGeometryError, ValueError) as error:
            return None, f"It is not drawn: {error}"

    def _pose(self, component: Component, node: Node | None) -> Pose | None:
        seen = self.source.observation.world_T_piece.get(component.id)
        if seen is not None:
            return seen
        if node is not None:
            return node.world_T_component
        if component.layer is Layer.MATERIAL:
            return None
        return self.source.cell.world_T_model @ component.world_T_component

    def _status(self, component: Component, node: Node | None) -> str:
        if component.layer is Layer.MATERIAL:
            return self._stock_status(component.id, node)
        if component.layer is not Layer.TARGET:
            return "installed" if component.layer is Layer.AS_BUILT else "drawn"
        return self._target_status(component.id, node)

    def _stock_status(self, piece: ComponentId, node: Node | None) -> str:
        site = self.source.site
        if piece in site.consumed:
            return "used"
        if any(r.gripped == piece for r in self.source.observation.robots.values()):
            return "held"
        is_at_place = isinstance(node, MaterialNode) and bool(node.place)
        return "stock" if is_at_place else "stray"

    def _target_status(self, target: ComponentId, node: Node | None) -> str:
        site = self.source.site
        for status, targets in (
            ("needs-rework", site.needs_rework),
            ("installed", site.installed),
            ("refused", site.refused),
            ("standing", site.standing),
            ("in-place", site.placed),
        ):
            if target in targets:
                return status
        if target == self.source.active:
            return "active"
        is_ready = isinstance(node, TargetNode) and not missing_before(self.source.graph, node)
        return "ready" if is_ready else "waiting"

    def _is_accessible(self, node: Node | None) -> bool:
        if not isinstance(node, MaterialNode) or not node.place:
            return False
        return node.id in self._free

    def _waits_for(self, node: Node | None) -> list[Json]:
        if not isinstance(node, TargetNode):
            return []
        return list(missing_before(self.source.graph, node))

    def _made_of(self, component: Component) -> str | None:
        placed = self.source.site.placed.get(component.id)
        return None if placed is None else placed.piece

    def _deviation(self, target: ComponentId) -> Json:
        placed = self.source.site.placed.get(target)
        if placed is None:
            return None
        off_mm = placed.world_T_wanted.distance_to_m(placed.world_T_measured) * 1000.0
        off_deg = math.degrees(placed.world_T_wanted.angle_to_rad(placed.world_T_measured))
        return {
            "mm": round(off_mm, 2),
            "deg": round(off_deg, 3),
            "words": f"{off_mm:.1f} mm and {off_deg:.2f} degrees off",
        }

    def _note(self, target: ComponentId) -> str:
        site: Mapping[ComponentId, str] = {
            **self.source.site.refused,
            **self.source.site.needs_rework,
        }
        return site.get(target, "")
