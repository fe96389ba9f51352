"""Compiled modules without the packages around them."""

from __future__ import annotations

import subprocess
import sys

import pytest

from sitewright.errors import BackendMissingError
from sitewright.planning_twin.backends.extensions import extension

_LIGHT = """
import sys
from sitewright.planning_twin.backends.twin import make_backends
from sitewright.planning_twin.backends.extensions import extension
opw = extension("py_opw_kinematics", "_internal", role="kinematics")
make_backends()
heavy = {"scipy", "trimesh", "viser", "matplotlib"} & set(sys.modules)
assert not heavy, heavy
import py_opw_kinematics
assert py_opw_kinematics.KinematicModel is opw.KinematicModel
"""


def test_the_engines_load_without_viewers_and_scipy() -> None:
    run = subprocess.run(
        [sys.executable, "-c", _LIGHT], check=False, capture_output=True, text=True
    )
    assert run.returncode == 0, run.stderr


def test_a_module_is_loaded_once() -> None:
    first, second = (
        extension("py_opw_kinematics", "_internal", role="kinematics") for _ in range(2)
    )
    assert first is second


@pytest.mark.parametrize("package", ["no_such_package", "no_such.package", "json"])
def test_a_missing_module_is_named_with_what_it_is_for(package: str) -> None:
    with pytest.raises(BackendMissingError, match="path search"):
        extension(package, "_nothing", role="path search")
