"""Commands about the installation: ``doctor`` and ``version``."""

from __future__ import annotations

import click

from sitewright.cli.options import json_option
from sitewright.cli.output import Output

_BACKEND = 10


@click.command()
@json_option
def doctor(is_json: bool) -> int:  # noqa: FBT001 -- click
    """Look at this machine: what is needed, what is there, how to get what is missing."""
    from sitewright.app.doctor import diagnose

    out = Output(is_json)
    checks = diagnose()
    for check in checks:
        mark = "ok " if check.is_ok else ("NO " if check.is_needed else "-- ")
        out.line(f"{mark} {check.name}: {check.detail}")
        if not check.is_ok:
            out.line(f"     {check.fix}")
    is_ready = all(c.is_ok for c in checks if c.is_needed)
    out.document(
        "sitewright.doctor/1",
        {
            "is_ready": is_ready,
            "checks": [
                {
                    "name": c.name,
                    "is_ok": c.is_ok,
                    "is_needed": c.is_needed,
                    "detail": c.detail,
                    "fix": "" if c.is_ok else c.fix,
                }
                for c in checks
            ],
        },
    )
    return 0 if is_ready else _BACKEND


@click.command()
@json_option
def version(is_json: bool) -> int:  # noqa: FBT001 -- click
    """Print the version."""
    from importlib.metadata import version as version_of

    found = version_of("sitewright")
    out = Output(is_json)
    out.line(f"sitewright {found}")
    out.document("sitewright.version/1", {"version": found})
    return 0
