"""The twin of one project behind the web interface: journal, run process, cell and files."""

from __future__ import annotations

import asyncio
import shutil
from collections.abc import Mapping
from functools import partial
from importlib.metadata import version
from pathlib import Path

from sitewright.app.looking import graph_at
from sitewright.app.planning import start_of
from sitewright.app.project import read_project
from sitewright.app.reporting import REPORT_PAGE
from sitewright.app.run_folder import run_folders
from sitewright.app.serving.channel import Message
from sitewright.app.serving.history import Numbered, history_of
from sitewright.app.serving.live_feed import LiveFeed
from sitewright.app.serving.past_runs import bars_document
from sitewright.app.serving.proposal_shelf import ProposalShelf
from sitewright.app.serving.records import Records
from sitewright.app.serving.run_process import RunLink
from sitewright.app.serving.scene_shelf import SceneShelf, triangles
from sitewright.app.serving.side_work import SideWork, all_runs, one_run, why
from sitewright.central_controller.codec import to_json
from sitewright.central_controller.events import (
    AnyEvent,
    ApprovalRejected,
    ComponentDisplaced,
    ComponentInstalled,
    ComponentPositioned,
    ComponentStanding,
    DesignChanged,
    OperationDone,
    ProposalMade,
    ProposalSuperseded,
    RunStarted,
    SiteObserved,
    TargetRefused,
    event_from_json,
)
from sitewright.central_controller.fingerprint import check_code
from sitewright.central_controller.proposal import Proposal
from sitewright.central_controller.site_state import site_of
from sitewright.foundation.canonical import Json
from sitewright.foundation.clock import Clock
from sitewright.foundation.ids import RobotId
from sitewright.interaction_twin.decisions import Decision, Reply, Signed
from sitewright.interaction_twin.event_document import audit_document, event_document
from sitewright.interaction_twin.labels import labels_of
from sitewright.interaction_twin.narration import narrate
from sitewright.interaction_twin.phrases import ENGLISH, PHRASEBOOKS
from sitewright.interaction_twin.proposal_document import (
    ProposalSource,
    differences,
    proposal_document,
)
from sitewright.interaction_twin.proposal_story import story_of
from sitewright.interaction_twin.report.content import Stamped
from sitewright.interaction_twin.report.timeline import timeline
from sitewright.interaction_twin.roles import Person
from sitewright.interaction_twin.scene_document import (
    SceneSource,
)
from sitewright.interaction_twin.state_document import Standing, state_document
from sitewright.interaction_twin.web.twin import Audience, Document
from sitewright.robot_team.skill import SkillCall

_NS = 1_000_000_000
_MS = 1_000_000
_CHANGES_SCENE = (
    ComponentDisplaced,
    ComponentInstalled,
    ComponentPositioned,
    ComponentStanding,
    DesignChanged,
    OperationDone,
    ProposalMade,
    ProposalSuperseded,
    ApprovalRejected,
    RunStarted,
    TargetRefused,
)


