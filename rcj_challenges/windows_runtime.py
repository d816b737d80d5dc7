"""Where Windows finds the Microsoft Visual C++ runtime that MuJoCo needs.

Python brings a part of it along, many other programs install the rest, and on a new laptop it is missing. Our
dependency `msvc-runtime` brings it without an administrator. In a virtual environment, and where pip installs for one
user, its files do not lie beside `python.exe`, and Windows would not look for them.
"""

from __future__ import annotations

import os
import sys

TYPE_CHECKING = False
if TYPE_CHECKING:
    from pathlib import Path

NEEDED = "msvcp140_atomic_wait.dll"
"""The youngest of the files that `mujoco.dll` names: it came with the runtime of 2020."""

PACKAGE = "msvc-runtime"


def find() -> None:
    """Let Windows look into the folder of the package, unless the system has the runtime; elsewhere do nothing."""
    if sys.platform == "win32":
        from pathlib import Path  # noqa: PLC0415 - see `packaged_runtime`

        folder = packaged_runtime(Path(os.environ.get("SYSTEMROOT", r"C:\Windows")) / "System32")
        if folder is not None:
            os.add_dll_directory(str(folder))


def packaged_runtime(system: Path) -> Path | None:
    """Return the folder of the packaged runtime; None if the system has its own, or if there is none.

    Args:
        system: the folder of the system's own files.
    """
    if (system / NEEDED).exists():
        return None
    # No other system needs these, and every command imports this module before it hears Ctrl-C.
    from importlib import metadata  # noqa: PLC0415
    from pathlib import Path  # noqa: PLC0415

    try:
        files = metadata.distribution(PACKAGE).files or ()
    except metadata.PackageNotFoundError:
        return None
    places = (Path(str(file.locate())) for file in files if file.name.lower() == NEEDED)
    return next((place.resolve().parent for place in places if place.exists()), None)
