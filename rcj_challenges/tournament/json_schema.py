"""The JSON schema of tournament files, for completion and hints in editors."""

from __future__ import annotations

import json
from typing import Any

from rcj_challenges.scenario.json_schema import SchemaWriter, sentence_of
from rcj_challenges.tournament.tournament_file import Tournament

FILE = "tournament.schema.json"


def tournament_schema() -> dict[str, Any]:
    """Return the JSON schema (draft 2020-12) of a tournament file."""
    writer = SchemaWriter(with_params=False)
    properties = writer.properties(Tournament, partial=False)
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "RCJ Challenges tournament",
        "description": sentence_of(Tournament),
        "type": "object",
        "properties": properties,
        "required": [name for name, info in Tournament.model_fields.items() if info.is_required()],
        "anyOf": [{"required": ["teams"]}, {"required": ["teams_folder"]}],
        "additionalProperties": False,
        "$defs": dict(sorted(writer.definitions.items())),
    }


def schema_text() -> str:
    """Return the schema as it is committed."""
    return json.dumps(tournament_schema(), indent=2, ensure_ascii=False) + "\n"
