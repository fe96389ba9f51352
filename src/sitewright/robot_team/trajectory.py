"""A trajectory: positions over time, exact between its knots."""

from __future__ import annotations

import hashlib
from array import array
from bisect import bisect_right
from dataclasses import dataclass

from sitewright.foundation.ids import RobotId
from sitewright.robot_team.description import Joints

_MICRO = 1e6


@dataclass(frozen=True, slots=True, kw_only=True)
class Trajectory:
    """One robot's motion, rest to rest, with constant jerk between knots.

    The knots stand at every change of jerk, so that the cubic between two of them *is* the
    certified curve and nothing is lost by sending it.

    Attributes:
        times_s: Rising from 0; one per knot.
        positions_rad: Joint positions at each knot.
        velocities_rad_s: Joint velocities at each knot; zero at both ends.
        accelerations_rad_s2: Joint accelerations at the *start* of the piece after each knot.
        jerks_rad_s3: Joint jerks of the piece after each knot (the last entry is zero).
    """

    robot: RobotId
    times_s: tuple[float, ...]
    positions_rad: tuple[Joints, ...]
    velocities_rad_s: tuple[Joints, ...]
    accelerations_rad_s2: tuple[Joints, ...]
    jerks_rad_s3: tuple[Joints, ...]

    @property
    def duration_s(self) -> float:
        """Time from start to end."""
        return self.times_s[-1]

    @property
    def start_rad(self) -> Joints:
        """Where it starts."""
        return self.positions_rad[0]

    @property
    def end_rad(self) -> Joints:
        """Where it ends."""
        return self.positions_rad[-1]

    def at(self, time_s: float) -> tuple[Joints, Joints, Joints]:
        """Return position, velocity and acceleration at a time, clamped to the ends."""
        if time_s <= 0.0:
            return self.positions_rad[0], self.velocities_rad_s[0], self.accelerations_rad_s2[0]
        if time_s >= self.times_s[-1]:
            rest = (0.0,) * len(self.positions_rad[-1])
            return self.positions_rad[-1], rest, rest
        k = bisect_right(self.times_s, time_s) - 1
        h = time_s - self.times_s[k]
        rows = zip(
            self.positions_rad[k],
            self.velocities_rad_s[k],
            self.accelerations_rad_s2[k],
            self.jerks_rad_s3[k],
            strict=True,
        )
        states = [
            (
                q + h * (v + h * (a / 2.0 + h * j / 6.0)),
                v + h * (a + h * j / 2.0),
                a + h * j,
            )
            for q, v, a, j in rows
        ]
        q, v, a = zip(*states, strict=True)
        return q, v, a

    def sha256(self) -> str:
        """Hash of robot, shape and knots in microseconds and microradians."""
        return hashlib.sha256(self.content()).hexdigest()

    def content(self) -> bytes:
        """Return what is hashed: ``robot/KxJ/``, then K rows of 1 + 4 J little-endian int64.

        A row holds the time of a knot (us) and the J positions, velocities, accelerations and
        jerks there, each times 1e6.
        """
        numbers = array("q")
        for time_s, *rows in zip(
            self.times_s,
            self.positions_rad,
            self.velocities_rad_s,
            self.accelerations_rad_s2,
            self.jerks_rad_s3,
            strict=True,
        ):
            numbers.append(round(time_s * _MICRO))
            for row in rows:
                numbers.extend(round(x * _MICRO) for x in row)
        shape = f"{self.robot}/{len(self.times_s)}x{len(self.positions_rad[0])}/".encode()
        return shape + _little_endian(numbers)


def _little_endian(numbers: array[int]) -> bytes:
    import sys

    if sys.byteorder == "big":
        numbers.byteswap()
    return numbers.tobytes()
