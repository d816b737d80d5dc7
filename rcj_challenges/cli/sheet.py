"""``rcj-challenge sheet``: the rule sheet of a scenario. No physics, no programs."""

from __future__ import annotations

from pathlib import Path

from rcj_challenges.cli.output_paths import OutputError, check_ending, deliver, file_for_terminal

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
    out = out or file_for_terminal(f"{loaded.scenario.id}.html")
    if out is None:
        return deliver(sheet_markdown(loaded.scenario, loaded.roster), None)
    if out.suffix.lower() in _HTML:
        return deliver(sheet_html(loaded.scenario, loaded.roster), out)
    from urllib.parse import quote

    from rcj_challenges.views.drawing import draw_scenario

    drawing = out.with_suffix(".svg")
    shown = f"![The field]({quote(drawing.name)})"
    if drawing.exists() and not (out.is_file() and shown.encode() in out.read_bytes()):  # of no earlier sheet
        raise OutputError(f"{drawing} exists already; nothing was written", "choose another --out", code="file-exists")
    deliver(draw_scenario(loaded.scenario, loaded.roster), drawing)
    return deliver(sheet_markdown(loaded.scenario, loaded.roster, shown), out)
