"""``rcj-challenge schema``: the JSON schemas of scenario files and of tournament files."""

from __future__ import annotations

import sys
from pathlib import Path

from rcj_challenges.cli.output_paths import refuse_devices
from rcj_challenges.core.errors import RcjError, format_error, room_help
from rcj_challenges.scenario import json_schema as of_scenarios
from rcj_challenges.scenario.resources import schemas_folder
from rcj_challenges.tournament import json_schema as of_tournaments


class SchemaFileError(RcjError):
    """The schema cannot be written where it was asked for."""

    CODE = "cannot-write"


def write_schema(out: Path | None, *, of_tournament: bool = False) -> int:
    """Write a schema and print where.

    Args:
        out: the file; left out: the one that is shipped, in ``schemas/`` below the current directory.
        of_tournament: write that of tournament files, not of scenario files.

    Returns:
        0.

    Raises:
        SchemaFileError: the file cannot be written.
        OutputNameError: it is the name of a device.
    """
    refuse_devices(out=out)
    schema = of_tournaments if of_tournament else of_scenarios
    file = Path("schemas") / schema.FILE if out is None else out
    try:
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(schema.schema_text(), encoding="utf-8", newline="\n")
    except OSError as error:
        raise SchemaFileError(f"{file}: cannot be written: {format_error(error)}", room_help(error)) from error
    sys.stdout.write(f"{file}\n")
    return 0


def check_schema() -> int:
    """Print whether the shipped schemas are what the models say: 0 if so, else 1."""
    code = 0
    for schema, command in ((of_scenarios, "schema"), (of_tournaments, "schema --tournament")):
        if schema.schema_is_fresh():
            sys.stdout.write(f"{schema.FILE} is fresh\n")
        else:
            sys.stderr.write(
                f"{schemas_folder().name}/{schema.FILE} is stale: write it with `rcj-challenge {command}`\n"
            )
            code = 1
    return code
