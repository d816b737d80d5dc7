"""Write the schemas of what the commands answer: ``run --json`` and ``check --json``.

    python scripts/write_schemas.py

That of scenario files is written by ``rcj-challenge schema``, for authors have it too.
"""

from __future__ import annotations

from pathlib import Path

from rcj_challenges.checker.report import schema_text
from rcj_challenges.records.result import result_schema_text

FOLDER = Path(__file__).parents[1] / "schemas"
TEXTS = {"check.schema.json": schema_text, "result.schema.json": result_schema_text}


def main() -> None:
    """Write them all."""
    for name, text in TEXTS.items():
        (FOLDER / name).write_text(text(), encoding="utf-8", newline="\n")
        print(f"{FOLDER.name}/{name}")


if __name__ == "__main__":
    main()
