"""From the solids of a foreign file to the geometry and frame of one component."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from sitewright.building_model.component import (
    BoxGeometry,
    CompoundGeometry,
    ConvexGeometry,
    ExtrusionGeometry,
    Geometry,
)
from sitewright.building_model.formats.body_split import Body, bodies_of
from sitewright.building_model.formats.box_fit import (
    Facing,
    FittedBox,
    facings_of,
    fit_box,
    is_box,
    is_convex,
    oriented,
)
from sitewright.building_model.formats.hull_points import hull_of
from sitewright.building_model.formats.neutral import (
    BoxSolid,
    ExtrusionSolid,
    FacesSolid,
    NeutralSolid,
)
from sitewright.foundation.pose import Pose, Vector, cross, norm, scale, subtract

SimpleGeometry = BoxGeometry | ExtrusionGeometry | ConvexGeometry
Point2 = tuple[float, float]

_RECTANGLE = 4
_RIGHT_ANGLE = 1e-6
_NEAR_M = 1e-3


@dataclass(frozen=True, slots=True, kw_only=True)
class Note:
    """Something to be told of a component's shape."""

    code: str
    message: str
    fix: str
    is_error: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class Piece:
    """One body in the model frame, in metres.

    Attributes:
        box: Its own frame, if it is a box; its axes are kept if `has_grain`.
        geometry: Its shape in `world_T_geometry`.
        notes: What was lost or guessed.
    """

    points_m: tuple[Vector, ...]
    facings: tuple[Facing, ...]
    geometry: SimpleGeometry
    world_T_geometry: Pose
    box: FittedBox | None = None
    has_grain: bool = False
    notes: tuple[Note, ...] = ()


def pieces_of(
    solid: NeutralSolid, metres: float, shift_m: Vector, *, repairs_hull: bool
) -> list[Piece]:
    """Return the separate bodies of a solid in the model frame.

    Args:
        solid: What the reader found, in the file's unit.
        metres: Metres per unit.
        shift_m: Taken off all coordinates.
        repairs_hull: Close open surfaces by their convex hull.
    """
    match solid:
        case BoxSolid():
            size = scale(solid.size, metres)
            pose = _placed(solid.file_T_box, metres, shift_m)
            return [_box_piece(pose, size, has_grain=solid.has_grain)]
        case ExtrusionSolid():
            return [_extruded(solid, metres, shift_m)]
        case FacesSolid():
            points = [subtract(scale(p, metres), shift_m) for p in solid.vertices]
            return [
                _surface(body, repairs_hull=repairs_hull) for body in bodies_of(points, solid.faces)
            ]


def shaped(pieces: Sequence[Piece]) -> tuple[Geometry, Pose] | None:
    """Return the geometry of a component and its frame in the model; None if it is flat."""
    first = pieces[0]
    if len(pieces) == 1 and first.box is not None:
        return BoxGeometry(first.box.size_m), first.box.world_T_box
    box = _common_box(pieces)
    if box is None or min(box.size_m) <= 0.0:
        return None
    back = box.world_T_box.inverse()
    parts = tuple(_in_frame(piece, back) for piece in pieces)
    _, geometry = parts[0]
    if len(parts) == 1 and isinstance(geometry, ConvexGeometry):
        return geometry, box.world_T_box
    return CompoundGeometry(parts), box.world_T_box


def clusters_of(pieces: Sequence[Piece]) -> int:
    """Return how many groups of pieces lie apart, judged by their boxes along the axes."""
    extents = [_extent(p) for p in pieces]
    group = list(range(len(pieces)))
    for i, a in enumerate(extents):
        for j in range(i):
            if group[i] != group[j] and _meet(a, extents[j]):
                old, new = group[i], group[j]
                group = [new if g == old else g for g in group]
    return len(set(group))


def _common_box(pieces: Sequence[Piece]) -> FittedBox | None:
    points = [p for piece in pieces for p in piece.points_m]
    ranked = sorted(
        (f for piece in pieces for f in piece.facings), key=lambda f: (-f.area_m2, f.direction)
    )
    return fit_box(points, _distinct(ranked))


def _distinct(facings: Sequence[Facing]) -> list[Facing]:
    kept: list[Facing] = []
    for facing in facings:
        if all(norm(cross(facing.direction, k.direction)) > _RIGHT_ANGLE for k in kept):
            kept.append(facing)
    return kept[:12]


def _in_frame(piece: Piece, box_T_world: Pose) -> tuple[Pose, SimpleGeometry]:
    if isinstance(piece.geometry, ConvexGeometry):
        here = tuple(box_T_world.apply(p) for p in piece.geometry.points_m)
        return Pose(), ConvexGeometry(here)
    return box_T_world @ piece.world_T_geometry, piece.geometry


def _box_piece(pose: Pose, size_m: Vector, *, has_grain: bool) -> Piece:
    axes = (pose.x_axis, pose.y_axis, pose.z_axis)
    box = FittedBox(pose, size_m) if has_grain else oriented(pose.position_m, axes, size_m)
    areas = (size_m[1] * size_m[2], size_m[0] * size_m[2], size_m[0] * size_m[1])
    half = scale(box.size_m, 0.5)
    corners = tuple(
        box.world_T_box.apply((x * half[0], y * half[1], z * half[2]))
        for x in (-1.0, 1.0)
        for y in (-1.0, 1.0)
        for z in (-1.0, 1.0)
    )
    return Piece(
        points_m=corners,
        facings=tuple(Facing(a, s) for a, s in zip(axes, areas, strict=True)),
        geometry=BoxGeometry(box.size_m),
        world_T_geometry=box.world_T_box,
        box=box,
        has_grain=has_grain,
    )


