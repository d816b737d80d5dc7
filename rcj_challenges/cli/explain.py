"""``rcj-challenge explain``: prints the page of a code, or the list of all codes.

A room that reports problems with codes has a module ``error_pages`` with a mapping ``PAGES`` from each of its codes
to a page: one sentence that says what the code means, then what to do about it, as an author or a pupil reads it. A
code of several rooms has its page in the lowest of them.
"""

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
from rcj_challenges.cli.stdio import print_safely
from rcj_challenges.core.diagnostics import Diagnostic, DiagnosticError


@app.register(WRITE, "rcj-challenge explain each-never-named")
def explain(
    code: Annotated[
        str | None, typer.Argument(metavar="CODE", help="A code, as in warning[each-never-named]; default: all.")
    ] = None,
) -> None:
    """Explain the code of an error or a warning."""
    pages = {name: page for of_room in pages_by_room().values() for name, page in of_room.items()}
    if code is None:
        width = max(map(len, pages))
        for name, page in sorted(pages.items()):
            print_safely(f"{name:{width}}  {page.splitlines()[0]}")
        return
    if code not in pages:
        near = get_close_matches(code, pages, 1)
        hint = f"did you mean '{near[0]}'? " if near else ""
        raise DiagnosticError(
            Diagnostic("unknown-code", f"unknown code '{code}'", f"{hint}rcj-challenge explain lists all codes")
        )
    print_safely(f"{code}\n\n{pages[code]}")


def pages_by_room() -> dict[str, Mapping[str, str]]:
    """Pages of each room that has some."""
    names = sorted(module.name for module in iter_modules(rcj_challenges.__path__) if module.ispkg)
    modules = {name: f"{rcj_challenges.__name__}.{name}.error_pages" for name in names}
    return {name: import_module(module).PAGES for name, module in modules.items() if find_spec(module) is not None}
