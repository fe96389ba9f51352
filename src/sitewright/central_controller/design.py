"""The design of a project: what does not change during a run."""

from __future__ import annotations

from dataclasses import dataclass

from sitewright.building_model.component import Component
from sitewright.building_model.model import BuildingModel
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Pose
from sitewright.robot_team.cell import Cell


@dataclass(frozen=True, slots=True, kw_only=True)
class Design:
    """What does not change during a run."""

    model: BuildingModel
    cell: Cell

    def component(self, component: ComponentId) -> Component:
        """Return a component of the design."""
        return self.model.component_by_id[component]

    def world_T_target(self, target: ComponentId) -> Pose:
        """Return where a target belongs in the world."""
        return self.cell.world_T_model @ self.component(target).world_T_component
