"""IFC files for tests, made with ifcopenshell as an authoring program would write them."""

from __future__ import annotations

import itertools
import math
import uuid
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import pytest

ifcopenshell = pytest.importorskip("ifcopenshell", reason="needs the extra 'ifc'")

from ifcopenshell import guid  # noqa: E402

STUD_MM = (45.0, 95.0)
Point = Sequence[float]


class IfcDraft:
    """An IFC file under construction, in millimetres unless told otherwise.

    With a seed its GlobalIds are the same each time.
    """

    def __init__(
        self, schema: str = "IFC4", *, prefix: str | None = "MILLI", seed: str = ""
    ) -> None:
        self._seed, self._count = seed, itertools.count()
        self.file: Any = ifcopenshell.file(schema=schema)
        new = self.file.create_entity
        self.context = new(
            "IfcGeometricRepresentationContext",
            ContextType="Model",
            CoordinateSpaceDimension=3,
            Precision=1e-5,
            WorldCoordinateSystem=self.axes(),
        )
        self.body = new(
            "IfcGeometricRepresentationSubContext",
            ContextIdentifier="Body",
            ContextType="Model",
            ParentContext=self.context,
            TargetView="MODEL_VIEW",
        )
        units = None
        if prefix != "none":
            length = new("IfcSIUnit", UnitType="LENGTHUNIT", Prefix=prefix, Name="METRE")
            units = new("IfcUnitAssignment", Units=[length])
        self.project = self.rooted(
            "IfcProject", Name="panel", RepresentationContexts=[self.context], UnitsInContext=units
        )

    def rooted(self, kind: str, **values: Any) -> Any:
        if self.file.schema == "IFC2X3" and "OwnerHistory" not in values:
            values["OwnerHistory"] = self._history()
        name = f"{self._seed} {next(self._count)}"
        own = guid.compress(uuid.uuid5(uuid.NAMESPACE_OID, name).hex) if self._seed else guid.new()
        return self.file.create_entity(kind, GlobalId=own, **values)

    def point(self, *values: float) -> Any:
        return self.file.create_entity("IfcCartesianPoint", Coordinates=[float(v) for v in values])

    def direction(self, *values: float) -> Any:
        return self.file.create_entity("IfcDirection", DirectionRatios=[float(v) for v in values])

    def axes(self, at: Point = (0, 0, 0), z: Point | None = None, x: Point | None = None) -> Any:
        return self.file.create_entity(
            "IfcAxis2Placement3D",
            self.point(*at),
            self.direction(*z) if z else None,
            self.direction(*x) if x else None,
        )

    def placed(
        self,
        at: Point = (0, 0, 0),
        z: Point | None = None,
        x: Point | None = None,
        *,
        within: Any = None,
    ) -> Any:
        return self.file.create_entity("IfcLocalPlacement", within, self.axes(at, z, x))

    def rectangle(self, sides: Point = STUD_MM) -> Any:
        return self.file.create_entity(
            "IfcRectangleProfileDef", "AREA", None, None, float(sides[0]), float(sides[1])
        )

    def outline(self, corners: Sequence[Point]) -> Any:
        line = self.file.create_entity(
            "IfcPolyline", Points=[self.point(*c) for c in (*corners, corners[0])]
        )
        return self.file.create_entity("IfcArbitraryClosedProfileDef", "AREA", None, line)

    def extruded(self, profile: Any, depth: float, *, position: Any = None) -> Any:
        position = position or self.axes()
        up = self.direction(0, 0, 1)
        return self.file.create_entity("IfcExtrudedAreaSolid", profile, position, up, float(depth))

    def clipped(self, solid: Any, at: Point, normal: Point, *, agreement: bool = False) -> Any:
        plane = self.file.create_entity("IfcPlane", self.axes(at, normal))
        half = self.file.create_entity("IfcHalfSpaceSolid", plane, agreement)
        return self.file.create_entity("IfcBooleanClippingResult", "DIFFERENCE", solid, half)

    def clipped_within(self, solid: Any, at: Point, normal: Point, corners: Sequence[Point]) -> Any:
        """Clip only inside a prism over corners in the x-y plane of the item."""
        plane = self.file.create_entity("IfcPlane", self.axes(at, normal))
        line = self.file.create_entity(
            "IfcPolyline", Points=[self.point(*c) for c in (*corners, corners[0])]
        )
        half = self.file.create_entity(
            "IfcPolygonalBoundedHalfSpace",
            BaseSurface=plane,
            AgreementFlag=False,
            Position=self.axes(),
            PolygonalBoundary=line,
        )
        return self.file.create_entity("IfcBooleanClippingResult", "DIFFERENCE", solid, half)

    def shape(self, *items: Any) -> Any:
        body = self.file.create_entity(
            "IfcShapeRepresentation", self.body, "Body", "SolidModel", list(items)
        )
        return self.file.create_entity("IfcProductDefinitionShape", None, None, [body])

    def element(
        self, kind: str, name: str, placement: Any, shape: Any | None, **values: Any
    ) -> Any:
        return self.rooted(
            kind, Name=name, ObjectPlacement=placement, Representation=shape, **values
        )

    def member(
        self,
        name: str,
        start: Point,
        along: Point,
        length: float,
        *,
        sides: Point = STUD_MM,
        within: Any = None,
        **values: Any,
    ) -> Any:
        """Add a member; the first of its sides is upright, or along x if it stands."""
        x = (1, 0, 0) if along[2] else (0, 0, 1)
        placement = self.placed(start, along, x, within=within)
        shape = self.shape(self.extruded(self.rectangle(sides), length))
        return self.element("IfcMember", name, placement, shape, **values)

    def whole(self, kind: str, name: str, parts: Sequence[Any], **values: Any) -> Any:
        whole = self.element(kind, name, self.placed(), values.pop("shape", None), **values)
        self.rooted("IfcRelAggregates", RelatingObject=whole, RelatedObjects=list(parts))
        return whole

    def properties(self, element: Any, name: str, values: Mapping[str, object]) -> Any:
        new = self.file.create_entity
        kinds = {str: "IfcLabel", int: "IfcInteger", float: "IfcReal", bool: "IfcBoolean"}
        single = [
            new("IfcPropertySingleValue", key, None, new(kinds[type(v)], v), None)
            for key, v in values.items()
        ]
        own = self.rooted("IfcPropertySet", Name=name, HasProperties=single)
        return self.rooted(
            "IfcRelDefinesByProperties",
            RelatedObjects=[element],
            RelatingPropertyDefinition=own,
        )

    def material(self, name: str, elements: Sequence[Any]) -> None:
        material = self.file.create_entity("IfcMaterial", Name=name)
        self.rooted(
            "IfcRelAssociatesMaterial", RelatedObjects=list(elements), RelatingMaterial=material
        )

    def task(self, name: str, builds: Sequence[Any] = (), **values: Any) -> Any:
        task = self.rooted("IfcTask", Name=name, IsMilestone=False, **values)
        for element in builds:
            self.rooted("IfcRelAssignsToProduct", RelatedObjects=[task], RelatingProduct=element)
        return task

    def sequence(self, *tasks: Any) -> None:
        for before, after in itertools.pairwise(tasks):
            self.rooted(
                "IfcRelSequence",
                RelatingProcess=before,
                RelatedProcess=after,
                SequenceType="FINISH_START",
            )

    def write(self, path: Path) -> Path:
        self.file.write(str(path))
        return path

    def _history(self) -> Any:
        if found := self.file.by_type("IfcOwnerHistory"):
            return found[0]
        new = self.file.create_entity
        person = new(
            "IfcPersonAndOrganization", new("IfcPerson"), new("IfcOrganization", None, "x")
        )
        program = new("IfcApplication", person.TheOrganization, "1", "x", "x")
        return new("IfcOwnerHistory", person, program, None, "ADDED", None, None, None, 0)


