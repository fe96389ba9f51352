"""Continuous proof that a path keeps its distances, by conservative advancement."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np
from typing_extensions import override

from sitewright.foundation.ids import RobotId
from sitewright.planning_twin.backends.advancement import Advancement, TooNear
from sitewright.planning_twin.backends.distances import EPS_M, DistanceEngine, lower_bounds
from sitewright.planning_twin.backends.path_lines import PathLines, lines_of
from sitewright.planning_twin.backends.proof_scene import ProofScene, ProofScenes
from sitewright.planning_twin.backends.surroundings import whole
from sitewright.planning_twin.backends.team_pairs import tables_of
from sitewright.planning_twin.moment import by_robot, moment_of
from sitewright.planning_twin.motion import Certificate, Certifier, JointPath, TeamPath
from sitewright.planning_twin.refusal import NotClear
from sitewright.planning_twin.scene import SceneSnapshot
from sitewright.robot_team.description import Joints

STANDING_SHARE = 0.5
"""Pairs that the motion leaves alone must keep this share of the clearance."""


class ConservativeAdvancement(Certifier):
    """Proves every pair of every segment, between the samples too.

    A pair is proven on an interval of a line if its distance in the middle is at least its
    threshold, plus how far its parts can come nearer within the interval, plus a reserve for
    the distance engine. Otherwise the interval is halved for that pair.

    Pairs that the path does not move were certified by the motion that brought them there, and
    sensed postures never repeat to the bit; they are looked at once and must keep half of the
    clearance, or their own threshold where they are declared.

    Bodies that no arm can come near to with its rails where this path has them are proven far
    away by lengths alone (see `SceneParts`), with all their pairs.
    """

    def __init__(self, scenes: ProofScenes, *, is_strict: bool = False) -> None:
        self._scenes = scenes
        self._engine = DistanceEngine(is_strict=is_strict)

    @override
    def certify(self, scene: SceneSnapshot, path: JointPath | TeamPath) -> Certificate | NotClear:
        part = self._scenes.around(scene, _postures(scene, path))
        search = self._proven(self._scenes.of(part.scene), path)
        if isinstance(search, NotClear):
            return _with_moment(scene, path, search)
        closest = search.closest()
        if closest.distance_m > part.beyond_m:
            # something that is left out might be nearer than that
            part = whole(scene)
            search = self._proven(self._scenes.of(scene), path)
            if isinstance(search, NotClear):
                return _with_moment(scene, path, search)
            closest = search.closest()
        layout = self._scenes.of(part.scene).layout
        near = sum(len(table.names) for table in tables_of(layout, path.robots))
        return Certificate(
            scene_revision=self._scenes.revision(scene),
            path_sha256=path.sha256(),
            clearance_m=scene.clearance_m,
            closest_distance_m=closest.distance_m,
            closest_pair=closest.pair,
            closest_at=closest.at,
            eps_m=EPS_M,
            pairs=near + part.left_out * layout.movable,
            evaluations=search.evaluations,
            engine=f"{self._engine.name}{', strict' if self._engine.is_strict else ''}",
        )

    @override
    def objection(self, scene: SceneSnapshot, path: JointPath | TeamPath) -> NotClear | None:
        part = self._scenes.around(scene, _postures(scene, path))
        found = self._proven(self._scenes.of(part.scene), path)
        return _with_moment(scene, path, found) if isinstance(found, NotClear) else None

    def _proven(self, proof: ProofScene, path: JointPath | TeamPath) -> Advancement | NotClear:
        lines = lines_of(path)
        standing = self._standing_too_near(proof, path)
        if standing is not None:
            return standing
        search = Advancement(proof, path, lines, self._engine)
        found = search.prove()
        return _not_clear(lines, found) if isinstance(found, TooNear) else search

    def _standing_too_near(self, proof: ProofScene, path: JointPath | TeamPath) -> NotClear | None:
        _, table = tables_of(proof.layout, path.robots)
        placed = proof.standing()
        rows = np.arange(len(table.a))
        first = np.zeros(len(rows), dtype=np.intp)
        bounds = lower_bounds(proof.layout, placed, table, first, rows)
        for number, segment in enumerate(path.segments):
            tau = table.thresholds(proof.clearance_m * STANDING_SHARE, segment.threshold_m)
            asked = np.flatnonzero(bounds < tau + EPS_M)
            distances = self._engine.distances(
                proof.layout, placed, table, first[: len(asked)], asked
            )
            bounds[asked] = np.maximum(bounds[asked], distances)
            bad = np.flatnonzero(bounds < tau + EPS_M)
            if len(bad):
                worst = int(bad[np.argmin((bounds - tau)[bad])])
                return NotClear(
                    pair=table.names[table.name[worst]],
                    q_rad=segment.waypoints_rad[0],
                    distance_m=float(bounds[worst]),
                    threshold_m=float(tau[worst]),
                    segment=number,
                )
        return None


def _with_moment(scene: SceneSnapshot, path: JointPath | TeamPath, found: NotClear) -> NotClear:
    moved = by_robot(scene, path.robots, found.q_rad)
    return replace(found, moment=moment_of(scene, moved, found.pair))


def _postures(scene: SceneSnapshot, path: JointPath | TeamPath) -> Mapping[RobotId, list[Joints]]:
    """Return the corners of the path, robot by robot."""
    waypoints = [q for segment in path.segments for q in segment.waypoints_rad]
    whose = [by_robot(scene, path.robots, q) for q in waypoints]
    return {robot: [q[robot] for q in whose] for robot in path.robots}


def _not_clear(lines: PathLines, found: TooNear) -> NotClear:
    q = lines.at(np.array([found.line]), np.array([found.share]))[0]
    return NotClear(
        pair=found.pair,
        q_rad=tuple(float(v) for v in q),
        distance_m=found.distance_m,
        threshold_m=found.threshold_m,
        segment=int(lines.segment[found.line]),
    )
