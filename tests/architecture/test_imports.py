"""The picture of ARCHITECTURE holds: who may import whom, and the pure parts load light."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import pytest

SOURCE = Path(__file__).parents[2] / "src" / "sitewright"
HEAVY_FOLDERS = {"formats", "inference", "drivers", "planners", "backends", "web"}
PURE_PARTS = (
    "foundation",
    "building_model",
    "robot_team",
    "construction_graph",
    "symbolic_planning",
    "planning_twin",
    "central_controller",
    "interaction_twin",
)
HEAVY = {"numpy", "pydantic", "mujoco", "coal", "pinocchio", "apsw", "scipy", "rich"}

_LOAD_EACH_IN_A_FORK = """
import importlib, json, os, sys, traceback
heavy, found = set(json.loads(sys.argv[1])), {}
for name in json.loads(sys.argv[2]):
    read, write = os.pipe()
    child = os.fork()
    if child == 0:
        try:
            importlib.import_module(name)
            answer = ", ".join(sorted(heavy & set(sys.modules)))
        except BaseException:
            answer = traceback.format_exc(limit=-1)
        os.write(write, answer.encode()[:4000])
        os._exit(0)
    os.close(write)
    with os.fdopen(read) as pipe:
        if answer := pipe.read():
            found[name] = answer
    os.waitpid(child, 0)
print(json.dumps(found))
"""


def _modules(part: str) -> list[str]:
    found = []
    for file in sorted((SOURCE / part).rglob("*.py")):
        inside = file.relative_to(SOURCE)
        if not HEAVY_FOLDERS & set(inside.parts[1:]):
            names = inside.with_suffix("").parts
            found.append(".".join(("sitewright", *names)).removesuffix(".__init__"))
    return found


@pytest.mark.parametrize("part", PURE_PARTS)
def test_every_module_of_a_pure_part_loads_alone_and_light(part: str) -> None:
    modules = _modules(part)
    assert modules
    command = [sys.executable, "-c", _LOAD_EACH_IN_A_FORK]
    command += [json.dumps(sorted(HEAVY)), json.dumps(modules)]
    run = subprocess.run(command, capture_output=True, text=True, check=True)
    assert json.loads(run.stdout) == {}


def test_the_import_contracts_hold() -> None:
    linter = Path(sys.executable).with_name("lint-imports")
    run = subprocess.run(
        [str(linter), "--no-cache"],
        cwd=SOURCE.parents[1],
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.returncode == 0, run.stdout[-3000:]
