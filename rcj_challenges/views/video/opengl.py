"""The OpenGL with which MuJoCo draws without a window."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager

from rcj_challenges.core.errors import RcjError
from rcj_challenges.views.codes import NO_OPENGL

_OPENING_ERRORS = (ImportError, AttributeError, RuntimeError, OSError)
"""What PyOpenGL and MuJoCo raise where a library or a device is missing."""


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
