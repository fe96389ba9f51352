"""Fast Downward out of process: our SAS into its search binary, or its own driver as reference.

It is GPL software, so it is run as a program of its own and never imported.
"""

from __future__ import annotations

import contextlib
import os
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path
from typing import IO

from sitewright.errors import BackendError, BackendMissingError
from sitewright.foundation.sentence import Sentence
from sitewright.symbolic_planning.planner import NoPlan, SkillSequence, foregone, sequence
from sitewright.symbolic_planning.problem import Problem
from sitewright.symbolic_planning.sas import sas_text

_SEARCH = (
    "let(hlm,landmark_sum(lm_factory=lm_reasonable_orders_hps(lm_rhw()),pref=true),"
    "let(hff,ff(),lazy_wastar([hff,hlm],preferred=[hff,hlm],w={w},max_time={max_time})))"
)
BEST = _SEARCH.format(w=1, max_time=0.5)
"""Near-optimal plans; gives up after half a second."""
QUICK = _SEARCH.format(w=3, max_time=10)
"""Second try: dearer plans, much deeper."""
OPTIMAL = "astar(lmcut())"
"""Proven optimum; for certificates and tests, slow beyond four robots."""

_SOLVED = frozenset({0, 1, 2, 3})
_PROVEN_UNSOLVABLE = frozenset({10, 11})
_GAVE_UP = {
    12: Sentence("the search ended without a plan"),
    13: Sentence("the search ended without a plan"),
}
_LIMIT = {
    20: Sentence("the translator ran out of memory"),
    21: Sentence("the translator ran out of time"),
    22: Sentence("the search ran out of memory"),
    23: Sentence("the search ran out of time"),
    24: Sentence("the search ran out of memory and time"),
}
_PLAN = "plan"
_TASK = "task.sas"
_INSTALL = "pip install 'up-fast-downward>=1.0,<2'"


@dataclass(frozen=True, slots=True)
class Finished:
    """A run of an outside program.

    Attributes:
        code: Exit code; negative is the signal that ended it; None if we stopped it in time.
        output: What it printed, both streams.
        plan: Lines of the plan file, comments left out; None without a file.
    """

    code: int | None
    output: str
    plan: tuple[str, ...] | None


def installation() -> Path:
    """Return the folder of Fast Downward inside the installed package.

    Raises:
        BackendMissingError: The package or its binary is not there.
    """
    spec = find_spec("up_fast_downward")
    for location in (spec.submodule_search_locations if spec else None) or ():
        folder = Path(location) / "downward"
        if search_binary(folder).is_file():
            return folder
    raise BackendMissingError(
        "symbolic planner", "fast-downward", available=("builtin",), install=_INSTALL
    )


def search_binary(folder: Path) -> Path:
    """Return the search program in an installation."""
    return folder / "builds" / "release" / "bin" / "downward"


class FastDownward:
    """Fast path: our grounding, Fast Downward's search. Two searches, the better one first."""

    name = "fast-downward"

    def __init__(
        self, *, folder: Path | None = None, searches: Sequence[str] = (BEST, QUICK)
    ) -> None:
        """Use the installed package, or an installation in another folder.

        Args:
            folder: Holds ``builds/release/bin/downward``.
            searches: Tried in order until one answers.
        """
        self._folder = folder
        self._searches = tuple(searches)

    def plan(self, problem: Problem, *, timeout_s: float = 10.0) -> SkillSequence | NoPlan:
        """Return a validated plan, or a "no"; see `SymbolicPlanner`."""
        answer = foregone(problem, planner=self.name)
        if answer is not None:
            return answer
        binary = search_binary(self._folder or installation())
        task = sas_text(
            problem.actions, init=problem.init, goal=problem.goal, goal_not=problem.goal_not
        )
        started_s = time.perf_counter()
        result: SkillSequence | NoPlan = NoPlan(
            is_proven=False, reason=Sentence("No search was run.")
        )
        for number, search in enumerate(self._searches):
            left_s = timeout_s - (time.perf_counter() - started_s)
            if number > 0 and left_s <= 0.0:
                break
            command = [str(binary), "--search", search, "--internal-plan-file", _PLAN]
            run = _run(command, {_TASK: task}, stdin=_TASK, timeout_s=left_s)
            wall_s = time.perf_counter() - started_s
            planner = f"{self.name} search {number + 1}"
            result = _answer(problem, run, planner, wall_s, is_reproducible=number == 0)
            if isinstance(result, SkillSequence) or result.is_proven:
                break
        return result


