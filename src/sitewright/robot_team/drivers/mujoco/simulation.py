"""The running cell: time, motion, fingers, and what holds what."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from threading import Event

import mujoco

from sitewright.foundation.canonical import Json
from sitewright.foundation.ids import ComponentId, EndEffectorId, RobotId
from sitewright.foundation.mjcf.model import MjcfModel
from sitewright.foundation.pose import Pose
from sitewright.robot_team.cell import Cell, EndEffector, EndEffectorKind
from sitewright.robot_team.drivers.mujoco.arms import ArmControl
from sitewright.robot_team.drivers.mujoco.blind_pairs import blind_pairs
from sitewright.robot_team.drivers.mujoco.contacts import ContactWatch
from sitewright.robot_team.drivers.mujoco.fixings import Fixings
from sitewright.robot_team.drivers.mujoco.pace import Pace
from sitewright.robot_team.drivers.mujoco.physics import Motion, Physics
from sitewright.robot_team.drivers.mujoco.scene import (
    Contents,
    finger_joints,
    joint_name,
    model_of,
    pad_bodies,
)

Effect = Mapping[str, Json]
FINGER_SPEED_M_S = 0.10


@dataclass(frozen=True, slots=True, kw_only=True)
class Checkpoint:
    """Everything that is needed to go on after a crash of the cell."""

    motion: Motion
    reference: Mapping[str, float]
    fixings: Fixings


class Simulation:
    """The physics of one cell with its controls.

    Attributes:
        fixings: What is fixed to what now.
        watch: The contact log of the current command.
        hold: Set from outside to stop the motion on its path.
        lost: Robots whose piece fell since the last command began.
    """

    def __init__(
        self,
        contents: Contents,
        checkpoint: Checkpoint,
        *,
        record: Callable[[Effect], None],
        real_time_factor: float = 0.0,
    ) -> None:
        self.contents = contents
        self.fixings = checkpoint.fixings
        self.watch = ContactWatch()
        self.hold = Event()
        self.lost: set[RobotId] = set()
        self.on_step: Callable[[Simulation], None] | None = None
        self._record = record
        self._pace = Pace(real_time_factor)
        self._blind: dict[tuple[RobotId, EndEffectorId | None], frozenset[tuple[str, str]]] = {}
        self.arms = ArmControl(contents.cell)
        self.physics = Physics(self._model(), checkpoint.motion)
        self._bind()
        self.arms.stand(self.physics, checkpoint.reference)

    @property
    def cell(self) -> Cell:
        """The cell that is simulated."""
        return self.contents.cell

    @property
    def time_s(self) -> float:
        """The clock of the cell."""
        return float(self.physics.d.time)

    @property
    def step_s(self) -> float:
        """The time step."""
        return float(self.physics.m.opt.timestep)

    def checkpoint(self) -> Checkpoint:
        """Return the present state."""
        return Checkpoint(
            motion=self.physics.motion(),
            reference=self.arms.reference(),
            fixings=self.fixings,
        )

    def effect(self, kind: str, **facts: Json) -> None:
        """Write down, for good, something that just happened to the world."""
        self._record({"effect": kind, "time_s": self.time_s, **facts})

    def fix(self, fixings: Fixings) -> None:
        """Change what holds what and go on from the same positions and speeds."""
        self.fixings = fixings
        self.physics.rebuild(self._model())
        self._bind()

    def _bind(self) -> None:
        self.arms.bind(self.physics, self.fixings)
        self.watch.bind(self.physics)

    def _model(self) -> MjcfModel:
        blind: set[tuple[str, str]] = set()
        for robot in self.cell.robot_by_id.values():
            key = (robot.id, self.fixings.mounted.get(robot.id))
            if key not in self._blind:
                self._blind[key] = blind_pairs(robot, self.tool_of(robot.id))
            blind |= self._blind[key]
        return model_of(self.contents, self.fixings, blind)

    # ---- time -----------------------------------------------------------------------------

    def step(self) -> None:
        """Advance by one time step, with the arms after their reference."""
        m, d = self.physics.m, self.physics.d
        mujoco.mj_step1(m, d)
        self.watch.look(self.physics)
        self.arms.drive(self.physics)
        mujoco.mj_step2(m, d)
        if self.on_step is not None:
            self.on_step(self)
        self._pace.keep(self.time_s)

    def advance(self, seconds: float) -> None:
        """Let time pass while the arms hold still."""
        self.arms.dq[:] = 0.0
        self.arms.ddq[:] = 0.0
        for _ in range(max(1, round(seconds / self.step_s))):
            self.step()
        self.physics.refresh()

    # ---- end effectors ---------------------------------------------------------------------

    def tool_of(self, robot: RobotId) -> EndEffector | None:
        """Return the end effector on a robot's flange."""
        tool = self.fixings.mounted.get(robot)
        return None if tool is None else self.cell.end_effector_by_id[tool]

    def gripper_of(self, robot: RobotId) -> EndEffector | None:
        """Return the gripper on a robot's flange, if what it carries is one."""
        tool = self.tool_of(robot)
        return tool if tool is not None and tool.kind is EndEffectorKind.GRIPPER else None

    def tip(self, robot: RobotId) -> Pose:
        """Return the measured world pose of a robot's tip frame (tool0)."""
        return self.physics.pose(f"{robot}/{self.cell.robot_by_id[robot].description.tip}")

    def aperture_m(self, tool: EndEffector) -> float:
        """Return the measured opening of a gripper."""
        names = [joint_name(tool.id, j.name) for j in finger_joints(tool)]
        positions, _ = self.physics.joint_numbers(names)
        return float(self.physics.d.qpos[positions].sum())

    def pads_on(self, tool: EndEffector, piece: str) -> int:
        """Return how many pads of a gripper press on a piece."""
        return len(self.physics.touching(pad_bodies(tool), piece))

    def gripped(self, robot: RobotId) -> ComponentId | None:
        """Return the piece that both pads of a robot press on, by contact."""
        tool = self.gripper_of(robot)
        if tool is None:
            return None
        pads = pad_bodies(tool)
        between = (p for p in self.contents.pieces if self.pads_on(tool, p) == len(pads))
        return next(between, None)

    def move_fingers(self, tool: EndEffector, aperture_m: float) -> None:
        """Send a gripper's fingers to an opening at their speed; they stop at what they meet."""
        drives = [self.physics.drives[joint_name(tool.id, j.name)] for j in finger_joints(tool)]
        start = [float(self.physics.d.ctrl[k]) for k in drives]
        goal = aperture_m / len(drives)
        way_m = max(abs(goal - s) for s in start)
        steps = max(1, round(way_m / FINGER_SPEED_M_S / self.step_s))
        self.arms.dq[:] = 0.0
        self.arms.ddq[:] = 0.0
        for k in range(1, steps + 1):
            for drive, s in zip(drives, start, strict=True):
                self.physics.d.ctrl[drive] = s + (goal - s) * k / steps
            self.step()
        self.advance(0.1)

    def drop(self, robot: RobotId, why: str) -> None:
        """Open a robot's fingers at once, as a lost grip does; the piece falls."""
        grip, tool = self.fixings.grips[robot], self.gripper_of(robot)
        self.fix(self.fixings.let_go(robot))
        self.lost.add(robot)
        if tool is not None:
            for joint in finger_joints(tool):
                drive = self.physics.drives[joint_name(tool.id, joint.name)]
                self.physics.d.ctrl[drive] = joint.upper_rad
        self.effect("dropped", robot=robot, piece=grip.piece, why=why)

    def push(self, piece: ComponentId, way_m: float) -> None:
        """Shift a piece along the world's x, as a hand would."""
        motion = self.physics.motion()
        x, *rest = motion.position[piece]
        moved = {**motion.position, piece: (x + way_m, *rest)}
        self.physics.rebuild(self._model())
        self.physics.restore(replace(motion, position=moved))
        self._bind()

    def near_pairs(self, limit_m: float, bodies: Iterable[str] = ()) -> set[tuple[str, str]]:
        """Return which pieces lie against each other, a fixture, or one of `bodies`."""
        pieces = list(self.contents.pieces)
        others = [*self.cell.fixture_by_id, *bodies]
        pairs = [(a, b) for k, a in enumerate(pieces) for b in (*pieces[:k], *others)]
        return {(a, b) for a, b in pairs if self.physics.gap_m(a, b, 2 * limit_m) <= limit_m}
