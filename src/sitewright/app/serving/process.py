"""The process of a run, as the server starts it.

python -m sitewright.app.serving.process --project DIR [--cell FILE] [--speed FACTOR]
"""

from __future__ import annotations

import argparse
import os
import sys
from pathlib import Path

from sitewright.app.serving.channel import Channel
from sitewright.app.serving.project_run import worker_of
from sitewright.errors import SitewrightError


def main(arguments: list[str]) -> int:
    """Run the project of the command line for the server at the other end of the pipe."""
    parser = argparse.ArgumentParser(description="The process of a run behind a page.")
    parser.add_argument("--project", type=Path, required=True, metavar="DIR")
    parser.add_argument("--cell", type=Path)
    parser.add_argument("--speed", type=float, default=1.0)
    parser.add_argument("--from-design", action="store_true")
    parser.add_argument("--waits", action="store_true", help="go on only when told")
    options = parser.parse_args(arguments)
    writer = os.fdopen(os.dup(sys.stdout.fileno()), "wb")
    os.dup2(sys.stderr.fileno(), sys.stdout.fileno())  # what a library prints is no message
    channel = Channel(sys.stdin.buffer, writer)
    try:
        worker = worker_of(
            channel,
            options.project,
            cell=options.cell,
            speed=options.speed,
            from_design=options.from_design,
            waits=options.waits,
        )
    except SitewrightError as error:
        channel.send({"is": "run", "what": "broken", "message": str(error)})
        return error.exit_code
    worker.serve()
    return 0


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
