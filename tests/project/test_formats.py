"""A format of the tournament is one file and one line: nothing outside of its package looks which one a stage has."""

import ast
import re
from pathlib import Path
from typing import get_args

import rcj_challenges
from rcj_challenges.tournament.formats import Stage

PACKAGE = Path(rcj_challenges.__file__).parent
FORMATS = PACKAGE / "tournament" / "formats"
CLASSES = {one.__name__: one for one in get_args(get_args(Stage)[0])}
TAGS = {get_args(one.model_fields["stage"].annotation)[0] for one in CLASSES.values()}
ALLOWED: dict[str, str] = {}
"""Modules outside the package that look into a format, each with the reason."""


def looks_into_a_format(tree: ast.AST) -> bool:
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("rcj_challenges.tournament.formats"):
            if CLASSES.keys() & {name.name for name in node.names} or node.module.rpartition(".")[2] in TAGS:
                return True
        elif isinstance(node, ast.Compare):
            attributes = {one.attr for one in ast.walk(node) if isinstance(one, ast.Attribute)}
            constants = {one.value for one in ast.walk(node) if isinstance(one, ast.Constant)}
            if {"kind", "stage"} & attributes and TAGS & constants:
                return True
    return False


def test_only_the_modules_on_the_list_look_into_a_format() -> None:
    sources = [path for path in PACKAGE.rglob("*.py") if FORMATS not in path.parents]
    assert len(sources) > 300
    found = {
        path.relative_to(PACKAGE).as_posix()
        for path in sources
        if looks_into_a_format(ast.parse(path.read_text(encoding="utf-8")))
    }
    assert found == ALLOWED.keys()


def test_no_page_of_the_site_asks_for_a_format() -> None:
    asks = re.compile(rf"""kind\s*[!=]=\s*["']({"|".join(TAGS)})["']""")
    pages = list((PACKAGE / "tournament" / "site" / "templates").glob("*.html"))
    assert len(pages) > 10
    assert [path.name for path in pages if asks.search(path.read_text(encoding="utf-8"))] == []


def test_each_format_is_in_the_file_named_after_it() -> None:
    assert {one.__module__.rpartition(".")[2] for one in CLASSES.values()} == TAGS


def test_the_search_finds_what_it_looks_for() -> None:
    for line in (
        "from rcj_challenges.tournament.formats import Swiss",
        "from rcj_challenges.tournament.formats.swiss import anything",
        "x = 1 if stage.kind != 'swiss' else 2",
        "x = stage.stage in ('swiss', 'round_robin')",
    ):
        assert looks_into_a_format(ast.parse(line)), line
