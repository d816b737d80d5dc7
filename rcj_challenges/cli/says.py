"""What commands print for other programs, and the streams that they print to: they may be closed, narrow, or unread."""

from __future__ import annotations

import codecs
import contextlib
import io
import json
import os
import sys
from typing import Any

from rcj_challenges.facts.errors import HostError, told_of


def say_json(value: Any) -> None:
    """Print a value as JSON and nothing else; who reads no more of it changes nothing about a command's exit code.

    Letters stand in it as they are where the output is UTF-8, else as JSON's own escapes: it means the same then.

    Raises:
        HostError: it cannot be written, as to a file on a full disk.
    """
    wide = codecs.lookup(getattr(sys.stdout, "encoding", None) or "utf-8").name == "utf-8"
    text = json.dumps(value, ensure_ascii=not wide, indent=2)
    if any("\ud800" <= letter <= "\udfff" for letter in text):
        text = json.dumps(value, indent=2)
    try:
        sys.stdout.write(text + "\n")
        sys.stdout.flush()
    except BrokenPipeError:
        say_no_more(sys.stdout)
    except OSError as error:
        say_no_more(sys.stdout)
        raise HostError(f"the output cannot be written: {told_of(error)}") from error


def say_no_more(stream: Any) -> None:
    """Let what is still printed there go nowhere: else the interpreter complains of it at its end."""
    with contextlib.suppress(OSError, ValueError), contextlib.ExitStack() as stack:
        nowhere = os.open(os.devnull, os.O_WRONLY)
        stack.callback(os.close, nowhere)
        os.dup2(nowhere, stream.fileno())


def open_what_is_closed() -> None:
    """Let the three standard streams lead nowhere where they are closed, as cron and services like to start commands.

    Else the next files that are opened take their places, such as the log of the match, and get what is printed.
    """
    for number, name in enumerate(("stdin", "stdout", "stderr")):
        try:
            os.fstat(number)
        except OSError:
            if os.open(os.devnull, os.O_RDWR) != number:
                return  # this system numbers otherwise
            file = io.FileIO(number, "r" if name == "stdin" else "w", closefd=False)
            buffered: Any = io.BufferedReader(file) if name == "stdin" else io.BufferedWriter(file)
            setattr(sys, name, io.TextIOWrapper(buffered, encoding="utf-8", errors="backslashreplace"))
