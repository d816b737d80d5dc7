"""What tests of checks share."""

import json
import warnings

import pytest

from rcj_challenges.checker import reader, reading


@pytest.fixture
def sources_read_here(monkeypatch):
    """Read the sources of submissions in this process, by what else runs in one of its own.

    For tests of what comes after that: to start that process takes longer than all else until the programs start. That
    it takes strange sources with it and nothing else is tested where they are.
    """

    def ask(paths, files, max_imports):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            said = [json.dumps(reader.read_source(files[path], path.name)) for path in paths]
        return [reading._source(json.loads(one)) for one in said], ""

    monkeypatch.setattr(reading, "_ask", ask)
