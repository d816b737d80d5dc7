from __future__ import annotations

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))

from fake_match import FakeMatch


@pytest.fixture
def match(tmp_path: Path) -> FakeMatch:
    return FakeMatch(tmp_path)


OF_WINDOWS = pytest.param(True, id="threaded", marks=[] if sys.platform == "win32" else [pytest.mark.nightly])


@pytest.fixture(params=[pytest.param(False, id="polled"), OF_WINDOWS])
def either_match(request: pytest.FixtureRequest, tmp_path: Path) -> FakeMatch:
    """The same match with either way of exchanging messages; Windows has only one, and elsewhere it is tried by night."""
    if sys.platform == "win32" and not request.param:
        pytest.skip("pipes cannot be polled on Windows")
    return FakeMatch(tmp_path, portable=request.param)
