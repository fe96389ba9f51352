"""The twin of one project behind the web interface: journal, run process, cell and files."""

from __future__ import annotations

import asyncio
import shutil
from collections.abc import Mapping, Sequence
from functools import partial
from importlib.metadata import version
from pathlib import Path

from sitewright.app.looking import graph_at
from sitewright.app.reporting import REPORT_PAGE
from sitewright.app.run_folder import run_folders
from sitewright.app.serving.channel import Message
from sitewright.app.serving.live_feed import LiveFeed
from sitewright.app.serving.own_words import own_words
from sitewright.app.serving.past_runs import bars_document, history
from sitewright.app.serving.pictures import plan_schedule, run_schedule
from sitewright.app.serving.policy_file import policy_of
from sitewright.app.serving.proposal_shelf import ProposalShelf
from sitewright.app.serving.run_process import RunLink
from sitewright.app.serving.run_view import RunView
from sitewright.app.serving.scene_shelf import SceneShelf
from sitewright.app.serving.side_work import (
    SideWork,
    StepAsked,
    all_runs,
    is_whole,
    one_run,
    replay,
    why,
)
from sitewright.app.serving.telling import by_hand_document, retold_reply, ways_reply
from sitewright.central_controller.codec import to_json
from sitewright.central_controller.fingerprint import check_code
from sitewright.central_controller.proposal import Proposal
from sitewright.construction_graph.graph import ConstructionGraph
from sitewright.foundation.canonical import Json
from sitewright.foundation.clock import Clock
from sitewright.interaction_twin.decisions import Decision, Reply, Signed
from sitewright.interaction_twin.drawing.bars import planned_bars
from sitewright.interaction_twin.drawing.gantt import beside_a_picture
from sitewright.interaction_twin.drawing.graph_picture import (
    building_of,
    for_fingers,
    graph_picture,
)
from sitewright.interaction_twin.event_document import audit_document
from sitewright.interaction_twin.languages import PHRASEBOOKS, with_own_skills
from sitewright.interaction_twin.phrases import ENGLISH, Phrasebook
from sitewright.interaction_twin.proposal_document import (
    ProposalSource,
    differences,
    proposal_document,
)
from sitewright.interaction_twin.proposal_story import story_of
from sitewright.interaction_twin.report.content import Stamped
from sitewright.interaction_twin.report.timeline import timeline
from sitewright.interaction_twin.roles import Person, Verb
from sitewright.interaction_twin.web.twin import Audience, Document

_NS = 1_000_000_000
_MS = 1_000_000


