"""The folder of one run: journal, blobs, proposals, PDDL texts; and the chain of runs."""

from __future__ import annotations

import json
import secrets
from collections.abc import Mapping
from pathlib import Path

from sitewright.central_controller.codec import DecodeError, from_json, to_json
from sitewright.central_controller.events import AnyEvent, RunStarted, event_from_json
from sitewright.central_controller.fingerprint import check_code, fingerprint
from sitewright.central_controller.proposal import Proposal
from sitewright.errors import ExecutionError, did_you_mean
from sitewright.foundation.canonical import canonical_json
from sitewright.journal.blobs import BlobStore, sync_folder, write_whole
from sitewright.journal.errors import JournalCorruptError, UnsafeFolderError
from sitewright.journal.record import Record
from sitewright.journal.sqlite import read_records
from sitewright.planning_twin.scene import SceneSnapshot
from sitewright.planning_twin.scene_texts import UnreadableSceneError, read_scene, texts_of

_NETWORK = ("nfs", "nfs4", "cifs", "smb3", "smbfs", "virtiofs", "9p", "fuse.sshfs")
_SCHEMA = "sitewright.proposal/1"


class RunFolder:
    """Paths and files of one run."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self._kept: set[str] = set()

    @property
    def run(self) -> str:
        """The run's id, which is the folder's name."""
        return self.path.name

    @property
    def journal(self) -> Path:
        """The journal's file."""
        return self.path / "journal.db"

    @property
    def blobs(self) -> BlobStore:
        """Large values, named by their hashes."""
        return BlobStore(self.path / "blobs")

    def create(self) -> None:
        """Make the folder and what is in it; what is there stays."""
        for folder in (self.path, self.path / "proposals", self.path / "pddl"):
            folder.mkdir(parents=True, exist_ok=True)
        sync_folder(self.path.parent)

    def is_blank(self) -> bool:
        """Return whether the run never began; then nothing else may be there."""
        if self.journal.stat().st_size and read_records(self.journal):
            return False
        if any((self.path / "proposals").glob("*.json")):
            raise JournalCorruptError(self.journal, "all its records are gone")
        return True

    def save_proposal(self, proposal: Proposal) -> str:
        """Write a proposal under its fingerprint, durably, and return the fingerprint."""
        digest = fingerprint(proposal)
        text = canonical_json(
            {
                "schema": _SCHEMA,
                "fingerprint": digest,
                "code": check_code(digest),
                "proposal": to_json(proposal),
            }
        )
        write_whole(self._proposal(digest), text.encode())
        return digest

    def load_proposal(self, digest: str) -> Proposal:
        """Read a proposal back; one that is not what its fingerprint says is an error."""
        path = self._proposal(digest)
        try:
            stored = json.loads(path.read_bytes())
            proposal = from_json(Proposal, stored["proposal"])
        except (OSError, ValueError, KeyError, TypeError) as error:
            raise JournalCorruptError(path, f"the proposal cannot be read ({error})") from error
        if fingerprint(proposal) != digest:
            raise JournalCorruptError(path, "the proposal was changed after it was written")
        return proposal

    def keep_scene(self, scene: SceneSnapshot) -> None:
        """Write the texts of a scene that a certificate is about, durably, each once."""
        for digest, text in texts_of(scene).items():
            if digest not in self._kept:
                self.blobs.put(text.encode())
                self._kept.add(digest)

    def load_scene(self, revision: str) -> SceneSnapshot:
        """Read a scene back; what is not what its hash says is an error."""
        try:
            return read_scene(revision, lambda digest: self.blobs.get(digest).decode())
        except UnreadableSceneError as error:
            raise JournalCorruptError(self.path / "blobs" / revision, str(error)) from error

    def save_texts(self, name: str, texts: Mapping[str, str]) -> None:
        """Write PDDL texts as ``pddl/<name>-<n>.<suffix>``, n counting the plans of a target."""
        folder, number = self.path / "pddl", 1
        while any(folder.glob(f"{name}-{number}.*")):
            number += 1
        for suffix, text in texts.items():
            write_whole(folder / f"{name}-{number}.{suffix}", text.encode())

    def _proposal(self, digest: str) -> Path:
        return self.path / "proposals" / f"{digest}.json"


def run_folders(runs: Path) -> tuple[RunFolder, ...]:
    """Return the runs of a project, oldest first; a folder without journal never began."""
    if not runs.is_dir():
        return ()
    return tuple(RunFolder(p) for p in sorted(runs.iterdir()) if (p / "journal.db").is_file())


def run_named(runs: Path, run: str) -> RunFolder:
    """Return a run of a project by its id; one that is not there is an `ExecutionError`."""
    names = [f.run for f in run_folders(runs)]
    if run not in names:
        raise ExecutionError(f"There is no run {run!r} in {runs}.{did_you_mean(run, names)}")
    return RunFolder(runs / run)


def next_run_folder(runs: Path) -> RunFolder:
    """Return a folder for a new run; its name sorts after all others."""
    numbers = [int(p.name[:4]) for p in runs.glob("[0-9][0-9][0-9][0-9]-*")]
    return RunFolder(runs / f"{max(numbers, default=0) + 1:04d}-{secrets.token_hex(2)}")


def chain_of(folder: RunFolder) -> tuple[RunFolder, ...]:
    """Return the run and all that it continues, the first one first."""
    chain = [folder]
    while True:
        start = start_of_run(chain[0])
        if start is None or not start.previous_run:
            return tuple(chain)
        chain.insert(0, RunFolder(folder.path.parent / start.previous_run))


def chain_events(chain: tuple[RunFolder, ...]) -> tuple[tuple[AnyEvent, ...], str]:
    """Return all events of a chain and its last hash; each run begins where one ended."""
    head, events = "", list[AnyEvent]()
    for folder in chain:
        records = read_records(folder.journal)
        for record in records:
            event = event_of(folder, record)
            if isinstance(event, RunStarted) and event.previous_head != head:
                what = "the run before was changed after this one began"
                raise JournalCorruptError(folder.journal, what)
            events.append(event)
        head = records[-1].hash.hex() if records else ""
    return tuple(events), head


def event_of(folder: RunFolder, record: Record) -> AnyEvent:
    """Return the event of a record; one that this version cannot read is an error."""
    try:
        return event_from_json(record.kind, record.version, record.value())
    except DecodeError as error:
        raise JournalCorruptError(folder.journal, f"record {record.seq}: {error}") from error


def start_of_run(folder: RunFolder) -> RunStarted | None:
    """Return the first event of a run; None if there is none."""
    records = read_records(folder.journal)
    if not records:
        return None
    event = event_of(folder, records[0])
    return event if isinstance(event, RunStarted) else None


def refuse_network_folder(folder: Path) -> None:
    """Raise if a folder is on a network file system, where locks and syncs may lie."""
    try:
        mounts = Path("/proc/mounts").read_text(encoding="utf-8").splitlines()
    except OSError:
        return
    resolved, best = folder.resolve(), ("", "")
    for line in mounts:
        _, place, kind, *_ = line.split()
        place = place.replace("\\040", " ")
        if resolved.is_relative_to(place) and len(place) >= len(best[0]):
            best = (place, kind)
    if best[1] in _NETWORK:
        raise UnsafeFolderError(folder, best[1])


def installation_key(folder: Path) -> bytes:
    """Return the key that seals approvals on this machine; made once, readable by its owner."""
    path = folder / "approval.key"
    if not path.exists():
        folder.mkdir(parents=True, exist_ok=True, mode=0o700)
        write_whole(path, secrets.token_bytes(32))
        path.chmod(0o600)
    return path.read_bytes()
