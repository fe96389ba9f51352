"""The as-built model: the design with what was installed folded into it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace

from sitewright.building_model.component import AsBuilt, Component, Layer
from sitewright.building_model.model import BuildingModel
from sitewright.errors import BuildingModelError
from sitewright.foundation.ids import ComponentId, OperationId
from sitewright.foundation.pose import Pose

VERIFIED = "verified"
"""Status of a target that is installed: it stands, has its operations, and was measured."""
_WITHOUT_RECORD: Mapping[Layer, str] = {Layer.TARGET: "planned", Layer.MATERIAL: "available"}


class UnknownInstallationError(BuildingModelError):
    """A record is about a component that the design does not have; was it changed?"""

    def __init__(self, component: str) -> None:
        self.component = component
        super().__init__(
            f"{component!r} was installed but is not in the design. Use the design of that run."
        )


@dataclass(frozen=True, slots=True, kw_only=True)
class InstallRecord:
    """What is known of one installed target.

    Attributes:
        material: Piece that it was made of.
        robot: Who placed it.
        installed_at: Time of the event, ISO 8601 in UTC.
        world_T_measured: Sensed pose in the world.
        operations: Status of each operation: ``done`` or what went wrong.
        status: Status of the target: ``verified`` once it is installed, before that how far it is
            (``held``, ``placed``, ``fastened``) or ``rejected``.
    """

    target: ComponentId
    material: ComponentId
    world_T_measured: Pose
    robot: str = ""
    installed_at: str = ""
    operations: Mapping[OperationId, str] = field(default_factory=dict)
    status: str = VERIFIED


def fold(model: BuildingModel, installs: Sequence[InstallRecord]) -> BuildingModel:
    """Return the model as built: installed targets on layer As-Built, their pieces gone.

    A target whose piece is in place but not installed yet stays a target with a record. The
    design pose stays in `world_T_component`; the measured one is in `as_built`.

    Args:
        model: The design; it is not changed.
        installs: Installed targets in any order; a later record of a target wins.
    """
    components = dict(model.component_by_id)
    for record in installs:
        if record.target not in components:
            raise UnknownInstallationError(record.target)
        components[record.target] = _built(model.component_by_id[record.target], record)
    used = {r.material for r in installs}
    return replace(
        model,
        component_by_id={i: c for i, c in components.items() if i not in used},
        stacks=tuple(
            replace(s, items=tuple(i for i in s.items if i not in used)) for s in model.stacks
        ),
    )


def is_installed(component: Component) -> bool:
    """Whether a component was built by the team, fastened and measured."""
    return component.layer is Layer.AS_BUILT and component.as_built is not None


def status_of(component: Component) -> str:
    """Return how far a component is; empty for what the team neither builds nor uses."""
    if component.as_built is not None:
        return component.as_built.status
    return _WITHOUT_RECORD.get(component.layer, "")


def deviation_of(component: Component, world_T_model: Pose) -> tuple[float, float] | None:
    """Return how far (m, rad) a component was sensed from where it should be; None if it was not.

    Args:
        component: A component with or without an as-built record.
        world_T_model: Places the model in the cell that measured it.
    """
    record = component.as_built
    measured = record.world_T_component_measured if record else None
    if measured is None:
        return None
    designed = world_T_model @ component.world_T_component
    return designed.distance_to_m(measured), designed.angle_to_rad(measured)


def _built(component: Component, record: InstallRecord) -> Component:
    return replace(
        component,
        layer=Layer.AS_BUILT if record.status == VERIFIED else component.layer,
        as_built=AsBuilt(
            status=record.status,
            material_used=record.material,
            installed_at=record.installed_at,
            robot=record.robot,
            world_T_component_measured=record.world_T_measured,
            operations=dict(sorted(record.operations.items())),
        ),
    )
