"""The command ``serve``: the page of a project on this machine."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click

from sitewright.cli.options import FILE, cell_option, json_option, project_argument
from sitewright.cli.output import Output

if TYPE_CHECKING:
    from sitewright.app.serving.server import Address, ServeOptions

_SERVE = "sitewright.serve/1"


@click.command()
@project_argument
@click.option(
    "--port",
    type=click.IntRange(0, 65_535),
    default=8765,
    show_default=True,
    help="Port on this machine; 0 takes a free one.",
)
@click.option("--no-browser", is_flag=True, help="Do not open the page.")
@click.option(
    "--speed",
    type=click.FloatRange(0.0, 100.0),
    default=1.0,
    show_default=True,
    help="Of the simulated cell: 1 is real time, 0 as fast as it can.",
)
@click.option("--users", type=FILE, help="Users with tokens of their own (`sitewright user`).")
@click.option("--from-design", is_flag=True, help="Start on an empty site.")
@cell_option
@json_option
def serve(  # noqa: PLR0913, PLR0917 -- one argument per option
    project: Path,
    port: int,
    no_browser: bool,  # noqa: FBT001 -- click
    speed: float,
    users: Path | None,
    from_design: bool,  # noqa: FBT001 -- click
    cell: Path | None,
    is_json: bool,  # noqa: FBT001 -- click
) -> int:
    """Serve the page on which people see, understand, approve and steer the run."""
    from sitewright.app.serving.server import ServeOptions

    options = ServeOptions(
        folder=project, cell=cell, port=port, speed=speed, from_design=from_design, users=users
    )
    return serve_page(options, Output(is_json), opens_browser=not no_browser)


def serve_page(options: ServeOptions, out: Output, *, opens_browser: bool) -> int:
    """Serve until interrupted; tell where."""
    from sitewright.app.serving.server import serve as serve_project

    def on_ready(address: Address) -> None:
        out.line(f"The page: {address.url}")
        out.line("The link signs in one time. Ctrl-C holds the run and ends the server.")
        out.document(_SERVE, {"port": address.port, "url": address.url})
        sys.stdout.flush()
        if opens_browser:
            click.launch(address.url)

    serve_project(options, on_ready=on_ready)
    out.note("The server has ended and nothing moves; `sitewright serve` goes on.")
    return 0


@click.command()
@click.argument("name")
@click.option(
    "--role",
    type=click.Choice(["viewer", "operator", "supervisor", "admin"]),
    required=True,
    help="What the person may do at the page.",
)
@click.option(
    "--file",
    type=FILE,
    default=Path("users.toml"),
    show_default=True,
    help="The users file; made if it is not there.",
)
@json_option
def user(name: str, role: str, file: Path, is_json: bool) -> int:  # noqa: FBT001 -- click
    """Add a person who may sign in at the page, and print the token, this once."""
    from sitewright.app.serving.users import new_user
    from sitewright.interaction_twin.roles import Role

    out = Output(is_json)
    token = new_user(file, name, Role(role))
    out.line(f"Token of {name} ({role}), shown this once: {token}")
    out.line(f"Serve with: sitewright serve --users {file}")
    out.document("sitewright.user/1", {"name": name, "role": role, "token": token})
    return 0
