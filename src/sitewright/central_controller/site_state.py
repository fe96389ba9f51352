"""What the controller knows of the site: a fold of the design and the journal's events."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from sitewright.building_model.component import Layer
from sitewright.building_model.model import BuildingModel
from sitewright.foundation.ids import ComponentId, OperationId, RobotId, ZoneId
from sitewright.foundation.pose import Pose, Vector
from sitewright.robot_team.driver import Observation
from sitewright.robot_team.skill import SkillCall


@dataclass(frozen=True, slots=True, kw_only=True)
class PlacedPiece:
    """A piece that was positioned at a target.

    Attributes:
        world_T_wanted: Where the approved step should put it.
        world_T_measured: Where it was sensed last.
        robot: Who put it there.
    """

    piece: ComponentId
    world_T_wanted: Pose
    world_T_measured: Pose
    robot: RobotId


@dataclass(frozen=True, slots=True, kw_only=True)
class Rejection:
    """A proposal that a person refused, for the planner to do better.

    Attributes:
        reason: ``wrong-component``, ``wrong-robot``, ``path-unsafe``, ``site-differs``,
            ``later`` or ``other``.
        detail: The person's own words.
        step: The step that it is about; 0 is the whole plan.
        calls: Skill calls that were refused: the one step, or all that were left.
    """

    fingerprint: str
    target: ComponentId
    reason: str
    detail: str = ""
    step: int = 0
    calls: tuple[SkillCall, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class DrawnZone:
    """A box that a person drew to be kept out of; it has no body.

    Attributes:
        size_m: Full edge lengths along its own axes.
        who: Who drew it.
    """

    id: ZoneId
    size_m: Vector
    world_T_zone: Pose
    who: str


@dataclass(frozen=True, slots=True, kw_only=True)
class SiteState:
    """The site after all recorded events.

    Attributes:
        targets: Components of the design that are to be built.
        operations: Operations of each target, in order of the design.
        serial: Counts changes of the site that no proposal predicted.
        placed: Piece at each target that has one, also while it is still held or not fastened.
        standing: Targets whose piece stands without a robot.
        done_operations: Fasteners driven, finishes applied.
        installed: Targets that stand and have all their operations, in order of installation.
        place_by_robot: PDDL place (as site id) where each robot's last known motion ended;
            None is in transit. A robot is absent while its place is unknown.
        sensed: Last observation that was recorded, to tell what moved since.
        needs_rework: Targets that a person must put right, with the reason.
        refused: Targets set aside in this run, with the reason.
        rejections: What people refused in this run.
        zones: What people drew to be kept out of, beside the zones of the cell.
        waiting: Targets that wait until another one is installed, because they have no plan
            before.
    """

    targets: tuple[ComponentId, ...] = ()
    operations: Mapping[ComponentId, tuple[OperationId, ...]] = field(default_factory=dict)
    serial: int = 0
    placed: Mapping[ComponentId, PlacedPiece] = field(default_factory=dict)
    standing: frozenset[ComponentId] = frozenset()
    done_operations: frozenset[OperationId] = frozenset()
    installed: tuple[ComponentId, ...] = ()
    place_by_robot: Mapping[RobotId, str | None] = field(default_factory=dict)
    sensed: Observation | None = None
    needs_rework: Mapping[ComponentId, str] = field(default_factory=dict)
    refused: Mapping[ComponentId, str] = field(default_factory=dict)
    rejections: tuple[Rejection, ...] = ()
    zones: Mapping[ZoneId, DrawnZone] = field(default_factory=dict)
    waiting: Mapping[ComponentId, ComponentId] = field(default_factory=dict)

    @property
    def is_complete(self) -> bool:
        """Whether every target of the design is installed."""
        return all(t in self.installed for t in self.targets)

    @property
    def consumed(self) -> frozenset[ComponentId]:
        """Pieces that are no stock any more, because they are placed at a target."""
        return frozenset(p.piece for p in self.placed.values())

    @property
    def excluded(self) -> frozenset[ComponentId]:
        """Targets that must not be proposed now."""
        return frozenset(self.refused) | frozenset(self.needs_rework)

    @property
    def is_at_end(self) -> bool:
        """Whether no target is left that could be proposed."""
        return all(t in self.installed or t in self.excluded for t in self.targets)

    def is_secured(self, target: ComponentId) -> bool:
        """Whether a target stands and has all its operations."""
        needed = self.operations.get(target, ())
        return target in self.standing and all(o in self.done_operations for o in needed)


def site_of(model: BuildingModel) -> SiteState:
    """Return the empty site of a design: nothing built, nothing sensed."""
    targets = tuple(c for c in model.component_by_id.values() if c.layer is Layer.TARGET)
    return SiteState(
        targets=tuple(c.id for c in targets),
        operations={c.id: tuple(o.id for o in c.operations) for c in targets},
    )
