"""Places for real short matches: one for a test, and one for all tests of a file that look at the same match."""

import pytest

from tests.match.playing import Place


@pytest.fixture
def place(tmp_path):
    return Place(tmp_path)


@pytest.fixture(scope="module")
def shared_place(tmp_path_factory):
    return Place(tmp_path_factory.mktemp("shared"))


@pytest.fixture
def team_folder(place):
    return place.team_folder


@pytest.fixture
def play(place):
    return place.play
