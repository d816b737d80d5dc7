"""Who reads no more of what a command prints (``| head``) changes nothing about its exit code."""

import os
import sys
from contextlib import contextmanager

import pytest

from rcj_challenges.cli.test import play_tests
from rcj_challenges.cli.validate import validate

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="a pipe without a reader is reported differently")

SOUND = """schema_version: 2
id: sound
title: Sound
extends: match
expect:
  inherited: null
"""
FAILS = SOUND + "  scored: {keyframes: [{at_s: 1}], lasts_s: 2, score: {yellow: 5}}\n"


@pytest.fixture
def files(tmp_path):
    for name, text in (("sound", SOUND), ("fails", FAILS), ("wrong", "id: wrong\n")):
        (tmp_path / f"{name}.yaml").write_text(text, encoding="utf-8")
    return lambda *names: [str(tmp_path / f"{name}.yaml") for name in names]


@contextmanager
def unread(name: str):
    """Leave one of the two streams unread, each line of which is written at once."""
    reader, writer = os.pipe()
    os.close(reader)
    with pytest.MonkeyPatch.context() as patch, os.fdopen(writer, "w", buffering=1, encoding="utf-8") as stream:
        patch.setattr(sys, name, stream)
        yield


@pytest.mark.parametrize("stream", ["stdout", "stderr"])
def test_failed_test_gives_its_exit_code_when_output_is_not_read(files, stream):
    with unread(stream):
        assert play_tests(files("fails")) == 1
        assert play_tests(files("wrong", "fails")) == 2


@pytest.mark.parametrize("stream", ["stdout", "stderr"])
def test_invalid_file_gives_its_exit_code_when_output_is_not_read(files, stream):
    with unread(stream):
        assert validate(files("sound", "wrong")) == 2
