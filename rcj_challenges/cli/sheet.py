"""``rcj-challenge sheet``: the rule sheet of a scenario. No physics, no programs."""

from __future__ import annotations

import sys
from pathlib import Path

from rcj_challenges.cli.output_paths import OutputError, check_ending, deliver
from rcj_challenges.cli.stdio import shell_quoted

_HTML = (".html", ".htm")


def sheet(scenario: str, out: Path | None, overrides: list[str]) -> int:
    """Write the rule sheet of a scenario: HTML if the file is called ``.html``, Markdown if ``.md``.

    HTML has the drawing in it. Beside Markdown it is a file of its own: sites that show Markdown show no inline SVG.

    Raises:
        RcjError: wrong input; also a file that is called otherwise, or that cannot be written.
    """
    from rcj_challenges.scenario.load import load
    from rcj_challenges.views.sheet import sheet_html, sheet_markdown

    check_ending(out, (".md", *_HTML), "its name must end in .md or .html")
    loaded = load(scenario, overrides)
    if out is None:
        # A terminal does not show the source of a drawing; a file or another program gets all of it.
        command = f"rcj-challenge draw {shell_quoted(scenario)} --out field.svg"
        picture = f"The drawing: `{command}`" if sys.stdout.isatty() else None
        return deliver(sheet_markdown(loaded.scenario, loaded.roster, picture), None)
    if out.suffix.lower() in _HTML:
        return deliver(sheet_html(loaded.scenario, loaded.roster), out)
    from urllib.parse import quote

    from rcj_challenges.views.drawing import draw_scenario

    drawing = out.with_suffix(".svg")
    if drawing.exists() and not out.exists():  # it is not the drawing of an earlier sheet
        raise OutputError(f"{drawing} exists already; nothing was written", "choose another --out", code="file-exists")
    deliver(draw_scenario(loaded.scenario, loaded.roster), drawing)
    return deliver(sheet_markdown(loaded.scenario, loaded.roster, f"![The field]({quote(drawing.name)})"), out)
