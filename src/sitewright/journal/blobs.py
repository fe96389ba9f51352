"""Large values beside the journal, each a file named by its SHA-256."""

from __future__ import annotations

import os
from pathlib import Path

from sitewright.foundation.canonical import sha256_hex
from sitewright.journal.errors import JournalCorruptError, JournalFullError


class BlobStore:
    """A folder of immutable files; what is in it is on the disk before its name is told."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        folder.mkdir(parents=True, exist_ok=True)

    def put(self, data: bytes) -> str:
        """Write a blob (once) and return its SHA-256."""
        digest = sha256_hex(data)
        target = self.folder / digest
        if not target.exists():
            write_whole(target, data)
        return digest

    def get(self, digest: str) -> bytes:
        """Return a blob; a missing or changed one is a `JournalCorruptError`."""
        path = self.folder / digest
        try:
            data = path.read_bytes()
        except OSError as error:
            raise JournalCorruptError(
                path, f"the blob cannot be read ({error.strerror})"
            ) from error
        if sha256_hex(data) != digest:
            raise JournalCorruptError(path, "the blob was changed after it was written")
        return data


def write_whole(path: Path, data: bytes) -> None:
    """Write a file so that after any crash it is there whole, as it was before, or not at all."""
    temporary = path.with_name(f".{path.name}.{os.getpid()}.tmp")
    try:
        with temporary.open("wb") as file:
            file.write(data)
            file.flush()
            os.fsync(file.fileno())
        temporary.replace(path)
        sync_folder(path.parent)
    except OSError as error:
        temporary.unlink(missing_ok=True)
        raise JournalFullError(path, error.strerror or str(error)) from error


def sync_folder(folder: Path) -> None:
    """Make a folder's entries durable."""
    descriptor = os.open(folder, os.O_RDONLY | os.O_DIRECTORY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)
