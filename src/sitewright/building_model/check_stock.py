"""Is there a piece of stock for every target, and is the stock in stacks?"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from sitewright.building_model.component import Component, Layer
from sitewright.building_model.findings import refused
from sitewright.building_model.matching import (
    LENGTH_TOLERANCE_M,
    MaterialType,
    fits,
    is_section_equal,
    material_type_of,
)
from sitewright.building_model.model import BuildingModel
from sitewright.building_model.shapes import UnsupportedGeometryError
from sitewright.errors import Problem, did_you_mean


def stock_problems(model: BuildingModel) -> Iterator[Problem]:
    """Yield targets without a fitting piece, and material that lies nowhere."""
    yield from _stack_problems(model)
    stock = [
        (c, wanted)
        for c in model.component_by_id.values()
        if c.layer is Layer.MATERIAL and (wanted := _type_of(c))
    ]
    left = Counter(wanted for _, wanted in stock)
    for component in _targets(model):
        wanted = _type_of(component)
        if wanted is None:
            continue
        match = next((m for m in sorted(left) if left[m] and fits(m, wanted)), None)
        if match is None:
            yield _lack(component, wanted, sorted({m for _, m in stock}))
        else:
            left[match] -= 1


def _targets(model: BuildingModel) -> list[Component]:
    return [c for c in model.component_by_id.values() if c.layer is Layer.TARGET]


def _type_of(component: Component) -> MaterialType | None:
    try:
        return material_type_of(component)
    except UnsupportedGeometryError:
        return None


def _lack(component: Component, wanted: MaterialType, stock: list[MaterialType]) -> Problem:
    same_type = [m for m in stock if m[0] == wanted[0] and wanted[3] in ("", m[3])]
    if not same_type:
        hint = did_you_mean(wanted[0], {m[0] for m in stock})
        material = f" of material {wanted[3]!r}" if wanted[3] else ""
        message = f"There is no stock of type {wanted[0]!r}{material}.{hint}"
        return refused("M1", component, message, "Add a stack of it.")
    same_section = [m for m in same_type if is_section_equal(m[1], wanted[1])]
    if not same_section:
        sections = ", ".join(sorted({_millimetres(m[1]) for m in same_type}))
        message = f"It needs section {_millimetres(wanted[1])} mm; the stock has {sections}."
        return refused("M3", component, message, "Add a stack of that section.")
    if any(abs(m[2] - wanted[2]) <= LENGTH_TOLERANCE_M for m in same_section):
        message = f"All stock of type {wanted[0]!r} and its size is used up by other targets."
        return refused("M1", component, message, "Add pieces to the stack.")
    lengths = sorted({m[2] for m in same_section})
    message = f"It needs {wanted[2]:.3f} m; the stock is {_list(lengths)} m long."
    return refused("M2", component, message, "Nothing is cut in the cell: add that length.")


def _stack_problems(model: BuildingModel) -> Iterator[Problem]:
    where: Counter[str] = Counter()
    for stack in model.stacks:
        for item in stack.items:
            where[item] += 1
            component = model.component_by_id.get(item)
            if component is None or component.layer is not Layer.MATERIAL:
                found = (
                    "does not exist"
                    if component is None
                    else f"is on layer {component.layer.value}"
                )
                hint = did_you_mean(item, model.component_by_id) if component is None else ""
                yield Problem(
                    code="M4",
                    severity="E",
                    where=stack.id,
                    message=f"Its item {item!r} {found}.{hint}",
                    fix="List components on layer material.",
                )
    for component in model.component_by_id.values():
        if component.layer is Layer.MATERIAL and where[component.id] != 1:
            times = where[component.id]
            message = f"It is material and lies in {times} stacks."
            yield refused("M4", component, message, "List it in exactly one stack.")


def _millimetres(section_m: tuple[float, float]) -> str:
    return " x ".join(f"{s * 1000:g}" for s in section_m)


def _list(lengths_m: list[float]) -> str:
    return ", ".join(f"{x:.3f}" for x in lengths_m)
