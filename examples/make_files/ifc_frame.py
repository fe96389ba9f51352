"""Models a small frame with IfcOpenShell's own API, tasks and properties included: frame.ifc.

    python ifc_frame.py frame.ifc

Needs ifcopenshell only. An authoring program writes the same entities.
"""

import sys

import ifcopenshell.api.aggregate
import ifcopenshell.api.context
import ifcopenshell.api.geometry
import ifcopenshell.api.material
import ifcopenshell.api.project
import ifcopenshell.api.pset
import ifcopenshell.api.root
import ifcopenshell.api.sequence
import ifcopenshell.api.unit
import numpy as np

file = ifcopenshell.api.project.create_file("IFC4")
project = ifcopenshell.api.root.create_entity(file, "IfcProject", name="Frame")
millimetre = ifcopenshell.api.unit.add_si_unit(file, unit_type="LENGTHUNIT", prefix="MILLI")
ifcopenshell.api.unit.assign_unit(file, units=[millimetre])
whole = ifcopenshell.api.context.add_context(file, context_type="Model")
body = ifcopenshell.api.context.add_context(
    file, "Model", "Body", target_view="MODEL_VIEW", parent=whole
)
frame = ifcopenshell.api.root.create_entity(file, "IfcElementAssembly", name="Frame")
timber = ifcopenshell.api.material.add_material(file, name="C24", category="wood")

SUPPORT, STUD = (90.0, 140.0), (90.0, 40.0)  # width and height in mm


def member(name, kind, start, along, length, sides):
    """Return a member: a rectangle, pulled from its start along the grain (all in mm)."""
    made = ifcopenshell.api.root.create_entity(file, "IfcMember", name=name, predefined_type=kind)
    z = np.array(along, float)
    up = np.array([0.0, 0.0, 1.0])
    placement = np.eye(4)
    placement[:3, 0], placement[:3, 1], placement[:3, 2] = np.cross(up, z), up, z
    placement[:3, 3] = start
    ifcopenshell.api.geometry.edit_object_placement(file, made, placement, is_si=False)
    side = file.create_entity("IfcRectangleProfileDef", "AREA", XDim=sides[0], YDim=sides[1])
    shape = ifcopenshell.api.geometry.add_profile_representation(
        file, body, side, depth=length / 1000.0
    )
    ifcopenshell.api.geometry.assign_representation(file, made, shape)
    ifcopenshell.api.material.assign_material(file, [made], material=timber)
    return made


def own_properties(element, **properties):
    """Write what IFC has no entity for into the property set that Sitewright reads."""
    pset = ifcopenshell.api.pset.add_pset(file, element, "Sitewright")
    ifcopenshell.api.pset.edit_pset(file, pset, properties=properties)


def task(schedule, name, elements):
    """Return a task that installs elements."""
    made = ifcopenshell.api.sequence.add_task(
        file, work_schedule=schedule, name=name, predefined_type="INSTALLATION"
    )
    for element in elements:
        ifcopenshell.api.sequence.assign_product(file, element, made)
    return made


# What is to be built. The origin is the middle of the assembly table's top, z points up.
supports = [
    member(f"support {n}", "MULLION", (x, -1200, 70), (0, 1, 0), 2400.0, SUPPORT)
    for n, x in enumerate((-600, 600), 1)
]
studs = [
    member(f"stud {n}", "STUD", (-900, y, 160), (1, 0, 0), 1800.0, STUD)
    for n, y in enumerate((-800, 0, 800), 1)
]
ifcopenshell.api.aggregate.assign_object(file, [*supports, *studs], frame)

# In which order: two tasks, one after the other.
plan = ifcopenshell.api.sequence.add_work_schedule(file, name="Frame", predefined_type="PLANNED")
first, second = task(plan, "supports", supports), task(plan, "studs", studs)
ifcopenshell.api.sequence.assign_sequence(file, first, second)

# The stock, modelled anywhere: `Stack` is a stock place of the cell, `StackIndex` is from below.
for n in range(3):
    piece = member("", "MULLION", (3000, 0, 70 + 140 * n), (1, 0, 0), 2400.0, SUPPORT)
    own_properties(piece, Layer="Material", Stack="pallet-thick", StackIndex=n)
for n in range(4):
    piece = member("", "STUD", (3000, 500, 20 + 40 * n), (1, 0, 0), 1800.0, STUD)
    own_properties(piece, Layer="Material", Stack="pallet-thin", StackIndex=n)

file.write(sys.argv[1])
