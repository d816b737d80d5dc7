"""Invalid file names."""

from __future__ import annotations

import re

_DEVICES = re.compile(r"con|prn|aux|nul|conin\$|conout\$|(com|lpt)[0-9¹²³]", re.IGNORECASE)


def is_device_of_windows(name: str) -> bool:
    """Return whether Windows reserves this name, whatever its ending."""
    return _DEVICES.fullmatch(name.partition(".")[0].rstrip()) is not None
