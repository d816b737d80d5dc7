"""From a recorded run to a video or a picture."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from fractions import Fraction
from pathlib import Path

from PIL import Image

from rcj_challenges.core.errors import RcjError, unwritable
from rcj_challenges.core.sanitize import sanitize
from rcj_challenges.records.folder import replaced
from rcj_challenges.views.codes import BAD_SIZE
from rcj_challenges.views.palette import PALETTE
from rcj_challenges.views.video.camera import Camera
from rcj_challenges.views.video.clips import Moment
from rcj_challenges.views.video.footage import Footage
from rcj_challenges.views.video.overlay import Overlay
from rcj_challenges.views.video.requirements import offscreen_opengl

MIN_PX, MAX_PX = 160, 4096
_NAMED_SIZES = {"480p": (854, 480), "720p": (1280, 720), "1080p": (1920, 1080), "2160p": (3840, 2160)}

Draw = Callable[[Moment], Image.Image]
"""Returns the picture of a moment."""


def parse_size(text: str, *, even: bool) -> tuple[int, int]:
    """Parse ``1280x720`` or ``720p`` as pixels; an MP4 needs an even width and height.

    Raises:
        RcjError: it is not a size, or one that is too small, too large or odd.
    """
    name = text.strip().lower()
    if name in _NAMED_SIZES:
        return _NAMED_SIZES[name]
    match = re.fullmatch(r"(\d{1,6})x(\d{1,6})", name, re.ASCII)
    if match is None:
        known = ", ".join(_NAMED_SIZES)
        raise RcjError(f"--size {text[:40]!r}", f"write WIDTHxHEIGHT, such as 1280x720, or {known}", code=BAD_SIZE)
    size = (int(match[1]), int(match[2]))
    if not all(MIN_PX <= pixels <= MAX_PX for pixels in size):
        raise RcjError(f"--size {text[:40]}: width and height must be {MIN_PX} to {MAX_PX} pixels", code=BAD_SIZE)
    if even and (size[0] % 2 or size[1] % 2):
        near = f"{size[0] + size[0] % 2}x{size[1] + size[1] % 2}"
        raise RcjError(f"--size {text[:40]}: an MP4 needs an even width and height", f"try {near}", code=BAD_SIZE)
    return size


@contextmanager
def opened_renderer(footage: Footage, size: tuple[int, int], camera: str, *, fine: bool = False) -> Iterator[Draw]:
    """Open what draws moments of a size, with scoreboard and captions; smooth edges take several times as long.

    Raises:
        RcjError: the camera is unknown, or this computer has no OpenGL.
    """
    chosen, overlay = Camera.parse(camera, footage.roster), Overlay(footage, size)
    with offscreen_opengl():
        from rcj_challenges.views.video.renderer import SceneRenderer  # noqa: PLC0415 - loads MuJoCo

        renderer = SceneRenderer(footage, (size[0], size[1] - overlay.height), chosen, fine=fine)

    def draw(moment: Moment) -> Image.Image:
        frame = Image.new("RGB", size, PALETTE["outside"]["light"])
        frame.paste(renderer.draw(moment), (0, overlay.height))
        overlay.write(frame, moment)
        if chosen.kind == "behind":
            overlay.add_pictures(frame, moment, footage.roster.entities[chosen.entity])
        return frame

    try:
        yield draw
    finally:
        renderer.close()


def write_snapshot(draw: Draw, moment: Moment, path: Path) -> None:
    """Write the picture of a moment as PNG.

    Raises:
        RcjError: it cannot be written.
    """
    picture = draw(moment)
    try:
        with replaced(path) as file:
            picture.save(file, "PNG")
    except OSError as error:
        raise unwritable(path, error) from error


def write_video(
    draw: Draw, footage: Footage, shown: Sequence[Moment], path: Path, *, size: tuple[int, int], fps: Fraction,
    progress: Callable[[int], None],
) -> None:  # fmt: skip
    """Write moments as one MP4 of ``fps`` frames a second, see `mp4.opened_mp4`.

    ``size`` in pixels is that of the pictures that ``draw`` returns; ``progress`` gets the number of frames so far.

    Raises:
        RcjError: the file cannot be written.
    """
    from rcj_challenges.views.video.mp4 import opened_mp4  # noqa: PLC0415 - a snapshot needs no av

    names = " - ".join(sanitize(title, 60) for title in footage.titles.values())
    with opened_mp4(path, size, fps, f"{names}: {sanitize(footage.scenario.title, 100)}") as add:
        for done, moment in enumerate(shown, 1):
            add(draw(moment))
            progress(done)
