"""Where commands are asked to write: names that one of the systems on which we run cannot give to a file."""

from __future__ import annotations

from pathlib import Path

from rcj_challenges.facts.errors import RcjError
from rcj_challenges.facts.file_names import is_device_of_windows


class OutputNameError(RcjError):
    """A name that a file or folder cannot have."""

    CODE = "device-name"


def refuse_devices(**outputs: Path | None) -> None:
    """Refuse what no file on Windows may be called, on every system: what is made is handed on.

    Only the last name of a path counts: who has a folder of such a name already knows where it works.

    Args:
        outputs: what was given, by the option's name without its dashes; None: nothing.

    Raises:
        OutputNameError: one of them is the name of a device.
    """
    for option, path in outputs.items():
        if path is not None and is_device_of_windows(path.name):
            name = path.name.partition(".")[0].rstrip()
            message = f"--{option} {path}: '{name}' is a device on Windows, where no file has that name"
            raise OutputNameError(message, "choose another name")
