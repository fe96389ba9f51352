"""A small project built by the real command line, in processes that can be killed.

What happened is read from two sides that know nothing of each other: the controller's journal and
the cell's physical log.
"""

from __future__ import annotations

import json
import os
import re
import signal
import subprocess
import sys
import time
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import apsw
import psutil

from sitewright.app.project import new_project
from sitewright.app.run_folder import chain_events, chain_of, run_folders
from sitewright.central_controller.events import (
    AnyEvent,
    ComponentPositioned,
    OperationDone,
    SkillIntent,
    SkillOutcome,
)
from sitewright.foundation.ids import CommandId
from sitewright.robot_team.drivers.mujoco.cell_log import (
    LOG_NAME,
    Record,
    read_physical_log,
    read_records,
)
from sitewright.robot_team.drivers.mujoco.places import PID_NAME

_INTERRUPTIBLE = "import signal; signal.signal(signal.SIGINT, signal.default_int_handler)"
COMMAND = (sys.executable, "-c", f"{_INTERRUPTIBLE}; from sitewright.cli.main import main; main()")
"""Shells start what they put in the background with SIGINT ignored; the test sends one."""
NAILS_PER_STUD = 4
_POLL_S = 0.01
_PATIENCE_S = 110.0


@dataclass(frozen=True, slots=True, kw_only=True)
class Ended:
    """How a command ended."""

    exit_code: int
    document: Mapping[str, Any]
    said: str

    @property
    def message(self) -> str:
        return str(self.document.get("message", ""))


