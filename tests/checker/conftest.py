"""What tests of checks share."""

import json
import warnings

import pytest

from rcj_challenges.checker import reader, reading


@pytest.fixture
def sources_read_here(monkeypatch):
    """Read the sources of submissions in this process: starting another one takes longer than the rest of a check."""

    def ask(paths, files, max_imports):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            found = [json.dumps(reader.read_source(files[path], path.name)) for path in paths]
        return [reading._source(json.loads(one)) for one in found], ""

    monkeypatch.setattr(reading, "_ask", ask)
