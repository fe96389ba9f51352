"""Ids of the parts of foreign files, read without any importer."""

from __future__ import annotations

import json
import re
from pathlib import Path


def elements_of_ifc(file: Path) -> set[str]:
    import ifcopenshell

    return {e.GlobalId for e in ifcopenshell.open(file).by_type("IfcMember")}


def objects_of_rhino(file: Path) -> set[str]:
    import rhino3dm

    solids = (rhino3dm.Extrusion, rhino3dm.Brep)
    objects = rhino3dm.File3dm.Read(str(file)).Objects
    return {str(o.Attributes.Id) for o in objects if isinstance(o.Geometry, solids)}


def transformations_of_btlx(file: Path) -> set[str]:
    return set(re.findall(r'<Transformation GUID="\{?([^"}]+)', file.read_text(encoding="utf-8")))


def elements_of_timber(file: Path) -> set[str]:
    return set(json.loads(file.read_bytes())["data"]["elements"])


def nodes_of_assembly(file: Path) -> set[str]:
    return set(json.loads(file.read_bytes())["data"]["graph"]["data"]["node"])


def objects_of_obj(file: Path) -> set[str]:
    return set(re.findall(r"^[og] (.+?)\s*$", file.read_text(encoding="utf-8"), re.MULTILINE))


def elements_of_bars(file: Path) -> set[str]:
    return {str(e["element_id"]) for e in json.loads(file.read_bytes())["element_list"]}
