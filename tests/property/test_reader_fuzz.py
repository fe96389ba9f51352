"""Readers in pure Python meet damaged bytes: a model or a rejection, never another exception."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest
from hypothesis import HealthCheck, example, given, settings
from hypothesis import strategies as st

from sitewright.building_model.formats.bar_frame import read_bar_frame
from sitewright.building_model.formats.btlx import read_btlx
from sitewright.building_model.formats.compas_assembly import read_compas_assembly
from sitewright.building_model.formats.detect import FileKind, kind_of
from sitewright.building_model.formats.from_neutral import model_of
from sitewright.building_model.formats.import_map import READ_KEYS, ImportMap, read_map
from sitewright.building_model.formats.native import write_building
from sitewright.building_model.formats.neutral import NeutralFile
from sitewright.building_model.formats.obj import read_obj
from sitewright.errors import ModelRejectedError, Problem

BTLX = b"""<BTLx xmlns="https://www.design2machine.com" Version="2.0.0"><Project><Parts>
<Part SingleMemberNumber="1" Annotation="stud" Count="1" Length="800" Height="120" Width="60">
<Transformations><Transformation GUID="{a-1}"><Position><ReferencePoint X="0" Y="0" Z="0"/>
<XVector X="0" Y="0" Z="1"/><YVector X="0" Y="1" Z="0"/></Position></Transformation>
</Transformations><Processings><JackRafterCut ReferencePlaneID="1"><Orientation>end</Orientation>
<StartX>790.0</StartX><Angle>90.0</Angle><Inclination>60.0</Inclination></JackRafterCut>
<Drilling ReferencePlaneID="2"><StartX>50</StartX><StartY>30</StartY><Depth>20</Depth>
<Diameter>8</Diameter></Drilling></Processings></Part></Parts></Project></BTLx>"""
OBJ = b"""o block 1
v 0 0 0
v 1 0 0
v 1 1 0
v 0 1 0
v 0 0 1
v 1 0 1
v 1 1 1
v 0 1 1
f 4 3 2 1
f 5 6 7 8
f 1 2 6 5
f 2 3 7 6
f 3/1 4//2 8 7
f -5 -8 -4 -1
"""
_VERTEX = {
    str(i): {"x": float(i & 1), "y": float(i >> 1 & 1), "z": float(i >> 2)} for i in range(8)
}
_SIDES = ([0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5])
_NODE = {
    "is_support": True,
    "block": {"data": {"vertex": _VERTEX, "face": {str(i): f for i, f in enumerate(_SIDES)}}},
}
ASSEMBLY = json.dumps(
    {
        "dtype": "compas_assembly.datastructures/Assembly",
        "data": {"graph": {"data": {"node": {"0": _NODE}, "edge": {"0": {}}}}},
    }
).encode()
BARS = json.dumps(
    {
        "unit": "meter",
        "material_properties": {"cross_sec_area": 16.0, "cross_sec_area_unit": "centimeter^2"},
        "node_list": [
            {"node_id": 0, "point": {"X": 0, "Y": 0, "Z": 0}, "is_grounded": 1},
            {"node_id": 1, "point": {"X": 1.0, "Y": 0, "Z": 2}, "is_grounded": 0},
        ],
        "element_list": [{"element_id": 0, "end_node_ids": [0, 1]}],
    }
).encode()
MAP = b'[user_text]\norder = "construction_order"\n[layers]\nHolz = "material"\n'

READERS: dict[str, tuple[bytes, Callable[[Path], NeutralFile], str | None]] = {
    "btlx": (BTLX, read_btlx, None),
    "obj": (OBJ, read_obj, "m"),
    "compas_assembly": (ASSEMBLY, read_compas_assembly, "m"),
    "bar_frame": (BARS, read_bar_frame, None),
}
NASTY = (
    b"NaN",
    b"1e999",
    b"-1e30",
    b"2147483648",
    b"\x00",
    b"\xff\xfe",
    b"[[[[",
    b"<x>",
    b"0",
    b"",
)

Edits = list[tuple[float, int, bytes]]
edits: st.SearchStrategy[Edits] = st.lists(
    st.tuples(
        st.floats(0.0, 1.0),
        st.integers(0, 40),
        st.one_of(st.sampled_from(NASTY), st.binary(max_size=6)),
    ),
    min_size=1,
    max_size=4,
)


def damaged(content: bytes, changes: Edits) -> bytes:
    for place, width, put in changes:
        at = int(place * len(content))
        content = content[:at] + put + content[at + width :]
    return content


def outcome(
    content: bytes, name: str, reader: Callable[[Path], NeutralFile], unit: str | None
) -> str:
    with TemporaryDirectory() as folder:
        file = Path(folder) / f"damaged.{name}"
        file.write_bytes(content)
        try:
            model, _ = model_of(reader(file), file, unit=unit)
            write_building(model, Path(folder) / "building.json")
        except ModelRejectedError as rejected:
            problems = rejected.problems
        else:
            return "model"
    assert problems
    assert all(p.code and p.where and p.message for p in problems)
    return "rejected"


@pytest.mark.parametrize("name", READERS)
def test_the_undamaged_file_is_a_model(name: str) -> None:
    content, reader, unit = READERS[name]
    assert kind_of(content) == FileKind(name)
    assert outcome(content, name, reader, unit) == "model"


@pytest.mark.parametrize("name", READERS)
@given(changes=edits)
@settings(max_examples=120, suppress_health_check=[HealthCheck.too_slow])
def test_a_damaged_file_is_a_model_or_rejected(name: str, changes: Edits) -> None:
    content, reader, unit = READERS[name]
    assert outcome(damaged(content, changes), name, reader, unit) in {"model", "rejected"}


@pytest.mark.parametrize("name", READERS)
@given(share=st.floats(0.0, 0.98))
@settings(max_examples=20)
def test_the_first_part_of_a_file_is_a_model_or_rejected(name: str, share: float) -> None:
    content, reader, unit = READERS[name]
    part = content[: int(share * len(content))]
    assert outcome(part, name, reader, unit) in {"model", "rejected"}


@given(content=st.binary(max_size=200))
@example(b"{" * 5000)
@example(b"<" * 5000)
def test_any_bytes_are_of_some_kind(content: bytes) -> None:
    assert kind_of(content) in set(FileKind)


@given(changes=edits)
@settings(max_examples=60)
def test_a_damaged_map_is_a_map_or_rejected(changes: Edits) -> None:
    with TemporaryDirectory() as folder:
        file = Path(folder) / "import.toml"
        file.write_bytes(damaged(MAP, changes))
        words: ImportMap | None = None
        problems: tuple[Problem, ...] = ()
        try:
            words = read_map(file)
        except ModelRejectedError as rejected:
            problems = rejected.problems
    assert (words is None) == bool(problems)
    assert words is None or set(words.foreign_keys) <= set(READ_KEYS)
    assert words is None or all(all(keys) for keys in words.foreign_keys.values())
