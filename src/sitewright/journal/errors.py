"""What can be wrong with a journal."""

from __future__ import annotations

from pathlib import Path

from sitewright.errors import JournalError


class JournalCorruptError(JournalError):
    """The journal's content cannot be trusted."""

    def __init__(self, path: Path, what: str) -> None:
        self.path, self.what = path, what
        super().__init__(
            f"{path}: the journal cannot be trusted: {what}. Nothing was started. Keep the file, "
            "restore the folder from a backup, or begin anew with `run --from-design`."
        )


class JournalTooNewError(JournalError):
    """A newer Sitewright wrote it."""

    def __init__(self, path: Path, found: int, known: int) -> None:
        super().__init__(
            f"{path}: written by a newer version of Sitewright (schema {found}, this one knows "
            f"{known}). Update Sitewright to go on with this run."
        )


class JournalBusyError(JournalError):
    """Another process holds the database for longer than we wait."""

    exit_code = 9

    def __init__(self, path: Path) -> None:
        super().__init__(
            f"{path}: another process has the journal locked. Wait for it and try again."
        )


class JournalFullError(JournalError):
    """No space, or the disk does not write."""

    def __init__(self, path: Path, what: str) -> None:
        super().__init__(
            f"{path}: not recorded, so nothing more is started: {what}. Free some space and give "
            "the same command again."
        )


class RefusedByJournalError(JournalError):
    """The database itself refused an event: a second start, outcome or use of an approval."""

    def __init__(self, path: Path, kind: str, what: str) -> None:
        super().__init__(f"{path}: event {kind!r} was refused by the journal: {what}.")


class UnsafeFolderError(JournalError):
    """The folder is on a network file system, where locks and syncs are not to be trusted."""

    exit_code = 2

    def __init__(self, folder: Path, kind: str) -> None:
        super().__init__(
            f"{folder} is on a {kind} file system, where a journal is not safe. "
            "Put the project on a local disk."
        )
