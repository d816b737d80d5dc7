"""Codes of errors and warnings, each with its page for ``rcj-challenge explain``."""

from __future__ import annotations

import re
from typing import Any, ClassVar, Literal, Self

_FORM = re.compile(r"[a-z][a-z0-9]*(-[a-z0-9]+)*|[a-z]+[.][a-z0-9_]+")

Level = Literal["passed", "warning", "error", "unchecked"]
"""How serious something is; ``unchecked``: unknown, and no verdict on what was examined."""


class Code(str):  # noqa: SLOT000 - its page is not fixed in size
    """The code of a diagnostic, stable since 0.1: lower case with hyphens, ``unknown-zone``, or ``stage.kind``.

    A package defines its codes in its module ``codes``. A code of several packages belongs to the lowest of them.

    Attributes:
        page: one sentence that says what the code means, an empty line, then what to do about it.
        level: of its diagnostics, unless one says otherwise.
        repair: whether ``check --fix`` repairs it: ``no``, ``yes``, or ``yes`` and the sign of a footnote.
    """

    defined: ClassVar[dict[str, Code]] = {}
    """All codes by name, of the modules that are imported."""

    page: str
    level: Level
    repair: str

    def __new__(cls, name: str, page: str, level: Level = "error", repair: str = "no") -> Self:
        """Define a code. The first line of its page is the sentence that says what it means.

        Raises:
            ValueError: it has another form, or is defined already.
        """
        if not _FORM.fullmatch(name) or name in cls.defined:
            raise ValueError(f"not a code, or defined twice: {name!r}")
        code = super().__new__(cls, name)
        code.page, code.level, code.repair = page.strip().replace("\n", "\n\n", 1), level, repair
        cls.defined[name] = code
        return code

    @classmethod
    def named(cls, name: str) -> Code:
        """Return the code of a name.

        Raises:
            KeyError: none is defined.
        """
        return cls.defined[name]

    def __reduce__(self) -> tuple[Any, ...]:
        return Code.named, (str(self),)

    @classmethod
    def __get_pydantic_core_schema__(cls, _source: object, _handler: object) -> Any:
        from pydantic_core import core_schema  # noqa: PLC0415 - commands without models do not load it

        return core_schema.no_info_after_validator_function(cls.named, core_schema.str_schema())
