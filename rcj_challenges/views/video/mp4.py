"""Writes an MP4; under its final name there is never half a file."""

from __future__ import annotations

import os
from contextlib import suppress
from fractions import Fraction
from pathlib import Path
from types import TracebackType
from typing import Any, Self

import av
import numpy as np
from PIL import Image

from rcj_challenges.facts.errors import error_hint
from rcj_challenges.records.folder import when_free
from rcj_challenges.views.video.errors import VideoError, VideoInterruptedError, cannot_write

_CODECS = {
    # CRF 20 looks like the original; "veryfast" takes a third of the default's time for 10 % more bytes.
    "libx264": {"preset": "veryfast", "crf": "20"},
    # Encoders of FFmpeg builds without x264.
    "libopenh264": {"b": "4M"},
    "mpeg4": {"q:v": "4"},
}


class Mp4Writer:
    """Context manager that writes frames to ``NAME.mp4.PID.tmp`` and renames it when it is complete.

    After Ctrl-C the frames written so far are kept as ``NAME.part.mp4``. After any other error nothing is left.
    """

    def __init__(self, path: Path, size: tuple[int, int], fps: Fraction, title: str) -> None:
        self._path = path
        self._part = path.with_name(f"{path.stem}.part.mp4")
        self._temporary = path.with_name(f"{path.name}.{os.getpid()}.tmp")
        self._size, self._fps, self._title = size, fps, title
        self._frames = 0
        self._container: Any = None
        self._stream: Any = None

    def __enter__(self) -> Self:
        """Open the file.

        Raises:
            VideoError: it cannot be written.
        """
        codec = next(name for name in _CODECS if name in av.codec.codecs_available)
        try:
            # faststart puts the index first: web players start before they have the whole file.
            self._container = av.open(str(self._temporary), "w", format="mp4", options={"movflags": "+faststart"})
            self._container.metadata["title"] = self._title
            self._stream = self._container.add_stream(codec, rate=self._fps, options=_CODECS[codec])
            self._stream.width, self._stream.height = self._size
            self._stream.pix_fmt = "yuv420p"
        except OSError as error:
            self._discard()
            raise cannot_write(self._path, error) from error
        return self

    def add(self, picture: Image.Image) -> None:
        """Add an RGB picture; x264 compresses it in threads of its own.

        Raises:
            VideoError: the file cannot be written.
        """
        frame = av.VideoFrame.from_ndarray(np.asarray(picture), format="rgb24")
        frame.pts, frame.time_base = self._frames, 1 / self._fps
        try:
            self._container.mux(self._stream.encode(frame))
        except OSError as error:
            raise cannot_write(self._path, error) from error
        self._frames += 1

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        """Finish the file, keep it as ``.part.mp4``, or remove it.

        Raises:
            VideoInterruptedError: in place of the KeyboardInterrupt, if there are frames.
            VideoError: the file cannot be written.
        """
        interrupted = kind is not None and issubclass(kind, KeyboardInterrupt) and self._frames > 0
        try:
            if kind is None or interrupted:
                self._container.mux(self._stream.encode())
                self._container.close()
            if interrupted:
                self._temporary.replace(self._part)
                raise VideoInterruptedError(self._part, self._frames) from error
            if kind is None:
                self._rename()
        except OSError as failure:
            raise cannot_write(self._path, failure) from failure
        finally:
            self._discard()

    def _rename(self) -> None:
        """Give the complete file its name; if another program (a player on Windows) holds that, keep it beside it."""
        try:
            when_free(lambda: self._temporary.replace(self._path))
        except OSError as error:
            self._temporary.replace(self._part)
            raise VideoError(
                "cannot-write",
                f"{self._path}: {error_hint(error)}",
                f"close the program that shows it; the complete video is kept in {self._part}",
            ) from error

    def _discard(self) -> None:
        if self._container is not None:
            with suppress(OSError, ValueError):  # it is removed anyway
                self._container.close()
        with suppress(OSError):  # a virus scanner may have it open
            self._temporary.unlink()
