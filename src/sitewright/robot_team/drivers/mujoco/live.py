"""The cell as it moves, for those who watch: joints and pieces, also while a skill runs."""

from __future__ import annotations

import asyncio
import json
from dataclasses import dataclass
from pathlib import Path
from threading import Condition

from sitewright.errors import BackendError
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Pose
from sitewright.robot_team.drivers.mujoco.codec import Plain
from sitewright.robot_team.drivers.mujoco.places import socket_path
from sitewright.robot_team.drivers.mujoco.simulation import Simulation

_LONGEST_LINE = 4_000_000
_ANSWER_S = 2.0


class LiveView:
    """Hands out what is seen now; while time passes, the thread that steps looks for all."""

    def __init__(self) -> None:
        self._changed = Condition()
        self._wanted, self._seen = 0, 0
        self._picture: Plain = None

    def look(self, sim: Simulation) -> None:
        """Take a picture if somebody waits for one; called after every time step."""
        if self._wanted == self._seen:
            return
        with self._changed:
            self._picture, self._seen = picture_of(sim), self._wanted
            self._changed.notify_all()

    def wait(self, timeout_s: float) -> Plain:
        """Return a picture that is taken after this call; None if nothing stepped in time."""
        with self._changed:
            self._wanted += 1
            mine = self._wanted
            is_there = self._changed.wait_for(lambda: self._seen >= mine, timeout_s)
            return self._picture if is_there else None


def picture_of(sim: Simulation) -> Plain:
    """Return clock, joint positions by name, and poses of the pieces (m, quaternion wxyz)."""
    motion = sim.physics.motion()
    poses = {p: sim.physics.pose(p) for p in sim.contents.pieces}
    return {
        "time_s": sim.time_s,
        "joints": {n: q[0] for n, q in motion.position.items() if len(q) == 1},
        "pieces": {i: [*p.position_m, *p.quaternion_wxyz] for i, p in poses.items()},
    }


@dataclass(frozen=True, slots=True, kw_only=True)
class LivePicture:
    """What a watcher sees.

    Attributes:
        joints: Position of each joint by name: ``robot:joint``, ``end-effector:joint``.
    """

    time_s: float
    joints: dict[str, float]
    world_T_piece: dict[ComponentId, Pose]


class LiveCell:
    """A watcher's own connection to the simulated cell of a state folder; starts nothing.

    Every method raises `BackendError` if no cell answers there.
    """

    def __init__(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        self._reader, self._writer = reader, writer

    @classmethod
    async def attach(cls, folder: Path) -> LiveCell:
        """Connect to the cell that runs there."""
        path = socket_path(folder)
        try:
            reader, writer = await asyncio.open_unix_connection(str(path), limit=_LONGEST_LINE)
        except OSError as error:
            raise BackendError(f"No simulated cell answers at {path}.") from error
        return cls(reader, writer)

    async def see(self) -> LivePicture:
        """Return where everything is now."""
        found = await self._ask("live")
        return LivePicture(
            time_s=float(found["time_s"]),
            joints={str(n): float(q) for n, q in found["joints"].items()},
            world_T_piece={
                ComponentId(i): Pose((x, y, z), (w, a, b, c))
                for i, (x, y, z, w, a, b, c) in found["pieces"].items()
            },
        )

    async def hold(self) -> None:
        """Stop all motion on the path."""
        await self._ask("hold")

    def close(self) -> None:
        """Let the connection go."""
        self._writer.close()

    async def _ask(self, operation: str) -> Plain:
        question = json.dumps({"op": operation, "data": None}).encode() + b"\n"
        try:
            self._writer.write(question)
            line = await asyncio.wait_for(self._reader.readline(), _ANSWER_S)
            answer = json.loads(line)
        except (OSError, ValueError, TimeoutError) as error:
            raise BackendError(f"The simulated cell does not answer: {error}") from error
        if "error" in answer:
            raise BackendError(str(answer["message"]))
        return answer["value"]
