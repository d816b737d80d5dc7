"""``rcj-challenge schema``: the JSON schema of scenario files."""

from __future__ import annotations

import sys
from pathlib import Path

from rcj_challenges.cli.outputs import refuse_devices
from rcj_challenges.facts.errors import RcjError, advised
from rcj_challenges.scenario.json_schema import FILE, schema_is_fresh, schema_text
from rcj_challenges.scenario.resources import schemas_folder


class SchemaFileError(RcjError):
    """The schema cannot be written where it was asked for."""


def write_schema(out: Path | None) -> int:
    """Write the schema and print where.

    Args:
        out: the file; left out: ``schemas/scenario.schema.json`` below the current directory.

    Returns:
        0.

    Raises:
        SchemaFileError: the file cannot be written.
        OutputNameError: it is the name of a device.
    """
    refuse_devices(out=out)
    file = Path("schemas") / FILE if out is None else out
    try:
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(schema_text(), encoding="utf-8", newline="\n")
    except OSError as error:
        raise SchemaFileError(f"{file}: cannot be written: {advised(error)}") from error
    sys.stdout.write(f"{file}\n")
    return 0


def check_schema() -> int:
    """Say whether the shipped schema is what the models say: 0 if so, else 1."""
    if schema_is_fresh():
        sys.stdout.write(f"{FILE} is fresh\n")
        return 0
    sys.stderr.write(f"{schemas_folder().name}/{FILE} is stale: write it anew with `rcj-challenge schema`\n")
    return 1
