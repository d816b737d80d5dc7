"""``rcj-challenge draw``: the drawing of a scenario. No physics, no programs."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated

import typer

from rcj_challenges.cli.app import WRITE, app
from rcj_challenges.cli.options import Overrides, ScenarioName
from rcj_challenges.cli.output_paths import check_ending, deliver, file_for_terminal


@app.register(WRITE, "rcj-challenge draw relay_race.yaml --out relay_race.svg")
def draw(
    scenario: ScenarioName,
    out: Annotated[
        Path | None,
        typer.Option("--out", "-o", metavar="FILE", help=".svg or .png; default: a file on a terminal, else SVG."),
    ] = None,
    set_: Overrides = None,
) -> None:
    """Draw the field with zones, gates, spots, start poses and placement areas."""
    from rcj_challenges.scenario.load import load
    from rcj_challenges.views.drawing import draw_scenario

    check_ending(out, (".svg", ".png"), "its name must end in .svg or .png")
    loaded = load(scenario, set_ or [])
    out = out or file_for_terminal(f"{loaded.scenario.id}.svg")
    picture = draw_scenario(loaded.scenario, loaded.roster)
    if out is None or out.suffix.lower() == ".svg":
        deliver(picture, out)
        return
    from rcj_challenges.views.drawing.png import png_from_svg, written_with

    deliver(png_from_svg(picture), out)
    if written_with() is None:
        sys.stderr.write(
            f"{out.name} has no words, for no font for them was found on this computer: take --out "
            f"{out.stem}.svg, or install a font, such as DejaVu Sans or Noto Sans\n"
        )
