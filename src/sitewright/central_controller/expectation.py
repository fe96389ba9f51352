"""What should be sensed, compared with what is: deviations, contradictions, effects."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping

from sitewright.central_controller.events import (
    AnyEvent,
    ComponentDisplaced,
    ComponentInstalled,
    ComponentPositioned,
    ComponentStanding,
    DeviationSeen,
    OperationDone,
    SkillIntent,
)
from sitewright.central_controller.site_fold import site_after
from sitewright.central_controller.site_state import SiteState
from sitewright.foundation.canonical import Json
from sitewright.foundation.ids import ComponentId, OperationId, RobotId
from sitewright.foundation.pose import Pose, Quaternion, Vector
from sitewright.foundation.sentence import Sentence
from sitewright.robot_team.driver import Observation
from sitewright.robot_team.skill import Skill

LEVEL_0 = (0.002, math.radians(0.2))
LEVEL_1 = (0.010, math.radians(1.0))
JOINT_TOLERANCE_RAD = 0.010
_LETS_GO = (Skill.RELEASE, Skill.SET_DOWN)


def level_of(expected: Pose, sensed: Pose) -> int:
    """Return 0, 1 or 2: how far a pose is from what was expected."""
    distance_m, angle_rad = expected.distance_to_m(sensed), expected.angle_to_rad(sensed)
    for level, (most_m, most_rad) in enumerate((LEVEL_0, LEVEL_1)):
        if distance_m <= most_m and angle_rad <= most_rad:
            return level
    return 2


def unasked_changes(
    site: SiteState,
    now: Observation,
    *,
    intent: SkillIntent | None = None,
    strays: frozenset[ComponentId] = frozenset(),
) -> tuple[DeviationSeen, ...]:
    """Return what changed on the site though nothing (or only `intent`) was to change it.

    Args:
        site: The folded site with what was sensed before.
        now: What is sensed now.
        intent: The skill whose effects are looked at.
        strays: Pieces that lay, and still lie, where nothing relies on them. They may roll on;
            whether they got in the way is for the certificate to say.
    """
    if site.sensed is None:
        return ()
    call = intent.call if intent is not None else None
    mover = call.robot if call is not None else None
    after = intent.command_id if intent is not None else ""
    found = [
        *_robots_moved(site.sensed, now, mover),
        *_pieces_dropped(site.sensed, now, call.robot if call and call.skill in _LETS_GO else None),
        *_pieces_moved(site, now, strays | _exempt(intent, site.sensed, now)),
    ]
    return tuple(
        DeviationSeen(level=level, subject=subject, what=what, after=after)
        for level, subject, what in found
    )


def _exempt(
    intent: SkillIntent | None, before: Observation, now: Observation
) -> frozenset[ComponentId]:
    """Pieces whose motion is explained: in a gripper, or handled by the skill itself."""
    gripped = {r.gripped for o in (before, now) for r in o.robots.values() if r.gripped}
    handled = intent.params.get("piece") if intent is not None else None
    if isinstance(handled, str):
        gripped.add(ComponentId(handled))
    return frozenset(gripped)


_Finding = tuple[int, str, str]


def _robots_moved(
    before: Observation, now: Observation, mover: RobotId | None
) -> Iterator[_Finding]:
    for robot, was in before.robots.items():
        state = now.robots.get(robot)
        if state is None:
            yield 3, robot, Sentence("the robot is not sensed any more")
        elif robot != mover and state.mounted != was.mounted:
            yield (
                2,
                robot,
                Sentence(
                    "carries {tool}, not {other}", tool=str(state.mounted), other=str(was.mounted)
                ),
            )
        elif robot != mover:
            turned = max(abs(a - b) for a, b in zip(was.q_rad, state.q_rad, strict=True))
            if turned > JOINT_TOLERANCE_RAD:
                yield (
                    1,
                    robot,
                    Sentence(
                        "a joint moved by {by_rad:.3f} (rad, m on a rail) though it was at rest",
                        by_rad=turned,
                    ),
                )


def _pieces_dropped(
    before: Observation, now: Observation, lets_go: RobotId | None
) -> Iterator[_Finding]:
    for robot, was in before.robots.items():
        state = now.robots.get(robot)
        if was.gripped is None or robot == lets_go or state is None:
            continue
        if state.gripped != was.gripped:
            yield 2, was.gripped, Sentence("is not in the gripper of {robot} any more", robot=robot)


def _pieces_moved(
    site: SiteState, now: Observation, exempt: frozenset[ComponentId]
) -> Iterator[_Finding]:
    assert site.sensed is not None  # noqa: S101 -- the caller looked
    done = {site.placed[t].piece for t in site.installed if t in site.placed}
    for piece, was in site.sensed.world_T_piece.items():
        if piece in exempt:
            continue
        pose = now.world_T_piece.get(piece)
        if pose is None:
            yield 2, piece, Sentence("is not seen any more")
            continue
        level = level_of(was, pose)
        if level:
            moved_mm, angle_deg = (
                was.distance_to_m(pose) * 1e3,
                math.degrees(was.angle_to_rad(pose)),
            )
            is_worse = piece in done and level == 2  # noqa: PLR2004 -- a deviation level
            what = Sentence(
                "moved by {by_mm:.1f} mm and {by_deg:.2f} deg", by_mm=moved_mm, by_deg=angle_deg
            )
            worse = Sentence("{what} after it was installed", what=what)
            yield (3, piece, worse) if is_worse else (level, piece, what)


def contradictions(intent: SkillIntent, now: Observation) -> tuple[DeviationSeen, ...]:
    """Return where the sensors do not show what a skill reported as done."""
    text = _contradiction(intent, now)
    if not text:
        return ()
    subject = intent.call.arguments[0] if intent.call.arguments else intent.call.robot
    return (DeviationSeen(level=2, subject=subject, what=text, after=intent.command_id),)


def _contradiction(  # noqa: C901, PLR0911 -- one line per skill
    intent: SkillIntent, now: Observation
) -> str:
    params, state = intent.params, now.robots.get(intent.call.robot)
    if state is None:
        return Sentence("robot {robot} is not sensed", robot=intent.call.robot)
    piece = params.get("piece")
    match intent.call.skill:
        case Skill.GRASP if state.gripped != piece:
            return Sentence("{piece} is not sensed in the gripper", piece=str(piece))
        case Skill.POSITION:
            return _off_place(params, now)
        case Skill.RELEASE | Skill.SET_DOWN if state.gripped == piece:
            return Sentence("{piece} is still sensed in the gripper", piece=str(piece))
        case Skill.SET_DOWN:
            return _off_place(params, now)
        case Skill.FASTEN if params.get("operation") not in {f.operation for f in now.fasteners}:
            return Sentence(
                "the fastener {operation} is not sensed", operation=str(params.get("operation"))
            )
        case Skill.APPLY_FINISH:
            return _too_thin(params, now)
        case Skill.CHANGE_END_EFFECTOR if state.mounted != params.get("new"):
            return Sentence(
                "{tool} is mounted, not {other}",
                tool=str(state.mounted),
                other=str(params.get("new")),
            )
        case _:
            return ""


def _off_place(params: Mapping[str, Json], now: Observation) -> str:
    wanted, sensed = pose_of(params["world_T_piece"]), now.world_T_piece.get(_piece(params))
    if sensed is None:
        return Sentence("{piece} is not seen", piece=_piece(params))
    off_m, off_rad = wanted.distance_to_m(sensed), wanted.angle_to_rad(sensed)
    if off_m <= _number(params, "tolerance_m") and off_rad <= _number(params, "tolerance_rad"):
        return ""
    return Sentence(
        "{piece} is {off_mm:.1f} mm and {off_deg:.2f} deg off",
        piece=_piece(params),
        off_mm=off_m * 1e3,
        off_deg=math.degrees(off_rad),
    )


def _too_thin(params: Mapping[str, Json], now: Observation) -> str:
    share = now.coverage.get(OperationId(str(params.get("operation"))), 0.0)
    if share >= _number(params, "coverage"):
        return ""
    return Sentence(
        "only {share:.0%} of {operation} is covered",
        share=share,
        operation=str(params.get("operation")),
    )


def effects(intent: SkillIntent, site: SiteState, now: Observation, *, by: str) -> list[AnyEvent]:
    """Return the events by which a skill that is done changes the site, those not there yet."""
    events = [e for text in intent.effects for e in _effect(text, intent, site, now, by)]
    for event in events:
        site = site_after(site, event)
    target = intent.target
    placed = site.placed.get(target)
    if placed is not None and site.is_secured(target) and target not in site.installed:
        measured = now.world_T_piece.get(placed.piece, placed.world_T_measured)
        events.append(
            ComponentInstalled(
                target=target,
                piece=placed.piece,
                robot=placed.robot,
                world_T_wanted=placed.world_T_wanted,
                world_T_measured=measured,
            )
        )
    return events


def _effect(
    text: str, intent: SkillIntent, site: SiteState, now: Observation, by: str
) -> Iterator[AnyEvent]:
    match text.strip("()").split():
        case ["in-place", piece, target] if ComponentId(target) not in site.placed:
            wanted = pose_of(intent.params["world_T_piece"])
            yield ComponentPositioned(
                target=ComponentId(target),
                piece=ComponentId(piece),
                robot=intent.call.robot,
                world_T_wanted=wanted,
                world_T_measured=now.world_T_piece.get(ComponentId(piece), wanted),
            )
        case ["standing", target] if ComponentId(target) not in site.standing:
            yield ComponentStanding(target=ComponentId(target))
        case ["fastened" | "finished", operation] if operation not in site.done_operations:
            yield OperationDone(
                operation=OperationId(operation),
                target=intent.target,
                robot=intent.call.robot,
                by=by,
            )
        case _:
            pass


def displaced(site: SiteState, now: Observation) -> list[AnyEvent]:
    """Return the positioned pieces that left their target before they stood there."""
    gone: list[AnyEvent] = []
    for target, placed in site.placed.items():
        pose = now.world_T_piece.get(placed.piece)
        if target in site.standing or any(
            o in site.done_operations for o in site.operations.get(target, ())
        ):
            continue
        if pose is None or level_of(placed.world_T_measured, pose) > 1:
            gone.append(ComponentDisplaced(target=target, piece=placed.piece))
    return gone


def pose_of(value: Json) -> Pose:
    """Return a pose of skill parameters, ``{"p_m": [..], "q_wxyz": [..]}``."""
    if not isinstance(value, Mapping):
        raise TypeError(f"{value!r} is no pose")
    x, y, z = _floats(value["p_m"])
    w, i, j, k = _floats(value["q_wxyz"])
    position: Vector = (x, y, z)
    quaternion: Quaternion = (w, i, j, k)
    return Pose(position, quaternion)


def _floats(value: Json) -> list[float]:
    if isinstance(value, list | tuple):
        return [float(v) for v in value if isinstance(v, int | float)]
    raise TypeError(f"{value!r} is no list of numbers")


def _number(params: Mapping[str, Json], name: str) -> float:
    value = params[name]
    if isinstance(value, int | float):
        return float(value)
    raise TypeError(f"{name} is {value!r}, not a number")


def _piece(params: Mapping[str, Json]) -> ComponentId:
    return ComponentId(str(params["piece"]))


def settled_by_sensors(intent: SkillIntent, now: Observation) -> bool:
    """Return whether the sensors show that a skill without outcome took effect."""
    return not _contradiction(intent, now)
