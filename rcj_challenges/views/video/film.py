"""Writing an MP4: frames are compressed in a thread of their own, and a file is whole or not there."""

from __future__ import annotations

import os
from contextlib import suppress
from fractions import Fraction
from pathlib import Path
from queue import Queue
from threading import Thread
from types import TracebackType
from typing import Any, Self

import av
import numpy as np
from PIL import Image

from rcj_challenges.facts.errors import advised, is_held
from rcj_challenges.records.folder import when_free
from rcj_challenges.views.video.errors import FilmInterruptedError, VideoError

_WAITING_FRAMES = 4
"""Frames of 1280 by 720 have 2.7 MB: few wait, and drawing goes on while one is compressed."""
_CODECS = {
    # CRF 20 looks like the original; "veryfast" costs a third of the default's time for 10 % more bytes.
    "libx264": {"preset": "veryfast", "crf": "20"},
    # What other builds of FFmpeg than the wheel's may have instead.
    "libopenh264": {"b": "4M"},
    "mpeg4": {"q:v": "4"},
}


class Film:
    """An MP4 that grows frame by frame.

    It is written beside its final place under a name that ends in ``.tmp``. Only a finished film gets its name. One
    that is interrupted (Ctrl-C) is closed properly and kept as ``NAME.part.mp4``: what was made can be watched. After
    any other error nothing is left.

    Attributes:
        path: where it will be.
        part: where an interrupted one is kept.
        codec: the name of the encoder.
    """

    def __init__(self, path: Path, size: tuple[int, int], fps: Fraction, title: str) -> None:
        self.path = path
        self.part = path.with_name(f"{path.stem}.part.mp4")
        self.codec = next(name for name in _CODECS if name in av.codec.codecs_available)
        self._temporary = path.with_name(f"{path.name}.{os.getpid()}.tmp")
        self._size, self._fps, self._title = size, fps, title
        self._queue: Queue[av.VideoFrame | None] = Queue(_WAITING_FRAMES)
        self._error: BaseException | None = None
        self._added = self._written = 0
        self._container: Any = None
        self._stream: Any = None
        self._thread = Thread(target=self._compress, name="film", daemon=True)

    def __enter__(self) -> Self:
        """Open the file.

        Raises:
            VideoError: it cannot be written.
        """
        try:
            # The index at the front: players on the web begin before they have all of it.
            self._container = av.open(str(self._temporary), "w", format="mp4", options={"movflags": "+faststart"})
            self._container.metadata["title"] = self._title
            self._stream = self._container.add_stream(self.codec, rate=self._fps)
            self._stream.width, self._stream.height = self._size
            self._stream.pix_fmt = "yuv420p"
            self._stream.options = _CODECS[self.codec]
        except OSError as error:
            self._discard()
            raise VideoError(f"{self.path}: cannot be written: {advised(error)}") from error
        self._thread.start()
        return self

    def add(self, frame: Image.Image) -> None:
        """Add a frame, RGB. It is copied.

        Raises:
            VideoError: the file cannot be written.
        """
        self._raise_error()
        picture = av.VideoFrame.from_ndarray(np.asarray(frame), format="rgb24")
        picture.pts, picture.time_base = self._added, 1 / self._fps
        self._added += 1
        self._queue.put(picture)

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        """Finish the film, or keep what there is, or remove it.

        Raises:
            FilmInterruptedError: in place of the KeyboardInterrupt, if frames were kept.
            VideoError: the file cannot be written.
        """
        try:
            self._queue.put(None)
            self._thread.join()
            if kind is None:
                self._raise_error()
            self._container.close()
            if kind is None:
                self._take_place()
            elif issubclass(kind, KeyboardInterrupt) and self._error is None and self._written:
                self._temporary.replace(self.part)
                raise FilmInterruptedError(self.part, self._written) from error
        except OSError as failure:
            raise VideoError(f"{self.path}: cannot be written: {advised(failure)}") from failure
        finally:
            self._discard()

    def _take_place(self) -> None:
        """Give the finished film its name. Whatever forbids that, such as a player that shows an old one: it stays.

        Raises:
            VideoError: it is kept beside it.
        """
        try:
            when_free(lambda: self._temporary.replace(self.path))
        except OSError as failure:
            self._temporary.replace(self.part)
            told = f"{self.path}: cannot be written: {advised(failure)}"
            told += "; close the program that may show it" if is_held(failure) else ""
            raise VideoError(f"{told}. The whole video is kept in {self.part}") from failure

    def _compress(self) -> None:
        """Take frames until there are no more; after an error they are only taken."""
        while (frame := self._queue.get()) is not None:
            if self._error is None:
                try:
                    self._encode(frame)
                except BaseException as error:  # noqa: BLE001 - it is raised again where frames are added
                    self._error = error
        if self._error is None:
            try:
                for packet in self._stream.encode():
                    self._container.mux(packet)
            except BaseException as error:  # noqa: BLE001
                self._error = error

    def _encode(self, picture: av.VideoFrame) -> None:
        for packet in self._stream.encode(picture):
            self._container.mux(packet)
        self._written += 1

    def _raise_error(self) -> None:
        error = self._error
        if isinstance(error, OSError):
            raise VideoError(f"{self.path}: cannot be written: {advised(error)}") from error
        if error is not None:
            raise error

    def _discard(self) -> None:
        if self._container is not None:
            with suppress(OSError, ValueError):  # what is thrown away need not be whole
                self._container.close()
        with suppress(OSError):  # a virus scanner may have it open
            self._temporary.unlink()