class ProjectTwin:
    """Port `Twin` for a project and the process of its run."""

    def __init__(
        self, folder: Path, link: RunLink, audience: Audience, clock: Clock, *, cell: Path | None
    ) -> None:
        """Read the project and its journal; nothing is started yet.

        Raises:
            SitewrightError: The project or its journal cannot be read.
        """
        self._folder, self._cell_file = folder, cell
        self._link, self._audience, self._clock = link, audience, clock
        self._project = read_project(folder, cell=cell)
        self._labels = labels_of(self._project.model, self._project.cell)
        self._records = Records(site_of(self._project.model), history_of(self._runs))
        self._shelf, self._side = ProposalShelf(self._runs), SideWork()
        self._standing = Standing(is_active=False)
        self._shelf_lock = asyncio.Lock()
        self._started_ns = clock.monotonic_ns()
        self.feed = LiveFeed(audience, clock, folder=self._cell_folder, on_change=self._tell_state)
        self._scenes = SceneShelf(self.feed)

    @property
    def _runs(self) -> Path:
        return self._folder / "runs"

    async def start(self) -> None:
        """Start the process of the run."""
        await self._link.start(self._hear)

    async def stop(self) -> None:
        """Let the run hold and end."""
        await self._link.stop()
        await asyncio.to_thread(self._side.close)

    # ---- hearing -----------------------------------------------------------------------------

    def _hear(self, message: Message) -> None:
        if message["is"] == "event":
            self._hear_event(message)
        else:
            self._hear_of_run(message)
        self._tell_state()

    def _hear_event(self, message: Message) -> None:
        version_, number, at_utc_ns = message["version"], message["n"], message["at_utc_ns"]
        assert isinstance(version_, int)  # noqa: S101 -- our own process
        assert isinstance(number, int)  # noqa: S101
        assert isinstance(at_utc_ns, int)  # noqa: S101
        event = event_from_json(str(message["kind"]), version_, message["body"])
        stamped = Stamped(at_utc_ns=at_utc_ns, event=event, number=number)
        record = Numbered(str(message["run"]), stamped)
        if isinstance(event, DesignChanged):
            self._read_again()
        before = self._mounted()
        if not self._records.add(record):
            return
        if event.kind == "run_held":
            self._stand(is_hold_asked=False)
        if self._is_drawn_otherwise(event, before):
            self._scenes.outdate()
        self._audience.tell(event_document(record.run, stamped, self._labels))

    def _hear_of_run(self, message: Message) -> None:
        match message["what"]:
            case "begun":
                self._standing = Standing(is_active=True)
            case "broken" | "gone":
                trouble = self._standing.trouble or str(
                    message.get("message", "The process of the run ended.")
                )
                self._standing = Standing(
                    is_active=False, is_alive=message["what"] != "gone", trouble=trouble
                )
            case "idle":
                self._standing = Standing(is_active=False, trouble=self._standing.trouble)
            case _:
                self._standing = Standing(is_active=False)

    def _stand(self, *, is_hold_asked: bool) -> None:
        now = self._standing
        self._standing = Standing(
            is_active=now.is_active,
            is_alive=now.is_alive,
            trouble=now.trouble,
            is_hold_asked=is_hold_asked,
        )

    def _read_again(self) -> None:
        """Take up a changed design."""
        self._project = read_project(self._folder, cell=self._cell_file)
        self._labels = labels_of(self._project.model, self._project.cell)
        self._records = Records(site_of(self._project.model), self._records.all())

    def _mounted(self) -> Mapping[RobotId, str | None]:
        sensed = self._records.state.site.sensed
        return {} if sensed is None else {r: s.mounted for r, s in sensed.robots.items()}

    def _is_drawn_otherwise(self, event: AnyEvent, mounted: Mapping[RobotId, str | None]) -> bool:
        if isinstance(event, SiteObserved):
            return self._mounted() != mounted
        return isinstance(event, _CHANGES_SCENE)

    def _tell_state(self) -> None:
        self._audience.tell(self.state())

    def _cell_folder(self) -> Path | None:
        first = self._records.first_run
        return self._runs / first / "cell" if first else None

    # ---- looking -----------------------------------------------------------------------------

    def state(self) -> Document:
        """Return how the run stands now."""
        run, number = self._records.last
        standing = self._standing
        standing = Standing(
            is_active=standing.is_active,
            is_alive=standing.is_alive,
            trouble=standing.trouble,
            is_hold_asked=standing.is_hold_asked,
            started_at_ms=self._records.skill_started_ms,
        )
        return {
            **state_document(self._records.state, standing, self._labels),
            "run": run,
            "n": number,
            "scene_epoch": self._scenes.epoch,
            "cell": "live" if self.feed.is_live else "absent",
        }

    def events_after(self, run: str, number: int) -> list[Document]:
        """Return the events after one, in order."""
        return [
            event_document(r.run, r.stamped, self._labels) for r in self._records.after(run, number)
        ]

    def last_event(self) -> tuple[str, int]:
        """Return run and number of the newest event."""
        return self._records.last

    async def scene(self) -> tuple[str, bytes]:
        """Return hash and text of everything that is drawn; worked out once per epoch."""
        return await self._scenes.get(self._scene_source)

    def _scene_source(self) -> SceneSource:
        project, state = self._project, self._records.state
        start = start_of(project)
        seen = state.site.sensed
        made = state.proposal
        return SceneSource(
            project=project.model.name or project.folder.name,
            run=self._records.last[0],
            model=project.model,
            cell=project.cell,
            graph=graph_at(project, state.site),
            site=state.site,
            observation=start.observation if seen is None else seen,
            labels=self._labels,
            triangles=triangles,
            active=None if made is None else made.target,
        )

    async def proposal(self, fingerprint: str, language: str) -> Document | None:
        """Return a proposal; the open one if no fingerprint is given."""
        made = self._records.state.proposal
        wanted = fingerprint or ("" if made is None else made.fingerprint)
        if not wanted:
            state = self.state()
            return {"open": None, "phase": state["phase"], "reason": state["words"]}
        found = await self._find(wanted)
        if found is None:
            return None
        run, proposal = found
        history = [r.stamped for r in self._records.all()]
        story = story_of(wanted, history)
        if story is None:
            return None
        before = self._records.approved_before(wanted)
        previous = await self._find(before) if before else None
        is_open = made is not None and made.fingerprint == wanted
        state_ = self._records.state
        source = ProposalSource(
            run=run,
            fingerprint=wanted,
            proposal=proposal,
            story=story,
            next_step=state_.done + 1 if is_open else 1,
            labels=self._labels,
            why=state_.why if is_open else "",
            refusals=state_.refusals if is_open else (),
            previous=None if previous is None else (before, previous[1]),
            book=PHRASEBOOKS.get(language, ENGLISH),
        )
        return await asyncio.to_thread(partial(proposal_document, source, is_open=is_open))

    async def blob(self, sha256: str) -> bytes | None:
        """Return the exact bytes of a trajectory."""
        async with self._shelf_lock:
            return await asyncio.to_thread(self._shelf.trajectory, sha256)

    async def runs(self) -> Document:
        """Return all runs of the project."""
        return await self._side.do(all_runs, self._folder, self._cell_file)

    async def run(self, run: str) -> Document | None:
        """Return one run with its events and bars."""
        return await self._side.do(one_run, self._folder, self._cell_file, run)

    async def why(self, fingerprint: str, number: int) -> Document | None:
        """Return why a step of a proposal is as it is."""
        if await self._find(fingerprint) is None:
            return None
        return await self._side.do(why, self._folder, self._cell_file, fingerprint, number)

    async def report(self, run: str) -> bytes | None:
        """Return the report of a run; None while there is none."""
        folder = next((f for f in run_folders(self._runs) if f.run == run), None)
        page = None if folder is None else folder.path / REPORT_PAGE
        if page is None or not page.exists():
            return None
        return await asyncio.to_thread(page.read_bytes)

    async def schedule(self) -> Document:
        """Return planned and actual skills of the newest run on one time axis."""
        run, _ = self._records.last
        bars = timeline(s.event for s in self._records.of_run(run))
        return {
            "run": run,
            "planned": bars_document(bars.planned, self._labels),
            "actual": bars_document(bars.actual, self._labels),
        }

    async def graph(self) -> Document:
        """Return the construction relationship graph now."""
        graph = graph_at(self._project, self._records.state.site)
        return {
            "nodes": [
                {
                    "id": n.id,
                    "name": n.label,
                    "layer": n.layer.value,
                    "type": n.type,
                    "parents": list(n.construction_parents),
                    "order": getattr(n, "order", None),
                    "made_of": n.material_used,
                }
                for n in graph.node_by_id.values()
            ],
            "comes_before": [list(pair) for pair in graph.comes_before],
        }

    def audit(self) -> Document:
        """Return all decisions, the newest first."""
        found = (audit_document(r.run, r.stamped, self._labels) for r in self._records.all())
        return {"entries": [entry for entry in found if entry is not None][::-1]}

    async def health(self) -> Document:
        """Return how server, run, cell and journal are."""
        run, number = self._records.last
        now_ns = self._clock.utc_ns()
        seen_ns = self.feed.seen_ns
        return {
            "server": {
                "version": version("sitewright"),
                "uptime_s": (self._clock.monotonic_ns() - self._started_ns) / _NS,
                "clients": self._audience.size,
            },
            "run": {
                "phase": self.state()["phase"],
                "pid": self._link.process_id,
                "is_alive": self._link.process_id is not None,
            },
            "cell": {
                "state": "live" if self.feed.is_live else "absent",
                "age_ms": (now_ns - seen_ns) / _MS if seen_ns else None,
            },
            "journal": {"run": run, "n": number},
            "disk_free_bytes": shutil.disk_usage(self._folder).free,
        }

    # ---- deciding ----------------------------------------------------------------------------

    async def decide(self, decision: Decision, person: Person, body_sha256: str) -> Reply:
        """Pass a decision on to the run; a stale one comes back with what is different."""
        signed = Signed(decision=decision, person=person, body_sha256=body_sha256)
        reply = await self._link.ask("decide", {"signed": to_json(signed)})
        if reply.body.get("error") != "stale":
            return reply
        return Reply(status=reply.status, body=await self._with_difference(reply.body))

    async def hold(self, decision: Decision, person: Person, body_sha256: str) -> Reply:
        """Stop the robots: the cell first, the journal after."""
        told = await self.feed.hold()
        signed = Signed(decision=decision, person=person, body_sha256=body_sha256)
        reply = await self._link.ask("hold", {"signed": to_json(signed)})
        if reply.is_ok:
            self._stand(is_hold_asked=True)
            self._tell_state()
        return Reply(status=reply.status, body={**reply.body, "told_cell": told})

    async def ways(self, fingerprint: str, language: str) -> Reply:
        """Return what else could be done instead of the next step, in words."""
        reply = await self._link.ask("ways", {"fingerprint": fingerprint})
        ways = reply.body.get("ways")
        if not reply.is_ok or not isinstance(ways, list):
            return reply
        feasible: list[Json] = []
        infeasible: list[Json] = []
        for way in ways:
            told = self._told(way, language)
            (feasible if way["is_feasible"] else infeasible).append(told)
        body = {
            "fingerprint": fingerprint,
            "step": reply.body["step"],
            "feasible": feasible,
            "infeasible": infeasible,
        }
        return Reply(status=200, body=body)

    def _told(self, way: Mapping[str, Json], language: str) -> Json:
        call = way["call"]
        assert isinstance(call, Mapping)  # noqa: S101 -- our own process
        arguments = call["arguments"]
        assert isinstance(arguments, list)  # noqa: S101
        skill_call = SkillCall(str(call["skill"]), RobotId(str(call["robot"])), tuple(arguments))
        words = narrate(skill_call, self._labels, PHRASEBOOKS.get(language, ENGLISH))
        facts = {**call, "words": words, "duration_s": way["duration_s"]}
        if way["is_feasible"]:
            return {**facts, "price_s": way["price_s"], "note": way["note"]}
        return {**facts, "why_not": way["note"] or "It leads nowhere."}

    async def _with_difference(self, body: Mapping[str, Json]) -> Document:
        shown, open_ = str(body.get("shown") or ""), str(body.get("open") or "")
        old, new = await self._find(shown), await self._find(open_)
        changed: list[Json] = []
        if old is not None and new is not None:
            changed = differences(old[1], new[1], self._labels)
        open_now = {"fingerprint": open_, "code": check_code(open_)} if open_ else None
        return {**body, "open": open_now, "changed": changed}

    async def _find(self, fingerprint: str) -> tuple[str, Proposal] | None:
        async with self._shelf_lock:
            return await asyncio.to_thread(self._shelf.find, fingerprint)
