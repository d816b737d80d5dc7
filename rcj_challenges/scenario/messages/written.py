"""A condition as an author writes it, for messages that name one of several."""

from __future__ import annotations

import json
import re
from typing import Any

from pydantic import BaseModel

_PLAIN = re.compile(r"[^\W\d][\w-]*")
_NO_TEXT_TO_YAML = ("yes", "no", "on", "off", "true", "false", "null")
"""What YAML takes for something else than a text, unless it stands in quotation marks."""
_BEHIND = {"at_least": 1, "at_most": 1, "equals": 1, "negate": 2}
"""What people write behind all else."""


def as_written(value: Any) -> str:
    """Return a condition, or what stands in it, as an author writes it."""
    if isinstance(value, BaseModel):
        fields = {name: getattr(value, name) for name in value.model_fields_set}
        order = [name for name in type(value).model_fields if name in fields]
        order.sort(key=lambda name: (name != "condition", _BEHIND.get(name, 0)))
        return f"{{{', '.join(f'{name}: {as_written(fields[name])}' for name in order)}}}"
    if isinstance(value, list | tuple):
        return f"[{', '.join(map(as_written, value))}]"
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, str) and (value.casefold() in _NO_TEXT_TO_YAML or not _PLAIN.fullmatch(value)):
        return json.dumps(value, ensure_ascii=False)
    return f"{value:.10g}" if isinstance(value, float) else str(value)
