"""The camera."""

from __future__ import annotations

import struct
import zlib

from ._connection import RECOGNITION, Connection, complain, number
from .device import LONGEST_MS, ReadOnly, Sensor

TYPE_CHECKING = False
if TYPE_CHECKING:
    from typing import Any

__all__ = ["Camera", "CameraRecognitionObject"]

_ALL = bytes(range(256))
_SEEN = struct.Struct("<2H3B6d4H")
_MODELS = ("robot", "ball", "obstacle")


class CameraRecognitionObject:
    """A thing that a camera recognizes. Numbers are in the camera's frame: x forward, y to the left, z up."""

    def __init__(self, data: tuple[Any, ...]) -> None:
        self._id, model, *colour, x, y, z, yaw, width, height, left, top, columns, rows = data
        self._model, self._colours = _MODELS[model], [part / 255 for part in colour]
        self._position, self._orientation, self._size = [x, y, z], [0.0, 0.0, 1.0, yaw], [width, height]
        self._position_on_image, self._size_on_image = [left + columns // 2, top + rows // 2], [columns, rows]

    def getId(self) -> int:
        """Return its number, the same all through a half."""
        return int(self._id)

    def getPosition(self) -> list[float]:
        """Return where its middle is, in m from the camera."""
        return self._position

    def getOrientation(self) -> list[float]:
        """Return how it is turned: an axis, which points up, and the angle in rad."""
        return self._orientation

    def getSize(self) -> list[float]:
        """Return its width and its height in m."""
        return self._size

    def getPositionOnImage(self) -> list[int]:
        """Return column and row of the middle of what is visible of it."""
        return self._position_on_image

    def getSizeOnImage(self) -> list[int]:
        """Return width and height of what is visible of it, in pixels."""
        return self._size_on_image

    def getNumberOfColors(self) -> int:
        """Return 1."""
        return 1

    def getColors(self) -> list[float]:
        """Return red, green and blue from 0 to 1."""
        return self._colours

    def getModel(self) -> str:
        """Return what it is: ``robot``, ``ball`` or ``obstacle``."""
        return self._model

    def __repr__(self) -> str:
        return f"<{self.model} {self.id} at {self.position}>"

    id = ReadOnly(getId)
    position = ReadOnly(getPosition)
    orientation = ReadOnly(getOrientation)
    size = ReadOnly(getSize)
    position_on_image = ReadOnly(getPositionOnImage)
    size_on_image = ReadOnly(getSizeOnImage)
    number_of_colors = ReadOnly(getNumberOfColors)
    colors = ReadOnly(getColors)
    model = ReadOnly(getModel)


class Camera(Sensor):
    """Pictures of what is ahead: bytes in the order blue, green, red, alpha, row by row from the top left."""

    def _rcj_set_up(self, connection: Connection, spec: dict[str, Any]) -> None:
        super()._rcj_set_up(connection, spec)
        self._rcj_pictures = connection.queues[self._rcj_index]
        self._rcj_width, self._rcj_height = int(self._rcj_facts["width"]), int(self._rcj_facts["height"])
        self._rcj_packet: Any = None
        self._rcj_image = b""
        self._rcj_exposure = 1.0
        self._rcj_recognition_ms = 0

    def _rcj_stop(self) -> None:
        super()._rcj_stop()
        self._rcj_pictures.clear()

    def getImage(self) -> Any:
        """Return the latest picture as bytes, 4 a pixel: blue, green, red, 255; None before the first one.

        Example:
            ``red = camera.imageGetRed(camera.getImage(), camera.getWidth(), x, y)``
        """
        if not self._rcj_period_ms and not self._rcj_warned:
            self._rcj_warn()
        packets = self._rcj_pictures
        if not packets:
            return None
        packet = packets[-1]
        if packet is not self._rcj_packet:
            self._rcj_packet = packet
            data = packet[0]
            colours = data[0]
            numbers = data[1 + 3 * colours :]
            image = bytearray(b"\xff") * (4 * len(numbers))
            for part in range(3):
                table = data[3 - part : 1 + 3 * colours : 3] + _ALL[colours:]
                image[part::4] = numbers.translate(table)
            self._rcj_image = bytes(image)
        return self._rcj_image

    def getImageArray(self) -> Any:
        """Return the latest picture as lists: ``[x][y]`` is ``[red, green, blue]``; None before the first one."""
        image, width = self.getImage(), self._rcj_width
        if image is None:
            return None
        pixels = [[image[at + 2], image[at + 1], image[at]] for at in range(0, len(image), 4)]
        return [pixels[x::width] for x in range(width)]

    @staticmethod
    def imageGetRed(image: Any, width: int, x: int, y: int) -> int:
        """Return the red of a pixel, 0 to 255; x grows to the right, y downwards."""
        return int(image[4 * (y * width + x) + 2])

    @staticmethod
    def imageGetGreen(image: Any, width: int, x: int, y: int) -> int:
        """Return the green of a pixel, 0 to 255."""
        return int(image[4 * (y * width + x) + 1])

    @staticmethod
    def imageGetBlue(image: Any, width: int, x: int, y: int) -> int:
        """Return the blue of a pixel, 0 to 255."""
        return int(image[4 * (y * width + x)])

    @staticmethod
    def imageGetGray(image: Any, width: int, x: int, y: int) -> int:
        """Return the mean of red, green and blue of a pixel."""
        at = 4 * (y * width + x)
        return int(image[at] + image[at + 1] + image[at + 2]) // 3

    imageGetGrey = imageGetGray  # noqa: N815 - its name in Webots

    def getWidth(self) -> int:
        """Return how many columns a picture has."""
        return self._rcj_width

    def getHeight(self) -> int:
        """Return how many rows a picture has."""
        return self._rcj_height

    def getFov(self) -> float:
        """Return the angle from the left to the right edge of a picture in rad."""
        return float(self._rcj_facts["fov"])

    def getMinFov(self) -> float:
        """Return the same as ``getFov``."""
        return self.getFov()

    getMaxFov = getMinFov  # noqa: N815 - its name in Webots

    def setFov(self, fov: float) -> None:
        """Do nothing but print a warning: this camera has no zoom."""
        complain(f"Warning: {self._rcj_name!r} has no zoom: its field of view stays {self.getFov():g} rad.")

    def getNear(self) -> float:
        """Return how near something may be to be seen, in m."""
        return float(self._rcj_facts["near"])

    def getExposure(self) -> float:
        """Return what ``setExposure`` has set, 1 at first."""
        return self._rcj_exposure

    def setExposure(self, exposure: float) -> None:
        """Remember an exposure; pictures stay as they are."""
        self._rcj_exposure = float(exposure)

    def getFocalLength(self) -> float:
        """Return 0: the camera has no focus."""
        return 0.0

    def getFocalDistance(self) -> float:
        """Return 0: the camera has no focus."""
        return 0.0

    getMinFocalDistance = getMaxFocalDistance = getFocalDistance  # noqa: N815 - their names in Webots

    def saveImage(self, filename: str, quality: int = 100) -> int:
        """Write the latest picture as a PNG file; return 0, or -1 if there is none or the file cannot be written."""
        image = self.getImage()
        if image is None:
            return -1
        rows, size = [], 4 * self._rcj_width
        for begin in range(0, len(image), size):
            row = bytearray(3 * self._rcj_width)
            for part in range(3):
                row[part::3] = image[begin + 2 - part : begin + size : 4]
            rows.append(b"\0" + bytes(row))
        head = struct.pack(">2I5B", self._rcj_width, self._rcj_height, 8, 2, 0, 0, 0)
        chunks = _chunk(b"IHDR", head) + _chunk(b"IDAT", zlib.compress(b"".join(rows))) + _chunk(b"IEND", b"")
        try:
            with open(filename, "wb") as file:  # noqa: PTH123 - pathlib costs every program
                file.write(b"\x89PNG\r\n\x1a\n" + chunks)
        except OSError:
            return -1
        return 0

    def hasRecognition(self) -> bool:
        """Return whether it can recognize robots, balls and obstacles by itself."""
        return bool(self._rcj_facts["recognition"])

    def recognitionEnable(self, samplingPeriod: float | None = None, *, sampling_period: float | None = None) -> None:
        """Recognize things every ``samplingPeriod`` ms, but not more often than it can take pictures.

        It needs no pictures: without ``enable`` it costs less computing time.

        Example:
            ``camera.recognitionEnable(32)`` once at the start.
        """
        given = samplingPeriod if sampling_period is None else sampling_period
        period_ms = number(given, f"{self._rcj_name!r}: recognitionEnable takes a number of ms, such as 32")
        if not self.hasRecognition():
            complain(f"Warning: {self._rcj_name!r} has no recognition: it takes pictures only.")
            return
        self._rcj_recognition_ms = max(1, int(min(period_ms, LONGEST_MS))) if period_ms > 0 else 0
        if not self._rcj_recognition_ms:
            self._rcj_found().clear()
        ticks = self._rcj_connection.ticks_from_ms(period_ms) if self._rcj_recognition_ms else 0
        self._rcj_connection.sample(self._rcj_index + RECOGNITION, ticks)

    def recognitionDisable(self) -> None:
        """Recognize nothing any more."""
        if self._rcj_recognition_ms:
            self.recognitionEnable(0)

    def getRecognitionSamplingPeriod(self) -> int:
        """Return the period in ms that was asked for; 0 if it recognizes nothing."""
        return self._rcj_recognition_ms

    def getRecognitionNumberOfObjects(self) -> int:
        """Return how many things it recognizes."""
        return len(self.getRecognitionObjects())

    def getRecognitionObjects(self) -> list[CameraRecognitionObject]:
        """Return what it recognizes, the nearest first. What is hidden is not listed.

        Example:
            ``balls = [thing for thing in camera.getRecognitionObjects() if thing.model == "ball"]``
        """
        if not self._rcj_recognition_ms:
            help_ = "call recognitionEnable(32) before the first step"
            complain(f"Warning: {self._rcj_name!r} recognizes nothing yet: {help_}.", help_)
            return []
        found = self._rcj_found()
        return [CameraRecognitionObject(one) for one in _SEEN.iter_unpack(found[-1][0])] if found else []

    def _rcj_found(self) -> Any:
        return self._rcj_connection.queues[self._rcj_index + RECOGNITION]

    def hasRecognitionSegmentation(self) -> bool:
        """Return False: there are no segmented pictures."""
        return False

    isRecognitionSegmentationEnabled = hasRecognitionSegmentation  # noqa: N815 - its name in Webots

    def enableRecognitionSegmentation(self) -> None:
        """Do nothing but print a warning: there are no segmented pictures."""
        complain(f"Warning: {self._rcj_name!r} has no segmented pictures.")

    def disableRecognitionSegmentation(self) -> None:
        """Do nothing."""

    def getRecognitionSegmentationImage(self) -> None:
        """Return None: there are no segmented pictures."""

    getRecognitionSegmentationImageArray = getRecognitionSegmentationImage  # noqa: N815 - its name in Webots

    image = ReadOnly(getImage)
    width = ReadOnly(getWidth)
    height = ReadOnly(getHeight)
    fov = ReadOnly(getFov)
    min_fov = ReadOnly(getFov)
    max_fov = ReadOnly(getFov)
    near = ReadOnly(getNear)
    exposure = property(getExposure, setExposure)
    focal_length = ReadOnly(getFocalLength)
    recognition_sampling_period = property(getRecognitionSamplingPeriod, recognitionEnable)


def _chunk(kind: bytes, data: bytes) -> bytes:
    """Return a chunk of a PNG file (ISO/IEC 15948)."""
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
