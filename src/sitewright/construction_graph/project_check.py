"""Can this cell build this model? Everything that can be said without planning a motion."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from sitewright.building_model.component import Component, Layer, Operation, Process
from sitewright.building_model.findings import refused
from sitewright.building_model.model import BuildingModel
from sitewright.building_model.shapes import (
    DENSITY_KG_M3,
    is_mass_known,
    mass_of,
    shape_of,
    size_of,
    volume_of,
)
from sitewright.building_model.validation import STRUCTURE_CODES, check_model
from sitewright.construction_graph.reach import is_box_in_reach, is_point_in_reach
from sitewright.construction_graph.siting import gravity_problems, hanging_problems
from sitewright.errors import Problem, did_you_mean
from sitewright.foundation.pose import Pose
from sitewright.robot_team.cell import Capability, Cell, EndEffector, EndEffectorKind, Robot
from sitewright.robot_team.description import Description

_DRIVEN = frozenset({Process.NAIL, Process.SCREW, Process.DRILL})
_SAME_DIAMETER_M = 1e-4
_TOOLED = _DRIVEN | {Process.PAINT}
_SLENDER = 4.0
"""What is this many times longer than wide is a beam or a stud, and no block."""
_STONE = "concrete"
"""What a component of unknown material may be of."""

Crew = list[tuple[Robot, EndEffector]]
"""Robots, each with an end effector that it can carry."""


def check_project(model: BuildingModel, cell: Cell) -> list[Problem]:
    """Return all problems of a model by itself and with a cell, errors first."""
    found = check_model(model)
    if any(p.code in STRUCTURE_CODES and p.severity == "E" for p in found):
        return found
    found += gravity_problems(model, cell)
    found += hanging_problems(model, cell)
    found += _stack_problems(model, cell)
    for component in model.component_by_id.values():
        if component.layer is Layer.TARGET:
            found += _target_problems(model, cell, component)
    return sorted(found, key=lambda p: (p.severity, p.where, p.code, p.message))


def _stack_problems(model: BuildingModel, cell: Cell) -> Iterator[Problem]:
    for stack in model.stacks:
        if stack.place not in cell.stock_place_by_id:
            hint = did_you_mean(stack.place, cell.stock_place_by_id)
            yield Problem(
                code="Q5",
                severity="E",
                where=stack.id,
                message=f"It stands at {stack.place!r}, which the cell lacks.{hint}",
                fix="Add a [[stock_place]] to the cell, or correct 'place'.",
            )


def _target_problems(model: BuildingModel, cell: Cell, component: Component) -> Iterator[Problem]:
    world_T_component = cell.world_T_model @ component.world_T_component
    yield from _handling(model, cell, component, world_T_component)
    for operation in component.operations:
        if operation.process in _TOOLED:
            yield from _tooling(cell, component, operation, world_T_component)


def _handling(
    model: BuildingModel, cell: Cell, component: Component, world_T_component: Pose
) -> Iterator[Problem]:
    """Yield the reasons that leave no robot to place a component."""
    crew = _crew(cell, Capability.GRASPING, EndEffectorKind.GRIPPER)
    if not crew:
        yield refused(
            "Q6", component, "No robot of the cell has a gripper and can grasp.", "Add one."
        )
        return
    holding = [(r, e) for r, e in crew if _grips(e, component)]
    if not holding:
        yield _too_wide(crew, component)
    mass_kg = mass_of(component, model.materials)
    lifting = [c for c in holding or crew if mass_kg <= _left_kg(c)]
    if not lifting:
        yield _too_heavy(holding or crew, component, f"It weighs {mass_kg:.1f} kg")
    else:
        yield from _heavier_than_thought(model, lifting, component)
    able = [c for c in holding if c in lifting]
    if able and not any(
        is_box_in_reach(r, e, shape_of(component), world_T_component) for r, e in able
    ):
        names = ", ".join(sorted({r.id for r, _ in able}))
        message = f"No part of it is within reach of {names}."
        yield refused("Q4", component, message, "Move it, the model or a robot's base.")


def _too_wide(crew: Crew, component: Component) -> Problem:
    """Return Q2: what the grippers take, and what they should."""
    ranges = ", ".join(f"{e.id} takes {_millimetres(e.grips_m or ())} mm" for _, e in crew)
    sides = [f"{s * 1000:g}" for s in size_of(component)[1:]]
    narrowest = f"{min(size_of(component)[1:]) * 1000:g}"
    message = f"No gripper holds its section of {' x '.join(sides)} mm: {ranges}."
    fix = f"Add a gripper to the cell that takes {narrowest} mm."
    return refused("Q2", component, message, fix)


def _too_heavy(crew: Crew, component: Component, weighs: str) -> Problem:
    robot, gripper = max(crew, key=_left_kg)
    own_kg = _mass_kg(gripper.description)
    message = (
        f"{weighs}; with {gripper.id} ({own_kg:.1f} kg) "
        f"that is more than the {_payload_kg(robot):g} kg of {robot.id}."
    )
    return refused("Q1", component, message, "Use a stronger robot or a lighter component.")


def _heavier_than_thought(
    model: BuildingModel, crew: Crew, component: Component
) -> Iterator[Problem]:
    """Yield Q1 as a warning if a weight is a guess, and the robots could not lift stone."""
    length_m, *section_m = size_of(component)
    is_slender = length_m > _SLENDER * max(section_m)
    if is_slender or is_mass_known(component, model.materials):
        return
    stone_kg = volume_of(component) * DENSITY_KG_M3[_STONE]
    if any(stone_kg <= _left_kg(c) for c in crew):
        return
    taken_kg = mass_of(component, model.materials)
    material = f"Its material {component.material!r} is not known" if component.material else ""
    problem = _too_heavy(
        crew,
        component,
        f"{material or 'It states no material'}: taken as timber it weighs {taken_kg:.0f} kg, "
        f"as {_STONE} {stone_kg:.0f} kg",
    )
    fix = "State 'mass_kg', or a 'material' whose density is known."
    yield replace(problem, severity="W", fix=fix)


def _tooling(
    cell: Cell, component: Component, operation: Operation, world_T_component: Pose
) -> Iterator[Problem]:
    """Yield the first reason that leaves no robot to do an operation."""
    crew = [(r, e) for r, e in _finishers(cell, operation) if _does(e, operation)]
    if not crew:
        spec = operation.fastener
        what = (
            f"{spec.type} {spec.d_m * 1000:g} x {spec.l_m * 1000:g} mm"
            if spec
            else operation.process.value
        )
        verb = "drives" if operation.process in _DRIVEN else "does"
        offers = "; ".join(_offer(e) for _, e in _finishers(cell, operation)) or "no tool at all"
        message = f"No tool {verb} {what} of {operation.id!r}; the cell has {offers}."
        yield refused("Q3", component, message, "Add a tool for it to the cell.")
        return
    place = (world_T_component @ operation.component_T_operation).position_m
    if not any(is_point_in_reach(r, e, place) for r, e in crew):
        names = ", ".join(sorted({r.id for r, _ in crew}))
        message = f"Operation {operation.id!r} is out of reach of {names}."
        yield refused("Q4", component, message, "Move it, the model or a robot's base.")


def _finishers(cell: Cell, operation: Operation) -> Crew:
    skill = Capability.FASTENING if operation.process in _DRIVEN else Capability.FINISHING
    return _crew(cell, skill, EndEffectorKind.TOOL)


def _crew(cell: Cell, skill: Capability, kind: EndEffectorKind) -> Crew:
    return [
        (robot, tool)
        for robot in cell.robot_by_id.values()
        if skill in robot.can
        for name in robot.end_effectors
        if (tool := cell.end_effector_by_id[name]).kind is kind
    ]


def _grips(gripper: EndEffector, component: Component) -> bool:
    """Return whether the fingers can close along the component's y or z axis."""
    low, high = gripper.grips_m or (0.0, 0.0)
    return any(low <= width <= high for width in size_of(component)[1:])


def _does(tool: EndEffector, operation: Operation) -> bool:
    if operation.process.value not in tool.processes:
        return False
    spec = operation.fastener
    return spec is None or any(
        f.type == spec.type
        and abs(f.d_m - spec.d_m) <= _SAME_DIAMETER_M
        and f.l_min_m - 1e-6 <= spec.l_m <= f.l_max_m + 1e-6
        for f in tool.fasteners
    )


def _offer(tool: EndEffector) -> str:
    ranges = [
        f"{f.type} {f.d_m * 1000:g} x {_millimetres((f.l_min_m, f.l_max_m))} mm"
        for f in tool.fasteners
    ]
    return f"{tool.id}: {', '.join(ranges or tool.processes)}"


def _millimetres(span_m: tuple[float, ...]) -> str:
    return "-".join(f"{x * 1000:g}" for x in span_m)


def _mass_kg(description: Description) -> float:
    return sum(link.mass_kg for link in description.links)


def _left_kg(pair: tuple[Robot, EndEffector]) -> float:
    """Return what a robot can lift with an end effector on."""
    robot, end_effector = pair
    return _payload_kg(robot) - _mass_kg(end_effector.description)


def _payload_kg(robot: Robot) -> float:
    return robot.description.payload_kg
