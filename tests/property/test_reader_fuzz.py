"""Readers in pure Python meet damaged bytes: a model or a rejection, never another exception."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest
from hypothesis import HealthCheck, example, given, settings
from hypothesis import strategies as st

from builders_foreign import ASSEMBLY, BARS, BTLX, OBJ
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
