"""An event of the journal as pages get it: number, time, words, and its content."""

from __future__ import annotations

from sitewright.central_controller.decision import DecisionRecord
from sitewright.central_controller.events import event_to_json
from sitewright.foundation.canonical import Json
from sitewright.interaction_twin.labels import Labels
from sitewright.interaction_twin.phrases import ENGLISH, Phrasebook
from sitewright.interaction_twin.progress import progress_line
from sitewright.interaction_twin.report.content import Stamped

_NOT_FOR_PAGES = ("proofs", "params")
_MS = 1_000_000


def event_document(
    run: str, stamped: Stamped, labels: Labels, book: Phrasebook = ENGLISH
) -> dict[str, Json]:
    """Return an event without what only an audit of the files needs."""
    body = event_to_json(stamped.event)
    return {
        "type": "event",
        "run": run,
        "n": stamped.number,
        "at_ms": stamped.at_utc_ns // _MS,
        "kind": stamped.event.kind,
        "words": progress_line(stamped.event, labels, book).strip(),
        "body": {k: v for k, v in body.items() if k not in _NOT_FOR_PAGES},
    }


def audit_document(
    run: str, stamped: Stamped, labels: Labels, book: Phrasebook = ENGLISH
) -> dict[str, Json] | None:
    """Return who decided what, and which text was seen; None if the event is no decision."""
    event = stamped.event
    record = getattr(event, "decision", None)
    approval = getattr(event, "approval", None)
    who = str(getattr(event, "who", "") or getattr(approval, "who", ""))
    if not who:
        return None
    known = record if isinstance(record, DecisionRecord) else None
    return {
        "run": run,
        "n": stamped.number,
        "at_ms": stamped.at_utc_ns // _MS,
        "who": who,
        "kind": event.kind,
        "role": "" if known is None else known.role,
        "verb": event.kind if known is None else known.verb,
        "session": "" if known is None else known.session,
        "second": "" if known is None else known.second,
        "key": "" if known is None else known.key,
        "language": "" if known is None else known.language,
        "shown": [] if known is None else list(known.shown),
        "words": progress_line(event, labels, book).strip(),
        "detail": _detail(stamped),
    }


def _detail(stamped: Stamped) -> Json:
    body = event_to_json(stamped.event)
    return {k: v for k, v in body.items() if k not in {"decision", "who"}}
