"""Models a small wall frame with compas_timber, joints included: frame.json.

    python timber_frame.py frame.json

Needs compas_timber only. In Grasshopper the same model comes out of the component `Model`; write
it to a file with `compas.json_dump`.
"""

import sys

from compas.data import json_dump
from compas.geometry import Line, Point, Vector
from compas_timber.connections import LButtJoint, TButtJoint
from compas_timber.elements import Beam
from compas_timber.model import TimberModel

WIDTH, HEIGHT = 60.0, 120.0  # in mm, as all numbers here; the file itself states no unit
OUT_OF_WALL = Vector(0, 1, 0)

model = TimberModel()


def beam(category, start, end):
    """Add a beam on its centre line; `category` becomes the type."""
    line = Line(Point(*start), Point(*end))
    made = Beam.from_centerline(line, width=WIDTH, height=HEIGHT, z_vector=OUT_OF_WALL)
    made.name = category
    made.attributes["category"] = category
    made.attributes["sitewright.material"] = "C24"  # keys of ours are attributes like any other
    model.add_element(made)
    return made


sill = beam("sill", (0, 0, 0), (1500, 0, 0))
head = beam("head", (0, 0, 1200), (1500, 0, 1200))
posts = [beam("post", (x, 0, 0), (x, 0, 1200)) for x in (0, 750, 1500)]

# A joint says who is cut (first) and who runs through (second).
for post in posts:
    joint = TButtJoint if post is posts[1] else LButtJoint
    joint.create(model, post, sill)
    joint.create(model, post, head)

model.process_joinery()
json_dump(model, sys.argv[1])