class FastDownwardDriver:
    """Reference path: the PDDL text through Fast Downward's own translator."""

    name = "fast-downward-driver"

    def __init__(self, *, folder: Path | None = None, search: str = BEST) -> None:
        """Use the installed package, or an installation in another folder.

        Args:
            folder: Holds ``fast-downward.py`` and the builds.
            search: Option text of the search.
        """
        self._folder = folder
        self._search = search

    def plan(self, problem: Problem, *, timeout_s: float = 10.0) -> SkillSequence | NoPlan:
        """Return a validated plan, or a "no"; see `SymbolicPlanner`."""
        folder = self._folder or installation()
        command = [
            *(sys.executable, str(folder / "fast-downward.py")),
            *("--sas-file", _TASK, "--plan-file", _PLAN),
            *("--overall-time-limit", f"{max(1, round(timeout_s))}s"),
            *("--overall-memory-limit", "1500M"),
            *("domain.pddl", "problem.pddl", "--search", self._search),
        ]
        files = {"domain.pddl": problem.domain.text, "problem.pddl": problem.text}
        started_s = time.perf_counter()
        run = _run(command, files, stdin=None, timeout_s=timeout_s + 5.0)
        wall_s = time.perf_counter() - started_s
        return _answer(problem, run, self.name, wall_s, is_reproducible=True)


def _answer(
    problem: Problem, run: Finished, planner: str, wall_s: float, *, is_reproducible: bool
) -> SkillSequence | NoPlan:
    if run.code is None:
        return NoPlan(
            is_proven=False,
            reason=Sentence("The time limit was reached."),
            planner=planner,
            wall_s=wall_s,
        )
    if run.code in _SOLVED:
        if run.plan is None:
            raise BackendError(f"{planner} said that it found a plan, but wrote none.")
        return sequence(
            problem, run.plan, planner=planner, wall_s=wall_s, is_reproducible=is_reproducible
        )
    if run.code in _PROVEN_UNSOLVABLE:
        reason = Sentence("No order of skills reaches the goal.")
        return NoPlan(is_proven=True, reason=reason, planner=planner, wall_s=wall_s)
    limit = (_GAVE_UP | _LIMIT).get(run.code)
    if limit is None:
        raise BackendError(_broke(planner, run.code, run.output))
    return NoPlan(
        is_proven=False,
        reason=Sentence("No plan was found: {why}.", why=limit),
        planner=planner,
        wall_s=wall_s,
    )


def _broke(planner: str, code: int, output: str) -> str:
    tail = " ".join(output[-500:].split())
    number = -code if code < 0 else code - 128
    if number in {s.value for s in signal.Signals}:
        return f"{planner} was killed by {signal.Signals(number).name}; nothing was run. {tail}"
    return f"{planner} stopped with code {code}; nothing was run. {tail}"


def _run(
    command: Sequence[str], files: dict[str, str], *, stdin: str | None, timeout_s: float
) -> Finished:
    """Run a program in a fresh folder and a process group of its own."""
    with tempfile.TemporaryDirectory(prefix="sitewright-plan-") as name:
        folder = Path(name)
        for file, text in files.items():
            (folder / file).write_text(text, encoding="utf-8")
        with (folder / stdin if stdin else Path(os.devnull)).open("rb") as source:
            process = _start(command, folder, source)
        with process:
            try:
                output, _ = process.communicate(timeout=max(timeout_s, 0.01))
            except subprocess.TimeoutExpired:
                _kill_group(process)
                return Finished(None, "", None)
            except BaseException:
                _kill_group(process)
                raise
        return Finished(process.returncode, output, _plan_lines(folder / _PLAN))


def _start(command: Sequence[str], folder: Path, stdin: IO[bytes]) -> subprocess.Popen[str]:
    try:
        return subprocess.Popen(
            command,
            cwd=folder,
            stdin=stdin,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            errors="replace",
            start_new_session=True,
        )
    except FileNotFoundError as error:
        raise BackendMissingError(
            "symbolic planner", "fast-downward", available=("builtin",), install=_INSTALL
        ) from error
    except OSError as error:
        raise BackendError(f"Fast Downward cannot be started: {error}.") from error


def _kill_group(process: subprocess.Popen[str]) -> None:
    with contextlib.suppress(ProcessLookupError):
        os.killpg(process.pid, signal.SIGKILL)
    process.communicate()


def _plan_lines(file: Path) -> tuple[str, ...] | None:
    if not file.is_file():
        return None
    lines = (line.strip() for line in file.read_text(encoding="utf-8").splitlines())
    return tuple(line for line in lines if line and not line.startswith(";"))
