"""Laws of the native format: what is written is read back, and text never surprises."""

from __future__ import annotations

import json
import tempfile
from contextlib import suppress
from pathlib import Path

from hypothesis import given, settings
from hypothesis import strategies as st

from builders_building import document, ids
from sitewright.building_model.component import (
    AsBuilt,
    BoxGeometry,
    Component,
    CompoundGeometry,
    ConvexGeometry,
    FastenerSpec,
    Geometry,
    Layer,
    Operation,
    Origin,
    PlaneCut,
    Process,
    Source,
    SurfacePatch,
)
from sitewright.building_model.formats.json_text import parse
from sitewright.building_model.formats.native import read_building, write_building
from sitewright.building_model.model import BuildingModel, Relation, RelationKind, Stack
from sitewright.errors import ModelRejectedError
from sitewright.foundation.ids import ComponentId, OperationId, StackId, StockPlaceId
from sitewright.foundation.json_layout import laid_out
from sitewright.foundation.pose import Pose, Quaternion, from_axis_angle

lengths = st.integers(1, 400).map(lambda n: n / 100)
coordinates = st.integers(-(10**9), 10**9).map(lambda n: round(n / 1e7, 7))
vectors = st.tuples(coordinates, coordinates, coordinates)
words = st.text(st.characters(codec="utf-8", exclude_categories=["C", "Zl", "Zp"]), max_size=12)
json_values = st.recursive(
    st.none() | st.booleans() | st.integers(-9, 9) | coordinates | words,
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(words, inner, max_size=3),
    max_leaves=6,
)
free = st.dictionaries(words.filter(bool), json_values.filter(lambda v: v is not None), max_size=2)


def _written(q: Quaternion) -> Quaternion:
    w, x, y, z = (round(c, 9) + 0.0 for c in q)
    return (w, x, y, z)


@st.composite
def poses(draw: st.DrawFn) -> Pose:
    axis = draw(vectors.filter(any))
    q = from_axis_angle(axis, draw(st.floats(-3.1, 3.1)))
    return Pose(draw(vectors), _written(q))


BESIDE = PlaneCut((500.0, 0.0, 0.0), (1.0, 0.0, 0.0))
"""A cut beyond all that is drawn, parts of a compound too: it takes nothing away."""
boxes = st.tuples(lengths, lengths, lengths).map(BoxGeometry)
tetrahedra = lengths.map(
    lambda s: ConvexGeometry(((0.0, 0.0, 0.0), (s, 0.0, 0.0), (0.0, s, 0.0), (0.0, 0.0, s)))
)
geometries: st.SearchStrategy[Geometry] = (
    boxes
    | tetrahedra
    | st.lists(st.tuples(poses(), boxes), min_size=1, max_size=2).map(
        lambda parts: CompoundGeometry(tuple(parts))
    )
)


@st.composite
def operations(draw: st.DrawFn, owner: str, number: int) -> Operation:
    process = draw(st.sampled_from([Process.DRILL, Process.PAINT, Process.PLACE, Process.WELD]))
    patch = SurfacePatch(
        size_m=(draw(lengths), draw(lengths)), standoff_m=0.1, width_m=0.05, speed_m_s=0.2
    )
    spec = FastenerSpec(type="bolt", d_m=0.01, l_m=draw(lengths))
    return Operation(
        id=OperationId(f"{owner}.{number}"),
        process=process,
        on=ids(owner),
        component_T_operation=draw(poses()),
        method=draw(words),
        fastener=draw(st.none() | st.just(spec)),
        patch=patch if process is Process.PAINT else None,
        after=() if number == 1 else (OperationId(f"{owner}.{number - 1}"),),
        needs_hold=draw(st.booleans()),
        params=draw(free),
        origin=draw(st.sampled_from(Origin)),
    )


