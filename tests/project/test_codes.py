"""Each code is defined once, with its page for ``rcj-challenge explain``, and is reported somewhere."""

import re
from pathlib import Path

import pytest

import rcj_challenges
from rcj_challenges.cli.explain import all_codes
from rcj_challenges.core.code import Code
from tests.hostile.archives.cases import ALL

PACKAGE = Path(rcj_challenges.__file__).parent
FORM = re.compile(r"[a-z][a-z0-9]*((-[a-z0-9]+)+|[.][a-z0-9_]+)")
"""Hyphens, or the form ``stage.kind`` of the findings of ``check``."""


def test_every_page_begins_with_a_sentence():
    for code in all_codes().values():
        assert FORM.fullmatch(code)
        assert code.page.splitlines()[0].endswith((".", ":")), code


def test_every_code_is_reported_somewhere():
    constants = re.compile(r"^([A-Z][A-Z0-9_]+) = Code", re.MULTILINE)
    defined = {name for path in PACKAGE.glob("*/codes.py") for name in constants.findall(path.read_text("utf-8"))}
    others = [path.read_text("utf-8") for path in PACKAGE.rglob("*.py") if path.name != "codes.py"]
    assert defined - {word for text in others for word in re.findall(r"\w+", text)} == set()


def test_every_finding_of_the_hostile_corpus_is_a_code():
    assert {case.code for case in ALL.values()} - set(all_codes()) == set()


def test_a_code_cannot_be_defined_twice():
    with pytest.raises(ValueError, match="twice"):
        Code(next(iter(all_codes())), "Something else.")
