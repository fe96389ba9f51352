"""Rhino files as a designer draws them, made with rhino3dm; lengths in millimetres."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from sitewright.building_model.component import Component, Layer
from sitewright.building_model.model import BuildingModel
from sitewright.building_model.shapes import size_of

MM = 1000.0
Point = tuple[float, float, float]


class Drawing:
    """A .3dm file to be; `add` gives back the new object's id."""

    def __init__(self, unit: str = "Millimeters") -> None:
        import rhino3dm

        self.model = rhino3dm.File3dm()
        self.model.Settings.ModelUnitSystem = getattr(rhino3dm.UnitSystem, unit)
        self.model.Settings.ModelAbsoluteTolerance = 0.001

    def layer(self, path: str) -> int:
        """Return the index of a layer; it is made with its parents if it is new."""
        import rhino3dm

        parent, walked = None, ""
        for name in path.split("::"):
            walked = f"{walked}::{name}" if walked else name
            found = next((e for e in self.model.Layers if e.FullPath == walked), None)
            if found is None:
                layer = rhino3dm.Layer()
                layer.Name = name
                if parent is not None:
                    layer.ParentLayerId = parent.Id
                found = self.model.Layers.FindIndex(self.model.Layers.Add(layer))
            parent = found
        assert parent is not None
        return int(parent.Index)

    def add(
        self,
        geometry: Any,
        *,
        name: str = "",
        layer: str = "Target",
        text: Mapping[str, str] | None = None,
        group: str = "",
    ) -> str:
        import rhino3dm

        attributes = rhino3dm.ObjectAttributes()
        attributes.Name = name
        attributes.LayerIndex = self.layer(layer)
        for key, value in (text or {}).items():
            attributes.SetUserString(key, value)
        if group:
            attributes.AddToGroup(self._group(group))
        if isinstance(geometry, rhino3dm.InstanceReference):
            return str(self.model.Objects.AddInstanceObject(geometry, attributes))
        return str(self.model.Objects.Add(geometry, attributes))

    def block(self, name: str, *geometries: Any) -> str:
        """Return the id of a new block definition."""
        import rhino3dm

        attributes = tuple(rhino3dm.ObjectAttributes() for _ in geometries)
        origin = rhino3dm.Point3d(0, 0, 0)
        index = self.model.InstanceDefinitions.Add(
            name, "", "", "", origin, tuple(geometries), attributes
        )
        return str(self.model.InstanceDefinitions.FindIndex(index).Id)

    def write(self, path: Path) -> Path:
        assert self.model.Write(str(path), 8)
        return path

    def _group(self, name: str) -> int:
        import rhino3dm

        found = next((g for g in self.model.Groups if g.Name == name), None)
        if found is None:
            group = rhino3dm.Group()
            group.Name = name
            self.model.Groups.Add(group)
            found = self.model.Groups[len(self.model.Groups) - 1]
        return int(found.Index)


def outline(points: Sequence[Point]) -> Any:
    """Return a closed polygon as Rhino keeps it."""
    import rhino3dm

    line = rhino3dm.Polyline(len(points) + 1)
    for point in (*points, points[0]):
        line.Add(*point)
    return rhino3dm.PolylineCurve(line)


def extrusion(points: Sequence[Point], depth: float, *, is_capped: bool = True) -> Any:
    """Return a polygon pulled along its normal."""
    import rhino3dm

    return rhino3dm.Extrusion.Create(outline(points), depth, is_capped)


def brep_box(low: Point, high: Point) -> Any:
    import rhino3dm

    return rhino3dm.Brep.CreateFromBox(rhino3dm.Box(rhino3dm.BoundingBox(*low, *high)))


def moved(x: float, y: float, z: float) -> Any:
    import rhino3dm

    return rhino3dm.Transform.Translation(x, y, z)


def instance(block: str, xform: Any) -> Any:
    import rhino3dm

    return rhino3dm.InstanceReference(block, xform)


def draw_frame(model: BuildingModel, path: Path) -> dict[str, str]:
    """Draw a frame of upright boxes as a user does; return object ids by component id.

    Objects are named as the components; layers by role and type, references by name, no ids of
    ours. Supports are extrusions, studs are breps, the last target is a block; the stock lies
    beside the frame.
    """
    drawing = Drawing()
    targets = [c for c in model.component_by_id.values() if c.layer is Layer.TARGET]
    ids = {str(c.id): _draw_target(drawing, c, is_block=c is targets[-1]) for c in targets}
    for row, stack in enumerate(model.stacks):
        for index, item in enumerate(stack.items):
            piece = model.component_by_id[item]
            length, width, height = (s * MM for s in size_of(piece))
            y, z = 3000.0 + 500.0 * row, piece.world_T_component.position_m[2] * MM - height / 2
            drawing.add(
                brep_box((0, y, z), (length, y + width, z + height)),
                layer=f"Material::{piece.type}",
                text={
                    "sitewright.material": piece.material,
                    "sitewright.stack": stack.place,
                    "sitewright.stack_index": str(index),
                },
            )
    drawing.add(outline([(0, 0, 0), (500, 0, 0), (500, 500, 0)]), layer="Dimensions")
    drawing.write(path)
    return ids


def _draw_target(drawing: Drawing, target: Component, *, is_block: bool) -> str:
    low, high = _corners(target)
    if target.ground:
        rectangle = [(low[0], low[1]), (high[0], low[1]), (high[0], high[1]), (low[0], high[1])]
        shape = extrusion([(x, y, low[2]) for x, y in rectangle], high[2] - low[2])
    elif is_block:
        size = (high[0] - low[0], high[1] - low[1], high[2] - low[2])
        shape = instance(drawing.block("Stud block", brep_box((0, 0, 0), size)), moved(*low))
    else:
        shape = brep_box(low, high)
    parents = list(target.construction_parents)
    text = {
        "construction_order": str(target.order),  # the office's own key, mapped by import.toml
        "sitewright.material": target.material,
        "sitewright.parent": "; ".join(parents),
        "sitewright.ground": "yes" if target.ground else "",
        "sitewright.ops": json.dumps(_operations(target)) if target.operations else "",
        "Fire class": "R30",
        "Volume": '%<Volume("x","False")>%',
    }
    return drawing.add(
        shape,
        name=target.id,
        layer=f"Frame::Target::{target.type}",
        text={key: value for key, value in text.items() if value},
        group="Panel 1",
    )


def _corners(target: Component) -> tuple[Point, Point]:
    x, y, z = (s / 2.0 for s in size_of(target))
    pose = target.world_T_component
    ends = [pose.apply((-x, -y, -z)), pose.apply((x, y, z))]
    rows = [sorted((a * MM, b * MM)) for a, b in zip(*ends, strict=True)]
    low, high = zip(*rows, strict=True)
    return (low[0], low[1], low[2]), (high[0], high[1], high[2])


def _operations(target: Component) -> list[dict[str, Any]]:
    found = []
    for operation in target.operations:
        world_T_operation = target.world_T_component @ operation.component_T_operation
        assert operation.fastener is not None
        found.append(
            {
                "process": operation.process.value,
                "on": list(operation.on),
                "at": [v * MM for v in world_T_operation.position_m],
                "direction": list(world_T_operation.z_axis),
                "fastener": {
                    "type": operation.fastener.type,
                    "d_m": operation.fastener.d_m,
                    "l_m": operation.fastener.l_m,
                },
            }
        )
    return found
