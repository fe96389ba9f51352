"""Live joints and pieces: looks at the cell 30 times a second while somebody watches."""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import Callable, Sequence
from pathlib import Path

from sitewright.errors import BackendError
from sitewright.foundation.clock import Clock
from sitewright.foundation.pose import Pose
from sitewright.interaction_twin.web.frames import joints_frame, poses_frame
from sitewright.interaction_twin.web.twin import Audience
from sitewright.robot_team.drivers.mujoco.live import LiveCell, LivePicture

PERIOD_S = 1.0 / 30.0
_AT_LEAST_S = 0.25
_LOOK_AGAIN_S = 0.5
_STILL = 1e-5
_MS, _S = 1e6, 1e9
_MOVED_M, _TURNED_RAD = 2e-4, 1e-3


class LiveFeed:
    """Sends frames to all pages; tells when the cell comes or goes."""

    def __init__(
        self,
        audience: Audience,
        clock: Clock,
        *,
        folder: Callable[[], Path | None],
        on_change: Callable[[], None],
    ) -> None:
        """Prepare the feed.

        Args:
            audience: All pages.
            clock: For the time of a frame.
            folder: Of the simulated cell; None before there is one.
            on_change: Called when the cell came or went.
        """
        self._audience, self._clock = audience, clock
        self._folder, self._on_change = folder, on_change
        self._cell: LiveCell | None = None
        self._joints: Sequence[str] = ()
        self._base: Sequence[tuple[str, Pose]] = ()
        self._epoch = self._sequence = 0
        self._last: list[float] = []
        self._sent_ns = 0
        self.seen_ns = 0

    @property
    def is_live(self) -> bool:
        """Whether the cell answers."""
        return self._cell is not None

    def show_scene(
        self, epoch: int, joints: Sequence[str], pieces: Sequence[tuple[str, Pose]]
    ) -> None:
        """Set what frames are about from now on.

        Args:
            epoch: Of the scene document.
            joints: Names in the order of the frame, ``owner:joint``.
            pieces: Id and pose of each component of the document that has a pose; the id is empty
                for those that are no pieces.
        """
        self._epoch, self._joints, self._base = epoch, tuple(joints), tuple(pieces)
        self._last = []

    async def run(self) -> None:
        """Look and send until cancelled."""
        due_s = self._now_s()
        while True:
            if self._audience.size == 0 or not self._joints:
                await asyncio.sleep(PERIOD_S)
                continue
            try:
                await self._look()
            except BackendError:
                self._lose()
                await asyncio.sleep(_LOOK_AGAIN_S)
            due_s = next_look_s(due_s, self._now_s())
            await asyncio.sleep(due_s - self._now_s())

    def _now_s(self) -> float:
        return self._clock.monotonic_ns() / _S

    async def hold(self) -> bool:
        """Tell the cell to stop, over a connection of its own; False if none answers."""
        folder = self._folder()
        if folder is None:
            return False
        try:
            cell = await LiveCell.attach(folder)
            try:
                await cell.hold()
            finally:
                cell.close()
        except BackendError:
            return False
        return True

    async def _look(self) -> None:
        if self._cell is None:
            folder = self._folder()
            if folder is None:
                raise BackendError("There is no cell yet.")
            self._cell = await LiveCell.attach(folder)
            self._on_change()
        picture = await self._cell.see()
        self.seen_ns = self._clock.utc_ns()
        self._send(picture)

    def _send(self, picture: LivePicture) -> None:
        values = [picture.joints.get(n, 0.0) for n in self._joints]
        moved = len(values) != len(self._last) or any(
            abs(a - b) > _STILL for a, b in zip(values, self._last, strict=True)
        )
        now_ns = self._clock.monotonic_ns()
        if not moved and now_ns - self._sent_ns < _AT_LEAST_S * _S:
            return
        self._last, self._sent_ns = values, now_ns
        self._sequence += 1
        facts = {"epoch": self._epoch, "sequence": self._sequence}
        t_ms = self.seen_ns / _MS
        self._audience.show(joints_frame(values, t_ms=t_ms, **facts))
        self._audience.show(poses_frame(self._elsewhere(picture), t_ms=t_ms, **facts))

    def _elsewhere(self, picture: LivePicture) -> list[tuple[int, Pose]]:
        """Return the pieces that are not where the scene has them, by their index in it."""
        seen = {str(i): p for i, p in picture.world_T_piece.items()}
        return [
            (index, seen[name])
            for index, (name, base) in enumerate(self._base)
            if name in seen and _differs(base, seen[name])
        ]

    def _lose(self) -> None:
        if self._cell is None:
            return
        with contextlib.suppress(OSError):
            self._cell.close()
        self._cell = None
        self._on_change()


def next_look_s(due_s: float, now_s: float) -> float:
    """Return when to look next: on the beat of the looks before; one that is missed is left out.

    Args:
        due_s: When the last look was due.
        now_s: When it was done, on the same clock.
    """
    following_s = due_s + PERIOD_S
    return following_s if following_s > now_s else now_s + PERIOD_S


def _differs(a: Pose, b: Pose) -> bool:
    return a.distance_to_m(b) > _MOVED_M or a.angle_to_rad(b) > _TURNED_RAD
