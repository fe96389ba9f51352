"""The worker of a run: plans, asks, executes; what it hears comes through a pipe.

It ends when the server is gone: the robots are held, the journal says so, and `serve` goes on.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from threading import Lock, Thread
from typing import Protocol

from sitewright.app.run import RunResult
from sitewright.app.serving.channel import Channel, Message
from sitewright.app.serving.desk import Desk, Respond
from sitewright.app.serving.memory import Memory
from sitewright.central_controller.codec import from_json
from sitewright.central_controller.cycle_state import CycleState
from sitewright.central_controller.events import event_to_json
from sitewright.central_controller.site_state import SiteState
from sitewright.errors import SitewrightError
from sitewright.foundation.ids import ComponentId
from sitewright.interaction_twin.decisions import Reply, Signed, no_run
from sitewright.interaction_twin.policy import ApprovalPolicy
from sitewright.interaction_twin.report.content import Stamped
from sitewright.robot_team.driver import CellDriver

_PULSE_S = 0.05


@dataclass(slots=True)
class Hooks:
    """What a run is given to talk to the desk and the server.

    Attributes:
        desk: Who is asked.
        on_record: Gets every record once it is on the disk.
        on_connect: Gets the cell's driver whenever it is opened anew.
        begun_by: The decision to begin or go on, if a person made it.
    """

    desk: Desk
    on_record: Callable[[str, Stamped], None]
    on_connect: Callable[[CellDriver], None]
    begun_by: Signed | None = None


class RunOnce(Protocol):
    """Runs the project until it stops."""

    def __call__(self, hooks: Hooks) -> RunResult:
        """Begin, continue or resume the run; returns how it stands."""
        ...


@dataclass
class Worker:
    """Runs the project whenever somebody wants it to, and passes on what happens.

    Attributes:
        run_once: The run, put together elsewhere.
        begins_itself: Begin without being told: nothing is approved, so nothing moves.
        policy: Rules of the project.
        at_rest: The state of the run while it stands.
        types: Type of each component of the design.
    """

    channel: Channel
    memory: Memory
    run_once: RunOnce
    begins_itself: bool = False
    policy: ApprovalPolicy = field(default_factory=ApprovalPolicy)
    at_rest: Callable[[], CycleState] = lambda: CycleState(site=SiteState())
    types: Mapping[ComponentId, str] = field(default_factory=dict)
    _driver: CellDriver | None = field(default=None, init=False)
    _driver_lock: Lock = field(default_factory=Lock, init=False)

    def serve(self) -> None:
        """Work until the server is gone."""
        desk = Desk(
            self.memory,
            policy=self.policy,
            at_rest=self.at_rest,
            types=self.types,
            waits_to_go=not self.begins_itself,
            on_asking=self._tell_asking,
        )
        Thread(target=self._listen, args=(desk,), daemon=True).start()
        begun_by: Signed | None = None
        go = self.begins_itself
        while True:
            if not go:
                self.channel.send({"is": "run", "what": "idle"})
                begun_by = desk.wait_to_go()
                if begun_by is None:
                    return
            go = False
            self._run(desk, begun_by)
            if desk.has_quit:
                return

    def _run(self, desk: Desk, begun_by: Signed | None) -> None:
        self.channel.send({"is": "run", "what": "begun"})
        hooks = Hooks(desk, self._recorder(desk), self._connected, begun_by)
        try:
            result = self.run_once(hooks)
        except Exception as error:  # noqa: BLE001 -- the outermost loop: told, and asked for a decision
            desk.run_ended(error, str(error))
            kind = "" if isinstance(error, SitewrightError) else f"{type(error).__name__}: "
            self.channel.send({"is": "run", "what": "broken", "message": f"{kind}{error}"})
        else:
            desk.run_ended(None, result.message)
            self.channel.send(
                {
                    "is": "run",
                    "what": "stopped",
                    "message": result.message,
                    "exit_code": result.exit_code,
                }
            )
        finally:
            with self._driver_lock:
                self._driver = None

    def _tell_asking(self, asks: str) -> None:
        self.channel.send({"is": "run", "what": "asks", "asks": asks})

    def _recorder(self, desk: Desk) -> Callable[[str, Stamped], None]:
        def on_record(run: str, stamped: Stamped) -> None:
            self.channel.send(event_message(run, stamped))
            desk.on_record(run, stamped)

        return on_record

    def _connected(self, driver: CellDriver) -> None:
        with self._driver_lock:
            self._driver = driver

    # ---- listening -------------------------------------------------------------------------

    def _listen(self, desk: Desk) -> None:
        for message in self.channel.messages():
            self._hear(desk, message)
        desk.quit()
        self._hold_cell(desk)

    def _hear(self, desk: Desk, message: Message) -> None:
        respond = self._responder(str(message["id"]))
        match message["do"]:
            case "decide":
                desk.decide(from_json(Signed, message["signed"]), respond)
            case "hold":
                respond(desk.hold(from_json(Signed, message["signed"])))
                Thread(target=self._hold_cell, args=(desk,), daemon=True).start()
            case "ways":
                desk.other_ways(str(message["fingerprint"]), respond)
            case other:
                respond(no_run(f"The run does not know what {other!r} means."))

    def _responder(self, message_id: str) -> Respond:
        def respond(reply: Reply) -> None:
            self.channel.send(
                {"is": "reply", "id": message_id, "status": reply.status, "body": reply.body}
            )

        return respond

    def _hold_cell(self, desk: Desk) -> None:
        """Tell the cell again and again until the hold is written down.

        A skill that was told to the cell just before clears an earlier hold when it starts.
        """
        while desk.hold_asked() is not None:
            with self._driver_lock:
                driver = self._driver
            if driver is None:
                return
            try:
                driver.hold()
            except SitewrightError:
                return  # a cell that does not answer has stopped by itself
            time.sleep(_PULSE_S)


def event_message(run: str, stamped: Stamped) -> Message:
    """Return a record as it goes to the server."""
    return {
        "is": "event",
        "run": run,
        "n": stamped.number,
        "at_utc_ns": stamped.at_utc_ns,
        "kind": stamped.event.kind,
        "version": stamped.event.version,
        "body": event_to_json(stamped.event),
    }
