"""The figures of a run as cards on the report page."""

from __future__ import annotations

from collections.abc import Iterator
from html import escape

from sitewright.interaction_twin.measures import counted, in_millimetres, in_seconds
from sitewright.interaction_twin.report.content import Figures


def figure_cards(figures: Figures) -> str:
    """Return the figures as cards; what is worse than it should be is marked."""
    return f'<div class="figures">{"".join(_figure(*f) for f in _shown_figures(figures))}</div>'


def _figure(value: str, words: str, is_bad: bool) -> str:  # noqa: FBT001 -- private
    mark = " bad" if is_bad else ""
    return f'<div class="figure{mark}"><b>{escape(value)}</b><span>{escape(words)}</span></div>'


def _shown_figures(f: Figures) -> Iterator[tuple[str, str, bool]]:
    """Yield value, words and whether the value is worse than it should be."""
    yield (
        f"{f.targets_installed}/{f.targets_total}",
        "components installed",
        f.targets_installed < f.targets_total,
    )
    if f.fasteners_total:
        is_short = f.fasteners_driven < f.fasteners_total
        yield f"{f.fasteners_driven}/{f.fasteners_total}", "fasteners driven", is_short
    if f.finishes_total:
        is_short = f.finishes_applied < f.finishes_total
        yield f"{f.finishes_applied}/{f.finishes_total}", "finishes applied", is_short
    yield in_seconds(f.makespan_s), "makespan", False
    yield str(f.skills_executed), f"skills done, {f.skills_failed} failed", f.skills_failed > 0
    total = f.trajectories_total
    yield (
        f"{f.trajectories_certified}/{total}",
        "motions certified",
        f.trajectories_certified < total,
    )
    yield (
        f"{f.trajectories_confirmed}/{total}",
        "motions confirmed",
        f.trajectories_confirmed < total,
    )
    yield in_millimetres(f.closest_distance_m), "closest certified distance", False
    contacts = "not told" if f.unallowed_contacts is None else str(f.unallowed_contacts)
    yield contacts, "contacts not allowed", f.unallowed_contacts != 0
    yield tenths_of_millimetres(f.worst_pose_error_m), "worst position error", False
    yield milliradians(f.worst_pose_error_rad), "worst angle error", False
    yield str(f.replans), f"replans, {counted(f.questions_asked, 'question')} asked", False


def tenths_of_millimetres(length_m: float | None) -> str:
    """Return a length such as ``0.8 mm``."""
    return "-" if length_m is None else f"{length_m * 1000.0:.1f} mm"


def milliradians(angle_rad: float | None) -> str:
    """Return an angle such as ``0.4 mrad``."""
    return "-" if angle_rad is None else f"{angle_rad * 1000.0:.1f} mrad"