def _extruded(solid: ExtrusionSolid, metres: float, shift_m: Vector) -> Piece:
    pose = _placed(solid.file_T_profile, metres, shift_m)
    profile = tuple((x * metres, y * metres) for x, y in solid.profile)
    if len(profile) > 1 and profile[0] == profile[-1]:
        profile = profile[:-1]
    depth = solid.depth * metres
    if depth < 0.0:
        pose, depth = pose @ Pose((0.0, 0.0, depth)), -depth
    if not solid.holes and (rectangle := _rectangle(profile)) is not None:
        middle, x_axis, width, height = rectangle
        profile_T_box = Pose.from_axes(
            (*middle, depth / 2.0), (*x_axis, 0.0), (-x_axis[1], x_axis[0], 0.0)
        )
        return _box_piece(pose @ profile_T_box, (width, height, depth), has_grain=False)
    ends = tuple(pose.apply((x, y, z)) for z in (0.0, depth) for x, y in profile)
    return Piece(
        points_m=ends,
        facings=_prism_facings(pose, profile, depth),
        geometry=ExtrusionGeometry(profile, depth),
        world_T_geometry=pose,
        notes=_filled(len(solid.holes)),
    )


def _prism_facings(pose: Pose, profile: Sequence[Point2], depth_m: float) -> tuple[Facing, ...]:
    sides = []
    for (x, y), (u, v) in zip(profile, (*profile[1:], *profile[:1]), strict=True):
        length = ((u - x) ** 2 + (v - y) ** 2) ** 0.5
        if length > 0.0:
            normal = pose.turn(((v - y) / length, (x - u) / length, 0.0))
            sides.append(Facing(normal, length * depth_m))
    longest = sorted(sides, key=lambda f: (-f.area_m2, f.direction))
    return (Facing(pose.z_axis, 0.0), *_distinct(longest)[:11])


def _rectangle(profile: Sequence[Point2]) -> tuple[Point2, Point2, float, float] | None:
    """Return middle, x direction, width and height of a profile that is a rectangle."""
    if len(profile) != _RECTANGLE:
        return None
    (ax, ay), (bx, by), (cx, cy), (dx, dy) = profile
    width = ((bx - ax) ** 2 + (by - ay) ** 2) ** 0.5
    height = ((dx - ax) ** 2 + (dy - ay) ** 2) ** 0.5
    if min(width, height) <= 0.0:
        return None
    skew = abs((bx - ax) * (dx - ax) + (by - ay) * (dy - ay)) / (width * height)
    off = abs(ax + cx - bx - dx) + abs(ay + cy - by - dy)
    if skew > _RIGHT_ANGLE or off > _RIGHT_ANGLE * (width + height):
        return None
    middle = ((ax + cx) / 2.0, (ay + cy) / 2.0)
    return middle, ((bx - ax) / width, (by - ay) / width), width, height


def _filled(holes_total: int) -> tuple[Note, ...]:
    if not holes_total:
        return ()
    message = f"{holes_total} openings in its profile are filled."
    return (Note(code="G7", message=message, fix="Model it as pieces around the openings."),)


def _surface(body: Body, *, repairs_hull: bool) -> Piece:
    notes: list[Note] = []
    if body.open_edges:
        message = f"Its mesh is open ({body.open_edges} boundary edges)."
        notes.append(
            Note(code="G2", message=message, fix="--repair hull", is_error=not repairs_hull)
        )
    facings = tuple(facings_of(body))
    box = fit_box(body.points_m, facings)
    if box is not None and min(box.size_m) > 0.0 and is_box(body, box):
        return Piece(
            points_m=body.points_m,
            facings=facings,
            geometry=BoxGeometry(box.size_m),
            world_T_geometry=box.world_T_box,
            box=box,
            notes=tuple(notes),
        )
    if not is_convex(body):
        message = "It is not convex; its convex hull is taken."
        fix = "Model notches as cuts, or expect it to overlap its neighbours."
        notes.append(Note(code="G7", message=message, fix=fix))
    points, growth_m = hull_of(body.points_m)
    if growth_m > 0.0:
        message = f"It has many corners; a hull with fewer reaches up to {growth_m * 1e3:.1f} mm"
        notes.append(Note(code="G7", message=f"{message} less far.", fix="Simplify the mesh."))
    return Piece(
        points_m=points,
        facings=facings,
        geometry=ConvexGeometry(points),
        world_T_geometry=Pose(),
        notes=tuple(notes),
    )


def _placed(pose: Pose, metres: float, shift_m: Vector) -> Pose:
    return Pose(subtract(scale(pose.position_m, metres), shift_m), pose.quaternion_wxyz)


def _extent(piece: Piece) -> tuple[Vector, Vector]:
    xs, ys, zs = zip(*piece.points_m, strict=True)
    return (min(xs), min(ys), min(zs)), (max(xs), max(ys), max(zs))


def _meet(a: tuple[Vector, Vector], b: tuple[Vector, Vector]) -> bool:
    return all(a[0][k] <= b[1][k] + _NEAR_M and b[0][k] <= a[1][k] + _NEAR_M for k in range(3))
