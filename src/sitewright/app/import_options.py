"""Which options of an import mean something for which kind of file."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from sitewright.building_model.formats.detect import FileKind
from sitewright.errors import SitewrightError

_ALL = frozenset(
    {
        *("--unit", "--map", "--repair", "--split", "--group", "--lay-flat", "--turn-over"),
        *("--reader-gb", "--reader-s"),
    }
)
_BLANKS = "its parts are blanks and bars, each one closed solid"
_NO_WORDS = "the format holds no keys and no layers"
_OWN = "it is Sitewright's own format, in metres, and is taken as it stands"
REFUSED: Mapping[FileKind, Mapping[str, str]] = {
    FileKind.NATIVE: dict.fromkeys(_ALL, _OWN),
    FileKind.OBJ: {"--map": _NO_WORDS},
    FileKind.BTLX: {"--repair": _BLANKS, "--split": _BLANKS},
    FileKind.COMPAS_TIMBER: {"--repair": _BLANKS, "--split": _BLANKS},
    FileKind.BAR_FRAME: {"--repair": _BLANKS, "--split": _BLANKS},
}
"""Options that cannot do anything for a kind, each with the reason; all others are honoured."""


class ImportOptionError(SitewrightError):
    """An option was given that cannot do anything for this file."""

    exit_code = 2


def demand_meaning(kind: FileKind, given: Iterable[str]) -> None:
    """Refuse options that would be ignored.

    Args:
        kind: What the file is.
        given: Names of the options that were given: ``--map`` ...

    Raises:
        ImportOptionError: Some of them mean nothing for this kind.
    """
    refused = REFUSED.get(kind, {})
    reasons = [f"{name} ({refused[name]})" for name in given if name in refused]
    if reasons:
        told = " and ".join(reasons)
        raise ImportOptionError(f"This is a {kind} file; it takes no {told}. Leave that out.")
