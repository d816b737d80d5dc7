"""``rcj-challenge schema``: the JSON schemas of scenario files and of tournament files."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated

import typer

from rcj_challenges.cli.app import WRITE, app
from rcj_challenges.cli.output_paths import deliver, refuse_devices


@app.register(WRITE, "rcj-challenge schema --out scenario.schema.json")
def schema(
    out: Annotated[
        Path | None,
        typer.Option("--out", metavar="FILE", help="Where to write it; default: schemas/scenario.schema.json."),
    ] = None,
    tournament: Annotated[bool, typer.Option("--tournament", help="The schema of tournament files instead.")] = False,
    check: Annotated[bool, typer.Option("--check", help="Write nothing; exit 1 if a shipped one is stale.")] = False,
) -> int:
    """Write the JSON schema of scenario files or of tournament files, for completion in editors."""
    from rcj_challenges.scenario import json_schema as of_scenarios
    from rcj_challenges.scenario.resources import SCHEMAS_FOLDER
    from rcj_challenges.tournament import json_schema as of_tournaments

    if not check:
        refuse_devices(out=out)
        chosen = of_tournaments if tournament else of_scenarios
        deliver(chosen.schema_text(), Path("schemas") / chosen.FILE if out is None else out, make_folder=True)
        return 0
    code = 0
    for one, command in ((of_scenarios, "schema"), (of_tournaments, "schema --tournament")):
        file = SCHEMAS_FOLDER / one.FILE
        if file.is_file() and file.read_text("utf-8") == one.schema_text():
            sys.stdout.write(f"{one.FILE} is fresh\n")
        else:
            stale = f"{SCHEMAS_FOLDER.name}/{one.FILE} is stale: write it with `rcj-challenge {command}`\n"
            sys.stderr.write(stale)
            code = 1
    return code
