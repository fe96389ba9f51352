"""Facts about two parts of a foreign file, in metres and by our ids."""

from __future__ import annotations

from collections.abc import Mapping

from sitewright.building_model.formats.neutral import NeutralRelation
from sitewright.building_model.formats.neutral_scale import Scale
from sitewright.building_model.formats.part_names import Directory
from sitewright.building_model.model import Relation, RelationKind
from sitewright.foundation.canonical import Json
from sitewright.foundation.pose import scale, subtract


def relation_of(stated: NeutralRelation, directory: Directory, scaling: Scale) -> Relation | None:
    """Return a relation of the model; None if one end is left out, or its kind is not ours."""
    a, b = directory.by_source(stated.a), directory.by_source(stated.b)
    if a is None or b is None or a == b or stated.kind not in set(RelationKind):
        return None
    return Relation(kind=RelationKind(stated.kind), a=a, b=b, data=_data(stated.data, scaling))


def _data(data: Mapping[str, Json], scaling: Scale) -> dict[str, Json]:
    """Return the data of a relation in metres: ``area`` and ``location`` change their names."""
    result: dict[str, Json] = {}
    for key, value in data.items():
        if key == "area" and isinstance(value, int | float):
            result["area_m2"] = value * scaling.metres**2
        elif key == "location" and isinstance(value, list | tuple):
            x, y, z = (float(str(v)) for v in value)
            place = subtract(scale((x, y, z), scaling.metres), scaling.shift_m)
            result["location_m"] = list(place)
        else:
            result[key] = value
    return result
