"""From a recorded run to a video or a picture."""

from __future__ import annotations

import io
import re
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Protocol

from PIL import Image

from rcj_challenges.facts.errors import advised
from rcj_challenges.records.folder import replaced
from rcj_challenges.views.sentences import plain
from rcj_challenges.views.video import gl_probe
from rcj_challenges.views.video.board import Board
from rcj_challenges.views.video.camera import Camera
from rcj_challenges.views.video.errors import VideoError
from rcj_challenges.views.video.footage import Footage
from rcj_challenges.views.video.lettering import Lettering
from rcj_challenges.views.video.timeline import Clip, Moment, frame_count, moments
from rcj_challenges.views.video.topdown import TopDown

RENDERERS = ("auto", "top", "3d")
SMALLEST_PX, LARGEST_PX = 160, 4096
_NAMED_SIZES = {"480p": (854, 480), "720p": (1280, 720), "1080p": (1920, 1080), "2160p": (3840, 2160)}
_FROM_ABOVE = ("field", "top", "follow-ball")
"""Cameras that need no third dimension."""


class Stage(Protocol):
    """Draws moments."""

    name: str

    def picture(self, moment: Moment) -> Image.Image:
        """Return the picture of a moment, without the board; it is drawn over by the next."""

    def close(self) -> None:
        """Give back what it holds."""


@dataclass(frozen=True)
class Look:
    """How a run is shown.

    Attributes:
        size: width and height in pixels.
        camera: its name: field, top, side, follow-ball or behind:ROBOT.
        renderer: ``auto``, ``top`` or ``3d``.
        shadows: whether things throw shadows in 3-D; slow without a real GPU.
    """

    size: tuple[int, int] = (1280, 720)
    camera: str = "field"
    renderer: str = "auto"
    shadows: bool = False


def size_from(text: str, *, even: bool) -> tuple[int, int]:
    """Return the pixels that ``1280x720`` or ``720p`` means.

    Args:
        text: what the user wrote.
        even: whether width and height must be even, as MP4's colours need it.

    Raises:
        VideoError: it is no size, or one that nobody can look at.
    """
    found = re.fullmatch(r"(\d{1,6})x(\d{1,6})", text.strip().lower(), re.ASCII)
    if text.strip().lower() in _NAMED_SIZES:
        return _NAMED_SIZES[text.strip().lower()]
    if found is None:
        raise VideoError(f"--size {text[:40]!r}: write WIDTHxHEIGHT, as 1280x720, or one of {', '.join(_NAMED_SIZES)}")
    size = (int(found[1]), int(found[2]))
    if not all(SMALLEST_PX <= pixels <= LARGEST_PX for pixels in size):
        raise VideoError(f"--size {text[:40]}: width and height must be {SMALLEST_PX} to {LARGEST_PX} pixels")
    if even and (size[0] % 2 or size[1] % 2):
        near = f"{size[0] + size[0] % 2}x{size[1] + size[1] % 2}"
        raise VideoError(f"--size {text[:40]}: an MP4 needs an even width and height; try {near}")
    return size


class Studio:
    """Everything that is needed to draw a run in one way.

    Attributes:
        says: sentences for the user: with what it is drawn, and why not otherwise.
        lettering: what writes; its ``boxes`` are characters that no font has.
    """

    def __init__(self, footage: Footage, look: Look) -> None:
        """Choose how it is drawn.

        Raises:
            VideoError: the camera is unknown, or what was asked for cannot be drawn here.
        """
        if look.renderer not in RENDERERS:
            raise VideoError(f"--renderer {look.renderer[:40]!r} is unknown: there are {', '.join(RENDERERS)}")
        self.footage = footage
        self.says: list[str] = []
        self.lettering = Lettering()
        self._board = Board(footage, look.size, self.lettering)
        self._stage = self._choose(look, Camera.named(look.camera, footage.roster))

    def frame(self, moment: Moment) -> Image.Image:
        """Return the whole picture of a moment; it is drawn over by the next."""
        picture = self._stage.picture(moment)
        self._board.write(picture, moment)
        return picture

    def close(self) -> None:
        """Give back what drawing held."""
        self._stage.close()

    def unwritten(self) -> str:
        """Return the sentence about characters that no font has, or nothing."""
        boxes = "".join(self.lettering.boxes)
        if not boxes:
            return ""
        return (
            f"no font on this computer has {plain(boxes, 20)!r}: boxes stand there. "
            "Install one that has them, such as Noto Sans (docs/video.md)"
        )

    def _choose(self, look: Look, camera: Camera) -> Stage:
        top = self._board.height
        flat = look.renderer == "top"
        if flat and camera.kind not in _FROM_ABOVE:
            raise VideoError(
                f"--camera {look.camera} needs 3-D: with --renderer top there are {', '.join(_FROM_ABOVE)}"
            )
        reason = None if flat else gl_probe.why_not_solid()
        if reason is None and not flat:
            from rcj_challenges.views.video.solid import Solid  # noqa: PLC0415 - loads MuJoCo, after the backend is set

            self.says.append(f"drawn in 3-D by MuJoCo ({gl_probe.backend_name()})")
            return Solid(self.footage, look.size, top, camera, self.lettering, shadows=look.shadows)
        if look.renderer == "3d":
            raise VideoError(f"{reason}. Without it: --renderer top draws from above")
        self.says.append("drawn from above by Pillow" + (f", not in 3-D: {reason}" if reason else ""))
        if camera.kind not in _FROM_ABOVE:
            followed = ", following it" if camera.entity >= 0 else ""
            self.says.append(f"--camera {look.camera} needs 3-D: it is shown from above{followed}")
        return TopDown(self.footage, look.size, top, camera, self.lettering)


@contextmanager
def studio(footage: Footage, look: Look) -> Iterator[Studio]:
    """Open a studio and close it.

    Raises:
        VideoError: the camera is unknown, or what was asked for cannot be drawn here.
    """
    opened = Studio(footage, look)
    try:
        yield opened
    finally:
        opened.close()


def write_snapshot(made_in: Studio, moment: Moment, path: Path) -> None:
    """Write the picture of a moment as PNG.

    Raises:
        VideoError: it cannot be written.
    """
    file = io.BytesIO()
    made_in.frame(moment).save(file, "PNG", optimize=True)
    try:
        with replaced(path) as target:
            target.write(file.getvalue())
    except OSError as error:
        raise VideoError(f"{path}: cannot be written: {advised(error)}") from error


def write_video(
    made_in: Studio,
    clips: list[Clip],
    path: Path,
    *,
    size: tuple[int, int],
    fps: Fraction,
    speed: float,
    progress: Callable[[int, int], None] | None = None,
) -> int:
    """Write clips as one MP4. Returns the number of frames.

    Args:
        made_in: what draws.
        clips: what is shown, in order.
        path: of the file; it is whole or not there (see `rcj_challenges.views.video.film.Film`).
        size: width and height in pixels, as the studio's.
        fps: frames for each second of video.
        speed: seconds of the match in each second of video.
        progress: told (frames done, frames in all) after each frame.

    Raises:
        VideoError: it cannot be written.
    """
    from rcj_challenges.views.video.film import Film  # noqa: PLC0415 - a picture needs no av

    total = frame_count(clips, float(fps), speed)
    names = " - ".join(plain(title, 60) for title in made_in.footage.titles.values())
    with Film(path, size, fps, f"{names}: {plain(made_in.footage.scenario.title, 100)}") as film:
        for done, moment in enumerate(moments(made_in.footage, clips, float(fps), speed), 1):
            film.add(made_in.frame(moment))
            if progress is not None:
                progress(done, total)
    return total
