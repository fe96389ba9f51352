"""A process that runs commands of the command line one after the other, and its memory."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

_SERVER = """
import contextlib, io, json, resource, sys
sys.path[:] = json.loads(sys.argv[1])
from sitewright.building_model.formats import import_process
from sitewright.cli.main import exit_code

def peak_mb():
    status = open("/proc/self/status").read()  # rusage of a new process holds its parent's memory
    own = int(status.partition("VmHWM:")[2].split()[0])
    return max(own, resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss) / 1000.0

for line in sys.stdin:
    out, said = io.StringIO(), io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(said):
        code = exit_code(json.loads(line))
    told = {"code": code, "said": said.getvalue(), "out": out.getvalue(), "peak_mb": peak_mb()}
    print(json.dumps(told), flush=True)
"""


@dataclass(frozen=True, slots=True)
class CommandServer:
    """A process that runs commands one after the other, so that its memory is its own."""

    process: subprocess.Popen[str]

    def run(self, *arguments: str) -> dict[str, Any]:
        assert self.process.stdin is not None
        assert self.process.stdout is not None
        self.process.stdin.write(json.dumps(arguments) + "\n")
        self.process.stdin.flush()
        answer: dict[str, Any] = json.loads(self.process.stdout.readline())
        return answer


@contextmanager
def command_server() -> Iterator[CommandServer]:
    """Give a server that ends with the block."""
    command = [sys.executable, "-c", _SERVER, json.dumps(sys.path)]
    with subprocess.Popen(
        command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as process:
        yield CommandServer(process)
        process.kill()
