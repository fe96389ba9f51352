"""The as-built state as a table, for other programs."""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Mapping

from sitewright.building_model.as_built import deviation_of, status_of
from sitewright.building_model.component import Component, Layer
from sitewright.building_model.model import BuildingModel
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


_FORMULA = ("=", "+", "-", "@")


def as_built_csv(model: BuildingModel, world_T_model: Pose) -> str:
    """Return one line per component of the building; stock and zones are left out.

    Names, types and source ids that a spreadsheet would take for a formula begin with ``'``.

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


def _row(component: Component, world_T_model: Pose) -> Mapping[str, object]:
    record = component.as_built
    measured = record.world_T_component_measured if record else None
    pose = measured or world_T_model @ component.world_T_component
    off = deviation_of(component, world_T_model)
    done = sum(s == "done" for s in record.operations.values()) if record else 0
    return {
        "id": component.id,
        "name": _cell(component.name),
        "type": _cell(component.type),
        "layer": component.layer.value,
        "order": "" if component.order is None else component.order,
        "status": status_of(component),
        "material_used": (record.material_used or "") if record else "",
        "robot": record.robot if record else "",
        "installed_at": record.installed_at if record else "",
        "operations_done": done,
        "operations_total": len(component.operations),
        "deviation_mm": "" if off is None else f"{off[0] * 1000.0:.2f}",
        "deviation_deg": "" if off is None else f"{math.degrees(off[1]):.3f}",
        **dict(zip(("x_m", "y_m", "z_m"), (f"{v:.6f}" for v in pose.position_m), strict=True)),
        **dict(
            zip(("qw", "qx", "qy", "qz"), (f"{v:.7f}" for v in pose.quaternion_wxyz), strict=True)
        ),
        "source_id": _cell(component.source.id) if component.source else "",
    }


def _cell(text: str) -> str:
    """Return a text that no spreadsheet calculates."""
    return f"'{text}" if text.startswith(_FORMULA) else text
