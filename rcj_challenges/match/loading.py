"""Loads the physics, and reports what the computer lacks if that fails."""

from __future__ import annotations

import sys
from collections.abc import Callable
from importlib import import_module
from typing import TYPE_CHECKING, Any

from rcj_challenges.core.codes import NO_PHYSICS
from rcj_challenges.core.errors import HostError, interruption_behind
from rcj_challenges.windows_runtime import PACKAGE

if TYPE_CHECKING:
    from rcj_challenges.match.stage import HalfStage


def load_stage(load: Callable[[str], Any] = import_module, system: str = sys.platform) -> Callable[..., HalfStage]:
    """Return `rcj_challenges.match.stage.build_stage`.

    Raises:
        HostError: MuJoCo or numpy cannot be loaded on this computer.
    """
    try:
        builder: Callable[..., HalfStage] = load("rcj_challenges.match.stage").build_stage
    except (ImportError, OSError) as error:
        ours = (getattr(error, "name", None) or "").startswith("rcj_challenges")
        if ours or interruption_behind(error) is not None:
            raise
        raise HostError(f"the physics cannot be loaded: {error}", _help_for(system), code=NO_PHYSICS) from error
    return builder


def _help_for(system: str) -> str:
    if system == "win32":
        return (
            f"on Windows it mostly lacks Microsoft's Visual C++ runtime: python -m pip install {PACKAGE} brings it, "
            'or the "Visual C++ Redistributable" that Microsoft offers'
        )
    return "install it again: python -m pip install --force-reinstall --no-cache-dir mujoco numpy"
