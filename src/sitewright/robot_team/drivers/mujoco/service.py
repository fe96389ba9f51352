"""What the cell answers: commands by the ledger's rules, observations, holds."""

from __future__ import annotations

import traceback
from collections.abc import Callable, Mapping
from pathlib import Path
from threading import Lock

from sitewright.errors import CommandRefusedError, OutcomeUnknownError
from sitewright.foundation.canonical import canonical_json, sha256_hex
from sitewright.foundation.ids import CommandId
from sitewright.robot_team.driver import CommandState
from sitewright.robot_team.drivers.mujoco.cell_log import LOG_NAME, CellLog
from sitewright.robot_team.drivers.mujoco.codec import (
    Plain,
    Setup,
    checkpoint_from_json,
    checkpoint_to_json,
    command_from_json,
    observation_to_json,
    report_to_json,
    setup_from_json,
    setup_to_json,
)
from sitewright.robot_team.drivers.mujoco.faults import drop_when_due, nudge_when_due
from sitewright.robot_team.drivers.mujoco.live import LiveView, picture_of
from sitewright.robot_team.drivers.mujoco.observing import observe
from sitewright.robot_team.drivers.mujoco.opening import open_simulation
from sitewright.robot_team.drivers.mujoco.simulation import Effect, Simulation
from sitewright.robot_team.drivers.mujoco.skills import registry
from sitewright.robot_team.skill import SkillCommand

_LOOK_S = 0.2
"""While a skill runs and time stands still (physics is being rebuilt), ask again so often."""


def setup_hash(setup: Setup) -> str:
    """Return what tells two set-ups apart, be it read from the file or made by a client."""
    as_read = setup_from_json(setup_to_json(setup))
    return sha256_hex(canonical_json(setup_to_json(as_read)))


class CellService:
    """One simulated cell with its log; every method is safe from any thread.

    Attributes:
        is_broken: A command ended in a bug; the physics cannot be trusted any more.
    """

    def __init__(self, folder: Path, setup: Setup) -> None:
        self.is_broken = False
        self._setup_hash = setup_hash(setup)
        self._lock = Lock()
        self._running: CommandId | None = None
        self._log = CellLog(folder / LOG_NAME)
        last = self._log.ledger.checkpoint
        self._sim = open_simulation(
            setup, None if last is None else checkpoint_from_json(last), self._record
        )
        self._live = LiveView()
        self._sim.on_step = self._after_step
        if last is None:
            self._append("opened", {})
        self._operations: Mapping[str, Callable[[Plain], Plain]] = {
            "hello": self._hello,
            "new_epoch": self._new_epoch,
            "observe": self._observe,
            "status": self._status,
            "execute": self._execute,
            "hold": self._hold,
            "live": self._see,
            "extra": self._extra,
        }

    def answer(self, operation: str, data: Plain) -> Plain:
        """Do one operation; an unknown one is refused."""
        if operation not in self._operations:
            raise CommandRefusedError(f"the simulated cell knows no operation {operation!r}")
        return self._operations[operation](data)

    def _append(self, kind: str, facts: Mapping[str, Plain]) -> None:
        checkpoint = checkpoint_to_json(self._sim.checkpoint())
        self._log.append(kind, {**facts, "checkpoint": checkpoint})

    def _record(self, effect: Effect) -> None:
        self._append("effect", effect)

    def _hello(self, _: Plain) -> Plain:
        return {"setup": self._setup_hash}

    def _new_epoch(self, _: Plain) -> Plain:
        with self._lock:
            self._log.append("epoch", {"epoch": self._log.ledger.epoch + 1})
            return self._log.ledger.epoch

    def _observe(self, _: Plain) -> Plain:
        with self._lock:
            return observation_to_json(observe(self._sim))

    def _status(self, data: Plain) -> Plain:
        running = self._running
        status = self._log.ledger.status(CommandId(str(data)))
        if status.state is CommandState.ACCEPTED and data == running:
            return {"state": CommandState.RUNNING.value, "report": None}
        report = None if status.report is None else report_to_json(status.report)
        return {"state": status.state.value, "report": report}

    def _hold(self, _: Plain) -> Plain:
        self._sim.hold.set()
        return None

    def _after_step(self, sim: Simulation) -> None:
        drop_when_due(sim)
        self._live.look(sim)

    def _see(self, _: Plain) -> Plain:
        """Return where everything is, without waiting for the end of a skill."""
        while True:
            if self._lock.acquire(blocking=False):
                try:
                    return picture_of(self._sim)
                finally:
                    self._lock.release()
            picture = self._live.wait(_LOOK_S)
            if picture is not None:
                return picture

    def _extra(self, _: Plain) -> Plain:
        return {
            "contacts": list(self._log.ledger.contacts),
            "physical_log": str(self._log.path),
            "sim_time_s": self._sim.time_s,
        }

    def _execute(self, data: Plain) -> Plain:
        command = command_from_json(data)
        with self._lock:
            known = self._log.ledger.status(command.command_id)
            match known.state:
                case CommandState.ENDED:
                    return self._log.ledger.ended[command.command_id]
                case CommandState.ACCEPTED | CommandState.RUNNING:
                    raise OutcomeUnknownError(
                        f"command {command.command_id} was accepted before; its end is not recorded"
                    )
                case CommandState.NEVER:
                    return self._run(command)

    def _run(self, command: SkillCommand) -> Plain:
        if command.epoch < self._log.ledger.epoch:
            raise CommandRefusedError(
                f"epoch {command.epoch} is over; the cell is at {self._log.ledger.epoch}"
            )
        registry.check(self._sim, command, registry.EXECUTORS)
        self._sim.hold.clear()
        self._running = command.command_id
        try:
            self._do(command)
        except Exception as error:
            self.is_broken = True  # the physics may be ahead of the log; the next process is not
            traceback.print_exc()
            what = f"{type(error).__name__}: {error}"
            raise OutcomeUnknownError(f"the simulation broke off: {what}") from error
        finally:
            self._running = None
        return self._log.ledger.ended[command.command_id]

    def _do(self, command: SkillCommand) -> None:
        """Run a command, with a record before and after."""
        accepted = {"command_id": command.command_id, "skill": command.skill}
        self._append("accepted", {**accepted, "epoch": command.epoch, "robot": command.robot})
        report, contacts = registry.execute(self._sim, command)
        nudge_when_due(self._sim, len(self._log.ledger.ended) + 1)
        self._append(
            "ended",
            {
                "command_id": command.command_id,
                "report": report_to_json(report),
                "contacts": contacts,
            },
        )
