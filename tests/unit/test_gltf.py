"""Binary glTF: its own rules checked byte by byte, its content by another library."""

from __future__ import annotations

import io
import json
import math
import struct
from dataclasses import replace
from itertools import pairwise
from typing import Any

import numpy as np
import pytest
import trimesh

from sitewright.building_model.formats.gltf import Drawn, Look, Scene, Surface, glb_of, joined
from sitewright.foundation.pose import Pose, Vector, rotation, translation

BLUE = Look(name="blue", rgb=(0.1, 0.2, 0.9))
GLASS = Look(name="glass", rgb=(0.9, 0.9, 0.9), opacity=0.3)
TETRAHEDRON = Surface(
    ((0.0, 0.0, 0.0), (0.3, 0.0, 0.0), (0.0, 0.2, 0.0), (0.0, 0.0, 0.1)),
    ((0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)),
)
TETRAHEDRON_M3 = 0.3 * 0.2 * 0.1 / 6.0
TURNED = translation(1.0, 2.0, 3.0) @ rotation((1.0, 2.0, -1.0), 0.7)


def drawn(name: str, at: Pose = TURNED, **changes: Any) -> Drawn:
    usual: dict[str, Any] = {"surface": TETRAHEDRON, "look": BLUE}
    return Drawn(name=name, site_T_drawn=at, **{**usual, **changes})


def scene(*things: Drawn) -> Scene:
    return Scene(name="frame", drawn=things, facts={"state": "design"})


def chunks(content: bytes) -> tuple[dict[str, Any], bytes]:
    """Return document and buffer, checking the container on the way."""
    magic, version, length = struct.unpack_from("<4sII", content)
    assert (magic, version, length) == (b"glTF", 2, len(content))
    found, at = [], 12
    while at < length:
        size, kind = struct.unpack_from("<I4s", content, at)
        assert size % 4 == 0
        found.append((kind, content[at + 8 : at + 8 + size]))
        at += 8 + size
    assert at == length
    assert [k for k, _ in found] in ([b"JSON", b"BIN\x00"], [b"JSON"])
    return json.loads(found[0][1]), found[1][1] if len(found) > 1 else b""


def loaded(content: bytes) -> Any:
    return trimesh.load(io.BytesIO(content), file_type="glb", process=False)


def numbers(document: dict[str, Any], binary: bytes, accessor: int) -> Any:
    """Return what an accessor says, read by the words of the specification."""
    entry = document["accessors"][accessor]
    view = document["bufferViews"][entry["bufferView"]]
    kind, width = {5126: ("<f4", 3), 5125: ("<u4", 1)}[entry["componentType"]]
    assert entry["type"] == {3: "VEC3", 1: "SCALAR"}[width]
    assert view["byteOffset"] % 4 == 0
    assert view["byteLength"] == entry["count"] * width * 4
    data = binary[view["byteOffset"] : view["byteOffset"] + view["byteLength"]]
    return np.frombuffer(data, dtype=kind).reshape(-1, width)


def y_up(point: Vector) -> list[float]:
    """Return a point of the site as glTF has it: x stays, up becomes y, towards us becomes z."""
    x, y, z = point
    return [x, z, -y]


def test_buffers_are_where_the_document_says_and_bounds_are_exact() -> None:
    other = Surface((*TETRAHEDRON.corners_m, (0.123456789, 0.1, 0.2)), TETRAHEDRON.triangles)
    content = glb_of(scene(drawn("a"), drawn("b", surface=other), drawn("c", look=GLASS)))
    document, binary = chunks(content)
    assert document["asset"]["version"] == "2.0"
    (buffer,) = document["buffers"]
    assert len(binary) - 3 <= buffer["byteLength"] <= len(binary)
    spans = sorted((v["byteOffset"], v["byteLength"]) for v in document["bufferViews"])
    assert all(a + size <= b for (a, size), (b, _) in pairwise(spans))
    for mesh in document["meshes"]:
        (primitive,) = mesh["primitives"]
        corners = numbers(document, binary, primitive["attributes"]["POSITION"])
        bounds = document["accessors"][primitive["attributes"]["POSITION"]]
        assert [np.float32(v) for v in bounds["min"]] == list(corners.min(axis=0))
        assert [np.float32(v) for v in bounds["max"]] == list(corners.max(axis=0))
        index = numbers(document, binary, primitive["indices"])
        assert index.max() < len(corners)
        assert len(index) % 3 == 0
        assert document["materials"][primitive["material"]]


