"""A sheet as blocks, rendered as Markdown or as HTML."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from rcj_challenges.facts.sanitize import sanitize_lines
from rcj_challenges.views.markup import escaped


@dataclass(frozen=True)
class Heading:
    """A heading; level 1 is the title."""

    level: int
    text: str


@dataclass(frozen=True)
class Paragraph:
    """Running text."""

    text: str


@dataclass(frozen=True)
class Items:
    """A list; with ``numbered`` its order means something."""

    entries: tuple[str, ...]
    numbered: bool = False


@dataclass(frozen=True)
class Table:
    """A table with a head.

    Attributes:
        head: above the columns.
        rows: the cells of each.
        ends_in_words: whether the last column is a sentence beside several short ones: on a phone it keeps its width.
    """

    head: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    ends_in_words: bool = False


@dataclass(frozen=True)
class Picture:
    """An SVG document."""

    svg: str


Block = Heading | Paragraph | Items | Table | Picture

_MARKDOWN_MARKS = str.maketrans({mark: f"\\{mark}" for mark in "\\`*_[]<>#|"})

# Beside several others a column of sentences would be a tower of single words on a phone.
_CSS = """
:root{color-scheme:light dark}
body{font:16px/1.5 system-ui,-apple-system,'Segoe UI',sans-serif;max-width:60rem;margin:2rem auto;padding:0 1rem;
overflow-wrap:break-word}
table{border-collapse:collapse;margin:.5rem 0 1rem}th,td{border:1px solid #8886;padding:.3rem .6rem;text-align:left}
th{background:#8882}svg{max-width:100%;height:auto;background:#fff;border-radius:6px}li{margin:.3rem 0}
@media screen and (max-width:45rem){table,.drawing{display:block;overflow-x:auto}
.drawing svg{width:37rem;max-width:none}.words td:last-child{min-width:16rem}}
@media print{body{margin:0;max-width:none}h1,h2,h3{break-after:avoid}tr,svg{break-inside:avoid}}
"""


def as_markdown(blocks: Iterable[Block], picture: str | None) -> str:
    """Return the blocks as Markdown.

    Args:
        blocks: in order.
        picture: what stands for pictures, such as a link to a file; None: they stand in it themselves, as inline SVG,
            which most sites that show Markdown leave out.
    """
    shown = (picture if picture is not None and isinstance(block, Picture) else _markdown(block) for block in blocks)
    return "\n\n".join(shown) + "\n"


def as_html(title: str, blocks: Iterable[Block]) -> str:
    """Return the blocks as one self-contained HTML page."""
    body = "\n".join(_html(block) for block in blocks)
    return (
        '<!doctype html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'\">\n"
        f"<title>{escaped(title)}</title>\n<style>{_CSS}</style>\n</head>\n<body>\n{body}\n</body>\n</html>\n"
    )


def _markdown(block: Block) -> str:
    if isinstance(block, Heading):
        return f"{'#' * block.level} {_plain(block.text)}"
    if isinstance(block, Paragraph):
        return _plain(block.text)
    if isinstance(block, Items):
        return "\n".join(f"{f'{k}.' if block.numbered else '-'} {_plain(e)}" for k, e in enumerate(block.entries, 1))
    if isinstance(block, Table):
        rows = [block.head, tuple("---" for _ in block.head), *block.rows]
        return "\n".join(
            "| " + " | ".join(cell if k == 1 else _plain(cell) for cell in row) + " |" for k, row in enumerate(rows)
        )
    return "\n".join(line for line in block.svg.splitlines() if line.strip())


def _plain(text: str) -> str:
    return sanitize_lines(" ".join(text.split())).translate(_MARKDOWN_MARKS)


def _html(block: Block) -> str:
    if isinstance(block, Heading):
        return f"<h{block.level}>{escaped(block.text)}</h{block.level}>"
    if isinstance(block, Paragraph):
        return f"<p>{escaped(block.text)}</p>"
    if isinstance(block, Items):
        tag = "ol" if block.numbered else "ul"
        return f"<{tag}>" + "".join(f"<li>{escaped(entry)}</li>" for entry in block.entries) + f"</{tag}>"
    if isinstance(block, Table):
        rows = "".join(_row("td", row) for row in block.rows)
        words = ' class="words"' if block.ends_in_words else ""
        return f"<table{words}><thead>{_row('th', block.head)}</thead><tbody>{rows}</tbody></table>"
    # Where a phone shows the whole field, its key stands beside it, off the screen.
    return f'<div class="drawing">\n{block.svg}</div>'


def _row(tag: str, cells: Sequence[str]) -> str:
    return "<tr>" + "".join(f"<{tag}>{escaped(cell)}</{tag}>" for cell in cells) + "</tr>"
