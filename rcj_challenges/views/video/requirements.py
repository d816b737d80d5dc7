"""What videos and pictures need of a computer: optional packages, and the OpenGL with which MuJoCo draws."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from importlib.util import find_spec

from rcj_challenges.core.codes import MISSING_EXTRA
from rcj_challenges.core.errors import RcjError
from rcj_challenges.views.codes import NO_OPENGL

_OPENING_ERRORS = (ImportError, AttributeError, RuntimeError, OSError)
"""What PyOpenGL and MuJoCo raise where a library or a device is missing."""


def require_packages(*packages: str) -> None:
    """Check that optional packages are installed, before any work is done.

    Raises:
        RcjError: one is missing.
    """
    if missing := [package for package in packages if find_spec(package) is None]:
        message = f"videos and pictures need optional packages (missing: {', '.join(missing)})"
        help_ = 'pip install "rcj-challenges[video]"; or watch it in a browser: rcj-challenge view RUN'
        raise RcjError(message, help_, code=MISSING_EXTRA)


@contextmanager
def offscreen_opengl() -> Iterator[None]:
    """Open MuJoCo's renderer inside this context: on Linux it uses EGL, unless ``MUJOCO_GL`` is set.

    MuJoCo reads the variable when it is imported, so its first import has to be inside, too.

    Raises:
        RcjError: the renderer cannot be opened.
    """
    on_linux = sys.platform.startswith("linux")
    if on_linux:
        os.environ.setdefault("MUJOCO_GL", "egl")
    try:
        yield
    except _OPENING_ERRORS as error:
        install = "apt install libegl1 libgl1-mesa-dri (Debian, Ubuntu)" if on_linux else "install an OpenGL driver"
        raise RcjError(
            f"MuJoCo cannot draw on this computer: {type(error).__name__}: {error}",
            f"{install}; or watch the match in a browser, which needs no OpenGL: rcj-challenge view RUN",
            code=NO_OPENGL,
        ) from error
