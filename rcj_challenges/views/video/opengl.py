"""Finds an OpenGL library with which MuJoCo can draw on this computer."""

from __future__ import annotations

import os
import subprocess
import sys

from rcj_challenges.views.video.errors import VideoError

_LINUX_BACKENDS = ("egl", "osmesa", "glfw")
"""EGL and OSMesa need no display; GLFW needs a window system."""
_TIMEOUT_S = 60.0
"""Loading MuJoCo and a software GPU takes about a second; a cold disk gets a minute."""

_DRAW_ONE = """
import mujoco
model = mujoco.MjModel.from_xml_string('<mujoco><worldbody><geom size="1"/></worldbody></mujoco>')
data = mujoco.MjData(model)
mujoco.mj_forward(model, data)
with mujoco.Renderer(model, 32, 32) as renderer:
    renderer.update_scene(data)
    if not renderer.render().any():
        raise SystemExit("the picture stays black")
"""


def choose_backend() -> None:
    """Set ``MUJOCO_GL`` to a backend that can draw here; what the user has set is the only one that is tried.

    MuJoCo reads it when it is imported, so this has to be called before. Each backend draws a small picture in a
    process of its own, because a broken driver may hang or crash the process.

    Raises:
        VideoError: no backend can draw.
    """
    chosen = os.environ.get("MUJOCO_GL")
    on_linux = sys.platform.startswith("linux")
    reasons = []
    for backend in (chosen,) if chosen else _LINUX_BACKENDS if on_linux else ("",):
        reason = _failure(backend)
        if reason is None:
            os.environ["MUJOCO_GL"] = backend
            return
        reasons.append(f"{backend or 'OpenGL'}: {reason}")
    install = "apt install libegl1 libgl1-mesa-dri (Debian, Ubuntu)" if on_linux else "install an OpenGL driver"
    raise VideoError(
        "no-opengl",
        f"MuJoCo cannot draw on this computer ({'; '.join(reasons)})",
        f"{install}; or watch the match in a browser, which needs no OpenGL: rcj-challenge view RUN",
    )


def _failure(backend: str) -> str | None:
    """Return None if a backend draws, else the reason in a line."""
    try:
        # -P: files of the current folder are not imported.
        probe = subprocess.run(
            [sys.executable, "-P", "-c", _DRAW_ONE], env={**os.environ, "MUJOCO_GL": backend}, capture_output=True,
            text=True, encoding="utf-8", errors="replace", timeout=_TIMEOUT_S, check=False,
        )  # fmt: skip
    except (OSError, subprocess.TimeoutExpired) as error:
        return str(error)
    lines = probe.stderr.split("\n") if probe.returncode else []
    return None if not lines else next((line[:200] for line in reversed(lines) if line.strip()), "the process crashed")
