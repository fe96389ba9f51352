"""A small building, a planner for it, and a cell on disk that can be killed at any boundary."""

from __future__ import annotations

import pickle
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path

from sitewright.app.run import RunOptions
from sitewright.app.runner import RunPorts
from sitewright.central_controller.events import AnyEvent
from sitewright.central_controller.expectation import pose_of
from sitewright.central_controller.ports import (
    Alternative,
    Answer,
    ApprovalAnswer,
    ApprovalRequest,
    Approve,
    FactsChanged,
    NothingToDo,
    Planned,
    ProposalOutcome,
    Question,
    Scope,
    Settled,
    SiteContext,
    StillClear,
)
from sitewright.central_controller.proposal import Proposal, ProposedStep
from sitewright.central_controller.site_state import SiteState
from sitewright.errors import BackendError
from sitewright.foundation.canonical import Json
from sitewright.foundation.ids import BodyId, CommandId, ComponentId, OperationId, RobotId
from sitewright.foundation.pose import Pose
from sitewright.planning_twin.motion import (
    Agreement,
    Certificate,
    JointPath,
    PathSegment,
    PlannedMotion,
    TimedPath,
)
from sitewright.planning_twin.refusal import StaleCertificate
from sitewright.planning_twin.scene import Attachment
from sitewright.robot_team.driver import (
    CellDriver,
    CommandState,
    CommandStatus,
    FastenerObservation,
    Observation,
    RobotObservation,
    SkillReport,
)
from sitewright.robot_team.skill import SkillCall, SkillCommand
from sitewright.robot_team.trajectory import Trajectory

A, B = RobotId("robot-a"), RobotId("robot-b")
KEY = b"k" * 32


class Killed(BaseException):
    """Stands for SIGKILL of the controller: nothing catches it."""


class Clock:
    """Time that passes only when somebody looks."""

    def __init__(self) -> None:
        self.now_ns = 1_700_000_000_000_000_000

    def utc_ns(self) -> int:
        self.now_ns += 1_000_000
        return self.now_ns

    def monotonic_ns(self) -> int:
        return self.now_ns


@dataclass
class Boundaries:
    """Counts places where a process can die, and dies at the chosen one."""

    die_at: int = -1
    error: Callable[[], BaseException] = Killed
    count: int = 0

    def cross(self) -> None:
        self.count += 1
        if self.count == self.die_at:
            raise self.error()


class Ids:
    """Ids in a row; making one is a boundary before each write."""

    def __init__(self, boundaries: Boundaries, prefix: str = "id") -> None:
        self.boundaries, self.prefix, self.count = boundaries, prefix, 0

    def new(self) -> str:
        self.boundaries.cross()
        self.count += 1
        return f"{self.prefix}-{self.count:05d}"


def design(targets: int = 2, operations: int = 2) -> SiteState:
    names = [ComponentId(f"stud-{n}") for n in range(1, targets + 1)]
    return SiteState(
        targets=tuple(names),
        operations={
            t: tuple(OperationId(f"{t}-nail-{k}") for k in range(1, operations + 1)) for t in names
        },
    )


def place_rad(place: str) -> float:
    """The one joint position at which a robot's tip is at a place."""
    return 0.0 if place.startswith("home") else (sum(map(ord, place)) % 97 + 1) / 50.0


def stock_pose(piece: str) -> Pose:
    return Pose((-1.0, place_rad(piece), 0.3))


def target_pose(target: str) -> Pose:
    return Pose((1.0, place_rad(target), 0.5))


def pose_json(pose: Pose) -> Json:
    return {"p_m": list(pose.position_m), "q_wxyz": list(pose.quaternion_wxyz)}


@dataclass
class World:
    """Physics and ledger of the cell: all that outlives a crash of it."""

    pieces: dict[str, Pose]
    q_rad: dict[str, float] = field(default_factory=lambda: {A: 0.0, B: 0.0})
    gripped: dict[str, str | None] = field(default_factory=lambda: {A: None, B: None})
    nails: list[str] = field(default_factory=list)
    log: list[tuple[str, str, str]] = field(default_factory=list)
    epoch: int = 0
    ledger: dict[str, SkillReport | None] = field(default_factory=dict)


