"""``rcj-challenge schema``: the JSON schemas of scenario files and of tournament files."""

from __future__ import annotations

import sys
from pathlib import Path

from rcj_challenges.cli.output_paths import deliver, refuse_devices
from rcj_challenges.scenario import json_schema as of_scenarios
from rcj_challenges.scenario.resources import schemas_folder
from rcj_challenges.tournament import json_schema as of_tournaments


def write_schema(out: Path | None, *, of_tournament: bool = False) -> int:
    """Write a schema and print where; returns 0.

    Args:
        out: the file; None: the one that is shipped, in ``schemas/`` below the current directory.
        of_tournament: write that of tournament files, not of scenario files.

    Raises:
        OutputError: the file cannot be written.
        OutputNameError: it is the name of a device.
    """
    refuse_devices(out=out)
    schema = of_tournaments if of_tournament else of_scenarios
    file = Path("schemas") / schema.FILE if out is None else out
    return deliver(schema.schema_text(), file, make_folder=True)


def check_schema() -> int:
    """Print whether the shipped schemas are up to date: 0 if so, else 1."""
    code = 0
    for schema, command in ((of_scenarios, "schema"), (of_tournaments, "schema --tournament")):
        if schema.schema_is_fresh():
            sys.stdout.write(f"{schema.FILE} is fresh\n")
        else:
            stale = f"{schemas_folder().name}/{schema.FILE} is stale: write it with `rcj-challenge {command}`\n"
            sys.stderr.write(stale)
            code = 1
    return code
