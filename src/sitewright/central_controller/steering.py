"""What people change beside the plan: keep-out zones, work by hand, a model that is wrong."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace

from sitewright.central_controller.design import Design
from sitewright.central_controller.events import (
    AnyEvent,
    ComponentInstalled,
    ComponentStanding,
    DeviationSeen,
    DoneByHand,
    OperationDone,
    RunHeld,
    ZoneDrawn,
    ZoneRemoved,
)
from sitewright.central_controller.ports import ByHand, DrawZone, Mismatch, RemoveZone
from sitewright.central_controller.site_fold import site_after
from sitewright.central_controller.site_state import DrawnZone, SiteState
from sitewright.foundation.ids import ComponentId, OperationId, RobotId, ZoneId
from sitewright.foundation.sentence import Sentence
from sitewright.foundation.shapes import Box
from sitewright.robot_team.cell import Zone

HELD_BY_PERSON = 7
_NEEDS_PERSON = 3
_PERSON = RobotId("person")
_PREFIX = "keep-out"

Steering = Mismatch | DrawZone | RemoveZone | ByHand


def steered(site: SiteState, wish: Steering) -> tuple[str, list[AnyEvent]]:
    """Return why the open plan goes, and what is recorded before and after that.

    The first event of the list carries the decision, except for a mismatch, where the last does.
    """
    match wish:
        case DrawZone():
            return Sentence("{who} drew a keep-out zone.", who=wish.who), [_drawn(site, wish)]
        case RemoveZone(who=who, zone=zone, decision=decision):
            removed = ZoneRemoved(zone=zone, who=who, decision=decision)
            return Sentence("{who} removed {zone}.", who=who, zone=zone), [removed]
        case ByHand():
            why = Sentence("{who} did work on {target} by hand.", who=wish.who, target=wish.target)
            return why, list(_by_hand(site, wish))
        case Mismatch():
            why = Sentence("{component} does not match the site.", component=wish.component)
            return why, list(_mismatch(wish))


def hand_facts(site: SiteState) -> Mapping[ComponentId, tuple[str, ...]]:
    """Return what a person can vouch for: of targets whose piece was sensed in place.

    Where a piece is must be sensed; that it stands by itself and what is driven into it, or on
    it, a person may have done.
    """
    found: dict[ComponentId, tuple[str, ...]] = {}
    for target in site.placed:
        if target in site.installed:
            continue
        standing = () if target in site.standing else (f"(standing {target})",)
        left = (o for o in site.operations.get(target, ()) if o not in site.done_operations)
        found[target] = (*standing, *(f"(done {o})" for o in left))
    return found


def with_zones(design: Design, site: SiteState) -> Design:
    """Return the design with the zones that people drew."""
    if not site.zones:
        return design
    drawn = {
        z.id: Zone(id=z.id, shape=(Box(z.size_m),), world_T_zone=z.world_T_zone)
        for z in site.zones.values()
    }
    return replace(
        design, cell=replace(design.cell, zone_by_id={**design.cell.zone_by_id, **drawn})
    )


def _drawn(site: SiteState, wish: DrawZone) -> ZoneDrawn:
    numbers = [int(z.removeprefix(f"{_PREFIX}-")) for z in site.zones if z.startswith(_PREFIX)]
    zone = DrawnZone(
        id=ZoneId(f"{_PREFIX}-{max(numbers, default=0) + 1}"),
        size_m=wish.size_m,
        world_T_zone=wish.world_T_zone,
        who=wish.who,
    )
    return ZoneDrawn(zone=zone, who=wish.who, decision=wish.decision)


def _by_hand(site: SiteState, wish: ByHand) -> Iterator[AnyEvent]:
    yield DoneByHand(target=wish.target, effects=wish.effects, who=wish.who, decision=wish.decision)
    for effect in wish.effects:
        event = _effect(effect, wish.target)
        site = site_after(site, event)
        yield event
    placed = site.placed.get(wish.target)
    if placed is not None and site.is_secured(wish.target) and wish.target not in site.installed:
        yield ComponentInstalled(
            target=wish.target,
            piece=placed.piece,
            robot=placed.robot,
            world_T_wanted=placed.world_T_wanted,
            world_T_measured=placed.world_T_measured,
        )


def _effect(effect: str, target: ComponentId) -> AnyEvent:
    name, subject = effect.strip("()").split()
    if name == "standing":
        return ComponentStanding(target=ComponentId(subject))
    return OperationDone(operation=OperationId(subject), target=target, robot=_PERSON, by="person")


def _mismatch(wish: Mismatch) -> Iterator[AnyEvent]:
    what = Sentence("does not match the site, says {who}", who=wish.who)
    if wish.detail:
        what = Sentence("{what}: {detail}", what=what, detail=wish.detail)
    yield DeviationSeen(level=_NEEDS_PERSON, subject=wish.component, what=what)
    yield RunHeld(
        reason=Sentence(
            "{subject} {what}. Look at the cell, then resume.", subject=wish.component, what=what
        ),
        exit_code=HELD_BY_PERSON,
        who=wish.who,
        decision=wish.decision,
    )
