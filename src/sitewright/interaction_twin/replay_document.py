"""A whole run to be looked at again: everything that was sensed, and what ran in between."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from sitewright.central_controller.events import (
    AnyEvent,
    ComponentDisplaced,
    ComponentInstalled,
    ComponentPositioned,
    SiteObserved,
    SkillOutcome,
)
from sitewright.central_controller.site_state import SiteState
from sitewright.foundation.canonical import Json
from sitewright.foundation.ids import ComponentId, RobotId
from sitewright.foundation.pose import Pose
from sitewright.interaction_twin.drawing.bars import Bar
from sitewright.interaction_twin.report.content import Stamped
from sitewright.interaction_twin.report.timeline import timeline
from sitewright.interaction_twin.scene_document import pose_json
from sitewright.robot_team.driver import Observation, RobotObservation


@dataclass(frozen=True, slots=True, kw_only=True)
class ReplaySource:
    """What the document is made of.

    Attributes:
        before: The site when the run began, with what was sensed last.
        world_T_mount: Where each end effector that has a dock is when it is in it.
        history: All records of the run.
    """

    run: str
    before: SiteState
    world_T_mount: Mapping[str, Pose]
    history: Sequence[Stamped]


def replay_document(source: ReplaySource) -> dict[str, Json]:
    """Return the run on the axis of its schedule: seconds of the cell since the first skill.

    ``moments`` are differences: whoever puts those up to a time together has what was sensed then.
    """
    found = timeline(s.event for s in source.history)
    clock = list(_clock(source.history, found.zero_s))
    start = source.before.sensed or Observation(time_s=0.0, robots={}, world_T_piece={})
    ends_s = [b.ends_s for b in found.actual] + [at_s for _, at_s in clock]
    return {
        "run": source.run,
        "duration_s": round(max(ends_s, default=0.0), 6),
        "start": {**_sensed(start.robots, start.world_T_piece), "gone": []},
        "docks": {t: pose_json(pose) for t, pose in source.world_T_mount.items()},
        "placed": {t: p.piece for t, p in source.before.placed.items()},
        "events": [{"n": s.number, "at_s": at_s} for s, at_s in clock],
        "moments": [
            {
                "n": s.number,
                "at_s": at_s,
                **_sensed(s.event.robots, s.event.world_T_piece),
                "gone": list(s.event.gone),
            }
            for s, at_s in clock
            if isinstance(s.event, SiteObserved)
        ],
        "placings": [
            {"n": s.number, "at_s": at_s, "target": target, "piece": piece}
            for s, at_s in clock
            for target, piece in _placing(s.event)
        ],
        "skills": [_skill(bar) for bar in found.actual],
    }


def _clock(history: Sequence[Stamped], zero_s: float) -> Iterator[tuple[Stamped, float]]:
    """Yield each record with its time on the axis; a report comes when its skill has ended."""
    now_s = zero_s
    for stamped in history:
        match stamped.event:
            case SiteObserved(time_s=time_s):
                now_s = time_s
            case SkillOutcome(report=report):
                now_s += report.duration_s
            case _:
                pass
        yield stamped, round(max(0.0, now_s - zero_s), 6)


def _sensed(
    robots: Mapping[RobotId, RobotObservation], pieces: Mapping[ComponentId, Pose]
) -> dict[str, Json]:
    return {
        "robots": {
            name: {
                "q_rad": [round(q, 6) for q in robot.q_rad],
                "mounted": robot.mounted,
                "aperture_m": round(robot.aperture_m, 6),
                "gripped": robot.gripped,
            }
            for name, robot in robots.items()
        },
        "pieces": {piece: pose_json(pose) for piece, pose in pieces.items()},
    }


def _placing(event: AnyEvent) -> Iterator[tuple[str, str | None]]:
    match event:
        case ComponentPositioned(target=target, piece=piece):
            yield target, piece
        case ComponentInstalled(target=target, piece=piece):
            yield target, piece
        case ComponentDisplaced(target=target):
            yield target, None
        case _:
            pass


def _skill(bar: Bar) -> Json:
    return {
        "robot": bar.robot,
        "step": bar.step,
        "fingerprint": bar.fingerprint,
        "starts_s": round(bar.starts_s, 6),
        "duration_s": round(bar.duration_s, 6),
    }
