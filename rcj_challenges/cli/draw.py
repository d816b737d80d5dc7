"""``rcj-challenge draw``: the drawing of a scenario. No physics, no programs."""

from __future__ import annotations

import sys
from pathlib import Path

from rcj_challenges.cli.output_paths import check_ending, deliver, file_for_terminal


def draw(scenario: str, out: Path | None, overrides: list[str]) -> int:
    """Write the drawing of a scenario: PNG if the file is called ``.png``, SVG if ``.svg``; returns the exit code.

    Raises:
        RcjError: wrong input; also a file that is called otherwise, or that cannot be written.
    """
    from rcj_challenges.scenario.load import load
    from rcj_challenges.views.drawing import draw_scenario

    check_ending(out, (".svg", ".png"), "its name must end in .svg or .png")
    loaded = load(scenario, overrides)
    out = out or file_for_terminal(f"{loaded.scenario.id}.svg")
    picture = draw_scenario(loaded.scenario, loaded.roster)
    if out is not None and out.suffix.lower() == ".png":
        from rcj_challenges.views.drawing.png import png_from_svg, written_with

        done = deliver(png_from_svg(picture), out)
        if written_with() is None:
            sys.stderr.write(
                f"{out.name} has no words, for no font for them was found on this computer: take --out "
                f"{out.stem}.svg, or install a font, such as DejaVu Sans or Noto Sans\n"
            )
        return done
    return deliver(picture, out)
