"""The scenes that a run's certificates should be about: cell file, design, and what was sensed."""

from __future__ import annotations

from sitewright.app.design_changes import project_at
from sitewright.app.project import Project
from sitewright.app.run_folder import RunFolder, start_of_run
from sitewright.central_controller.cycle_state import CycleState
from sitewright.central_controller.design import Design
from sitewright.central_controller.ports import SiteContext
from sitewright.central_controller.proposal import ProposedStep
from sitewright.central_controller.situation import jobsite_of, piece_shapes
from sitewright.central_controller.start_site import site_at_start
from sitewright.foundation.canonical import sha256_hex
from sitewright.foundation.pose import Pose
from sitewright.planning_twin.jobsite import scene_of
from sitewright.planning_twin.recheck import scenes_in_turn
from sitewright.planning_twin.scene import SceneSnapshot
from sitewright.robot_team.description import Description, Joints
from sitewright.robot_team.kinematics import tip_pose


class ExpectedScenes:
    """Builds scenes anew from the project's files and the folded journal.

    Attributes:
        folder: Of the run.
        is_known: Whether the cell file is still the one of the run.
        pieces: Names of all pieces of material.
    """

    def __init__(self, project: Project, folder: RunFolder) -> None:
        self._project, self.folder = project, folder
        started = start_of_run(folder)
        cell_sha256 = sha256_hex(project.cell_file.read_bytes())
        self.is_known = started is not None and started.hashes.get("cell") == cell_sha256
        self.pieces: frozenset[str] = frozenset(piece_shapes(project.model))
        self._designs: dict[str, Design] = {}

    def of(self, state: CycleState, step: ProposedStep) -> tuple[SceneSnapshot | None, ...]:
        """Return the scene of each motion of a step; None where it cannot be known."""
        seen = state.site.sensed
        if not self.is_known or seen is None:
            return (None,) * len(step.motions)
        design = self._design(state.model_sha256)
        context = SiteContext(run=state.run, site=state.site, observation=seen)
        shapes = piece_shapes(design.model)
        site = jobsite_of(design, shapes, context, _PlainKinematics())
        scene = scene_of(site_at_start(site, step))
        return tuple(scene for scene, _ in scenes_in_turn(scene, step.motions))

    def _design(self, model_sha256: str) -> Design:
        if model_sha256 not in self._designs:
            then = project_at(self._project, model_sha256)
            self._designs[model_sha256] = Design(model=then.model, cell=then.cell)
        return self._designs[model_sha256]


class _PlainKinematics:
    """Forward kinematics without any engine."""

    def tip(self, description: Description, q_rad: Joints) -> Pose:
        """Return base_T_tip of a posture."""
        return tip_pose(description, q_rad)
