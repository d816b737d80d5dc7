"""The base of all errors that mean *wrong input*: shown as one message without a traceback, exit code 2."""

from __future__ import annotations

from typing import ClassVar


class RcjError(Exception):
    """Something given to us is wrong; the message says what, where, and what would be right.

    Attributes:
        exit_code: what the command line exits with.
    """

    exit_code: ClassVar[int] = 2
