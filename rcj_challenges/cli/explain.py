"""``rcj-challenge explain``: prints the page of a code, or the list of all codes."""

from __future__ import annotations

from collections.abc import Mapping
from difflib import get_close_matches
from importlib import import_module
from importlib.util import find_spec
from pkgutil import iter_modules
from typing import Annotated

import typer

import rcj_challenges
from rcj_challenges.cli.app import WRITE, app
from rcj_challenges.cli.codes import UNKNOWN_CODE
from rcj_challenges.cli.stdio import print_safely
from rcj_challenges.core.code import Code
from rcj_challenges.core.errors import RcjError


@app.register(WRITE, "rcj-challenge explain each-never-named")
def explain(
    code: Annotated[
        str | None, typer.Argument(metavar="CODE", help="A code, as in warning[each-never-named]; default: all.")
    ] = None,
) -> None:
    """Explain the code of an error or a warning."""
    codes = all_codes()
    if code is None:
        width = max(map(len, codes))
        for name, one in sorted(codes.items()):
            print_safely(f"{name:{width}}  {one.page.splitlines()[0]}")
        return
    if code not in codes:
        hint = "".join(f"did you mean '{near}'? " for near in get_close_matches(code, codes, 1))
        raise RcjError(f"unknown code '{code}'", f"{hint}rcj-challenge explain lists all codes", code=UNKNOWN_CODE)
    print_safely(f"{code}\n\n{codes[code].page}")


def all_codes() -> Mapping[str, Code]:
    """Return all codes by name: those of the module ``codes`` of each package, and those of lint."""
    for package in sorted(module.name for module in iter_modules(rcj_challenges.__path__) if module.ispkg):
        module = f"{rcj_challenges.__name__}.{package}.codes"
        if find_spec(module) is not None:
            import_module(module)
    import_module("rcj_challenges.scenario.lint.registry")
    return Code.defined