class ProjectTwin:
    """Port `Twin` for a project and the process of its run."""

    def __init__(
        self,
        folder: Path,
        link: RunLink,
        audience: Audience,
        clock: Clock,
        *,
        cell: Path | None = None,
        has_users: bool = False,
    ) -> None:
        """Read the project and its journal; nothing is started yet.

        Args:
            folder: The project.
            link: The way to the run.
            audience: All pages.
            clock: For what is not in the journal.
            cell: Another cell file.
            has_users: People have tokens of their own.

        Raises:
            SitewrightError: The project or its journal cannot be read.
        """
        self._folder, self._cell_file = folder, cell
        self._link, self._audience, self._clock = link, audience, clock
        self._view = RunView(folder, cell)
        self._shelf, self._side = ProposalShelf(self._view.runs), SideWork()
        self._policy = policy_of(self._view.project.settings, has_users=has_users)
        self._books = with_own_skills(PHRASEBOOKS, own_words(self._view.project.settings))
        self._shelf_lock = asyncio.Lock()
        self._start_lock = asyncio.Lock()
        self._is_ending = False
        self._holding: asyncio.Task[bool] | None = None
        self._started_ns = clock.monotonic_ns()
        self.feed = LiveFeed(
            audience,
            clock,
            folder=lambda: self._view.cell_folder,
            on_change=self._tell_state,
        )
        self._scenes = SceneShelf(self.feed)

    @property
    def asks_pin(self) -> bool:
        """Whether each decision at a page must carry the PIN of who makes it."""
        return self._policy.asks_pin

    async def start(self) -> None:
        """Start the process of the run."""
        await self._link.start(self._hear)

    async def stop(self) -> None:
        """Let the run hold and end."""
        self._is_ending = True
        await self._link.stop()
        await asyncio.to_thread(self._side.close)

    # ---- hearing -----------------------------------------------------------------------------

    def _hear(self, message: Message) -> None:
        if message["is"] == "event":
            self._hear_event(message)
        else:
            self._view.hear_of_run(message)
            if message["what"] == "gone" and not self._is_ending:
                self._holding = asyncio.create_task(self.feed.hold())  # nobody else would
        self._tell_state()

    def _hear_event(self, message: Message) -> None:
        heard = self._view.hear_event(message)
        if heard is None:
            return
        record, is_drawn_otherwise = heard
        if is_drawn_otherwise:
            self._scenes.outdate()
        self._audience.tell(lambda language: self._view.told(record, self._book(language)))

    async def _start_again(self) -> None:
        async with self._start_lock:
            if self._link.process_id is None:
                await self._link.start(self._hear, waits=True)

    def _tell_state(self) -> None:
        self._audience.tell(self.state)

    # ---- looking -----------------------------------------------------------------------------

    def state(self, language: str = "en") -> Document:
        """Return how the run stands now."""
        return {
            **self._view.document(self._book(language)),
            "scene_epoch": self._scenes.epoch,
            "cell": "live" if self.feed.is_live else "absent",
        }

    def events_after(self, run: str, number: int, language: str) -> Sequence[Document]:
        """Return the events after one, as pages get them."""
        return self._view.events_after(run, number, self._book(language))

    def last_event(self) -> tuple[str, int]:
        """Return run and number of the newest event."""
        return self._view.records.last

    async def scene(self) -> tuple[str, bytes]:
        """Return hash and text of everything that is drawn; worked out once per epoch."""
        return await self._scenes.get(self._view.scene_source)

    async def proposal(self, fingerprint: str, language: str) -> Document | None:
        """Return a proposal; the open one if no fingerprint is given."""
        made = self._view.records.state.proposal
        wanted = fingerprint or ("" if made is None else made.fingerprint)
        if not wanted:
            state = self.state(language)
            return {"open": None, "phase": state["phase"], "reason": state["words"]}
        found = await self._find(wanted)
        if found is None:
            return None
        run, proposal = found
        story = story_of(wanted, await self._history(run))
        if story is None:
            return None
        before = self._view.records.approved_before(wanted)
        previous = await self._find(before) if before else None
        earlier = story_of(before, self._view.records.stamped)
        is_open = made is not None and made.fingerprint == wanted
        state_ = self._view.records.state
        source = ProposalSource(
            run=run,
            fingerprint=wanted,
            proposal=proposal,
            story=story,
            next_step=state_.done + 1 if is_open else 1,
            labels=self._view.labels,
            why=state_.why if is_open else "",
            refusals=state_.refusals if is_open else (),
            previous=None if previous is None else (before, previous[1]),
            previous_done=frozenset() if earlier is None else earlier.done_steps,
            book=self._book(language),
            look_below_m=self._policy.look_below_m,
        )
        return await asyncio.to_thread(partial(proposal_document, source, is_open=is_open))

    async def blob(self, sha256: str) -> bytes | None:
        """Return the exact bytes of a trajectory."""
        async with self._shelf_lock:
            return await asyncio.to_thread(self._shelf.trajectory, sha256)

    async def runs(self) -> Document:
        """Return all runs of the project."""
        return await self._side.do(all_runs, self._folder, self._cell_file)

    async def run(self, run: str, language: str) -> Document | None:
        """Return one run with its events and bars."""
        book = self._book(language)
        return await self._side.do(one_run, self._folder, self._cell_file, run, book)

    async def replay(self, run: str) -> Document | None:
        """Return everything that was sensed in a run."""
        return await self._side.do(replay, self._folder, self._cell_file, run)

    async def why(self, fingerprint: str, number: int, language: str) -> Document | None:
        """Return why a step of a proposal is as it is."""
        if await self._find(fingerprint) is None:
            return None
        step = StepAsked(fingerprint, number, self._book(language))
        return await self._side.do(why, self._folder, self._cell_file, step)

    async def report(self, run: str) -> bytes | None:
        """Return the report of a run; None while there is none."""
        folder = next((f for f in run_folders(self._view.runs) if f.run == run), None)
        page = None if folder is None else folder.path / REPORT_PAGE
        if page is None or not page.exists():
            return None
        return await asyncio.to_thread(page.read_bytes)

    async def schedule(self) -> Document:
        """Return planned and actual skills of the newest run on one time axis."""
        run, _ = self._view.records.last
        bars = timeline(s.event for s in self._view.records.of_run(run))
        return {
            "run": run,
            "planned": bars_document(bars.planned, self._view.labels),
            "actual": bars_document(bars.actual, self._view.labels),
        }

    async def plan_schedule(self, fingerprint: str, language: str, width_px: float) -> str | None:
        """Return the schedule of a plan, and what ran of it, as a picture."""
        found = await self._find(fingerprint)
        if found is None:
            return None
        run, proposal = found
        records = await self._history(run)
        plan = planned_bars(proposal.steps, target=proposal.target, fingerprint=fingerprint)
        style = beside_a_picture(width_px, self._book(language))
        return await asyncio.to_thread(plan_schedule, plan, records, self._view.labels, style)

    async def run_schedule(self, run: str, language: str, width_px: float) -> str | None:
        """Return the schedule of a run as a picture; None if there is no such run."""
        records = await self._history(run)
        if not records:
            return None
        style = beside_a_picture(width_px, self._book(language))
        return await asyncio.to_thread(run_schedule, records, self._view.labels, style)

    async def graph_picture(self, language: str) -> str:
        """Return what rests on what in the building now as a picture."""
        graph = await self._graph()
        style = for_fingers(self._book(language))
        return await asyncio.to_thread(graph_picture, building_of(graph), style)

    async def graph(self) -> Document:
        """Return the construction relationship graph now."""
        graph = await self._graph()
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

    def audit(self, language: str) -> Document:
        """Return all decisions, the newest first."""
        labels, book = self._view.labels, self._book(language)
        found = (audit_document(r.run, r.stamped, labels, book) for r in self._view.records.all())
        return {"entries": [entry for entry in found if entry is not None][::-1]}

    async def health(self) -> Document:
        """Return how server, run, cell and journal are."""
        run, number = self._view.records.last
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
            "journal": {
                "run": run,
                "n": number,
                "is_whole": await self._side.do(is_whole, self._view.runs, run),
            },
            "disk_free_bytes": shutil.disk_usage(self._folder).free,
        }

    # ---- deciding ----------------------------------------------------------------------------

    async def decide(self, decision: Decision, person: Person, body_sha256: str) -> Reply:
        """Pass a decision on to the run; a stale one comes back with what is different.

        To resume a run whose process has gone starts the process anew.
        """
        if decision.verb is Verb.RESUME:
            await self._start_again()
        signed = Signed(decision=decision, person=person, body_sha256=body_sha256)
        book = self._book(decision.language)
        reply = await self._link.ask("decide", {"signed": to_json(signed)})
        reply = retold_reply(reply, self._view.labels, book)
        if reply.is_ok or "open" not in reply.body:
            return reply
        return Reply(status=reply.status, body=await self._with_difference(reply.body, book))

    async def hold(self, decision: Decision, person: Person, body_sha256: str) -> Reply:
        """Stop the robots: the cell first, the journal after."""
        told = await self.feed.hold()
        signed = Signed(decision=decision, person=person, body_sha256=body_sha256)
        reply = await self._link.ask("hold", {"signed": to_json(signed)})
        reply = retold_reply(reply, self._view.labels, self._book(decision.language))
        if reply.is_ok:
            self._view.hold_asked()
            self._tell_state()
        return Reply(status=reply.status, body={**reply.body, "told_cell": told})

    async def ways(self, fingerprint: str, language: str) -> Reply:
        """Return what else could be done instead of the next step, in words."""
        reply = await self._link.ask("ways", {"fingerprint": fingerprint})
        if not reply.is_ok:
            return retold_reply(reply, self._view.labels, self._book(language))
        return ways_reply(fingerprint, reply.body, self._view.labels, self._book(language))

    def by_hand(self, target: str, language: str) -> Document | None:
        """Return what a person can vouch for at a target; None if its piece is not in place."""
        site, book = self._view.records.state.site, self._book(language)
        return by_hand_document(target, site, self._view.labels, book)

    def _book(self, language: str) -> Phrasebook:
        """Return the sentences of a language; English for one that is not there."""
        return self._books.get(language, ENGLISH)

    async def _with_difference(self, body: Mapping[str, Json], book: Phrasebook) -> Document:
        shown, open_ = str(body.get("shown") or ""), str(body.get("open") or "")
        old, new = await self._find(shown), await self._find(open_)
        changed: list[Json] = []
        if old is not None and new is not None:
            changed = differences(old[1], new[1], self._view.labels, book)
        open_now = {"fingerprint": open_, "code": check_code(open_)} if open_ else None
        return {**body, "open": open_now, "changed": changed}

    async def _graph(self) -> ConstructionGraph:
        site = self._view.records.state.site
        return await asyncio.to_thread(graph_at, self._view.project, site)

    async def _history(self, run: str) -> Sequence[Stamped]:
        """Return the records of a run; none if there is no such run."""
        known = self._view.records.of_run(run)
        if known:
            return known
        folder = next((f for f in run_folders(self._view.runs) if f.run == run), None)
        return () if folder is None else await asyncio.to_thread(history, folder)

    async def _find(self, fingerprint: str) -> tuple[str, Proposal] | None:
        async with self._shelf_lock:
            return await asyncio.to_thread(self._shelf.find, fingerprint)
