"""How a cell starts: as designed, or from the last checkpoint of its log."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

import mujoco

from sitewright.errors import BackendError
from sitewright.foundation.ids import ComponentId
from sitewright.foundation.mjcf.model import MjcfModel, Solid
from sitewright.foundation.mjcf.text import mjcf_text
from sitewright.robot_team.cell import Cell
from sitewright.robot_team.drivers.mujoco.codec import Setup
from sitewright.robot_team.drivers.mujoco.fixings import Fixings, first_fixings
from sitewright.robot_team.drivers.mujoco.physics import Motion
from sitewright.robot_team.drivers.mujoco.scene import Contents, finger_joints, joint_name
from sitewright.robot_team.drivers.mujoco.simulation import Checkpoint, Effect, Simulation
from sitewright.robot_team.piece import Piece

_SETTLE_S = 0.5


def open_simulation(
    setup: Setup, last: Checkpoint | None, record: Callable[[Effect], None]
) -> Simulation:
    """Return a running cell that stands still.

    Args:
        setup: The cell and its pieces.
        last: Where it stood when its process ended; None is the very first start, in which
            the pieces settle on what they lie on.
        record: Writes effects down.
    """
    pieces = {p.id: p for p in setup.pieces}
    contents = Contents(cell=setup.cell, pieces=pieces, density_kg_m3=_densities(setup.pieces))
    start = first_checkpoint(setup.cell) if last is None else _still_there(last, contents)
    sim = Simulation(contents, start, record=record, real_time_factor=setup.real_time_factor)
    if last is None:
        sim.advance(_SETTLE_S)
    return sim


def first_checkpoint(cell: Cell) -> Checkpoint:
    """Return arms at home, mounted grippers wide open, tools in their docks."""
    fixings = first_fixings(cell)
    arms = {
        joint_name(robot.id, joint.name): q
        for robot in cell.robot_by_id.values()
        for joint, q in zip(robot.description.movable_joints, robot.home_q_rad, strict=True)
    }
    fingers = {
        joint_name(tool, joint.name): joint.upper_rad
        for tool in fixings.mounted.values()
        for joint in finger_joints(cell.end_effector_by_id[tool])
    }
    position = {name: (q,) for name, q in {**arms, **fingers}.items()}
    return Checkpoint(
        motion=Motion(position=position, target=fingers), reference=arms, fixings=fixings
    )


def _still_there(last: Checkpoint, contents: Contents) -> Checkpoint:
    """Return the checkpoint without what the project no longer has."""
    fixings, known = last.fixings, contents.pieces
    strangers = {*fixings.mounted.values(), *fixings.world_T_docked} - set(
        contents.cell.end_effector_by_id
    )
    if strangers or set(fixings.mounted) - set(contents.cell.robot_by_id):
        raise BackendError(
            f"The simulated cell remembers {', '.join(sorted(strangers)) or 'a robot'}, which"
            " cell.toml no longer has. Start it afresh (run --from-design)."
        )
    kept = replace(
        fixings,
        grips={r: g for r, g in fixings.grips.items() if g.piece in known},
        connections=tuple(
            c for c in fixings.connections if c.through in known and _is_there(c.into, contents)
        ),
        fasteners=tuple(f for f in fixings.fasteners if f.through in known),
    )
    return replace(last, fixings=_with_new_tools(kept, contents.cell))


def _with_new_tools(fixings: Fixings, cell: Cell) -> Fixings:
    at_start = first_fixings(cell)
    new = {
        tool: pose
        for tool, pose in at_start.world_T_docked.items()
        if tool not in fixings.world_T_docked and tool not in fixings.mounted.values()
    }
    return replace(fixings, world_T_docked={**fixings.world_T_docked, **new})


def _is_there(name: str, contents: Contents) -> bool:
    return name in contents.pieces or name in contents.cell.fixture_by_id


def _densities(pieces: tuple[Piece, ...]) -> Mapping[ComponentId, float]:
    """Return the density that gives each piece its mass, from the volume of its shape."""
    if not pieces:
        return {}
    unit = tuple(Solid(name=p.id, shape=p.shape, density_kg_m3=1.0) for p in pieces)
    try:
        m = mujoco.MjModel.from_xml_string(mjcf_text(MjcfModel(name="pieces", solids=unit)))
    except ValueError as error:
        raise BackendError(f"MuJoCo cannot build a piece: {error}") from error
    return {p.id: p.mass_kg / float(m.body_mass[m.body(p.id).id]) for p in pieces}
