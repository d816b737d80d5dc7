"""Programs that try what they must not, each attempt by itself, and tell what came of it."""

from __future__ import annotations

import ast
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path

import pytest
from fake_match import FakeMatch

from rcj_challenges.programs import isolation

BASE = ("clean_environment", "private_folder", "ends_with_parent")

_HEAD = """
import ctypes, errno, os, platform, resource, signal, socket, subprocess, sys, threading
from controller import Robot

robot = Robot()
libc = ctypes.CDLL(None, use_errno=True)

def syscall(x86_64, aarch64, *arguments):
    number = {"x86_64": x86_64, "aarch64": aarch64}[platform.machine()]
    passed = [ctypes.c_long(a) if isinstance(a, int) else a for a in arguments]
    if libc.syscall(ctypes.c_long(number), *passed) == -1:
        raise OSError(ctypes.get_errno(), "refused")

def attempt(name, action):
    try:
        outcome = action()
    except OSError as error:
        outcome = errno.errorcode.get(error.errno, type(error).__name__)
    except Exception as error:
        outcome = type(error).__name__
    else:
        outcome = "done" if outcome is None else str(outcome)
    print(ascii([name, outcome]))

"""
_TAIL = "\nwhile robot.step(32) != -1:\n    pass\n"


@contextmanager
def only(*layers: str) -> Iterator[None]:
    """Programs get these layers, and those without which runs would not be tidy."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(isolation, "active_layers", lambda *_: (*BASE, *layers))
        yield


def outcomes(folder: Path, attempts: Mapping[str, str], before: str = "", **limits: float) -> dict[str, str]:
    """Play a program that makes all attempts.

    Args:
        folder: for the match.
        attempts: expressions by name.
        before: lines that come first.
        limits: of the scenario.

    Returns:
        By name ``done``, what the expression gave, or the name of the error.
    """
    lines = [f"attempt({name!r}, lambda: {action})" for name, action in attempts.items()]
    played = FakeMatch(folder, **limits).play(_HEAD + before + "\n".join(lines) + _TAIL, 2)  # type: ignore[arg-type]
    assert played.fault is None, played.log
    return dict(ast.literal_eval(line) for line in played.said if line.startswith("["))
