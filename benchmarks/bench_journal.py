"""Time of one journal append, synced: median and p99 in milliseconds."""

from __future__ import annotations

import statistics
import sys
import tempfile
from pathlib import Path
from time import perf_counter

from sitewright.journal.record import Entry
from sitewright.journal.sqlite import SqliteJournal

APPENDS = 2_000
AIM_P99_MS = 50.0


def main() -> int:
    """Append events with a body of 1 kB and compare p99 with the aim."""
    with tempfile.TemporaryDirectory(dir=Path.cwd()) as folder:
        times_ms = sorted(_append_times_ms(Path(folder) / "journal.db"))
    p50, p99 = statistics.median(times_ms), times_ms[int(0.99 * APPENDS)]
    print(
        f"journal append, {APPENDS} events: p50 {p50:.2f} ms, p99 {p99:.2f} ms (aim {AIM_P99_MS})"
    )
    return 0 if p99 <= AIM_P99_MS else 1


def _append_times_ms(path: Path) -> list[float]:
    times_ms = []
    with SqliteJournal(path) as journal:
        for number in range(APPENDS):
            entry = Entry(
                event_id=str(number), run_id="bench", t_utc_ns=number, t_mono_ns=number,
                boot_id="b", actor="bench", kind="site_observed", version=1,
                body={"text": "x" * 1000},
            )  # fmt: skip
            start = perf_counter()
            journal.append(entry)
            times_ms.append((perf_counter() - start) * 1e3)
    return times_ms


if __name__ == "__main__":
    sys.exit(main())
