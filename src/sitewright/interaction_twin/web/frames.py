"""Binary frames of the WebSocket: a header of 16 bytes, then numbers of four."""

from __future__ import annotations

import struct
from collections.abc import Iterable, Sequence

from sitewright.foundation.pose import Pose

JOINTS, POSES = 1, 2
VERSION = 1
_HEADER = struct.Struct("<BBHId")
_POSE = struct.Struct("<HH7f")
_WRAP_16, _WRAP_32 = 1 << 16, 1 << 32


def joints_frame(values: Sequence[float], *, epoch: int, sequence: int, t_ms: float) -> bytes:
    """Return a frame with one float32 per joint of the scene, in its order (rad, m on rails)."""
    return _header(JOINTS, epoch, sequence, t_ms) + struct.pack(f"<{len(values)}f", *values)


def poses_frame(
    poses: Iterable[tuple[int, Pose]], *, epoch: int, sequence: int, t_ms: float
) -> bytes:
    """Return a frame with the pieces that are not where the scene has them.

    Args:
        poses: Index into the scene's components, and world pose.
        epoch: Of the scene that the indices are about.
        sequence: Counts frames.
        t_ms: Unix time in milliseconds at which it was sensed.
    """
    rows = (_POSE.pack(i, 0, *p.position_m, *p.quaternion_wxyz) for i, p in poses)
    return _header(POSES, epoch, sequence, t_ms) + b"".join(rows)


def _header(kind: int, epoch: int, sequence: int, t_ms: float) -> bytes:
    return _HEADER.pack(kind, VERSION, epoch % _WRAP_16, sequence % _WRAP_32, t_ms)