def wall_panel(schema: str = "IFC4", *, at: Point = (0, 0, 0), stud_mm: float = 2400.0) -> IfcDraft:
    """Return a standing panel: bottom plate, three studs, top plate, grouped, with tasks.

    The plates lie along x, 1.29 m long; studs are 622.5 mm apart; all are 45 x 95.

    Args:
        schema: IFC schema.
        at: Left end of the bottom plate's lower side, in the middle of its width.
        stud_mm: Length of the studs.
    """
    draft = IfcDraft(schema)
    plate, stud = (
        dict[str, Any]() if schema == "IFC2X3" else {"PredefinedType": kind}
        for kind in ("PLATE", "STUD")
    )
    x, y, z = at
    bottom = draft.member("bottom", (x, y, z + 22.5), (1, 0, 0), 1290.0, **plate)
    studs = [
        draft.member("stud", (x + 22.5 + 622.5 * n, y, z + 45), (0, 0, 1), stud_mm, **stud)
        for n in range(3)
    ]
    top = draft.member("top", (x, y, z + 67.5 + stud_mm), (1, 0, 0), 1290.0, **plate)
    draft.whole("IfcElementAssembly", "panel A", [bottom, *studs, top])
    draft.material("C24", [bottom, *studs, top])
    tasks = [draft.task("plate", [bottom]), draft.task("studs", studs), draft.task("cap", [top])]
    draft.sequence(*tasks)
    return draft