class DiskCell:
    """A cell whose world is a file: accepted, effect and end are three separate writes."""

    def __init__(self, folder: Path, boundaries: Boundaries, pieces: int = 5) -> None:
        self.file, self.boundaries = folder / "world.bin", boundaries
        self.fail: dict[str, str] = {}
        self.pretend: set[str] = set()
        if not self.file.exists():
            folder.mkdir(parents=True, exist_ok=True)
            names = [f"piece-{n}" for n in range(1, pieces + 1)]
            self.write(World(pieces={n: stock_pose(n) for n in names}))

    def read(self) -> World:
        world: World = pickle.loads(self.file.read_bytes())  # noqa: S301 -- our own file
        return world

    def write(self, world: World) -> None:
        temporary = self.file.with_suffix(".tmp")
        temporary.write_bytes(pickle.dumps(world))
        temporary.replace(self.file)

    def new_epoch(self) -> int:
        world = self.read()
        world.epoch += 1
        self.write(world)
        return world.epoch

    def observe(self) -> Observation:
        world = self.read()
        return Observation(
            time_s=float(len(world.log)),
            robots={
                robot: RobotObservation(
                    q_rad=(world.q_rad[robot],),
                    velocity_rad_s=(0.0,),
                    mounted=None,
                    gripped=ComponentId(piece) if (piece := world.gripped[robot]) else None,
                )
                for robot in (A, B)
            },
            world_T_piece={ComponentId(p): pose for p, pose in world.pieces.items()},
            fasteners=tuple(
                FastenerObservation(
                    operation=OperationId(n),
                    through=ComponentId("any"),
                    into="any",
                    penetration_m=0.05,
                )
                for n in world.nails
            ),
        )

    def status(self, command_id: CommandId) -> CommandStatus:
        ledger = self.read().ledger
        if command_id not in ledger:
            return CommandStatus(state=CommandState.NEVER)
        report = ledger[command_id]
        if report is None:
            return CommandStatus(state=CommandState.ACCEPTED)
        return CommandStatus(state=CommandState.ENDED, report=report)

    def execute(self, command: SkillCommand) -> SkillReport:
        self.boundaries.cross()
        world = self.read()
        if command.command_id in world.ledger:
            known = world.ledger[command.command_id]
            if known is None:
                raise BackendError("the outcome of this command is not known")
            return known
        if command.epoch < world.epoch:
            raise BackendError(f"epoch {command.epoch} is over; now {world.epoch}")
        world.ledger[command.command_id] = None
        self.write(world)
        self.boundaries.cross()
        reason = self.fail.pop(command.skill, "")
        if not reason and command.skill not in self.pretend:
            self.act(world, command)
            self.write(world)
        self.boundaries.cross()
        report = SkillReport(is_done=not reason, reason=reason, duration_s=1.0)
        world.ledger[command.command_id] = report
        self.write(world)
        self.boundaries.cross()
        return report

    def act(self, world: World, command: SkillCommand) -> None:
        robot, params = command.robot, command.params
        for trajectory in command.trajectories:
            assert abs(trajectory.start_rad[0] - world.q_rad[robot]) <= 0.0101
            world.q_rad[robot] = trajectory.end_rad[0]
        piece = str(params.get("piece", ""))
        match command.skill:
            case "grasp":
                world.gripped[robot] = piece
            case "position":
                x, y, z = pose_of(params["world_T_piece"]).position_m
                world.pieces[piece] = Pose((x, y, z + 0.001))
            case "release":
                world.gripped[robot] = None
            case "fasten":
                world.nails.append(str(params["operation"]))
            case _:
                pass
        what = str(params.get("operation") or piece or world.q_rad[robot])
        world.log.append((command.command_id, command.skill, what))

    def hold(self) -> None:
        pass

    def close(self) -> None:
        pass


def motion(robot: RobotId, start_rad: float, end_rad: float) -> PlannedMotion:
    path = JointPath(robot=robot, segments=(PathSegment(waypoints_rad=((start_rad,), (end_rad,))),))
    trajectory = Trajectory(
        robot=robot,
        times_s=(0.0, 1.0),
        positions_rad=((start_rad,), (end_rad,)),
        velocities_rad_s=((0.0,), (0.0,)),
        accelerations_rad_s2=((0.0,), (0.0,)),
        jerks_rad_s3=((0.0,), (0.0,)),
    )
    return PlannedMotion(
        timed=TimedPath(path=path, trajectory=trajectory, segment_ends_s=(1.0,)),
        certificate=certificate(path.sha256()),
        agreement=Agreement(samples=10, closest_distance_m=0.05, engine="test"),
        scene_edits={BodyId("gun"): Attachment(robot, Pose((0.0, 0.0, 0.1)))},
    )


