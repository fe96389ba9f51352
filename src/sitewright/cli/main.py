"""The command ``sitewright``: one group, and the only place where errors become exit codes."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence

import click

from sitewright.cli.audit_commands import audit
from sitewright.cli.check_command import check
from sitewright.cli.decision_commands import approve, hold, reject, resume
from sitewright.cli.export_commands import export
from sitewright.cli.failure import failed
from sitewright.cli.import_command import import_
from sitewright.cli.infer_commands import explain, infer
from sitewright.cli.layout_command import layout
from sitewright.cli.plan_commands import graph, plan, show
from sitewright.cli.project_commands import new
from sitewright.cli.run_commands import demo, report, resolve, run
from sitewright.cli.serve_command import serve, user
from sitewright.cli.system_commands import doctor, version


@click.group(context_settings={"help_option_names": ["-h", "--help"]})
def commands() -> None:
    """Sitewright turns a digital building model into a supervised assembly by a team of robots.

    \b
    Exit codes: 0 done, 1 internal error, 2 wrong usage, 3 model or cell invalid, 4 proven that
    no plan exists, 5 limit reached, 6 no motion for some targets, 7 approval missing, stale or
    refused, 8 execution failed or in question, 9 locked by another run, 10 backend missing or
    broken, 130 interrupted.
    """  # noqa: D301 -- \b keeps the lines together


for _command in (
    demo,
    new,
    import_,
    check,
    infer,
    explain,
    graph,
    layout,
    plan,
    show,
    run,
    serve,
    user,
    approve,
    reject,
    hold,
    resume,
    resolve,
    report,
    audit,
    export,
    doctor,
    version,
):
    commands.add_command(_command)


def main(arguments: Sequence[str] | None = None) -> None:
    """Run the command line and leave with its exit code."""
    sys.exit(exit_code(sys.argv[1:] if arguments is None else arguments))


def exit_code(arguments: Sequence[str]) -> int:
    """Run the command line and return its exit code; nothing but a bug shows a trace."""
    try:
        answer = commands.main(list(arguments), prog_name="sitewright", standalone_mode=False)
    except BrokenPipeError:  # the reader of stdout has gone; there is nobody to tell
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 1
    except BaseException as error:
        if isinstance(error, SystemExit):
            raise
        return failed(error, arguments)
    return answer if isinstance(answer, int) else 0