def framed_walls() -> IfcDraft:
    """Return two walls of a storey as a BIM user exports them, framed, in millimetres.

    W-01 is 1.29 m wide and 2.49 m high: bottom plate, three studs, top plate; it stands at an
    angle of 30 degrees. W-02 is the same and stands across its end. The members are placed in
    their walls, the walls in the storey; there are no tasks.
    """
    draft = IfcDraft(seed="framed walls")
    place = draft.placed((5000, 3000, 250))
    storey = draft.rooted("IfcBuildingStorey", Name="Ground floor", ObjectPlacement=place)
    draft.rooted("IfcRelAggregates", RelatingObject=draft.project, RelatedObjects=[storey])
    root = math.sqrt(3.0)
    along = draft.placed((0, 0, 0), (0, 0, 1), (root, 1, 0), within=place)
    across = draft.placed((1300, 750, 0), (0, 0, 1), (-1, root, 0), within=place)
    walls = [_framed_wall(draft, "W-01", along), _framed_wall(draft, "W-02", across)]
    draft.rooted(
        "IfcRelContainedInSpatialStructure", RelatedElements=walls, RelatingStructure=storey
    )
    return draft


def _framed_wall(draft: IfcDraft, name: str, place: Any) -> Any:
    plate: dict[str, Any] = {"PredefinedType": "PLATE", "within": place}
    stud: dict[str, Any] = {"PredefinedType": "STUD", "within": place}
    members = [
        draft.member("bottom plate", (0, 0, 22.5), (1, 0, 0), 1290, **plate),
        *(
            draft.member(f"stud {n + 1}", (22.5 + 622.5 * n, 0, 45), (0, 0, 1), 2400, **stud)
            for n in range(3)
        ),
        draft.member("top plate", (0, 0, 2467.5), (1, 0, 0), 1290, **plate),
    ]
    wall = draft.element("IfcWall", name, place, None, PredefinedType="ELEMENTEDWALL")
    draft.rooted("IfcRelAggregates", RelatingObject=wall, RelatedObjects=members)
    draft.material("C24", members)
    return wall


def lying_frame() -> IfcDraft:
    """Return two supports with three studs across, flat on a table, and the stock for them.

    The pieces of stock are on layer Material and say on which pile they lie, as a user writes
    it into property sets; the tasks put the supports before the studs.
    """
    draft = IfcDraft(seed="lying frame")
    thick: dict[str, Any] = {
        "sides": (140, 90),
        "PredefinedType": "USERDEFINED",
        "ObjectType": "Supporting Stud",
    }
    thin: dict[str, Any] = {"sides": (40, 90), "PredefinedType": "STUD"}
    supports = [
        draft.member(f"support {n}", (x, -1200, 70), (0, 1, 0), 2400, **thick)
        for n, x in enumerate((-600, 600), 1)
    ]
    studs = [
        draft.member(f"stud {n}", (-900, y, 160), (1, 0, 0), 1800, **thin)
        for n, y in enumerate((-800, 0, 800), 1)
    ]
    draft.sequence(draft.task("supports", supports), draft.task("studs", studs))
    stock = [
        *_pile(draft, "pallet-thick", (-2800, 1550, 0), 2400, 2, thick),
        *_pile(draft, "pallet-thin", (-2500, -1550, 0), 1800, 3, thin),
    ]
    draft.whole("IfcElementAssembly", "frame", [*supports, *studs])
    draft.material("C24", [*supports, *studs, *stock])
    return draft


def _pile(
    draft: IfcDraft, name: str, at: Point, length: float, count: int, kind: Mapping[str, Any]
) -> list[Any]:
    height, pieces = kind["sides"][0], []
    for n in range(count):
        start = (at[0], at[1], at[2] + height * (n + 0.5))
        piece = draft.member(f"{name} {n}", start, (1, 0, 0), length, **kind)
        draft.properties(piece, "Sitewright", {"Layer": "Material", "Stack": name, "StackIndex": n})
        pieces.append(piece)
    return pieces
