"""A rule sheet as sections, and how templates turn it into Markdown and HTML."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from importlib.resources import files
from typing import Any

from rcj_challenges.core.sanitize import sanitize_lines
from rcj_challenges.views.drawing.field import Picture


@dataclass(frozen=True)
class Items:
    """A list, with what introduces it; with ``numbered`` its order means something."""

    entries: tuple[str, ...]
    title: str = ""
    numbered: bool = False

    @property
    def tag(self) -> str:
        """The HTML element of the list."""
        return "ol" if self.numbered else "ul"


@dataclass(frozen=True)
class Table:
    """A table: the cells above its columns, those of each row, and what introduces it."""

    head: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    title: str = ""

    def without_empty(self) -> Table:
        """Return it without the columns that are empty in every row."""
        kept = [k for k in range(len(self.head)) if any(row[k] for row in self.rows)]
        rows = tuple(tuple(row[k] for k in kept) for row in self.rows)
        return Table(tuple(self.head[k] for k in kept), rows, self.title)


Block = str | Items | Table | Picture
"""A paragraph, a list, a table or the drawing."""


@dataclass(frozen=True)
class Section:
    """A heading with what stands below it."""

    title: str
    blocks: tuple[Any, ...]


@dataclass(frozen=True)
class Sheet:
    """A rule sheet: the lead is what players read, about two pages; the appendix what the referee tests beside a base.

    Attributes:
        base: the preset that has a page for all the rest.
    """

    title: str
    description: str
    lead: tuple[Section, ...]
    appendix: tuple[Section, ...] = ()
    base: str = ""


def beyond(sections: Iterable[Section], base: Iterable[Section]) -> Iterator[Section]:
    """Yield what sections have and a base has not; and of what the names are that only its tables have."""
    blocks = [block for section in base for block in section.blocks]
    known = {one for block in blocks for one in (block.entries if isinstance(block, Items) else ())} | {*blocks}
    rows = {block.head: block.rows for block in blocks if isinstance(block, Table)}
    for section in sections:
        left = tuple(one for block in section.blocks for one in _beyond(block, known, rows))
        if left:
            yield Section(section.title, left)


def _beyond(block: Block, known: set[Block], rows: Mapping[tuple[str, ...], Sequence[tuple[str, ...]]]) -> list[Block]:
    if isinstance(block, Items) and not block.numbered:
        entries = tuple(one for one in block.entries if one not in known)
        return [replace(block, entries=entries)] if entries else []
    if not isinstance(block, Table):
        return [] if block in known else [block]
    usual, names = rows.get(block.head, ()), {row[0] for row in block.rows}
    left = replace(block, rows=tuple(row for row in block.rows if row not in usual))
    missing = [row[0] for row in usual if row[0] not in names]
    return [*([left] if left.rows else []), *([f"Not here: {', '.join(missing)}."] if missing else [])]


_MARKDOWN_MARKS = str.maketrans({mark: f"\\{mark}" for mark in "\\`*_[]<>#|"})


def to_html(sheet: Sheet) -> str:
    """Return a sheet as one self-contained HTML page."""
    return _rendered("sheet.html.j2", sanitize_lines, sheet=sheet)


def to_markdown(sheet: Sheet, picture: str | None) -> str:
    """Return a sheet as Markdown, with a text in place of the drawing; None: inline SVG, which most sites leave out."""
    from markupsafe import Markup  # noqa: PLC0415 - only a command that renders a sheet needs it

    def shown(drawing: Picture) -> Markup:
        text = "\n".join(filter(str.strip, drawing.svg().splitlines())) if picture is None else picture
        return Markup(text)  # noqa: S704 - made by the drawing

    text = _rendered("sheet.md.j2", _plain, sheet=sheet, shown=shown)
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
