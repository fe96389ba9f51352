"""The planned case study, once for all tests of this folder."""

from __future__ import annotations

import pytest

from builders_planning import STUD, SUPPORT_1, SUPPORT_2, Rehearsal, rehearse


@pytest.fixture(scope="session")
def frame() -> Rehearsal:
    """Return both supports and the first transverse stud, planned by the real engines."""
    return rehearse(SUPPORT_1, SUPPORT_2, STUD)
