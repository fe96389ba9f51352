"""Contact poses of the skills: pick, place, set down, drive, dock, with what they may touch."""

from __future__ import annotations

from sitewright.foundation.ids import BodyId, ComponentId
from sitewright.foundation.pose import Pose, scale
from sitewright.planning_twin.approach import CONTACT_M, NEAR_M, NEIGHBOUR_M, PRE_M, Touch
from sitewright.planning_twin.fastening import ToolPose
from sitewright.planning_twin.grasps import Grasp
from sitewright.planning_twin.jobsite import bodies_of_tool
from sitewright.planning_twin.task import Insertion, Task, declared
from sitewright.robot_team.cell import EndEffector
from sitewright.robot_team.gripper import mount_T_tcp

_FROM_ABOVE = Insertion()


def pick_touch(task: Task, tool: EndEffector, piece: ComponentId, at: Pose, grasp: Grasp) -> Touch:
    """Return the gripper's contact with a piece that lies somewhere, coming along the tcp."""
    world_T_tcp = at @ grasp.piece_T_tcp
    gripper = bodies_of_tool(tool)
    below = task.lies_on.get(piece, ())
    return Touch(
        world_T_tip=world_T_tcp @ mount_T_tcp(tool.description).inverse(),
        back_off=scale(world_T_tcp.z_axis, -1.0),
        near_m={
            **declared(NEIGHBOUR_M, gripper, below),
            **declared(CONTACT_M, gripper, (BodyId(piece),)),
        },
    )


def lift_thresholds(
    task: Task, tool: EndEffector, piece: ComponentId
) -> dict[tuple[str, str], float]:
    """Return what a held piece and its gripper may touch while leaving what it lies on."""
    below = task.lies_on.get(piece, ())
    return {
        **declared(NEIGHBOUR_M, bodies_of_tool(tool), below),
        **declared(CONTACT_M, (BodyId(piece),), below),
    }


def place_touch(
    task: Task, tool: EndEffector, piece: ComponentId, grasp: Grasp, insertion: Insertion
) -> Touch:
    """Return the held piece's contact with its neighbours at the target pose."""
    return set_down_touch(
        task.world_T_target, tool, piece, grasp, insertion=insertion, touches=task.touches
    )


def set_down_touch(
    world_T_piece: Pose,
    tool: EndEffector,
    piece: ComponentId,
    grasp: Grasp,
    *,
    touches: tuple[BodyId, ...],
    insertion: Insertion = _FROM_ABOVE,
) -> Touch:
    """Return the held piece's contact with what it is set down on."""
    world_T_tcp = world_T_piece @ grasp.piece_T_tcp
    return Touch(
        world_T_tip=world_T_tcp @ mount_T_tcp(tool.description).inverse(),
        back_off=insertion.come_from,
        near_length_m=NEAR_M + insertion.slide_m,
        distance_m=PRE_M + insertion.slide_m,
        near_m={
            **declared(NEIGHBOUR_M, bodies_of_tool(tool), touches),
            **declared(CONTACT_M, (BodyId(piece),), touches),
        },
    )


def leave_touch(task: Task, tool: EndEffector, piece: ComponentId, world_T_tip: Pose) -> Touch:
    """Return the way out of an opened gripper from a placed piece, back along the tcp."""
    world_T_tcp = world_T_tip @ mount_T_tcp(tool.description)
    gripper = bodies_of_tool(tool)
    return Touch(
        world_T_tip=world_T_tip,
        back_off=scale(world_T_tcp.z_axis, -1.0),
        near_m={
            **declared(NEIGHBOUR_M, gripper, task.touches),
            **declared(CONTACT_M, gripper, (BodyId(piece),)),
        },
    )


def spot_touch(tool: EndEffector, piece: ComponentId, pose: ToolPose) -> Touch:
    """Return a tool tip's contact with the piece that it fastens or finishes."""
    return Touch(
        world_T_tip=pose.world_T_tip,
        back_off=pose.back_off,
        near_m=declared(CONTACT_M, bodies_of_tool(tool), (BodyId(piece),)),
        label=pose.label,
    )
