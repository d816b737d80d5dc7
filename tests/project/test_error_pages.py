"""Each code that the package can report has a page for ``rcj-challenge explain``."""

import ast
import re
from functools import cache
from pathlib import Path

import pytest

import rcj_challenges
from rcj_challenges.cli.explain import pages_by_room
from tests.hostile.archives.cases import ALL

PACKAGE = Path(rcj_challenges.__file__).parent
CODE = re.compile(r"[a-z][a-z0-9]*((-[a-z0-9]+)+|[.][a-z0-9_]+)")
"""Hyphens, or the form ``stage.kind`` of the findings of ``check``."""
FUNCTIONS = (ast.FunctionDef, ast.AsyncFunctionDef)


@cache
def parsed(path):
    return ast.parse(path.read_text(encoding="utf-8"))


def sources(room):
    return sorted((PACKAGE / room).rglob("*.py"))


def parameters(node):
    """Return the names of what a function, or the fields of a class, takes, in order, without ``self``."""
    if isinstance(node, ast.ClassDef):
        inits = [one for one in node.body if isinstance(one, FUNCTIONS) and one.name == "__init__"]
        if inits:
            return parameters(inits[0])
        fields = (one for one in node.body if isinstance(one, ast.AnnAssign) and isinstance(one.target, ast.Name))
        return [(one.target.id, ast.unparse(one.annotation)) for one in fields]
    arguments = [(one.arg, ast.unparse(one.annotation) if one.annotation else "") for one in node.args.args]
    return arguments[1:] if arguments and arguments[0][0] in ("self", "cls") else arguments


@cache
def takers():
    """Return, by name, at which places functions or classes of the package take a code."""
    found = {}
    for path in sources(""):
        for node in ast.walk(parsed(path)):
            if isinstance(node, (*FUNCTIONS, ast.ClassDef)):
                taken = parameters(node)
                if ("code", "str") in taken:
                    found.setdefault(node.name, set()).add(taken.index(("code", "str")))
    return found


def given(call):
    """Yield what a call may give as a code."""
    name = getattr(call.func, "id", None) or getattr(call.func, "attr", None)
    places = takers().get(name, ())
    yield from (call.args[place] for place in places if place < len(call.args))
    yield from (one.value for one in call.keywords if one.arg == "code" and places)


def defaults(function):
    """Return the codes that a function takes if none is given."""
    named = zip(reversed(function.args.args), reversed(function.args.defaults), strict=False)
    return {code for argument, default in named if argument.arg == "code" for code in texts(default)}


def is_code_of_a_class(node):
    """Return whether this is the code of an error class, for errors that are raised without one."""
    return isinstance(node, ast.Assign) and [getattr(one, "id", "") for one in node.targets] == ["CODE"]


def texts(node):
    """Return the codes that stand somewhere in a part of a source."""
    constants = (one.value for one in ast.walk(node) if isinstance(one, ast.Constant) and isinstance(one.value, str))
    return {text for text in constants if CODE.fullmatch(text)}


def assigned(name, function):
    """Return the codes that a function assigns to a variable, alone or with others."""
    assignments = (one for one in ast.walk(function) if isinstance(one, ast.Assign))
    return {
        code
        for one in assignments
        if any(isinstance(part, ast.Name) and part.id == name for target in one.targets for part in ast.walk(target))
        for code in texts(one.value)
    }


def codes_in(node, around=None):
    """Yield the codes that are given in a source."""
    for inner in ast.iter_child_nodes(node):
        if is_code_of_a_class(inner):
            yield from texts(inner.value)
        if isinstance(inner, FUNCTIONS):
            yield from defaults(inner)
        for code in given(inner) if isinstance(inner, ast.Call) else ():
            yield from texts(code)
            if isinstance(code, ast.Name) and around is not None:
                yield from assigned(code.id, around)
        yield from codes_in(inner, inner if isinstance(inner, FUNCTIONS) else around)


def codes_of(room):
    return {code for path in sources(room) for code in codes_in(parsed(path))}


@pytest.mark.parametrize("room", pages_by_room())
def test_every_code_of_a_room_has_a_page(room):
    pages = {code for pages in pages_by_room().values() for code in pages}
    assert codes_of(room) - pages == set()


def test_codes_are_found_in_the_sources():
    assert {"disk-full", "store-in-use", "bad-size"} <= codes_of("")


def test_every_finding_of_the_hostile_corpus_has_a_page():
    pages = {code for pages in pages_by_room().values() for code in pages}
    assert {case.code for case in ALL.values()} - pages == set()


def test_no_code_has_two_pages():
    codes = [code for pages in pages_by_room().values() for code in pages]
    assert sorted(codes) == sorted(set(codes))


def test_every_page_begins_with_a_sentence():
    for code, page in ((code, page) for pages in pages_by_room().values() for code, page in pages.items()):
        assert CODE.fullmatch(code) or code.isalpha()
        assert page.splitlines()[0].endswith((".", ":")), code
