"""Scenes are kept as texts named by their hashes, and come back as they were."""

from __future__ import annotations

from pathlib import Path

import pytest

from motion_scenes import A, held_stud, two_arms
from sitewright.app.run_folder import RunFolder
from sitewright.foundation.canonical import sha256_hex
from sitewright.foundation.ids import BodyId
from sitewright.foundation.pose import Pose
from sitewright.foundation.shapes import Hull
from sitewright.journal.errors import JournalCorruptError
from sitewright.planning_twin.scene import Body, shape_hash
from sitewright.planning_twin.scene_texts import UnreadableSceneError, read_scene, texts_of

ROOF = Hull(((0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.1, 0.1, 1.0)))
SCENE = two_arms(held_stud(), Body(id=BodyId("roof"), shape=(ROOF,), placement=Pose((0.0, 5.0, 0))))


def test_every_text_has_the_name_of_its_hash_and_the_last_one_the_scenes() -> None:
    texts = texts_of(SCENE)
    assert all(sha256_hex(text) == digest for digest, text in texts.items())
    assert list(texts)[-1] == SCENE.revision()


def test_a_scene_that_was_read_back_is_the_same_scene() -> None:
    found = read_scene(SCENE.revision(), texts_of(SCENE).__getitem__)
    assert found.revision() == SCENE.revision()
    assert found.bodies == SCENE.bodies
    assert found.robots[A].q_rad == SCENE.robots[A].q_rad
    joints = [(j.name, j.axis, j.parent_T_joint) for j in found.robots[A].description.joints]
    assert joints == [
        (j.name, j.axis, j.parent_T_joint) for j in SCENE.robots[A].description.joints
    ]


def test_equal_shapes_are_kept_once(tmp_path: Path) -> None:
    folder = RunFolder(tmp_path)
    folder.keep_scene(SCENE)
    before = {p.name for p in (tmp_path / "blobs").iterdir()}
    moved = SCENE.placed(BodyId("stock-0"), Pose((0.0, 0.0, 3.0)))
    folder.keep_scene(moved)
    after = {p.name for p in (tmp_path / "blobs").iterdir()}
    assert after - before == {moved.revision()}
    assert RunFolder(tmp_path).load_scene(moved.revision()).bodies == moved.bodies


def test_a_text_that_was_changed_is_found_out(tmp_path: Path) -> None:
    folder = RunFolder(tmp_path)
    folder.keep_scene(SCENE)
    file = tmp_path / "blobs" / SCENE.revision()
    file.write_text(file.read_text().replace("0.4", "0.5", 1))
    with pytest.raises(JournalCorruptError, match="changed after it was written"):
        folder.load_scene(SCENE.revision())


@pytest.mark.parametrize("text", ["[]", "{}", '{"robots": {"a": [1]}}', "no json"])
def test_a_text_that_is_no_scene_is_named(text: str) -> None:
    digest = sha256_hex(text)
    with pytest.raises(UnreadableSceneError, match=digest[:12]):
        read_scene(digest, {digest: text}.__getitem__)


def test_a_shape_that_is_missing_is_named() -> None:
    texts = texts_of(SCENE)
    lost = shape_hash((ROOF,))
    del texts[lost]
    with pytest.raises(UnreadableSceneError, match=lost):
        read_scene(SCENE.revision(), texts.__getitem__)
