"""Whether MuJoCo can draw here: found out by drawing one small picture in a process of its own.

A missing or broken graphics library may refuse to be imported, hang, or take the whole process down; none of this may
happen to the program that asks.
"""

from __future__ import annotations

import os
import subprocess
import sys

_PATIENCE_S = 60.0
"""Loading MuJoCo and a software GPU takes about a second; a cold disk is given a minute."""

_DRAW_ONE = """
import mujoco
spec = mujoco.MjSpec()
spec.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_SPHERE, size=[1, 0, 0], rgba=[1, 1, 1, 1])
model = spec.compile()
data = mujoco.MjData(model)
mujoco.mj_forward(model, data)
with mujoco.Renderer(model, 32, 32) as renderer:
    renderer.update_scene(data)
    if not renderer.render().any():
        raise SystemExit("the picture stays black")
"""

DEBIAN_HINT = "on Debian and Ubuntu: apt install libegl1 libgl1-mesa-dri"


def choose_backend() -> None:
    """Let MuJoCo draw without a display on Linux, unless the user chose a backend (``MUJOCO_GL``).

    It has to be called before mujoco is imported.
    """
    if sys.platform.startswith("linux") and not os.environ.get("MUJOCO_GL"):
        os.environ["MUJOCO_GL"] = "egl"


def backend_name() -> str:
    """Return what MuJoCo draws with."""
    defaults = {"darwin": "CGL", "win32": "WGL"}
    return (os.environ.get("MUJOCO_GL") or defaults.get(sys.platform, "GLFW")).upper()


def why_not_solid() -> str | None:
    """Return None if MuJoCo can draw here, else the reason in a line."""
    if "mujoco" in sys.modules and not os.environ.get("MUJOCO_GL") and sys.platform.startswith("linux"):
        return "MuJoCo was loaded before, without a graphics backend: set MUJOCO_GL=egl before the start"
    choose_backend()
    try:
        probe = subprocess.run(
            [sys.executable, "-P", "-c", _DRAW_ONE],
            capture_output=True, text=True, encoding="utf-8", errors="replace", timeout=_PATIENCE_S, check=False,
        )  # fmt: skip
    except (OSError, subprocess.TimeoutExpired) as error:
        return f"MuJoCo could not draw: {error}"
    if probe.returncode == 0:
        return None
    lines = [line.strip() for line in probe.stderr.splitlines() if line.strip()]
    said = lines[-1][:200] if lines else f"the drawing process ended with {probe.returncode}"
    hint = f" ({DEBIAN_HINT})" if backend_name() == "EGL" else ""
    return f"MuJoCo cannot draw with {backend_name()}: {said}{hint}"