def certificate(path_sha256: str) -> Certificate:
    return Certificate(
        scene_revision="r1",
        path_sha256=path_sha256,
        clearance_m=0.01,
        closest_distance_m=0.042,
        closest_pair=("a", "b"),
        closest_at=(0, 0.5),
        eps_m=1e-4,
        pairs=3,
        evaluations=10,
        engine="test",
    )


@dataclass
class StepWriter:
    """Writes steps one after the other, each starting where the robot then stands."""

    q_rad: dict[RobotId, float]
    steps: list[ProposedStep] = field(default_factory=list)

    def add(
        self, call: SkillCall, *effects: str, to: str = "", params: Mapping[str, Json] | None = None
    ) -> None:
        motions: tuple[PlannedMotion, ...] = ()
        if to:
            motions = (motion(call.robot, self.q_rad[call.robot], place_rad(to)),)
            self.q_rad[call.robot] = place_rad(to)
        self.steps.append(
            ProposedStep(
                number=len(self.steps) + 1,
                call=call,
                params=params or {},
                motions=motions,
                duration_s=1.0,
                relies_on=(f"(at {call.robot} somewhere)",),
                effects=effects,
            )
        )

    def reach(self, robot: RobotId, place: str) -> None:
        if self.q_rad[robot] != place_rad(place):
            call = SkillCall("reach", robot, (place,))
            self.add(call, f"(at {robot} {place})", f"(not (in-transit {robot}))", to=place)

    def retract(self, robot: RobotId) -> None:
        if self.q_rad[robot] != 0.0:
            self.add(SkillCall("retract", robot, ("home",)), f"(in-transit {robot})", to="home")


class SmallPlanner:
    """Plans a target from any state of the small cell."""

    def __init__(self) -> None:
        self.calls = 0

    def propose(
        self, context: SiteContext, *, exclude: frozenset[ComponentId] = frozenset()
    ) -> ProposalOutcome:
        self.calls += 1
        site = context.site
        left = [t for t in site.targets if t not in site.installed and t not in exclude]
        if not left:
            return NothingToDo()
        steps = _steps_for(left[0], context)
        return self.planned(context, left[0], steps)

    def planned(
        self, context: SiteContext, target: ComponentId, steps: tuple[ProposedStep, ...]
    ) -> Planned:
        proposal = Proposal(
            run=context.run,
            target=target,
            steps=steps,
            site_serial=context.site.serial,
            context={"cell": "c" * 64, "model": "m" * 64},
        )
        texts = {"problem": "(define (problem p))", "plan": "(reach a b)"}
        return Planned(proposal=proposal, attachments=texts, timing_s={"total": 0.1})

    def alternatives(self, context: SiteContext) -> tuple[Alternative, ...]:
        del context
        return (Alternative(call=SkillCall("reach", B, ("lookout",)), duration_s=1.0),)

    def propose_single(self, context: SiteContext, call: SkillCall) -> ProposalOutcome:
        left = [t for t in context.site.targets if t not in context.site.installed]
        writer = _writer(context)
        writer.reach(call.robot, call.arguments[0])
        return self.planned(context, left[0], tuple(writer.steps))


def _writer(context: SiteContext) -> StepWriter:
    return StepWriter({r: s.q_rad[0] for r, s in context.observation.robots.items()})


def _steps_for(target: ComponentId, context: SiteContext) -> tuple[ProposedStep, ...]:
    site, seen, writer = context.site, context.observation, _writer(context)
    held = seen.robots[A].gripped
    if target not in site.placed:
        if held is None:
            stock = [p for p in sorted(seen.world_T_piece) if p not in site.consumed]
            held = stock[0]
            writer.reach(A, held)
            call = SkillCall("grasp", A, (held, "stock", "gripper"))
            writer.add(call, f"(holding {A} {held})", params={"piece": held, "width_m": 0.04})
        writer.reach(A, target)
        writer.add(
            SkillCall("position", A, (held, target)),
            f"(in-place {held} {target})",
            f"(not (holding {A} {held}))",
            params={
                "piece": held,
                "world_T_piece": pose_json(target_pose(target)),
                "tolerance_m": 0.01,
                "tolerance_rad": 0.02,
            },
        )
    todo = [o for o in site.operations[target] if o not in site.done_operations]
    for k, operation in enumerate(todo):
        if k == 1 and held is not None:
            _release(writer, target, held)
            held = None
        writer.reach(B, operation)
        call = SkillCall("fasten", B, (operation, target, "gun"))
        writer.add(call, f"(fastened {operation})", params={"operation": operation})
    if held is not None or (target in site.placed and target not in site.standing):
        _release(writer, target, held or site.placed[target].piece)
    writer.retract(A)
    writer.retract(B)
    return tuple(writer.steps)


