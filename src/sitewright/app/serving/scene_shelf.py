"""The scene document of the present epoch, worked out once beside the event loop."""

from __future__ import annotations

import asyncio
import json
from collections.abc import Callable, Mapping
from functools import lru_cache

from sitewright.app.drawn_scene import surface_of
from sitewright.app.serving.live_feed import LiveFeed
from sitewright.central_controller.expectation import pose_of
from sitewright.foundation.canonical import Json, canonical_json, sha256_hex
from sitewright.foundation.pose import Pose
from sitewright.foundation.shapes import Shape
from sitewright.interaction_twin.scene_document import (
    SceneSource,
    Triangles,
    joint_names,
    scene_document,
)


class SceneShelf:
    """Keeps the newest scene and tells the feed what its frames are about.

    Attributes:
        epoch: Counts scenes; pages that have another one ask again.
    """

    def __init__(self, feed: LiveFeed) -> None:
        self._feed = feed
        self.epoch = 1
        self._kept: tuple[str, bytes] | None = None
        self._lock = asyncio.Lock()

    def outdate(self) -> None:
        """Something is drawn otherwise from now on."""
        self.epoch, self._kept = self.epoch + 1, None

    async def get(self, source_now: Callable[[], SceneSource]) -> tuple[str, bytes]:
        """Return hash and text; a scene that is outdated while it is made is made again."""
        async with self._lock:
            while self._kept is None:
                epoch = self.epoch
                document, source = await asyncio.to_thread(_made, source_now)
                if epoch == self.epoch:
                    self._keep(document, source)
            return self._kept

    def _keep(self, document: dict[str, Json], source: SceneSource) -> None:
        digest = sha256_hex(canonical_json({**document, "epoch": self.epoch}))[:32]
        text = json.dumps({**document, "hash": digest, "epoch": self.epoch}, ensure_ascii=False)
        self._kept = (digest, text.encode())
        joints = [f"{owner}:{joint}" for owner, joint in joint_names(source.cell)]
        components = document["components"]
        assert isinstance(components, list)  # noqa: S101 -- made by `scene_document`
        self._feed.show_scene(self.epoch, joints, [_placed(c) for c in components])


def _made(source_now: Callable[[], SceneSource]) -> tuple[dict[str, Json], SceneSource]:
    source = source_now()
    return scene_document(source), source


@lru_cache(maxsize=4_096)
def triangles(shape: Shape) -> Triangles:
    """Return the faces of a shape as the document writes them; worked out once per shape."""
    surface = surface_of(shape)
    return surface.corners_m, surface.triangles


def _placed(component: Json) -> tuple[str, Pose]:
    """Return id and pose of a component of the document; no id if it has no pose."""
    assert isinstance(component, Mapping)  # noqa: S101 -- made by `scene_document`
    world_T = component["world_T"]
    if not isinstance(world_T, Mapping):
        return "", Pose()
    return str(component["id"]), pose_of(world_T)