def test_another_library_finds_every_node_with_its_shape_where_it_belongs() -> None:
    found = loaded(glb_of(scene(drawn("a"), drawn("b", Pose()), drawn("c", look=GLASS))))
    assert set(found.graph.nodes_geometry) == {"a", "b", "c"}
    for name, pose in (("a", TURNED), ("b", Pose()), ("c", TURNED)):
        matrix, geometry = found.graph[name]
        mesh = found.geometry[geometry].copy()
        assert mesh.is_watertight
        assert mesh.volume == pytest.approx(TETRAHEDRON_M3, rel=1e-6), "its faces look outwards"
        mesh.apply_transform(matrix)
        wanted = [y_up(pose.apply(c)) for c in TETRAHEDRON.corners_m]
        assert mesh.vertices == pytest.approx(np.array(wanted), abs=1e-6)


def test_node_poses_are_those_of_the_site_below_one_turn_to_y_up() -> None:
    document, _ = chunks(glb_of(scene(drawn("a"))))
    root, node = document["nodes"]
    assert document["scenes"][document["scene"]]["nodes"] == [0]
    assert root["children"] == [1]
    assert root["rotation"] == pytest.approx([-math.sqrt(0.5), 0.0, 0.0, math.sqrt(0.5)])
    assert node["translation"] == pytest.approx([1.0, 2.0, 3.0])
    w, x, y, z = TURNED.quaternion_wxyz
    assert node["rotation"] == pytest.approx([x, y, z, w])


def test_facts_go_into_extras() -> None:
    facts = {"layer": "target", "order": 3, "label": "Ständer"}
    document, _ = chunks(glb_of(scene(drawn("a", facts=facts))))
    assert document["nodes"][1]["extras"] == facts
    assert document["scenes"][0]["extras"] == {"state": "design"}


def test_equal_shapes_are_stored_once_and_each_look_is_one_material() -> None:
    things = [drawn(f"s-{n}", translation(n, 0.0, 0.0)) for n in range(50)]
    document, binary = chunks(glb_of(scene(*things, drawn("glass", look=GLASS))))
    assert len(binary) == 4 * 3 * 4 + 4 * 3 * 4
    assert (len(document["accessors"]), len(document["meshes"])) == (2, 2)
    opaque, glass = document["materials"]
    assert (opaque["name"], "alphaMode" in opaque) == ("blue", False)
    assert (glass["alphaMode"], glass["pbrMetallicRoughness"]["baseColorFactor"][3]) == (
        "BLEND",
        0.3,
    )


def test_an_empty_scene_is_a_file_without_a_buffer() -> None:
    document, binary = chunks(glb_of(scene()))
    assert binary == b""
    assert [k for k in document if document[k] == []] == []
    assert "children" not in document["nodes"][0]


def test_the_same_scene_gives_the_same_bytes_and_another_one_does_not() -> None:
    one = scene(drawn("a"), drawn("b", look=GLASS))
    assert glb_of(one) == glb_of(replace(one))
    assert glb_of(one) != glb_of(scene(drawn("a"), drawn("b")))


def test_joined_surfaces_keep_their_triangles() -> None:
    both = joined([TETRAHEDRON, replace(TETRAHEDRON, corners_m=((1.0, 1.0, 1.0),) * 4)])
    assert len(both.corners_m) == 8
    assert both.triangles[4:] == tuple((a + 4, b + 4, c + 4) for a, b, c in TETRAHEDRON.triangles)
