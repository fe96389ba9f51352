"""Draws a small frame and its stock as a Rhino user would, attributes included: frame.3dm.

    python rhino_frame.py frame.3dm

Needs rhino3dm only. In Rhino the same is done by hand: layers, boxes, Attribute User Text.
"""

import json
import sys

import rhino3dm

model = rhino3dm.File3dm()
model.Settings.ModelUnitSystem = rhino3dm.UnitSystem.Millimeters


def layer(path):
    """Return the index of a layer such as Target::stud; layers that are missing are made."""
    parent, walked = None, ""
    for name in path.split("::"):
        walked = f"{walked}::{name}" if walked else name
        found = next((one for one in model.Layers if one.FullPath == walked), None)
        if found is None:
            new = rhino3dm.Layer()
            new.Name = name
            if parent is not None:
                new.ParentLayerId = parent.Id
            found = model.Layers.FindIndex(model.Layers.Add(new))
        parent = found
    return parent.Index


def box(name, layer_path, low, size, **keys):
    """Draw a box by its lowest corner and its size, with our keys as attribute user text."""
    high = [a + b for a, b in zip(low, size, strict=True)]
    shape = rhino3dm.Brep.CreateFromBox(rhino3dm.Box(rhino3dm.BoundingBox(*low, *high)))
    attributes = rhino3dm.ObjectAttributes()
    attributes.Name = name
    attributes.LayerIndex = layer(layer_path)
    for key, value in keys.items():
        attributes.SetUserString(f"sitewright.{key}", str(value))
    attributes.SetUserString("Fire class", "R30")  # a key of the office's own: it is kept
    model.Objects.AddBrep(shape, attributes)


def nails(stud, y):
    """Return four nails as text: points on the stud's top side, driven downwards."""
    return json.dumps(
        [
            {
                "process": "nail",
                "on": [stud, support],
                "at": [x, y + dy, 180],
                "direction": [0, 0, -1],
                "fastener": {"type": "nail", "d_m": 0.0031, "l_m": 0.09},
            }
            for x, support in ((-600, "support-1"), (600, "support-2"))
            for dy in (-25, 25)
        ]
    )


# What is to be built. The origin is the middle of the assembly table's top, z points up.
for number, x in enumerate((-600, 600), 1):
    box(
        f"support-{number}",
        "Target::Frame::support",
        (x - 45, -1200, 0),
        (90, 2400, 140),
        material="C24",
        order=1,
        ground="yes",
    )
for number, y in enumerate((-800, 0, 800), 1):
    name = f"stud-{number}"
    box(
        name,
        "Target::Frame::stud",
        (-900, y - 45, 140),
        (1800, 90, 40),
        material="C24",
        order=2,
        parent="support-1; support-2",
        ops=nails(name, y),
    )

# The stock: drawn anywhere; `stack` is a stock place of the cell, `stack_index` counts from below.
for n in range(3):
    box(
        "",
        "Material::support",
        (3000, 0, 140 * n),
        (2400, 90, 140),
        material="C24",
        stack="pallet-thick",
        stack_index=n,
    )
for n in range(4):
    box(
        "",
        "Material::stud",
        (3000, 500, 40 * n),
        (1800, 90, 40),
        material="C24",
        stack="pallet-thin",
        stack_index=n,
    )

model.Write(sys.argv[1], 8)
