"""All engines of the planning twin, put together."""

from __future__ import annotations

from sitewright.planning_twin.backends.certifier import ConservativeAdvancement
from sitewright.planning_twin.backends.collision_check import CoalCollisionCheck
from sitewright.planning_twin.backends.mujoco_crosscheck import MujocoCrossCheck
from sitewright.planning_twin.backends.opw_kinematics import OpwKinematics
from sitewright.planning_twin.backends.proof_scene import ProofScenes
from sitewright.planning_twin.backends.ruckig_timer import RuckigTimer
from sitewright.planning_twin.backends.two_trees import TwoTrees
from sitewright.planning_twin.motion import PlanningBackends


def make_backends() -> PlanningBackends:
    """Return the engines; they share what they compile, so use them in one thread."""
    proofs = ProofScenes()
    return PlanningBackends(
        kinematics=OpwKinematics(),
        collision=CoalCollisionCheck(proofs),
        planner=TwoTrees(proofs),
        certifier=ConservativeAdvancement(proofs),
        timer=RuckigTimer(),
        cross_check=MujocoCrossCheck(proofs),
    )
