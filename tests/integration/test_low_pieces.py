"""Pieces so low that the fingers come near to the table under them."""

from __future__ import annotations

from builders_walls import lattice
from sitewright.app.planning import plan_project


def test_a_lath_of_30_mm_is_laid_on_the_table_and_let_go_of() -> None:
    """The fingers keep 9.5 mm to the table then, less than the cell's clearance."""
    project = lattice(1, 1)
    assert project.cell.clearance_m > 0.0095
    report = plan_project(project)
    assert report.escalated == ()
    assert report.refusals == ()
    assert report.targets_planned == 1
