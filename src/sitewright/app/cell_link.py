"""The connection to the cell, whose loss is an event of the run and not its end."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

from sitewright.errors import BackendError, BackendMissingError
from sitewright.foundation.ids import CommandId
from sitewright.robot_team.driver import CellDriver, CommandStatus, Observation, SkillReport
from sitewright.robot_team.skill import SkillCommand

_T = TypeVar("_T")


class CellLostError(Exception):
    """The cell did not answer; what it was doing is uncertain."""


class CellLink:
    """A driver whose `BackendError` becomes a `CellLostError`; no other backend's does."""

    def __init__(self, connect: Callable[[], CellDriver]) -> None:
        """Connect; a cell that does not come up is as good as lost."""
        self.driver = _linked(connect)

    def new_epoch(self) -> int:
        """Raise the epoch."""
        return _linked(self.driver.new_epoch)

    def observe(self) -> Observation:
        """Return what is sensed now."""
        return _linked(self.driver.observe)

    def status(self, command_id: CommandId) -> CommandStatus:
        """Ask the ledger."""
        return _linked(lambda: self.driver.status(command_id))

    def execute(self, command: SkillCommand) -> SkillReport:
        """Run a command to its end."""
        return _linked(lambda: self.driver.execute(command))

    def hold(self) -> None:
        """Stop all motion."""
        _linked(self.driver.hold)

    def ask(self, question: Callable[[CellDriver], _T]) -> _T:
        """Return the answer to a question about the cell that is not part of the port."""
        return _linked(lambda: question(self.driver))


def _linked(call: Callable[[], _T]) -> _T:
    try:
        return call()
    except BackendMissingError:
        raise  # trying again does not install it
    except BackendError as error:
        raise CellLostError(str(error)) from error
