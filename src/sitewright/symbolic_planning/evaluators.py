"""What each predicate means: its truth now, and what it must be after the installation."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from enum import Enum

from sitewright.building_model.component import Layer
from sitewright.construction_graph.graph import TargetNode
from sitewright.construction_graph.queries import is_ready
from sitewright.foundation.ids import ComponentId, EndEffectorId, OperationId, RobotId
from sitewright.robot_team.cell import EndEffector, FastenerRange
from sitewright.symbolic_planning.site_index import SiteIndex, bare_flange

_DIAMETER_TOLERANCE_M = 1e-4
_LENGTH_TOLERANCE_M = 1e-4


class Truth(Enum):
    """Answer of an evaluator."""

    TRUE = "true"
    FALSE = "false"
    ANY = "any"
    """After the installation: does not matter."""


Evaluate = Callable[[tuple[str, ...], SiteIndex], Truth]


@dataclass(frozen=True, slots=True)
class Evaluator:
    """Meaning of a predicate.

    Attributes:
        types: Types of its arguments; a domain's declaration may narrow them, not change them.
        now: Truth in the state as sensed.
        after: Truth that the installed state must have.
    """

    types: tuple[str, ...]
    now: Evaluate
    after: Evaluate


def _truth(value: bool) -> Truth:  # noqa: FBT001 (a conversion)
    return Truth.TRUE if value else Truth.FALSE


def _any(_args: tuple[str, ...], _site: SiteIndex) -> Truth:
    return Truth.ANY


def _true(_args: tuple[str, ...], _site: SiteIndex) -> Truth:
    return Truth.TRUE


def _false(_args: tuple[str, ...], _site: SiteIndex) -> Truth:
    return Truth.FALSE


def _if_installed(wanted: Truth) -> Evaluate:
    """Return what installing the target asks for; an errand leaves the target as it is."""

    def after(_args: tuple[str, ...], site: SiteIndex) -> Truth:
        return Truth.ANY if site.view.errand is not None else wanted

    return after


# --- what cell and model know -----------------------------------------------------------------


def _can(args: tuple[str, ...], site: SiteIndex) -> Truth:
    robot = site.view.cell.robot_by_id[RobotId(args[0])]
    return _truth(any(args[1] == c for c in robot.can))


def _accepts(args: tuple[str, ...], site: SiteIndex) -> Truth:
    robot = site.view.cell.robot_by_id[RobotId(args[0])]
    return _truth(args[1] in robot.end_effectors or args[1] == bare_flange(robot.id))


def _matches(args: tuple[str, ...], site: SiteIndex) -> Truth:
    piece, target = ComponentId(args[0]), ComponentId(args[1])
    if target == site.view.target:
        return _truth(piece in site.view.candidates)
    return _truth(site.view.in_place.get(target) == piece)


def _ready(args: tuple[str, ...], site: SiteIndex) -> Truth:
    node = site.view.graph.node_by_id.get(ComponentId(args[0]))
    if isinstance(node, TargetNode):
        return _truth(is_ready(site.view.graph, node))
    return _truth(node is not None and node.layer is Layer.AS_BUILT)


def _spot_of(args: tuple[str, ...], site: SiteIndex) -> Truth:
    return _truth(site.target_of.get(OperationId(args[0])) == args[1])


def _driven_after(args: tuple[str, ...], site: SiteIndex) -> Truth:
    return _truth((args[0], args[1]) in site.driven_after)


def _drives(args: tuple[str, ...], site: SiteIndex) -> Truth:
    tool = site.view.cell.end_effector_by_id[EndEffectorId(args[0])]
    operation = site.fasteners[OperationId(args[1])]
    if operation.process not in tool.processes:
        return Truth.FALSE
    if operation.fastener is None:
        return Truth.TRUE
    spec = operation.fastener
    return _truth(any(_fits(spec.type, spec.d_m, spec.l_m, r) for r in tool.fasteners))


def _fits(kind: str, d_m: float, l_m: float, offer: FastenerRange) -> bool:
    return (
        offer.type == kind
        and abs(offer.d_m - d_m) <= _DIAMETER_TOLERANCE_M
        and offer.l_min_m - _LENGTH_TOLERANCE_M <= l_m <= offer.l_max_m + _LENGTH_TOLERANCE_M
    )


def _applies(args: tuple[str, ...], site: SiteIndex) -> Truth:
    tool: EndEffector = site.view.cell.end_effector_by_id[EndEffectorId(args[0])]
    return _truth(site.finishes[OperationId(args[1])].process in tool.processes)


# --- what the planning twin knows -------------------------------------------------------------


def _can_reach(args: tuple[str, ...], site: SiteIndex) -> Truth:
    return _truth(args in site.view.geometry.can_reach)


def _can_grasp(args: tuple[str, ...], site: SiteIndex) -> Truth:
    return _truth(args in site.view.geometry.can_grasp)


def _can_place(args: tuple[str, ...], site: SiteIndex) -> Truth:
    return _truth(args in site.view.geometry.can_place)


def _can_set_down(args: tuple[str, ...], site: SiteIndex) -> Truth:
    return _truth(args in site.view.geometry.can_set_down)


def _excludes(args: tuple[str, ...], site: SiteIndex) -> Truth:
    return _truth(args in site.view.geometry.excludes)


def _tacks(args: tuple[str, ...], site: SiteIndex) -> Truth:
    return _truth(args in site.view.geometry.tacks)


# --- what skills change -----------------------------------------------------------------------


def _at(args: tuple[str, ...], site: SiteIndex) -> Truth:
    return _truth(site.view.robot_status[RobotId(args[0])].place == args[1])


def _at_after(args: tuple[str, ...], site: SiteIndex) -> Truth:
    return Truth.TRUE if site.preparation[RobotId(args[0])] == args[1] else Truth.ANY


def _in_transit(args: tuple[str, ...], site: SiteIndex) -> Truth:
    return _truth(site.view.robot_status[RobotId(args[0])].place is None)


def _mobile(args: tuple[str, ...], site: SiteIndex) -> Truth:
    return _truth(site.view.robot_status[RobotId(args[0])].steadying is None)


def _vacant(args: tuple[str, ...], site: SiteIndex) -> Truth:
    return _truth(args[0] not in site.occupied)


def _hand_empty(args: tuple[str, ...], site: SiteIndex) -> Truth:
    status = site.view.robot_status[RobotId(args[0])]
    return _truth(status.holding is None and status.steadying is None)


def _holding(args: tuple[str, ...], site: SiteIndex) -> Truth:
    return _truth(site.view.robot_status[RobotId(args[0])].holding == args[1])


def _steadying(args: tuple[str, ...], site: SiteIndex) -> Truth:
    return _truth(site.view.robot_status[RobotId(args[0])].steadying == args[1])


def _mounted(args: tuple[str, ...], site: SiteIndex) -> Truth:
    robot = RobotId(args[0])
    return _truth((site.view.robot_status[robot].mounted or bare_flange(robot)) == args[1])


def _docked(args: tuple[str, ...], site: SiteIndex) -> Truth:
    end_effector = EndEffectorId(args[0])
    station = site.view.docked.get(end_effector) or site.bare_dock.get(end_effector)
    return _truth(station == args[1])


def _lies_at(args: tuple[str, ...], site: SiteIndex) -> Truth:
    return _truth(site.view.lies_at.get(ComponentId(args[0])) == args[1])


def _lies_at_after(args: tuple[str, ...], site: SiteIndex) -> Truth:
    errand = site.view.errand
    is_wanted = errand is not None and args == (errand.piece, errand.place)
    return Truth.TRUE if is_wanted else Truth.ANY


def _accessible(args: tuple[str, ...], site: SiteIndex) -> Truth:
    piece = ComponentId(args[0])
    return _truth(piece in site.view.lies_at and piece not in site.covered)


def _is_standing(target: ComponentId, site: SiteIndex) -> bool:
    node = site.view.graph.node_by_id.get(target)
    is_built = node is not None and node.layer is Layer.AS_BUILT
    return is_built or target in site.view.standing


def _is_positioned(target: ComponentId, site: SiteIndex) -> bool:
    return target in site.view.in_place or _is_standing(target, site)


def _pending(args: tuple[str, ...], site: SiteIndex) -> Truth:
    return _truth(not _is_positioned(ComponentId(args[0]), site))


def _positioned(args: tuple[str, ...], site: SiteIndex) -> Truth:
    return _truth(_is_positioned(ComponentId(args[0]), site))


def _standing(args: tuple[str, ...], site: SiteIndex) -> Truth:
    return _truth(_is_standing(ComponentId(args[0]), site))


def _in_place(args: tuple[str, ...], site: SiteIndex) -> Truth:
    return _truth(site.view.in_place.get(ComponentId(args[1])) == args[0])


def _in_place_after(args: tuple[str, ...], site: SiteIndex) -> Truth:
    piece, target = ComponentId(args[0]), ComponentId(args[1])
    placed = site.view.in_place.get(target)
    if placed is not None:
        return Truth.TRUE if placed == piece else Truth.ANY
    is_only = target == site.view.target and site.view.candidates == (piece,)
    return Truth.TRUE if is_only else Truth.ANY


def _done(args: tuple[str, ...], site: SiteIndex) -> Truth:
    return _truth(args[0] in site.view.done_operations)


EVALUATORS: Mapping[str, Evaluator] = {
    "can": Evaluator(("robot", "skill"), _can, _any),
    "accepts": Evaluator(("robot", "end-effector"), _accepts, _any),
    "can-reach": Evaluator(("robot", "place"), _can_reach, _any),
    "can-grasp": Evaluator(("robot", "gripper", "thing"), _can_grasp, _any),
    "can-place": Evaluator(("robot", "thing", "target"), _can_place, _any),
    "can-set-down": Evaluator(("robot", "thing", "stock-place"), _can_set_down, _any),
    "excludes": Evaluator(("robot", "place", "place"), _excludes, _any),
    "matches": Evaluator(("thing", "target"), _matches, _any),
    "ready": Evaluator(("target",), _ready, _if_installed(Truth.TRUE)),
    "spot-of": Evaluator(("place", "target"), _spot_of, _any),
    "tacks": Evaluator(("fastener", "target"), _tacks, _any),
    "driven-after": Evaluator(("place", "fastener"), _driven_after, _any),
    "drives": Evaluator(("tool", "fastener"), _drives, _any),
    "applies": Evaluator(("tool", "finish"), _applies, _any),
    "at": Evaluator(("robot", "place"), _at, _at_after),
    "in-transit": Evaluator(("robot",), _in_transit, _any),
    "mobile": Evaluator(("robot",), _mobile, _true),
    "vacant": Evaluator(("place",), _vacant, _any),
    "hand-empty": Evaluator(("robot",), _hand_empty, _true),
    "holding": Evaluator(("robot", "thing"), _holding, _false),
    "steadying": Evaluator(("robot", "target"), _steadying, _false),
    "mounted": Evaluator(("robot", "end-effector"), _mounted, _any),
    "docked": Evaluator(("end-effector", "tool-station"), _docked, _any),
    "lies-at": Evaluator(("thing", "stock-place"), _lies_at, _lies_at_after),
    "accessible": Evaluator(("thing",), _accessible, _any),
    "pending": Evaluator(("target",), _pending, _if_installed(Truth.FALSE)),
    "in-place": Evaluator(("thing", "target"), _in_place, _in_place_after),
    "positioned": Evaluator(("target",), _positioned, _if_installed(Truth.TRUE)),
    "standing": Evaluator(("target",), _standing, _if_installed(Truth.TRUE)),
    "fastened": Evaluator(("fastener",), _done, _if_installed(Truth.TRUE)),
    "finished": Evaluator(("finish",), _done, _if_installed(Truth.TRUE)),
}
"""Every predicate that a domain file may use."""
