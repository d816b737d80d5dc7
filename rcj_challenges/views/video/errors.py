"""What can be wrong with a wish for a video or a picture."""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path

from rcj_challenges.facts.errors import RcjError


class VideoError(RcjError):
    """A video or picture that cannot be made as asked for: the message says what is possible."""


class VideoExtraMissingError(VideoError):
    """The optional packages are not installed."""


class FilmInterruptedError(KeyboardInterrupt):
    """Ctrl-C while a video was made; what was made until then is kept."""

    def __init__(self, kept: Path, frames: int) -> None:
        super().__init__(f"{frames} frames are kept in {kept}")
        self.kept = kept
        self.frames = frames


_PACKAGES = {"PIL": "pillow"}


def need_extra(*packages: str) -> None:
    """Check that optional packages are there, before any work is done.

    Raises:
        VideoExtraMissingError: one is not installed; the message says how to get it and what works without.
    """
    missing = [_PACKAGES.get(package, package) for package in packages if find_spec(package) is None]
    if missing:
        raise VideoExtraMissingError(
            f"videos and pictures need optional packages (missing: {', '.join(missing)}): "
            'pip install "rcj-challenges[video]". '
            "Without them: rcj-challenge view RUN shows the match in a browser, rcj-challenge replay RUN writes it"
        )
