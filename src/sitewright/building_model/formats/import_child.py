"""The child process of `import_process`: limits first, then one function, then its answer.

It reads a stranger's bytes with other people's parsers. Therefore it may use only so much
memory, time and files, writes nothing unless it was allowed to, has no network where the kernel
lets us cut it off, and dies with its parent.
"""

from __future__ import annotations

import ctypes
import json
import os
import resource
import signal
from collections.abc import Callable, Sequence
from importlib import import_module

from sitewright.errors import ModelRejectedError
from sitewright.foundation.canonical import Json

_PR_SET_PDEATHSIG = 1
_PR_SET_NO_NEW_PRIVS = 38
_CAPABILITY_VERSION_3 = 0x20080522
_CAP_DAC_OVERRIDE, _CAP_DAC_READ_SEARCH = 1, 2
_CLONE_NEWUSER, _CLONE_NEWNET = 0x10000000, 0x40000000


def main(spec: str, function: str, *arguments: str) -> None:
    """Print ``{"answer": ..}``, or ``{"problems": [..]}`` if the file was refused.

    Args:
        spec: Parent process and limits, as `import_process.run_child` writes them.
        function: ``module:name`` of a function of texts that returns JSON.
        arguments: Its arguments.
    """
    parent, memory, cpu, written, files = (int(v) for v in spec.split(","))
    _die_with(parent)
    leave_network()
    _limit(memory, cpu, written, files)
    drop_powers(keeps_writing=written > 0)
    answer_to = os.fdopen(os.dup(1), "w", encoding="ascii")
    os.dup2(2, 1)  # what libraries print is no part of the answer
    module, _, name = function.partition(":")
    with answer_to:
        answer_to.write(_document(getattr(import_module(module), name), arguments))


def leave_network() -> bool:
    """Enter a network of our own without any interface; False where that is not allowed.

    Root does so in its own user namespace: in another it could not read files of other users.
    """
    libc = ctypes.CDLL(None, use_errno=True)
    kinds = _CLONE_NEWNET if os.geteuid() == 0 else _CLONE_NEWNET | _CLONE_NEWUSER
    return bool(libc.unshare(kinds) == 0)


def drop_powers(*, keeps_writing: bool) -> bool:
    """Keep no power of root but to reach files, so that no limit can be raised again.

    Args:
        keeps_writing: Files of other users may be written, too, as root may.

    Returns:
        False where the kernel does not let us; a user without powers has none to drop.
    """
    libc = ctypes.CDLL(None, use_errno=True)
    libc.prctl(_PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0)
    header = (ctypes.c_uint32 * 2)(_CAPABILITY_VERSION_3, 0)
    reaching = 1 << _CAP_DAC_READ_SEARCH | (1 << _CAP_DAC_OVERRIDE if keeps_writing else 0)
    kept = reaching if os.geteuid() == 0 else 0
    data = (ctypes.c_uint32 * 6)(kept, kept, 0, 0, 0, 0)  # effective, permitted, inheritable; twice
    return bool(libc.capset(header, data) == 0)


def _document(function: Callable[..., Json], arguments: Sequence[str]) -> str:
    try:
        return json.dumps({"answer": function(*arguments)}, allow_nan=False)
    except ModelRejectedError as error:
        return json.dumps({"problems": [_texts(p) for p in error.problems]})


def _die_with(parent: int) -> None:
    ctypes.CDLL(None).prctl(_PR_SET_PDEATHSIG, signal.SIGKILL)
    if os.getppid() != parent:  # it died before we could ask for that
        os._exit(1)


def _limit(memory: int, cpu: int, written: int, files: int) -> None:
    for kind, soft, hard in (
        (resource.RLIMIT_AS, memory, memory),
        (resource.RLIMIT_CPU, cpu, cpu + 1),  # the first sends SIGXCPU, which says why
        (resource.RLIMIT_FSIZE, written, written),
        (resource.RLIMIT_NOFILE, files, files),
        (resource.RLIMIT_CORE, 0, 0),
    ):
        _, most = resource.getrlimit(kind)
        allowed = hard if most == resource.RLIM_INFINITY else min(hard, most)
        resource.setrlimit(kind, (min(soft, allowed), allowed))


def _texts(problem: object) -> list[Json]:
    keys = ("code", "severity", "where", "message", "fix", "source_id")
    return [str(getattr(problem, key)) for key in keys]
