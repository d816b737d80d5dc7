"""A rule sheet as sections, and how templates turn it into Markdown and HTML."""

from __future__ import annotations

import re
from dataclasses import dataclass
from importlib.resources import files
from typing import Any

from rcj_challenges.core.sanitize import sanitize_lines
from rcj_challenges.views.drawing.field import Picture


@dataclass(frozen=True)
class Items:
    """A list; with ``numbered`` its order means something."""

    entries: tuple[str, ...]
    numbered: bool = False

    @property
    def tag(self) -> str:
        """The HTML element of the list."""
        return "ol" if self.numbered else "ul"


@dataclass(frozen=True)
class Table:
    """A table: the cells above its columns, and those of each row."""

    head: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]

    def without_empty(self) -> Table:
        """Return it without the columns that are empty in every row."""
        kept = [k for k in range(len(self.head)) if any(row[k] for row in self.rows)]
        return Table(tuple(self.head[k] for k in kept), tuple(tuple(row[k] for k in kept) for row in self.rows))


Block = str | Items | Table
"""A paragraph, a list or a table."""


@dataclass(frozen=True)
class Section:
    """A heading with what stands below it."""

    title: str
    blocks: tuple[Block, ...]


@dataclass(frozen=True)
class Sheet:
    """A rule sheet: the lead is what players read, about two pages; the appendix has all that the referee tests."""

    title: str
    description: str
    picture: Picture
    lead: tuple[Section, ...]
    appendix: tuple[Section, ...]


_MARKDOWN_MARKS = str.maketrans({mark: f"\\{mark}" for mark in "\\`*_[]<>#|"})


def to_html(sheet: Sheet) -> str:
    """Return a sheet as one self-contained HTML page."""
    return _rendered("sheet.html.j2", sanitize_lines, sheet=sheet)


def to_markdown(sheet: Sheet, picture: str | None) -> str:
    """Return a sheet as Markdown, with a text in place of the drawing; None: inline SVG, which most sites leave out."""
    from markupsafe import Markup  # noqa: PLC0415 - only a command that renders a sheet needs it

    shown = "\n".join(filter(str.strip, sheet.picture.svg().splitlines())) if picture is None else picture
    text = _rendered("sheet.md.j2", _plain, sheet=sheet, picture=Markup(shown))  # noqa: S704 - made by the drawing
    return re.sub(r"\n{3,}", "\n\n", re.sub(" +\n", "\n", text)).strip() + "\n"


def _plain(text: str) -> str:
    """Return text on one line without marks that mean something in Markdown."""
    return sanitize_lines(" ".join(text.split())).translate(_MARKDOWN_MARKS)


def _rendered(name: str, clean: Any, **values: Any) -> str:
    from jinja2 import Environment, StrictUndefined  # noqa: PLC0415 - takes a tenth of a second to import
    from markupsafe import Markup  # noqa: PLC0415

    environment = Environment(
        autoescape=name.endswith(".html.j2"),
        undefined=StrictUndefined,
        finalize=lambda value: clean(value) if type(value) is str else value,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters["markup"] = Markup
    template = files("rcj_challenges.views.sheet").joinpath("templates", name).read_text(encoding="utf-8")
    return environment.from_string(template).render(**values)
