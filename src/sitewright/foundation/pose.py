"""Rigid transforms in plain Python: no numpy, so that the pure parts stay light."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TypeAlias

Vector = tuple[float, float, float]
Quaternion = tuple[float, float, float, float]
Matrix3 = tuple[Vector, Vector, Vector]
Matrix4: TypeAlias = tuple[tuple[float, ...], ...]

_UNIT_TOLERANCE = 1e-6
_ROTATION_TOLERANCE = 4e-6
_PARALLEL = 1e-6
_STEEP = 0.9


def add(a: Vector, b: Vector) -> Vector:
    """Return a + b."""
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def subtract(a: Vector, b: Vector) -> Vector:
    """Return a - b."""
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def scale(a: Vector, factor: float) -> Vector:
    """Return factor * a."""
    return (factor * a[0], factor * a[1], factor * a[2])


def dot(a: Vector, b: Vector) -> float:
    """Return the inner product."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Vector, b: Vector) -> Vector:
    """Return the vector product."""
    return (
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    )


def norm(a: Vector) -> float:
    """Return the length."""
    return math.sqrt(dot(a, a))


def unit(a: Vector) -> Vector:
    """Return a scaled to length one; a zero vector is a ValueError."""
    length = norm(a)
    if length == 0.0:
        raise ValueError("a zero vector has no direction")
    return scale(a, 1.0 / length)


def distance(a: Vector, b: Vector) -> float:
    """Return |a - b|."""
    return norm(subtract(a, b))


@dataclass(frozen=True, slots=True)
class Pose:
    """A rigid transform ``parent_T_child``: turn, then shift.

    Attributes:
        position_m: Origin of the child in the parent frame.
        quaternion_wxyz: Unit quaternion of the child in the parent frame.
    """

    position_m: Vector = (0.0, 0.0, 0.0)
    quaternion_wxyz: Quaternion = (1.0, 0.0, 0.0, 0.0)

    def __post_init__(self) -> None:
        """Refuse numbers that are no rigid transform."""
        (x, y, z), (a, b, c, d) = self.position_m, self.quaternion_wxyz
        if not math.isfinite(x + y + z + a + b + c + d):
            raise ValueError(f"a pose must be finite: {self.position_m}, {self.quaternion_wxyz}")
        length = math.sqrt(a * a + b * b + c * c + d * d)
        if abs(length - 1.0) > _UNIT_TOLERANCE:
            raise ValueError(f"quaternion {self.quaternion_wxyz} has length {length:.6f}, not 1")

    def __matmul__(self, other: Pose) -> Pose:
        """Chain: ``a_T_b @ b_T_c == a_T_c``."""
        return Pose(
            self.apply(other.position_m),
            _normalised(_multiply(self.quaternion_wxyz, other.quaternion_wxyz)),
        )

    def inverse(self) -> Pose:
        """Return ``child_T_parent``."""
        w, x, y, z = self.quaternion_wxyz
        back = (w, -x, -y, -z)
        return Pose(_rotate(back, scale(self.position_m, -1.0)), back)

    def apply(self, point_m: Vector) -> Vector:
        """Return a point of the child frame in parent coordinates."""
        return add(_rotate(self.quaternion_wxyz, point_m), self.position_m)

    def turn(self, direction: Vector) -> Vector:
        """Return a direction of the child frame in parent coordinates."""
        return _rotate(self.quaternion_wxyz, direction)

    @property
    def x_axis(self) -> Vector:
        """The child's x axis in the parent frame."""
        return self.turn((1.0, 0.0, 0.0))

    @property
    def y_axis(self) -> Vector:
        """The child's y axis in the parent frame."""
        return self.turn((0.0, 1.0, 0.0))

    @property
    def z_axis(self) -> Vector:
        """The child's z axis in the parent frame."""
        return self.turn((0.0, 0.0, 1.0))

    def matrix(self) -> Matrix4:
        """Return the homogeneous 4 x 4 matrix, row by row."""
        x, y, z, p = self.x_axis, self.y_axis, self.z_axis, self.position_m
        rows = tuple((x[i], y[i], z[i], p[i]) for i in range(3))
        return (*rows, (0.0, 0.0, 0.0, 1.0))

    @staticmethod
    def from_axes(position_m: Vector, x_axis: Vector, y_axis: Vector) -> Pose:
        """Build a pose from its x axis and a y direction, which is made orthogonal to it."""
        x = unit(x_axis)
        y = unit(subtract(y_axis, scale(x, dot(x, y_axis))))
        return Pose(position_m, _quaternion_of(_columns(x, y, cross(x, y))))

    @staticmethod
    def from_z_axis(position_m: Vector, z_axis: Vector, x_hint: Vector = (1.0, 0.0, 0.0)) -> Pose:
        """Build a pose whose z axis is given; x is as near to `x_hint` as z allows."""
        z = unit(z_axis)
        is_clear = norm(cross(z, x_hint)) > _PARALLEL * max(norm(x_hint), _PARALLEL)
        hint = x_hint if is_clear else (0.0, 1.0, 0.0) if abs(z[1]) < _STEEP else (1.0, 0.0, 0.0)
        x = unit(subtract(hint, scale(z, dot(z, hint))))
        return Pose.from_axes(position_m, x, cross(z, x))

    @staticmethod
    def from_matrix(rows: Matrix4) -> Pose:
        """Build a pose from a homogeneous matrix; one that is no rotation is a ValueError."""
        (xx, yx, zx, px), (xy, yy, zy, py), (xz, yz, zz, pz) = rows[:3]
        x, y, z = (xx, xy, xz), (yx, yy, yz), (zx, zy, zz)
        off = abs(dot(x, x) - 1.0) + abs(dot(y, y) - 1.0) + distance(cross(x, y), z)
        if not off <= _ROTATION_TOLERANCE:
            raise ValueError(f"the upper left of {rows} is no rotation")
        return Pose((px, py, pz), _quaternion_of(_columns(x, y, z)))

    @staticmethod
    def from_rpy(position_m: Vector, rpy_rad: Vector) -> Pose:
        """Build a pose from URDF's fixed-axis roll, pitch, yaw."""
        roll, pitch, yaw = (
            from_axis_angle((1.0, 0.0, 0.0), rpy_rad[0]),
            from_axis_angle((0.0, 1.0, 0.0), rpy_rad[1]),
            from_axis_angle((0.0, 0.0, 1.0), rpy_rad[2]),
        )
        return Pose(position_m, _normalised(_multiply(yaw, _multiply(pitch, roll))))

    def angle_to_rad(self, other: Pose) -> float:
        """Return the rotation angle between the two orientations, 0 .. pi."""
        w, x, y, z = _multiply(self.inverse().quaternion_wxyz, other.quaternion_wxyz)
        return 2.0 * math.atan2(math.sqrt(x * x + y * y + z * z), abs(w))

    def distance_to_m(self, other: Pose) -> float:
        """Return the distance between the two origins."""
        return distance(self.position_m, other.position_m)