@dataclass(slots=True)
class RealSite:
    """A project folder with the wooden frame, as many studs of it as a test needs."""

    folder: Path
    lives: list[subprocess.Popen[bytes]] = field(default_factory=list)

    @classmethod
    def of(
        cls, folder: Path, *, studs: int = 1, supports: int = 2, **simulation: float
    ) -> RealSite:
        """Make the project; `simulation` are the settings of the simulated cell."""
        project = folder / "project"
        new_project(project, example="wooden_frame")
        building = json.loads((project / "building.json").read_text())
        left_out = {f"stud-{n}" for n in range(studs + 1, 4)}
        left_out |= {f"support-{n}" for n in range(supports + 1, 3)}
        building["components"] = [c for c in building["components"] if c["id"] not in left_out]
        (project / "building.json").write_text(json.dumps(building))
        site = cls(folder)
        site.simulate(**simulation)
        return site

    @property
    def project(self) -> Path:
        return self.folder / "project"

    @property
    def runs(self) -> Path:
        return self.project / "runs"

    @property
    def newest(self) -> Path:
        return run_folders(self.runs)[-1].path

    @property
    def journal(self) -> Path:
        return self.newest / "journal.db"

    @property
    def cell_folder(self) -> Path:
        """The cell stands in the folder of the first run of the chain."""
        return chain_of(run_folders(self.runs)[-1])[0].path / "cell"

    @property
    def cell_log(self) -> Path:
        return self.cell_folder / LOG_NAME

    def simulate(self, **settings: float) -> None:
        """Write the cell's ``[simulation]`` anew."""
        file = self.project / "cell.toml"
        text = file.read_text().split("\n[simulation]\n")[0]
        lines = [f"{name} = {value}" for name, value in settings.items()]
        file.write_text("\n".join([text.rstrip("\n"), "", "[simulation]", *lines, ""]))

    def without_buffers(self) -> None:
        """Take every buffer station out of the cell."""
        file = self.project / "cell.toml"
        tables = re.split(r"(?m)^(?=\[)", file.read_text())
        file.write_text("".join(t for t in tables if 'kind = "buffer"' not in t))

    def paint(self, target: str) -> None:
        """Add a painted stripe to a target, on its upper face."""
        file = self.project / "building.json"
        building = json.loads(file.read_text())
        (component,) = [c for c in building["components"] if c["id"] == target]
        height_m = component["geometry"]["box"]["size_m"][2]
        component["operations"] = [
            {
                "id": f"{target}.paint",
                "process": "paint",
                "on": [target],
                "component_T_operation": {"p_m": [0, 0, height_m / 2], "q_wxyz": [0, 1, 0, 0]},
                "patch": {
                    "size_m": [0.4, 0.08],
                    "standoff_m": 0.12,
                    "width_m": 0.05,
                    "speed_m_s": 0.15,
                },
            }
        ]
        file.write_text(json.dumps(building))

    # ---- commands --------------------------------------------------------------------------

    def begin(self, *arguments: str, **environment: str) -> subprocess.Popen[bytes]:
        """Give the run command and go on at once."""
        return self._start("run", str(self.project), "--approve", "auto", *arguments, **environment)

    def run(self, *arguments: str, **environment: str) -> Ended:
        """Give the run command and wait for its end."""
        return self.end_of(self.begin(*arguments, **environment))

    def resolve(self, document: Mapping[str, Any], answer: str) -> Ended:
        """Answer the open question of a document."""
        question = document["question"]
        return self.end_of(
            self._start(
                "resolve", question["run"], str(question["step"]), answer,
                "--project", str(self.project), "--who", "tester",
            )
        )  # fmt: skip

    def end_of(self, process: subprocess.Popen[bytes]) -> Ended:
        process.wait(_PATIENCE_S)
        name = self._output(self.lives.index(process))
        text = name.with_suffix(".out").read_text()
        return Ended(
            exit_code=process.returncode,
            document=json.loads(text) if text else {},
            said=name.with_suffix(".err").read_text(),
        )

    def _start(self, *arguments: str, **environment: str) -> subprocess.Popen[bytes]:
        name = self._output(len(self.lives))
        with name.with_suffix(".out").open("wb") as out, name.with_suffix(".err").open("wb") as err:
            process = subprocess.Popen(
                [*COMMAND, *arguments, "--json"],
                stdin=subprocess.DEVNULL,
                stdout=out,
                stderr=err,
                env={**os.environ, "XDG_STATE_HOME": str(self.folder / "state"), **environment},
            )
        self.lives.append(process)
        return process

    def _output(self, number: int) -> Path:
        return self.folder / f"life-{number}"

    # ---- kills -----------------------------------------------------------------------------

    def kill_controller(self) -> None:
        self.lives[-1].kill()
        self.lives[-1].wait()

    def kill_cell(self) -> None:
        """Kill the cell and wait until it is gone; it must have been there."""
        pid = self.cell_pid()
        assert pid is not None, "there is no cell to kill"
        os.kill(pid, signal.SIGKILL)
        until(lambda: not _is_alive(pid))

    def cell_pid(self) -> int | None:
        file = self.cell_folder / PID_NAME
        try:
            pid = int(json.loads(file.read_text())["pid"])
        except (OSError, ValueError):
            return None
        return pid if _is_alive(pid) else None

    def clean_up(self) -> None:
        """Leave no process behind."""
        for life in self.lives:
            if life.poll() is None:
                life.kill()
                life.wait()
        for log in self.runs.glob(f"*/cell/{PID_NAME}"):
            pid = int(json.loads(log.read_text())["pid"])
            if _is_alive(pid):
                os.kill(pid, signal.SIGKILL)

    # ---- what is on the disk ----------------------------------------------------------------

    def events(self) -> list[AnyEvent]:
        """Return the journal of the newest run and of those it continues."""
        return list(chain_events(chain_of(run_folders(self.runs)[-1]))[0])

    def journal_records(self) -> int:
        """Count the journal's records; 0 while there is none."""
        try:
            db = apsw.Connection(str(self.journal), flags=apsw.SQLITE_OPEN_READONLY)
        except (IndexError, apsw.Error):
            return 0
        try:
            return len(db.execute("SELECT seq FROM event").fetchall())
        except apsw.Error:
            return 0
        finally:
            db.close()

    def cell_records(self) -> list[Record]:
        try:
            return read_records(self.cell_log)[0]
        except IndexError:
            return []

    def cell_lines(self) -> int:
        """Count the cell's records; quick, for waiting."""
        return self._cell_bytes().count(b"\n")

    def last_cell_record(self) -> Record:
        """Return the last whole record of the cell; quick, for waiting."""
        lines = self._cell_bytes().rpartition(b"\n")[0].rsplit(b"\n", 1)
        return dict(json.loads(lines[-1])) if lines[-1] else {}

    def shots(self) -> int:
        """Count the nails that left a tool."""
        return self._cell_bytes().count(b'"effect":"fastener"')

    def _cell_bytes(self) -> bytes:
        try:
            return self.cell_log.read_bytes()
        except (IndexError, FileNotFoundError):
            return b""

    def physical(self, effect: str = "") -> list[Record]:
        """Return what really happened in the cell."""
        return [e for e in read_physical_log(self.cell_log) if effect in ("", e["effect"])]


