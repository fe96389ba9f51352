"""Commands that look ahead: ``graph``, ``plan`` and ``show``."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from sitewright.cli.options import FILE, cell_option, json_option, project_argument
from sitewright.cli.output import Output
from sitewright.cli.terminal import Dialogue

if TYPE_CHECKING:
    from sitewright.app.planning import PlanReport
    from sitewright.app.project import Project
    from sitewright.central_controller.ports import Planned
    from sitewright.foundation.canonical import Json
    from sitewright.interaction_twin.labels import Labels


@click.command()
@project_argument
@cell_option
@click.option("--svg", type=FILE, help="Write the picture to this file.")
@json_option
def graph(project: Path, cell: Path | None, svg: Path | None, is_json: bool) -> int:  # noqa: FBT001
    """Show the construction relationship graph of the site as it stands now."""
    from sitewright.app.looking import graph_of_site
    from sitewright.app.project import open_project
    from sitewright.construction_graph.queue import target_queue
    from sitewright.interaction_twin.drawing.graph_picture import graph_picture
    from sitewright.interaction_twin.text_graph import text_graph

    out = Output(is_json)
    found = graph_of_site(open_project(project, cell=cell))
    queue = target_queue(found)
    for line in text_graph(found):
        out.line(line)
    out.line()
    out.line(f"Next targets: {', '.join(queue) or 'none'}")
    if svg is not None:
        svg.write_text(graph_picture(found) + "\n", encoding="utf-8")
        out.line(f"Picture: {svg}")
    nodes: list[Json] = [
        {
            "id": node.id,
            "label": node.label,
            "layer": node.layer.value,
            "type": node.type,
            "construction_parents": list(node.construction_parents),
            "material_used": node.material_used,
        }
        for node in sorted(found.node_by_id.values(), key=lambda n: n.id)
    ]
    out.document("sitewright.graph/1", {"nodes": nodes, "queue": list(queue)})
    return 0


@click.command()
@project_argument
@cell_option
@click.option("--target", help="Stop after this target.")
@click.option("--steps", is_flag=True, help="Show every step in plain words.")
@json_option
def plan(
    project: Path,
    cell: Path | None,
    target: str | None,
    steps: bool,  # noqa: FBT001 -- click
    is_json: bool,  # noqa: FBT001 -- click
) -> int:
    """Plan all targets in order, motions certified, without moving anything.

    Fastening counts as planned only where the design states fasteners.
    """
    from sitewright.app.planning import plan_project
    from sitewright.app.project import open_project
    from sitewright.interaction_twin.labels import labels_of

    opened, out = open_project(project, cell=cell), Output(is_json)
    _require_target(opened, target)
    labels = labels_of(opened.model, opened.cell)
    with Dialogue() as dialogue:
        found = plan_project(
            opened, target, lambda t, words: dialogue.say(f"{labels.name(t)}: {labels.told(words)}")
        )
    for planned in found.planned:
        for line in _plan_lines(planned, labels, is_long=steps):
            out.line(line)
    for escalation in found.escalated:
        reason = labels.told(f"{escalation.verdict}: {escalation.reason}")
        out.line(f"{labels.name(escalation.target)}: refused, {reason}")
    for waiting in found.waiting:
        out.line(f"{labels.name(waiting)}: not planned")
    total_s = found.timing_s.get("total", 0.0)
    out.line(f"{found.targets_planned} of {found.targets_total} planned in {total_s:.1f} s.")
    notes = _plan_notes(opened)
    for note in notes:
        out.line(note)
    out.document("sitewright.plan/1", {**_plan_document(found), "notes": list(notes)})
    codes = [e.exit_code for e in found.escalated]
    return 0 if not codes else _plan_exit_code(found, codes)


def _require_target(project: Project, target: str | None) -> None:
    from sitewright.app.project import ProjectError
    from sitewright.errors import did_you_mean

    if target is not None and target not in project.model.component_by_id:
        hint = did_you_mean(target, project.model.component_by_id)
        raise ProjectError(f"There is no component {target!r} in the model.{hint}")


def _plan_notes(project: Project) -> tuple[str, ...]:
    from sitewright.building_model.component import Layer

    targets = [c for c in project.model.component_by_id.values() if c.layer is Layer.TARGET]
    bare = sum(not c.operations for c in targets)
    if bare < len(targets):
        return ()
    return ("Fastening is not counted: this design states no fasteners for its components.",)


def _plan_exit_code(found: PlanReport, codes: list[int]) -> int:
    """Return the refusals' own code if nothing was planned and they agree, else 6."""
    return codes[0] if not found.planned and len(set(codes)) == 1 else 6


