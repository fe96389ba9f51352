"""Loads the compiled module of a package without what the package imports along with it."""

from __future__ import annotations

import importlib.util
import sys
from collections.abc import Iterator
from importlib.machinery import EXTENSION_SUFFIXES
from pathlib import Path
from typing import Any

from sitewright.errors import BackendMissingError


def extension(package: str, name: str, *, role: str) -> Any:  # noqa: ANN401 - a compiled module
    """Return a package's compiled module, registered so that the package itself finds it later.

    ``py_opw_kinematics`` imports scipy, which takes most of a second; its compiled module takes
    milliseconds.

    Args:
        package: Where the module lies, e.g. ``py_opw_kinematics``.
        name: Its name there, e.g. ``_internal``.
        role: What it is needed for, for the message if it is missing.
    """
    full_name = f"{package}.{name}"
    if full_name in sys.modules:
        return sys.modules[full_name]
    for file in _candidates(package, name):
        spec = importlib.util.spec_from_file_location(full_name, file)
        if spec is not None and spec.loader is not None:
            module = importlib.util.module_from_spec(spec)
            sys.modules[full_name] = module
            spec.loader.exec_module(module)
            return module
    raise BackendMissingError(role, package, available=())


def _candidates(package: str, name: str) -> Iterator[Path]:
    try:
        found = importlib.util.find_spec(package)
    except ModuleNotFoundError:
        return
    folders = found.submodule_search_locations if found is not None else None
    for folder in folders or ():
        files = (Path(folder) / f"{name}{suffix}" for suffix in EXTENSION_SUFFIXES)
        yield from (f for f in files if f.exists())
