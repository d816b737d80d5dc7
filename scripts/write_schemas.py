"""Write the schemas of what the commands print, ``run --json`` and ``check --json``, and of the interface of a site.

    python scripts/write_schemas.py

That of scenario files is written by ``rcj-challenge schema``, for authors have it too.
"""

from __future__ import annotations

import argparse
import json
import sys
import tempfile
from pathlib import Path
from typing import Any

from rcj_challenges.checker.report import CheckReport
from rcj_challenges.records.result import RunResult

FOLDER = Path(__file__).parents[1] / "schemas"


def check_text() -> str:
    """Return the schema of ``check --json``."""
    schema = CheckReport.model_json_schema(mode="serialization")
    for name in ("level", "repair"):
        del schema["$defs"]["Diagnostic"]["properties"][name]["default"]
    return _written(schema)


def result_text() -> str:
    """Return the schema of ``run --json``."""
    return _written(RunResult.model_json_schema())


def _written(schema: dict[str, Any]) -> str:
    draft = {"$schema": "https://json-schema.org/draft/2020-12/schema"}
    return json.dumps(draft | schema, indent=2, ensure_ascii=False) + "\n"


def site_text() -> str:
    """Return the OpenAPI description of a site."""
    from rcj_challenges.web.config import make_site, set_up  # noqa: PLC0415 - half a second

    with tempfile.TemporaryDirectory() as folder:
        set_up(make_site(Path(folder) / "site", "Site"))
        from rcj_challenges.web.api import openapi_text  # noqa: PLC0415 - once Django is set up

        return openapi_text()


TEXTS = {"check.schema.json": check_text, "result.schema.json": result_text, "site.openapi.json": site_text}


def main() -> int:
    """Write them all, or with --check compare them; returns the exit code."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--check", action="store_true")
    if parser.parse_args().check:
        stale = [name for name, text in TEXTS.items() if (FOLDER / name).read_text(encoding="utf-8") != text()]
        print(f"stale: {stale}; run python scripts/write_schemas.py" if stale else "fresh")
        return 1 if stale else 0
    for name, text in TEXTS.items():
        (FOLDER / name).write_text(text(), encoding="utf-8", newline="\n")
        print(f"{FOLDER.name}/{name}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
