"""Which robots could do a step, and what keeps the others from it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from sitewright.building_model.component import Operation
from sitewright.building_model.shapes import size_of
from sitewright.central_controller.design import Design
from sitewright.central_controller.ports import RefusalNote
from sitewright.foundation.ids import ComponentId, RobotId
from sitewright.foundation.pose import Pose
from sitewright.planning_twin.fastening import Spot
from sitewright.planning_twin.jobsite import drives
from sitewright.robot_team.cell import Capability, EndEffector, Robot
from sitewright.robot_team.skill import Skill, SkillCall

_NEEDS: Mapping[str, Capability] = {
    Skill.GRASP: Capability.GRASPING,
    Skill.POSITION: Capability.POSITIONING,
    Skill.SET_DOWN: Capability.POSITIONING,
    Skill.RELEASE: Capability.RELEASING,
    Skill.FASTEN: Capability.FASTENING,
    Skill.APPLY_FINISH: Capability.FINISHING,
    Skill.CHANGE_END_EFFECTOR: Capability.TOOL_CHANGING,
}


@dataclass(frozen=True, slots=True, kw_only=True)
class Doer:
    """A robot, asked whether it could do an act.

    Attributes:
        can_by: What makes it fit for the act: its capability, and end effector if one is needed.
        obstacles: Why it cannot; empty if nothing that is known speaks against it.
    """

    robot: RobotId
    can_by: str
    obstacles: tuple[str, ...]


def doers(design: Design, act: SkillCall, refusals: Sequence[RefusalNote]) -> tuple[Doer, ...]:
    """Return every robot of the cell with what speaks against it for an act, in order of id.

    Args:
        design: Model and cell.
        act: Grasp, position, fasten ...; a move has no needs of its own.
        refusals: What geometry refused while the plan was made.
    """
    robots = (design.cell.robot_by_id[r] for r in sorted(design.cell.robot_by_id))
    return tuple(_doer(design, robot, act, refusals) for robot in robots)


def _doer(design: Design, robot: Robot, act: SkillCall, refusals: Sequence[RefusalNote]) -> Doer:
    needed = _NEEDS.get(act.skill)
    lacks = needed is not None and needed not in robot.can
    what, fits = _end_effector_for(design, act)
    tools = [design.cell.end_effector_by_id[i] for i in robot.end_effectors]
    fitting = sorted(t.id for t in tools if fits(t))
    obstacles = []
    if needed is not None and lacks:
        can = ", ".join(sorted(c.value for c in robot.can)) or "nothing"
        obstacles.append(f"it is not made for {needed.value} (it does {can})")
    if what and not fitting:
        obstacles.append(f"none of its end effectors {what}")
    obstacles += _refused(robot, act, refusals)
    by = [needed.value] if needed is not None and not lacks else []
    by += [f"{' or '.join(fitting)} {what}"] if what and fitting else []
    return Doer(robot=robot.id, can_by=", ".join(by), obstacles=tuple(obstacles))


def _end_effector_for(design: Design, act: SkillCall) -> tuple[str, Callable[[EndEffector], bool]]:
    """Return what an end effector must do for an act, in words, and a test; no words if none."""
    match act.skill, act.arguments:
        case (Skill.GRASP | Skill.POSITION | Skill.SET_DOWN, (piece, *_)):
            component = design.model.component_by_id.get(ComponentId(piece))
            if component is not None:
                sides_m = size_of(component)[1:]
                sides = " x ".join(f"{s * 1000:g}" for s in sides_m)
                return f"holds {sides} mm", lambda e: _holds(e, sides_m)
        case (Skill.FASTEN | Skill.APPLY_FINISH, (name, target, *_)):
            operation = _operation(design, name)
            if operation is not None:
                return _does(operation), lambda e: _drives(e, operation, ComponentId(target))
        case _:
            pass
    return "", lambda _e: True


def _operation(design: Design, name: str) -> Operation | None:
    components = design.model.component_by_id.values()
    return next((o for c in components for o in c.operations if o.id == name), None)


def _holds(gripper: EndEffector, sides_m: tuple[float, ...]) -> bool:
    low, high = gripper.grips_m or (1.0, 0.0)
    return any(low <= side <= high for side in sides_m)


def _does(operation: Operation) -> str:
    spec = operation.fastener
    if spec is None:
        return f"does {operation.process.value}"
    return f"drives a {spec.type} {spec.d_m * 1000:g} x {spec.l_m * 1000:g} mm"


def _drives(tool: EndEffector, operation: Operation, target: ComponentId) -> bool:
    spot = Spot(
        operation=operation.id,
        process=operation.process,
        target=target,
        world_T_operation=Pose(),
        fastener=operation.fastener,
    )
    return operation.process in tool.processes and drives(tool, spot)


def _refused(robot: Robot, act: SkillCall, refusals: Sequence[RefusalNote]) -> Iterator[str]:
    """Yield what geometry refused this robot about the act's piece or spot."""
    about = act.arguments[:1]
    for note in refusals:
        words = note.reason.replace(":", " ").split()
        if robot.id in words and any(a in words for a in about):
            yield note.reason