def _is_alive(pid: int) -> bool:
    try:
        return bool(psutil.Process(pid).status() != psutil.STATUS_ZOMBIE)
    except psutil.NoSuchProcess:
        return False


def until(condition: Callable[[], bool], patience_s: float = _PATIENCE_S) -> None:
    """Wait for something that must come."""
    deadline_s = time.monotonic() + patience_s
    while not condition():
        assert time.monotonic() < deadline_s, "waited in vain"
        time.sleep(_POLL_S)


@contextmanager
def real_site(
    folder: Path, *, studs: int = 1, supports: int = 2, **simulation: float
) -> Iterator[RealSite]:
    """Give a project, and end all its processes afterwards."""
    site = RealSite.of(folder, studs=studs, supports=supports, **simulation)
    try:
        yield site
    finally:
        site.clean_up()


def check_journal_against_physics(
    site: RealSite, *, nails: int, aside: frozenset[str] = frozenset()
) -> None:
    """Compare the journal with what happened in the cell; never with itself.

    Pieces that were put aside were gripped and let go, and are not in the building.
    """
    events, physical = site.events(), site.physical()
    intents = {e.command_id: e for e in events if isinstance(e, SkillIntent)}
    accepted = Counter(r["command_id"] for r in site.cell_records() if r["kind"] == "accepted")
    assert set(accepted) <= set(intents), "the cell ran something that was not intended"
    assert set(accepted.values()) <= {1}, "a command was accepted twice"
    effects = Counter((e["effect"], e["command_id"]) for e in physical if "command_id" in e)
    assert set(effects.values()) <= {1}, "an effect happened twice"
    assert {command for _, command in effects} <= set(accepted)
    _check_nails(events, physical, nails)
    _check_pieces(site, events, physical, aside)
    outcomes = [e for e in events if isinstance(e, SkillOutcome)]
    _check_outcomes(outcomes, intents, {command for _, command in effects})


def _check_nails(events: list[AnyEvent], physical: list[Record], nails: int) -> None:
    driven = Counter(e["operation"] for e in physical if e["effect"] == "fastener")
    done = Counter(str(e.operation) for e in events if isinstance(e, OperationDone))
    painted = {e["operation"] for e in physical if e["effect"] == "paint"}
    assert driven == Counter({o: n for o, n in done.items() if o not in painted})
    assert len(driven) == nails
    assert set(driven.values()) <= {1}, "a nail was driven twice"


def _check_pieces(
    site: RealSite, events: list[AnyEvent], physical: list[Record], aside: frozenset[str]
) -> None:
    """Each piece in the building was gripped, let go once for each grip, and no other is gone."""
    gripped = Counter(e["piece"] for e in physical if e["effect"] == "gripped")
    let_go = Counter(e["piece"] for e in physical if e["effect"] in ("let-go", "dropped"))
    assert gripped == let_go
    used = {str(e.piece) for e in events if isinstance(e, ComponentPositioned)}
    assert used | aside == set(gripped)
    assert not used & aside
    assert site.cell_records()[-1]["checkpoint"]["fixings"]["grips"] == {}


_EFFECT_BY_SKILL = {"grasp": "gripped", "release": "let-go", "fasten": "fastener"}


def _check_outcomes(
    outcomes: list[SkillOutcome], intents: Mapping[CommandId, SkillIntent], effective: set[str]
) -> None:
    """What the journal holds for done happened, and what happened it does not hold for undone."""
    assert set(Counter(o.command_id for o in outcomes).values()) <= {1}
    for outcome in outcomes:
        if intents[outcome.command_id].call.skill in _EFFECT_BY_SKILL:
            assert outcome.report.is_done == (outcome.command_id in effective)