def _release(writer: StepWriter, target: ComponentId, piece: str) -> None:
    call = SkillCall("release", A, (target,))
    writer.add(call, f"(standing {target})", params={"piece": piece, "aperture_m": 0.1})


class AlwaysClear:
    """Certifies everything again; can be told to refuse once."""

    def __init__(self) -> None:
        self.refuse_once: StaleCertificate | FactsChanged | None = None
        self.lying_about: frozenset[ComponentId] = frozenset()

    def strays(self, context: SiteContext) -> frozenset[ComponentId]:
        return self.lying_about & set(context.observation.world_T_piece)

    def check(
        self, step: ProposedStep, context: SiteContext
    ) -> StillClear | StaleCertificate | FactsChanged:
        del context
        if self.refuse_once is not None:
            refusal, self.refuse_once = self.refuse_once, None
            return refusal
        return StillClear(tuple(certificate(m.timed.path.sha256()) for m in step.motions))


@dataclass
class Person:
    """Approves everything, or answers from a script first; answers questions by looking."""

    script: list[Callable[[ApprovalRequest], ApprovalAnswer]] = field(default_factory=list)
    look: Callable[[Question], Answer | None] = lambda _: None
    scope: Scope = field(default_factory=Scope)
    asked: list[ApprovalRequest] = field(default_factory=list)
    questions: list[Question] = field(default_factory=list)

    def ask(self, request: ApprovalRequest) -> ApprovalAnswer:
        self.asked.append(request)
        if self.script:
            return self.script.pop(0)(request)
        return Approve(fingerprint=request.fingerprint, who="tester", scope=self.scope)

    def answer(self, question: Question) -> Settled | None:
        self.questions.append(question)
        found = self.look(question)
        return None if found is None else Settled(answer=found)


@dataclass
class Site:
    """All fakes of one test, in one folder."""

    folder: Path
    site: SiteState = field(default_factory=design)
    controller: Boundaries = field(default_factory=Boundaries)
    cell_life: Boundaries = field(default_factory=Boundaries)
    planner: SmallPlanner = field(default_factory=SmallPlanner)
    check: AlwaysClear = field(default_factory=AlwaysClear)
    person: Person = field(default_factory=Person)
    clock: Clock = field(default_factory=Clock)
    events: list[AnyEvent] = field(default_factory=list)
    fail: dict[str, str] = field(default_factory=dict)
    pretend: set[str] = field(default_factory=set)  # skills reported as done that did nothing
    lives: int = 0

    def ports(self) -> RunPorts:
        self.lives += 1

        def on_event(event: AnyEvent) -> None:
            self.events.append(event)
            self.controller.cross()

        return RunPorts(
            planner=self.planner,
            check=self.check,
            approver=self.person,
            connect=self.connect,
            clock=self.clock,
            ids=Ids(self.controller, f"life-{self.lives}"),
            key=KEY,
            write_as_built=_write_as_built,
            final_figures=lambda _: {"contacts": 0},
            pause=lambda _: None,
            on_event=on_event,
            min_free_bytes=0,
        )

    def connect(self, folder: Path) -> CellDriver:
        cell = DiskCell(folder / "cell", self.cell_life)
        cell.fail, cell.pretend = self.fail, self.pretend
        return cell

    def options(self, *, from_design: bool = False) -> RunOptions:
        return RunOptions(
            project="small",
            runs=self.folder / "runs",
            design=self.site,
            hashes={"model": "m" * 64},
            cell_lock=self.folder / "cell.lock",
            from_design=from_design,
        )

    def world(self, run: str = "") -> World:
        cells = sorted((self.folder / "runs").glob(f"{run or '*'}/cell"))
        return DiskCell(cells[-1], Boundaries()).read()

    def change_world(self, change: Callable[[World], None]) -> None:
        cell = DiskCell(max((self.folder / "runs").glob("*/cell")), Boundaries())
        world = cell.read()
        change(world)
        cell.write(world)


def _write_as_built(folder: Path, site: SiteState, installed_at: Mapping[ComponentId, str]) -> None:
    lines = [f"{t} {installed_at[t]}" for t in site.installed]
    (folder / "as_built.json").write_text("\n".join(lines), encoding="utf-8")


def cell_dies() -> BaseException:
    return BackendError("the cell's process has gone")


def moved(pose: Pose, by_m: float) -> Pose:
    x, y, z = pose.position_m
    return replace(pose, position_m=(x + by_m, y, z))
