"""Commands that complete a model and say why: ``infer`` and ``explain``."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from sitewright.cli.options import FILE, cell_option, json_option, project_argument
from sitewright.cli.output import Output, problems_json

if TYPE_CHECKING:
    from collections.abc import Iterator, Sequence

    from sitewright.app.model_changes import Change
    from sitewright.foundation.canonical import Json

_CONTACT = " contact "
_SHOWN = 100


@click.command()
@project_argument
@cell_option
@click.option(
    "--rules",
    type=FILE,
    help="Rules to add to the model's: a TOML or JSON file, or builtin:timber-panel.",
)
@click.option("--write", is_flag=True, help="Change building.json; keeps building.json.bak.")
@json_option
def infer(
    project: Path,
    cell: Path | None,
    rules: Path | None,
    write: bool,  # noqa: FBT001 -- click
    is_json: bool,  # noqa: FBT001 -- click
) -> int:
    """Infer contacts, supports, order, fasteners, grasps and stock; show what would change."""
    from sitewright.app.inferring import infer_project
    from sitewright.app.model_writing import BACKUP

    out = Output(is_json)
    found = infer_project(project, rules=rules, write=write, cell=cell)
    for line in change_lines(found.changes):
        out.line(line)
    out.notes(found.problems)
    if found.is_written:
        out.line(f"{len(found.changes)} changes written; the old model is {project / BACKUP}.")
    elif found.changes:
        out.line(f"{len(found.changes)} changes; nothing is written without --write.")
    else:
        out.line("Nothing to infer: the model has it all.")
    out.document(
        "sitewright.infer/1",
        {
            "is_written": found.is_written,
            "changes": changes_json(found.changes),
            "problems": problems_json(found.problems),
        },
    )
    return 0


@click.group()
def explain() -> None:
    """Say why: a component's facts, its place in the order, a step of a plan."""


@explain.command("component")
@click.argument("component")
@project_argument
@json_option
def component_(component: str, project: Path, is_json: bool) -> int:  # noqa: FBT001 -- click
    """Say where each fact of COMPONENT comes from, and who touches, carries and holds it."""
    from sitewright.app.explaining import explain_component

    return _say(is_json, "component", component, explain_component(project, component))


@explain.command("order")
@click.argument("component")
@project_argument
@json_option
def order_(component: str, project: Path, is_json: bool) -> int:  # noqa: FBT001 -- click
    """Say why COMPONENT comes when it comes: what must be there first, what waits for it."""
    from sitewright.app.explaining import explain_order

    return _say(is_json, "order", component, explain_order(project, component))


@explain.command("step")
@click.argument("step", type=click.IntRange(min=1))
@project_argument
@click.option("--code", help="Check code of the plan; the newest plan by default.")
@click.option("--target", help="The newest plan for this component.")
@cell_option
@json_option
def step_(
    step: int,
    project: Path,
    code: str | None,
    target: str | None,
    cell: Path | None,
    is_json: bool,  # noqa: FBT001 -- click
) -> int:
    """Say why STEP of a plan is there, why by this robot, with this piece, and in this way."""
    from sitewright.app.explaining_steps import explain_step
    from sitewright.app.project import read_project
    from sitewright.interaction_twin.labels import labels_of
    from sitewright.interaction_twin.step_document import step_document
    from sitewright.interaction_twin.step_words import explanation

    opened, out = read_project(project, cell=cell), Output(is_json)
    reasons = explain_step(opened, step, code=code, target=target)
    lines = explanation(reasons, labels_of(opened.model, opened.cell))
    for line in lines:
        out.line(line)
    document = {"topic": "step", "id": str(step), "lines": list(lines), **step_document(reasons)}
    out.document("sitewright.explain/1", document)
    return 0


def change_lines(changes: Sequence[Change]) -> Iterator[str]:
    """Yield the diff for people: ``+`` new, ``-`` gone, ``~`` another value; contacts counted."""
    contacts = [c for c in changes if _CONTACT in c.where]
    for change in changes:
        if _CONTACT in change.where or change.key == "origins":
            continue
        name = ".".join(n for n in (change.where, change.key) if n)
        why = f"  ({change.why})" if change.why else ""
        if change.old is None:
            value = f": {_short(change.new)}" if change.key else ""
            yield f"+ {name}{value}{why}"
        elif change.new is None:
            yield f"- {name}"
        else:
            yield f"~ {name}: {_short(change.old)} -> {_short(change.new)}{why}"
    if contacts:
        yield f"+ {sum(c.old is None for c in contacts)} contacts (--json lists them)"


def changes_json(changes: Sequence[Change]) -> list[Json]:
    """Return the diff as JSON, contacts too."""
    return [
        {"where": c.where, "key": c.key, "old": c.old, "new": c.new, "why": c.why} for c in changes
    ]


def _short(value: object) -> str:
    text = f"{len(value)} entries" if isinstance(value, list) and len(value) > 4 else str(value)  # noqa: PLR2004 - a short list
    return text if len(text) <= _SHOWN else f"{text[:_SHOWN]}..."


def _say(is_json: bool, topic: str, name: str, lines: list[str]) -> int:  # noqa: FBT001 -- click
    out = Output(is_json)
    for line in lines:
        out.line(line)
    out.document("sitewright.explain/1", {"topic": topic, "id": name, "lines": list(lines)})
    return 0
