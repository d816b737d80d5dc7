"""``rcj-challenge sheet``: the rule sheet of a scenario. No physics, no programs."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from rcj_challenges.cli.app import WRITE, app
from rcj_challenges.cli.options import Overrides, ScenarioName
from rcj_challenges.cli.output_paths import check_ending, deliver, file_for_terminal
from rcj_challenges.core.errors import taken

_HTML = (".html", ".htm")


@app.register(WRITE, "rcj-challenge sheet relay_race.yaml --out relay_race.html")
def sheet(
    scenario: ScenarioName,
    out: Annotated[
        Path | None,
        typer.Option(
            "--out",
            "-o",
            metavar="FILE",
            help=".html, or .md with an .svg beside it; default: an .html on a terminal, else Markdown.",
        ),
    ] = None,
    set_: Overrides = None,
) -> None:
    """Write the rule sheet for the teams; of a preset, the page of all that sheets of what extends it leave out."""
    from rcj_challenges.scenario.load import load
    from rcj_challenges.scenario.resources import PRESETS_FOLDER, names_in
    from rcj_challenges.views.sheet import sheet_html, sheet_markdown

    check_ending(out, (".md", *_HTML), "its name must end in .md or .html")
    is_preset = str(scenario) in names_in(PRESETS_FOLDER)
    loaded = load(PRESETS_FOLDER / f"{scenario}.yaml" if is_preset else scenario, set_ or [])
    out = out or file_for_terminal(f"{loaded.scenario.id}.html")
    if out is None:
        deliver(sheet_markdown(loaded.scenario, loaded.roster), None)
        return
    if out.suffix.lower() in _HTML:
        deliver(sheet_html(loaded.scenario, loaded.roster), out)
        return
    from urllib.parse import quote

    from rcj_challenges.views.drawing import draw_scenario

    # A file of its own: sites that show Markdown show no inline SVG.
    drawing = out.with_suffix(".svg")
    shown = f"![The field]({quote(drawing.name)})"
    if drawing.exists() and not (out.is_file() and shown.encode() in out.read_bytes()):  # of no earlier sheet
        raise taken(drawing)
    deliver(draw_scenario(loaded.scenario, loaded.roster), drawing)
    deliver(sheet_markdown(loaded.scenario, loaded.roster, shown), out)
