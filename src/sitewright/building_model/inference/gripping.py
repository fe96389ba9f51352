"""Where a parallel gripper can hold a component: opposite side faces within its opening."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import product

from sitewright.building_model.component import Component
from sitewright.building_model.shapes import size_of
from sitewright.foundation.pose import Pose, Vector, cross, distance, dot

LONG_M = 2.5
"""From this length on two robots may carry: grasps at a fifth from each end are added."""
GRASPS_MAX = 6
_STEP_M = 0.2
_END_M = 0.05
_COVERED = 0.9
_NEAR_M = 0.10
_SIDES: tuple[tuple[Vector, int], ...] = (
    ((0.0, 0.0, -1.0), 1),
    ((0.0, 0.0, 1.0), 1),
    ((0.0, -1.0, 0.0), 2),
    ((0.0, 1.0, 0.0), 2),
)
"""Approach direction in the component frame, and the axis that the fingers close along."""


def grasps_of(
    component: Component,
    grips_m: Sequence[tuple[float, float]],
    covered: Iterable[Vector] = (),
) -> tuple[Pose, ...]:
    """Return grasp frames in the component frame, the best first; none if no gripper fits.

    z is the approach direction, y the closing axis; the origin lies on the middle line.

    Args:
        component: A piece whose x axis is its length.
        grips_m: Narrowest and widest grip of each gripper of the cell.
        covered: Outward normals (component frame) of faces in contact once it is placed: the
            gripper neither comes from there nor puts a finger there.
    """
    size, hidden = size_of(component), list(covered)
    centre_m = component.com_m[0] if component.com_m is not None else 0.0
    places = _places(size[0], centre_m)
    fasteners = [o.component_T_operation.position_m for o in component.operations]
    found: list[tuple[tuple[float, float, int], Pose]] = []
    for (approach, closing), x in product(_SIDES, places):
        if not any(low <= size[closing] <= high for low, high in grips_m):
            continue
        finger: Vector = (0.0, float(closing == 1), float(closing == 2))  # noqa: PLR2004
        if _is_hidden(approach, finger, hidden):
            continue
        pose = Pose.from_axes((x, 0.0, 0.0), cross(finger, approach), finger)
        clear_m = min((distance(pose.position_m, f) for f in fasteners), default=_NEAR_M)
        rank = (max(0.0, _NEAR_M - clear_m), abs(x - centre_m), len(found))
        found.append((rank, pose))
    return tuple(pose for _, pose in sorted(found, key=lambda f: f[0])[:GRASPS_MAX])


def _places(length_m: float, centre_m: float) -> list[float]:
    """Return where along the piece: its centre of mass, beside it, and for two robots."""
    half = length_m / 2.0 - _END_M
    offsets = [centre_m, centre_m + _STEP_M, centre_m - _STEP_M]
    if length_m >= LONG_M:
        offsets += [-0.3 * length_m, 0.3 * length_m]
    return [x for x in offsets if abs(x) <= max(half, 0.0)] or [0.0]


def _is_hidden(approach: Vector, finger: Vector, covered: Iterable[Vector]) -> bool:
    """Whether a face in contact is where the gripper comes from, or where a finger lies."""
    return any(dot(n, approach) < -_COVERED or abs(dot(n, finger)) > _COVERED for n in covered)
