"""What stands where: each target with the piece used and how far it is from where it should be."""

from __future__ import annotations

from sitewright.building_model.model import BuildingModel
from sitewright.central_controller.site_state import SiteState
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.pose import Pose
from sitewright.interaction_twin.report.content import BuiltComponent


def built_components(model: BuildingModel, site: SiteState) -> tuple[BuiltComponent, ...]:
    """Return one row per target: first the installed ones as they came, then the others."""
    others = [t for t in site.targets if t not in site.installed]
    return tuple(_row(model, site, target) for target in (*site.installed, *others))


def _row(model: BuildingModel, site: SiteState, target: ComponentId) -> BuiltComponent:
    operations = [o.id for o in model.component_by_id[target].operations]
    done = sum(o in site.done_operations for o in operations)
    status, note = _status(site, target)
    placed = site.placed.get(target)
    if placed is None:
        return BuiltComponent(
            target=target, status=status, operations_total=len(operations), note=note
        )
    sensed = placed.world_T_measured
    if site.sensed is not None:
        sensed = site.sensed.world_T_piece.get(placed.piece, sensed)
    error_m, error_rad = pose_error(placed.world_T_wanted, sensed)
    return BuiltComponent(
        target=target,
        status=status,
        piece=placed.piece,
        robot=placed.robot,
        operations_done=done,
        operations_total=len(operations),
        position_error_m=error_m,
        angle_error_rad=error_rad,
        note=note,
    )


def _status(site: SiteState, target: ComponentId) -> tuple[str, str]:
    if target in site.needs_rework:
        return "needs rework", site.needs_rework[target]
    if target in site.installed:
        return "installed", ""
    if target in site.refused:
        return "refused", site.refused[target]
    return ("in place" if target in site.placed else "open"), ""


def pose_error(wanted: Pose, sensed: Pose) -> tuple[float, float]:
    """Return distance (m) and angle (rad) between two poses of one piece."""
    return wanted.distance_to_m(sensed), wanted.angle_to_rad(sensed)