def _plan_lines(planned: Planned, labels: Labels, *, is_long: bool) -> tuple[str, ...]:
    from sitewright.interaction_twin.proposal_view import plan_lines, view_of

    lines = plan_lines(view_of(planned.proposal, labels, refusals=planned.refusals))
    return (*lines, "") if is_long else (f"{lines[0]}, code {lines[1].split()[-1]}",)


def _plan_document(found: PlanReport) -> dict[str, Json]:
    from dataclasses import asdict

    from sitewright.central_controller.fingerprint import fingerprint
    from sitewright.interaction_twin.report.figures import refusal_json

    proposals: list[Json] = [
        {
            "target": p.proposal.target,
            "fingerprint": fingerprint(p.proposal),
            "steps": len(p.proposal.steps),
            "duration_s": sum(s.duration_s for s in p.proposal.steps),
            "closest_distance_m": min(
                (d for s in p.proposal.steps if (d := s.closest_distance_m) is not None),
                default=None,
            ),
            "planning_s": dict(p.timing_s),
        }
        for p in found.planned
    ]
    escalated: list[Json] = [
        {
            "target": e.target,
            "reason": e.reason,
            "is_proven": e.is_proven,
            "verdict": e.verdict,
            "blockers": list(e.blockers),
            "counter_proposals": [asdict(c) for c in e.counter_proposals],
        }
        for e in found.escalated
    ]
    return {
        "targets_total": found.targets_total,
        "targets_planned": found.targets_planned,
        "proposals": proposals,
        "refused": escalated,
        "waiting": list(found.waiting),
        "refusals": [refusal_json(r) for r in found.refusals],
        "planning_s": dict(found.timing_s),
    }


@click.command()
@project_argument
@click.argument("code", required=False)
@cell_option
@json_option
def show(project: Path, code: str | None, cell: Path | None, is_json: bool) -> int:  # noqa: FBT001
    """Show a proposal of the project's runs by its check CODE; the newest by default."""
    from sitewright.app.looking import find_proposal
    from sitewright.app.project import open_project
    from sitewright.interaction_twin.labels import labels_of
    from sitewright.interaction_twin.narration import narrate
    from sitewright.interaction_twin.proposal_view import plan_lines, view_of
    from sitewright.interaction_twin.text_gantt import text_gantt

    opened, out = open_project(project, cell=cell), Output(is_json)
    found = find_proposal(opened, code)
    labels = labels_of(opened.model, opened.cell)
    view = view_of(found.proposal, labels)
    for line in (*plan_lines(view), "", *text_gantt(view.steps)):
        out.line(line)
    steps: list[Json] = [
        {
            "number": step.number,
            "robot": step.call.robot,
            "skill": step.call.skill,
            "arguments": list(step.call.arguments),
            "words": narrate(step.call, labels),
            "duration_s": step.duration_s,
            "closest_distance_m": step.closest_distance_m,
        }
        for step in found.proposal.steps
    ]
    out.document(
        "sitewright.proposal-view/1",
        {
            "run": found.run,
            "target": found.proposal.target,
            "fingerprint": found.fingerprint,
            "code": view.code,
            "steps": steps,
        },
    )
    return 0
