"""``rcj-challenge draw``: the drawing of a scenario, or of a team's designs. No physics, no programs."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from rcj_challenges.cli.app import WRITE, app
from rcj_challenges.cli.codes import OPTION_DOES_NOT_FIT
from rcj_challenges.cli.options import Overrides, ScenarioName
from rcj_challenges.cli.output_paths import check_ending, deliver, file_for_terminal
from rcj_challenges.core.diagnostics import Diagnostic, DiagnosticError

if TYPE_CHECKING:
    from rcj_challenges.scenario.models.scenario import Scenario


@app.register(
    WRITE,
    "rcj-challenge draw relay_race.yaml --out relay_race.svg",
    "rcj-challenge draw robot_cup.yaml --design my_team.zip --out design.png",
)
def draw(
    scenario: ScenarioName,
    out: Annotated[
        Path | None,
        typer.Option("--out", "-o", metavar="FILE", help=".svg or .png; default: a file on a terminal, else SVG."),
    ] = None,
    set_: Overrides = None,
    design: Annotated[
        str | None,
        typer.Option("--design", metavar="TEAM", help="Draw the robots in this team's robot.yaml, with their prices."),
    ] = None,
) -> None:
    """Draw the field with zones, gates, spots, start poses and placement areas; or the robots that a team designed."""
    from rcj_challenges.scenario.load import load
    from rcj_challenges.views.drawing import draw_scenario

    check_ending(out, (".svg", ".png"), "its name must end in .svg or .png")
    loaded = load(scenario, set_ or [])
    out = out or file_for_terminal(f"{loaded.scenario.id if design is None else 'design'}.svg")
    picture = _designs(loaded.scenario, design) if design is not None else draw_scenario(loaded.scenario, loaded.roster)
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


def _designs(scenario: Scenario, team_path: str) -> str:
    """Return the drawing of a team's designs, judged by the first guideline of the scenario.

    Raises:
        DiagnosticError: there is nothing to draw: no guideline, no robot.yaml, or one that cannot be read.
    """
    from rcj_challenges.cli.team_args import locate_team
    from rcj_challenges.match.designs import brought_by
    from rcj_challenges.submissions.team import open_team
    from rcj_challenges.views.drawing.designs import draw_designs

    seat = next((seat for seat, entrant in scenario.entrants.items() if entrant.design), None)
    if seat is None:
        help_ = "give one in which teams design robots"
        raise DiagnosticError(Diagnostic(OPTION_DOES_NOT_FIT, f"{scenario.id} has no guidelines for robots", help_))
    team = open_team(locate_team(team_path), *scenario.entrants.values())
    brought = brought_by(team, seat, scenario)
    if brought is None:
        raise DiagnosticError(Diagnostic(OPTION_DOES_NOT_FIT, f"{team.name} has no robot.yaml"))
    (verdict,) = brought.verdicts
    if not verdict.designs:
        raise DiagnosticError(*verdict.problems)
    return draw_designs(team.name, verdict)
