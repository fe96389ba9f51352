"""Kills the real controller, the simulated cell, or both at random moments of a real run.

    python benchmarks/kill_campaign.py examples/wooden_frame --kills 10 --seed 1

A copy of the project is built; after each kill the same command is given again, and a question
is answered by what the cell's physical log says. At the end the journal is compared with the
physical log: every fastener once in both.
"""

from __future__ import annotations

import argparse
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path

from sitewright.journal.sqlite import read_records

SITEWRIGHT = str(Path(sys.executable).with_name("sitewright"))
OPEN_QUESTION = 8
WHO = ("controller", "cell", "both")
MOVING = ("brings", "drives", "grips", "lifts", "puts", "lets go", "backs away", "goes to")


def main() -> int:
    """Run the campaign and return 0 if journal and physics agree."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("project", type=Path)
    parser.add_argument("--kills", type=int, default=10)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    chosen = random.Random(options.seed)  # noqa: S311 -- repeatable, no secret
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name) / "project"
        shutil.copytree(options.project, folder, ignore=shutil.ignore_patterns("runs"))
        kills, questions = _build(folder, options.kills, chosen)
        driven, recorded = _driven(folder), _recorded(folder)
    is_right = driven == recorded and set(driven.values()) == {1}
    print(f"{kills} kills, {questions} questions, {len(driven)} fasteners, ", end="")
    print("journal and physical log agree" if is_right else f"WRONG: {driven} {recorded}")
    return 0 if is_right else 1


def _build(folder: Path, kills: int, chosen: random.Random) -> tuple[int, int]:
    """Give the command again and again until the building stands; count kills and questions."""
    done = questions = 0
    while True:
        run, log = _start(folder), folder.with_name("progress.txt")
        while done < kills and _wait_for_motion(run, log, chosen.randint(1, 8)):
            who = chosen.choice(WHO)
            done += 1
            print(f"killed {who} at: {log.read_text().splitlines()[-1].strip()}", flush=True)
            if who != "controller":
                _kill_cell(folder)
            if who != "cell":
                run.kill()
                run.wait()
        code = run.wait()
        if code == 0:
            return done, questions
        result = folder.with_name("result.json").read_text()
        question = json.loads(result).get("question") if code == OPEN_QUESTION else None
        if question:
            questions += 1
            _answer(folder, question)
        elif code != -signal.SIGKILL:
            print(f"the run ended with {code}: {json.loads(result).get('message')}")
            return done, questions


def _start(folder: Path) -> subprocess.Popen[bytes]:
    command = [SITEWRIGHT, "run", str(folder)]
    with (
        folder.with_name("result.json").open("wb") as result,
        folder.with_name("progress.txt").open("wb") as progress,
    ):
        return subprocess.Popen(
            [*command, "--approve", "auto", "--json"], stdout=result, stderr=progress
        )


def _wait_for_motion(run: subprocess.Popen[bytes], log: Path, lines: int) -> bool:
    """Wait for so many more lines about moving robots; False if the run ended before."""
    lines += _motions(log)
    while run.poll() is None:
        if _motions(log) >= lines:
            return True
        time.sleep(0.005)
    return False


def _motions(log: Path) -> int:
    return sum(any(m in line for m in MOVING) for line in log.read_text().splitlines())


def _kill_cell(folder: Path) -> None:
    """Kill the one cell process whose command line names our folder."""
    for entry in Path("/proc").glob("[0-9]*/cmdline"):
        try:
            words = entry.read_bytes().decode(errors="replace")
        except OSError:
            continue
        if "drivers.mujoco.process" in words and str(folder) in words:
            os.kill(int(entry.parent.name), signal.SIGKILL)


def _answer(folder: Path, question: dict[str, object]) -> None:
    operation = str(question["text"]).split("(")[1].split()[1]
    answer = "done" if operation in _driven(folder) else "not-done"
    words = [str(question["run"]), str(question["step"]), answer]
    subprocess.run(
        [SITEWRIGHT, "resolve", "--project", str(folder), *words, "--json"],
        check=True,
        capture_output=True,
        input=b"y\ny\n",
    )


def _driven(folder: Path) -> Counter[str]:
    """Count the fasteners of the physical log."""
    found: Counter[str] = Counter()
    for path in folder.glob("runs/*/cell/cell.jsonl"):
        for line in path.read_text().splitlines():
            entry = json.loads(line)
            if entry.get("kind") == "effect" and "operation" in entry:
                found[entry["operation"]] += 1
    return found


def _recorded(folder: Path) -> Counter[str]:
    """Count the fasteners of the journal."""
    return Counter(
        str(record.value()["operation"])
        for path in folder.glob("runs/*/journal.db")
        for record in read_records(path)
        if record.kind == "operation_done"
    )


if __name__ == "__main__":
    sys.exit(main())
