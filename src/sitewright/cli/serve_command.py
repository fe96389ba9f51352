"""The commands ``serve``, the page of a project, and ``user``, who may sign in there."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING

import click

from sitewright.cli.options import FILE, cell_option, json_option, project_argument
from sitewright.cli.output import Output

if TYPE_CHECKING:
    from sitewright.app.serving.reached import Tls
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
@click.option("--host", help="Address of this machine for others; needs --users and --tls-*.")
@click.option("--tls-cert", type=FILE, help="Certificate with its chain (PEM).")
@click.option("--tls-key", type=FILE, help="Key of the certificate (PEM, without a password).")
@click.option("--tablet", is_flag=True, help="With --host: print the link as a QR code too.")
@click.option("--from-design", is_flag=True, help="Start on an empty site.")
@cell_option
@json_option
def serve(  # noqa: PLR0913, PLR0917 -- one argument per option
    project: Path,
    port: int,
    no_browser: bool,  # noqa: FBT001 -- click
    speed: float,
    users: Path | None,
    host: str | None,
    tls_cert: Path | None,
    tls_key: Path | None,
    tablet: bool,  # noqa: FBT001 -- click
    from_design: bool,  # noqa: FBT001 -- click
    cell: Path | None,
    is_json: bool,  # noqa: FBT001 -- click
) -> int:
    """Serve the page on which people see, understand, approve and steer the run."""
    from sitewright.app.serving.server import ServeOptions

    tls = _checked_tls(tls_cert, tls_key)
    _check_host(host, is_guarded=users is not None and tls is not None, tablet=tablet)
    options = ServeOptions(
        folder=project,
        cell=cell,
        port=port,
        speed=speed,
        from_design=from_design,
        users=users,
        host=host,
        tls=tls,
    )
    out = Output(is_json)
    return serve_page(options, out, opens_browser=not no_browser, draws_code=tablet)


def _checked_tls(certificate: Path | None, key: Path | None) -> Tls | None:
    from sitewright.app.serving.reached import Tls

    if certificate is None and key is None:
        return None
    if certificate is None or key is None:
        raise click.UsageError("--tls-cert and --tls-key belong together; give both.")
    tls = Tls(certificate, key)
    if fault := tls.fault():
        raise click.UsageError(fault)
    return tls


def _check_host(host: str | None, *, is_guarded: bool, tablet: bool) -> None:
    from sitewright.app.serving.reached import host_fault

    if host is None:
        if tablet:
            raise click.UsageError("--tablet needs --host: a tablet cannot reach 127.0.0.1.")
        return
    if not is_guarded:
        raise click.UsageError(
            "--host lets other machines in, so it needs people with tokens of their own "
            "(--users FILE, see `sitewright user`) and TLS (--tls-cert FILE --tls-key FILE)."
        )
    if fault := host_fault(host):
        raise click.UsageError(f"--host: {fault}")


_BY_NAME = "People sign in by name, with the tokens that `sitewright user` printed."


def serve_page(
    options: ServeOptions, out: Output, *, opens_browser: bool, draws_code: bool = False
) -> int:
    """Serve until interrupted; tell where, to a tablet's camera too if asked."""
    from sitewright.app.serving.server import serve as serve_project

    def on_ready(address: Address) -> None:
        out.line(f"The page: {address.url}")
        if draws_code and not out.is_json:
            click.echo(_qr_code(address.url))
        signs_in = "The link signs in one time." if options.users is None else _BY_NAME
        out.line(f"{signs_in} Ctrl-C holds the run and ends the server.")
        out.document(_SERVE, {"port": address.port, "url": address.url})
        sys.stdout.flush()
        if opens_browser:
            click.launch(address.url)

    serve_project(options, on_ready=on_ready)
    out.note("The server has ended and nothing moves; `sitewright serve` goes on.")
    return 0


def _qr_code(text: str) -> str:
    """Return a text as a QR code of block characters, dark on light."""
    import io

    import segno

    drawn = io.StringIO()
    segno.make_qr(text, error="m").terminal(drawn, compact=True)
    return drawn.getvalue()


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
@click.option("--pin", "has_pin", is_flag=True, help="Ask for a PIN for shared tablets too.")
@json_option
def user(name: str, role: str, file: Path, has_pin: bool, is_json: bool) -> int:  # noqa: FBT001 -- click
    """Add a person who may sign in at the page, and print the token, this once."""
    from sitewright.app.serving.users import new_user
    from sitewright.interaction_twin.roles import Role

    out = Output(is_json)
    pin = ""
    if has_pin:
        pin = click.prompt(
            "PIN (4 to 12 digits)", hide_input=True, confirmation_prompt=True, err=True
        )
    token = new_user(file, name, Role(role), pin=pin)
    out.line(f"Token of {name} ({role}), shown this once: {token}")
    out.line(f"Serve with: sitewright serve --users {file}")
    out.document("sitewright.user/1", {"name": name, "role": role, "token": token})
    return 0
