"""The as-built state as a table and as status by source id, for other programs."""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Mapping

from sitewright.building_model.component import Component, Layer
from sitewright.building_model.model import BuildingModel
from sitewright.foundation.canonical import Json
from sitewright.foundation.pose import Pose

COLUMNS = (
    "id",
    "name",
    "type",
    "layer",
    "order",
    "status",
    "material_used",
    "robot",
    "installed_at",
    "operations_done",
    "operations_total",
    "deviation_mm",
    "deviation_deg",
    "x_m",
    "y_m",
    "z_m",
    "qw",
    "qx",
    "qy",
    "qz",
    "source_id",
)


def as_built_csv(model: BuildingModel, world_T_model: Pose) -> str:
    """Return one line per component of the building; stock and zones are left out.

    Args:
        model: The model with as-built records folded in.
        world_T_model: Places the model in the cell that measured it.
    """
    text = io.StringIO()
    writer = csv.DictWriter(text, COLUMNS, lineterminator="\n")
    writer.writeheader()
    for component in model.component_by_id.values():
        if component.layer in (Layer.TARGET, Layer.AS_BUILT):
            writer.writerow(_row(component, world_T_model))
    return text.getvalue()


def status_by_source(model: BuildingModel, world_T_model: Pose) -> dict[str, Json]:
    """Return what a script inside the author's program writes back: source id to layer and keys."""
    found: dict[str, Json] = {}
    for component in model.component_by_id.values():
        if component.source is None or component.as_built is None:
            continue
        row = _row(component, world_T_model)
        keys: dict[str, Json] = {
            "status": str(row["status"]),
            "built_at": str(row["installed_at"]),
            "robot": str(row["robot"]),
            "material_used": str(row["material_used"]),
            "deviation_mm": str(row["deviation_mm"]),
            "deviation_deg": str(row["deviation_deg"]),
        }
        found[component.source.id] = {"layer": component.layer.value, "keys": keys}
    return found


def _row(component: Component, world_T_model: Pose) -> Mapping[str, object]:
    record = component.as_built
    designed = world_T_model @ component.world_T_component
    measured = record.world_T_component_measured if record else None
    pose = measured or designed
    done = sum(s == "done" for s in record.operations.values()) if record else 0
    return {
        "id": component.id,
        "name": component.name,
        "type": component.type,
        "layer": component.layer.value,
        "order": "" if component.order is None else component.order,
        "status": record.status if record else "planned",
        "material_used": (record.material_used or "") if record else "",
        "robot": record.robot if record else "",
        "installed_at": record.installed_at if record else "",
        "operations_done": done,
        "operations_total": len(component.operations),
        "deviation_mm": "" if measured is None else f"{designed.distance_to_m(pose) * 1000:.2f}",
        "deviation_deg": ""
        if measured is None
        else f"{math.degrees(designed.angle_to_rad(pose)):.3f}",
        **dict(zip(("x_m", "y_m", "z_m"), (f"{v:.6f}" for v in pose.position_m), strict=True)),
        **dict(
            zip(("qw", "qx", "qy", "qz"), (f"{v:.7f}" for v in pose.quaternion_wxyz), strict=True)
        ),
        "source_id": component.source.id if component.source else "",
    }
