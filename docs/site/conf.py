"""The documents as a searchable site: ``pip install -e ".[docs]" && sphinx-build -c docs/site . site``.

Sphinx reads the Markdown files as they are. What a page links to outside the documents, such as a scenario, is copied
beside it; folders have no page.
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[2]
_INDEX = "docs/README"
_DECISIONS = "docs/adr/README"
_LINK = re.compile(r"\]\((?!https?:)([\w./-]+)\.md[#)]")

project = "RCJ Challenges"
extensions = ["myst_parser"]
root_doc = _INDEX
include_patterns = ["*.md", "docs/*.md", "docs/adr/*.md"]
html_theme = "furo"
html_title = project
html_show_sourcelink = False
myst_heading_anchors = 4
suppress_warnings = ["myst.xref_missing", "myst.header"]  # links to folders; pages begin with any level


def _add_contents(_: Any, page: str, text: list[str]) -> None:
    """List the pages of an index in the sidebar, in the order of its links."""
    if page not in (_INDEX, _DECISIONS):
        return
    folder = (ROOT / page).parent
    linked = [(folder / f"{link}.md").resolve().relative_to(ROOT).with_suffix("") for link in _LINK.findall(text[0])]
    pages = [f"/{one.as_posix()}" for one in dict.fromkeys(linked) if one.as_posix() != page]
    if page == _INDEX:
        pages = ["/README", *pages]
    text[0] += "\n".join(["", "```{toctree}", ":hidden:", "", *pages, "```", ""])


def setup(app: Any) -> None:
    """Connect the hook."""
    app.connect("source-read", _add_contents)
