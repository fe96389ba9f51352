"""What all tests share: hypothesis settings, and skips that are failures where none is allowed."""

from __future__ import annotations

import os
from collections.abc import Generator
from pathlib import Path

import pytest
from hypothesis import settings

settings.register_profile("sitewright", deadline=None, print_blob=True)
settings.load_profile("sitewright")

NO_SKIP = os.environ.get("SITEWRIGHT_NO_SKIP") == "1"


@pytest.fixture(scope="session")
def shared_data() -> Path:
    """Return the folder of real input files, or skip the test by name."""
    folder = os.environ.get("SITEWRIGHT_DATA")
    if not folder:
        pytest.skip("needs real input files: set SITEWRIGHT_DATA to the folder that holds them")
    return Path(folder)


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(
    item: pytest.Item, call: pytest.CallInfo[None]
) -> Generator[None, pytest.TestReport, pytest.TestReport]:
    """Turn a skipped test into a failed one if nothing may be skipped."""
    report = yield
    if NO_SKIP and report.skipped and not hasattr(report, "wasxfail"):
        report.outcome = "failed"
        report.longrepr = f"{item.nodeid} was skipped ({call.when}): {_reason(report.longrepr)}"
    return report


@pytest.hookimpl(wrapper=True)
def pytest_make_collect_report(
    collector: pytest.Collector,
) -> Generator[None, pytest.CollectReport, pytest.CollectReport]:
    """Turn a module that skips itself into an error if nothing may be skipped."""
    report = yield
    if NO_SKIP and report.skipped:
        report.outcome = "failed"
        report.longrepr = f"{collector.nodeid} was skipped: {_reason(report.longrepr)}"
    return report


def _reason(longrepr: object) -> str:
    match longrepr:
        case (_, _, str(reason)):
            return reason
        case _:
            return str(longrepr)
