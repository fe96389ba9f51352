"""What a reader says when a file as a whole cannot be used."""

from __future__ import annotations

from pathlib import Path

from sitewright.building_model.formats.detect import refused
from sitewright.errors import ModelRejectedError


class UnreadableError(Exception):
    """A file cannot be used; for readers that are deep in a library and know no path.

    Attributes:
        code: Of the documentation, e.g. ``E2``.
        message: What is wrong, in one sentence.
        fix: What to do about it, in one sentence.
    """

    def __init__(self, code: str, message: str, fix: str) -> None:
        super().__init__(message)
        self.code, self.message, self.fix = code, message, fix

    def of(self, path: Path) -> ModelRejectedError:
        """Return the refusal of that file."""
        return refused(path, self.code, self.message, self.fix)