def translation(x_m: float, y_m: float, z_m: float) -> Pose:
    """Return a pure shift."""
    return Pose((x_m, y_m, z_m))


def rotation(axis: Vector, angle_rad: float) -> Pose:
    """Return a pure turn about an axis through the origin."""
    return Pose(quaternion_wxyz=from_axis_angle(axis, angle_rad))


def from_axis_angle(axis: Vector, angle_rad: float) -> Quaternion:
    """Return the quaternion of a turn about `axis` (any length but zero)."""
    a = unit(axis)
    s = math.sin(angle_rad / 2.0)
    return (math.cos(angle_rad / 2.0), a[0] * s, a[1] * s, a[2] * s)


def _multiply(a: Quaternion, b: Quaternion) -> Quaternion:
    aw, ax, ay, az = a
    bw, bx, by, bz = b
    return (
        aw * bw - ax * bx - ay * by - az * bz,
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
    )


def _normalised(q: Quaternion) -> Quaternion:
    w, x, y, z = q
    length = math.sqrt(w * w + x * x + y * y + z * z)
    sign = -1.0 if w < 0.0 else 1.0
    return (sign * w / length, sign * x / length, sign * y / length, sign * z / length)


def _rotate(q: Quaternion, v: Vector) -> Vector:
    w, a, b, c = q
    x, y, z = v
    # t = 2 (a, b, c) x v, and v + w t + (a, b, c) x t
    i, j, k = 2.0 * (b * z - c * y), 2.0 * (c * x - a * z), 2.0 * (a * y - b * x)
    return (
        x + w * i + (b * k - c * j),
        y + w * j + (c * i - a * k),
        z + w * k + (a * j - b * i),
    )


def _columns(x: Vector, y: Vector, z: Vector) -> Matrix3:
    return ((x[0], y[0], z[0]), (x[1], y[1], z[1]), (x[2], y[2], z[2]))


def _quaternion_of(r: Matrix3) -> Quaternion:
    """Shepperd's method: divide by the largest of the four squared components."""
    diagonal = (r[0][0], r[1][1], r[2][2])
    trace = sum(diagonal)
    off = (r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1])
    if trace >= max(diagonal):
        return _normalised((1.0 + trace, *off))
    i = diagonal.index(max(diagonal))
    j, k = (i + 1) % 3, (i + 2) % 3
    vector = [0.0, 0.0, 0.0]
    vector[i] = 1.0 + diagonal[i] - diagonal[j] - diagonal[k]
    vector[j] = r[i][j] + r[j][i]
    vector[k] = r[i][k] + r[k][i]
    return _normalised((off[i], vector[0], vector[1], vector[2]))
