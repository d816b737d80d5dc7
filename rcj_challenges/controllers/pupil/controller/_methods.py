"""Gives classes of compiled code the methods back that they had."""

from __future__ import annotations

import gc
import sys
from contextlib import suppress

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Mapping
    from typing import Any

_replaced: list[Any] = []
"""What stood in their dictionaries before. Python may still know it by its address: it must not be freed."""


def restore_methods(kind: type, restored: Mapping[str, Any]) -> None:
    """Give a class methods. It takes none from Python, but the dictionary behind it does.

    Nobody tells Python that the class has changed, so it forgets what it has looked up in any class.
    """
    with suppress(Exception):  # without them only programs that use them suffer
        (methods,) = gc.get_referents(kind.__dict__)
        forget = getattr(sys, "_clear_internal_caches", None) or sys._clear_type_cache  # noqa: SLF001
        _replaced.extend(methods.get(name) for name in restored)
        methods.update(restored)
        forget()