@st.composite
def components(draw: st.DrawFn, name: str, layer: Layer) -> Component:
    count = draw(st.integers(0, 2)) if layer is Layer.TARGET else 0
    record = AsBuilt(
        status="verified",
        material_used=ComponentId("m0"),
        world_T_component_measured=draw(st.none() | poses()),
        operations={OperationId("x"): "done"},
    )
    return Component(
        id=ComponentId(name),
        layer=layer,
        type=draw(words),
        geometry=draw(geometries),
        world_T_component=draw(poses()),
        name=draw(words),
        material=draw(words),
        order=draw(st.none() | st.integers(0, 5)),
        ground=draw(st.booleans()),
        cuts=(BESIDE,) if draw(st.booleans()) else (),
        mass_kg=draw(st.none() | lengths),
        com_m=draw(st.none() | vectors),
        hold_until_fasteners=draw(st.integers(0, 3)),
        operations=tuple(draw(operations(name, n)) for n in range(1, count + 1)),
        grasps=tuple(draw(st.lists(poses(), max_size=1))),
        source=draw(st.none() | st.just(Source(file="a.json", kind="x", id="7"))),
        raw=draw(free),
        ext=draw(free),
        origins={"order": (Origin.INFERRED, draw(words))} if draw(st.booleans()) else {},
        as_built=record if layer is Layer.AS_BUILT else None,
    )


@st.composite
def models(draw: st.DrawFn) -> BuildingModel:
    layers = draw(st.lists(st.sampled_from([*Layer]), min_size=1, max_size=4))
    made = [draw(components(f"{layer.value[0]}{n}", layer)) for n, layer in enumerate(layers)]
    pieces = tuple(c.id for c in made if c.layer is Layer.MATERIAL)
    a, b = made[0].id, made[-1].id
    contact = Relation(kind=RelationKind.CONTACT, a=a, b=b, confidence=0.5, data=draw(free))
    stack = Stack(
        id=StackId("s"), place=StockPlaceId("p"), items=pieces, stock_T_stack=draw(poses())
    )
    return BuildingModel(
        name=draw(words),
        component_by_id={c.id: c for c in sorted(made, key=lambda c: c.id)},
        relations=(contact,) if draw(st.booleans()) else (),
        stacks=(stack,) if pieces else (),
        materials={"C24": {"density_kg_m3": 420.0}} if draw(st.booleans()) else {},
        component_types=draw(st.dictionaries(words.filter(bool), free, max_size=1)),
        ground_z_m=draw(coordinates),
        site_T_model=draw(st.just(Pose()) | poses()),
    )


@given(model=models())
@settings(max_examples=60, deadline=None)
def test_what_is_written_is_read_back_and_written_to_the_same_bytes(model: BuildingModel) -> None:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "building.json"
        write_building(model, path)
        text = path.read_bytes()
        read = read_building(path, is_exported=True)
        assert read == model
        write_building(read, path)
        assert path.read_bytes() == text


@given(value=json_values)
@settings(max_examples=100, deadline=None)
def test_laid_out_text_holds_the_same_value(value: object) -> None:
    assert json.loads(laid_out(value)) == value  # type: ignore[arg-type]


TEXT = json.dumps(document())


@given(cut=st.integers(0, len(TEXT) - 1))
@settings(max_examples=60, deadline=None)
def test_a_file_cut_anywhere_is_never_read(cut: int) -> None:
    read, problems = parse(TEXT[:cut], Path("building.json"))
    assert read is None
    assert [p.code for p in problems] in (["E4"], ["E5"])


@given(position=st.integers(0, len(TEXT) - 1), junk=st.sampled_from('{}[]",:0-e\\x\x00'))
@settings(max_examples=60, deadline=None)
def test_a_damaged_file_is_read_or_refused_and_nothing_else(position: int, junk: str) -> None:
    damaged = TEXT[:position] + junk + TEXT[position + 1 :]
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "building.json"
        path.write_text(damaged, encoding="utf-8")
        with suppress(ModelRejectedError):
            read_building(path)
