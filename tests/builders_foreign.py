"""Small files of the foreign text formats, each of which is a model as it stands."""

from __future__ import annotations

import json

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
NATIVE = json.dumps(
    {
        "schema": "sitewright.building/1",
        "components": [
            {
                "id": "stud-1",
                "type": "stud",
                "geometry": {"box": {"size_m": [1.8, 0.09, 0.04]}},
                "world_T_component": {"p_m": [0.0, 0.0, 0.02], "q_wxyz": [1.0, 0.0, 0.0, 0.0]},
                "ground": True,
            }
        ],
        "stacks": [
            {
                "id": "pile",
                "place": "pallet",
                "generated": {
                    "type": "stud",
                    "section_m": [0.09, 0.04],
                    "length_m": 1.8,
                    "count": 2,
                },
            }
        ],
    }
).encode()
