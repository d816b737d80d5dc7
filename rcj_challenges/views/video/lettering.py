"""Text in any script, with the fonts that this computer has.

Pillow brings one font, for ASCII. Whatever else is needed is looked for among the system's fonts; what no font has is
written with plain letters (``é`` as ``e``) where that is possible, and as a hollow box where it is not. No font is
shipped: those for Chinese alone would be larger than all of this package.
"""

from __future__ import annotations

import math
import os
import sys
import unicodedata
from collections.abc import Iterator, Sequence
from functools import lru_cache
from io import BytesIO
from pathlib import Path

from PIL import Image, ImageDraw, ImageFont, features

from rcj_challenges.views.sentences import plain
from rcj_challenges.views.video.errors import VideoError
from rcj_challenges.views.video.fontfile import characters_of

_PREFERRED = (
    "notosans-regular", "segoeui", "sfns", "helveticaneue", "helvetica", "dejavusans", "liberationsans-regular",
    "arial", "notosanscjk-regular", "msyh", "pingfang", "hiragino sans gb", "yugothm", "malgun", "applesdgothicneo",
    "notosansarabic-regular", "notosanshebrew-regular", "notosansdevanagari-regular", "notosansthai-regular",
    "arial unicode", "arialuni",
)  # fmt: skip
"""Calm, upright, wide-spread fonts by file name, without its ending; the first that is there is the main one."""

_SUFFIXES = {".ttf", ".otf", ".ttc", ".otc"}
_PLAIN = str.maketrans(
    {"ß": "ss", "ø": "o", "Ø": "O", "ł": "l", "Ł": "L", "đ": "d", "Đ": "D", "æ": "ae", "Æ": "AE", "œ": "oe",
     "Œ": "OE", "þ": "th", "ð": "d", "\N{LATIN SMALL LETTER DOTLESS I}": "i", "\N{EN DASH}": "-", "\N{EM DASH}": "-",
     "\N{LEFT SINGLE QUOTATION MARK}": "'", "\N{RIGHT SINGLE QUOTATION MARK}": "'",
     "\N{LEFT DOUBLE QUOTATION MARK}": '"', "\N{RIGHT DOUBLE QUOTATION MARK}": '"',
     "\N{HORIZONTAL ELLIPSIS}": "...", "\N{MULTIPLICATION SIGN}": "x", "\N{MIDDLE DOT}": "-"}
)  # fmt: skip
"""What compatibility decomposition leaves as it is, in ASCII."""

_RIGHT_TO_LEFT = {"R", "AL"}
_ALONG = {"WS", "ON", "CS", "ES", "ET", "EN", "AN", "NSM", "BN", "B", "S"}
"""Bidirectional classes of what belongs to no script: it stays in the font of what stands before it."""


class Face:
    """One font.

    Attributes:
        source: its file, or its bytes.
        characters: the code points that it has.
    """

    def __init__(self, source: Path | bytes, characters: frozenset[int]) -> None:
        self.source = source
        self.characters = characters
        self._sizes: dict[int, ImageFont.FreeTypeFont] = {}

    def at(self, size: int) -> ImageFont.FreeTypeFont:
        """Return it in a size, in pixels."""
        if size not in self._sizes:
            source = BytesIO(self.source) if isinstance(self.source, bytes) else self.source
            self._sizes[size] = ImageFont.truetype(source, size)
        return self._sizes[size]


class Lettering:
    """Writes text; remembers what it could not write.

    Attributes:
        boxes: characters that were drawn as boxes, because no font has them.
    """

    def __init__(self, folders: Sequence[Path] | None = None) -> None:
        """Look which fonts there are.

        Args:
            folders: where fonts lie; None: where this system keeps them.

        Raises:
            VideoError: this Pillow can draw no outlines.
        """
        bundled = ImageFont.load_default(20)
        if not isinstance(bundled, ImageFont.FreeTypeFont) or not isinstance(bundled.path, BytesIO):
            raise VideoError('this Pillow was built without FreeType: pip install "rcj-challenges[video]" anew')
        data = bundled.path.getvalue()
        self.boxes: dict[str, None] = {}
        self._bundled = Face(data, characters_of(BytesIO(data)))
        self._files = iter(_font_files(system_folders() if folders is None else folders))
        self._faces: list[Face] = []
        self._known: dict[str, Face | None] = {}
        self._bolds: dict[Face, Face] = {}
        self._masks = lru_cache(maxsize=256)(self._mask)
        # Without it Pillow neither joins Arabic letters nor writes from the right.
        self._shapes = bool(features.check("raqm"))

    def mask(self, text: str, size: int, *, bold: bool = False) -> Image.Image:
        """Return a line of text as an ``L`` image: as wide as the text, `line_height` tall. Not to be changed."""
        return self._masks(text, size, bold)

    def width(self, text: str, size: int, *, bold: bool = False) -> int:
        """Return how wide a line of text is, in pixels."""
        return self.mask(text, size, bold=bold).width

    def fitted(self, text: object, size: int, widest: int, *, bold: bool = False) -> str:
        """Return text that is safe to show and at most so wide; what is cut off is told by three dots."""
        shown = plain(text, 200)
        if self.width(shown, size, bold=bold) <= widest:
            return shown
        low, high = 0, len(shown)
        while low < high:
            middle = (low + high + 1) // 2
            if self.width(shown[:middle].rstrip() + "...", size, bold=bold) <= widest:
                low = middle
            else:
                high = middle - 1
        return shown[:low].rstrip() + "..." if low else ""

    def _mask(self, text: str, size: int, bold: bool) -> Image.Image:
        runs = list(self._runs(text))
        if runs and _goes_left(text):
            runs.reverse()
        pieces = [(self._weighted(face, piece, bold=bold).at(size), self._ordered(piece)) for face, piece in runs]
        widths = [font.getlength(piece) for font, piece in pieces]
        image = Image.new("L", (max(1, math.ceil(sum(widths))), line_height(size)))
        pen = ImageDraw.Draw(image)
        x = 0.0
        for (font, piece), width in zip(pieces, widths, strict=True):
            pen.text((x, size), piece, fill=255, font=font, anchor="ls")
            x += width
        return image

    def _weighted(self, face: Face, piece: str, *, bold: bool) -> Face:
        """Return the bold brother of a face if it lies beside it and has the same letters."""
        if not bold or isinstance(face.source, bytes):
            return face
        if face not in self._bolds:
            self._bolds[face] = next(
                (found for found in map(_opened, _bold_files(face.source)) if found.characters), face
            )
        brother = self._bolds[face]
        return brother if all(ord(character) in brother.characters for character in piece) else face

    def _ordered(self, piece: str) -> str:
        if self._shapes or not _goes_left(piece):
            return piece
        return piece[::-1]

    def _runs(self, text: str) -> Iterator[tuple[Face, str]]:
        """Yield the pieces of a text that are written in one font each."""
        face, piece = self._main(), ""
        for character in text:
            along = unicodedata.bidirectional(character) in _ALONG
            if along and piece and ord(character) in face.characters:
                piece += character
                continue
            wanted, written = self._written(character)
            if wanted is not face and piece:
                yield face, piece
                piece = ""
            face, piece = wanted, piece + written
        if piece:
            yield face, piece

    def _written(self, character: str) -> tuple[Face, str]:
        """Return the font for a character and what is written in its place."""
        face = self._face_for(character)
        if face is not None:
            return face, character
        decomposed = unicodedata.normalize("NFKD", character.translate(_PLAIN))
        letters = "".join(letter for letter in decomposed if not unicodedata.combining(letter))
        main = self._main()
        if all(ord(letter) in main.characters for letter in letters):
            return main, letters
        self.boxes[character] = None
        return main, character

    def _main(self) -> Face:
        return self._face_for("n") or self._bundled

    def _face_for(self, character: str) -> Face | None:
        if character not in self._known:
            self._known[character] = self._search(ord(character))
        return self._known[character]

    def _search(self, code: int) -> Face | None:
        for face in self._faces:
            if code in face.characters:
                return face
        for path in self._files:
            face = _opened(path)
            if face.characters:
                self._faces.append(face)
            if code in face.characters:
                return face
        return self._bundled if code in self._bundled.characters else None


def line_height(size: int) -> int:
    """Return how tall a line of text of that size is: what stands below the line included."""
    return round(size * 1.4)


def system_folders() -> list[Path]:
    """Return where this system keeps its fonts."""
    home = Path.home()
    if sys.platform == "win32":
        local = os.environ.get("LOCALAPPDATA", str(home / "AppData" / "Local"))
        return [
            Path(os.environ.get("WINDIR", r"C:\Windows")) / "Fonts",
            Path(local) / "Microsoft" / "Windows" / "Fonts",
        ]
    if sys.platform == "darwin":
        return [Path("/System/Library/Fonts"), Path("/Library/Fonts"), home / "Library" / "Fonts"]
    return [
        Path("/usr/share/fonts"),
        Path("/usr/local/share/fonts"),
        home / ".local" / "share" / "fonts",
        home / ".fonts",
    ]


def _font_files(folders: Sequence[Path]) -> list[Path]:
    """Return all font files, those to be preferred first; the order is the same on every call."""
    found = {path for folder in folders if folder.is_dir() for path in folder.rglob("*")}
    return sorted((path for path in found if path.suffix.lower() in _SUFFIXES), key=_rank)


def _bold_files(path: Path) -> list[Path]:
    """Return where the bold brother of a font may lie: the habits of Noto and DejaVu, Liberation, and Windows."""
    stem, end = path.stem, path.suffix
    names = [stem.replace("-Regular", "-Bold"), f"{stem}-Bold", f"{stem}b", f"{stem}bd"]
    found = (path.with_name(name + end) for name in names if name != stem)
    return [candidate for candidate in found if candidate.is_file()]


def _rank(path: Path) -> tuple[int, str]:
    stem = path.stem.lower()
    if stem in _PREFERRED:
        return (_PREFERRED.index(stem), stem)
    special = any(word in stem for word in ("bold", "italic", "oblique", "mono", "light", "thin", "black", "condensed"))
    place = len(_PREFERRED) + (2 if special else 0 if "sans" in stem else 1)
    return (place, path.as_posix())


def _opened(path: Path) -> Face:
    try:
        with path.open("rb") as file:
            characters = characters_of(file)
        if characters:
            ImageFont.truetype(path, 10)  # what FreeType refuses is no font for us
    except (OSError, ValueError):
        characters = frozenset()
    return Face(path, characters)


def _goes_left(text: str) -> bool:
    """Return whether the first letter of a text belongs to a script that is written from the right."""
    for character in text:
        kind = unicodedata.bidirectional(character)
        if kind == "L" or kind in _RIGHT_TO_LEFT:
            return kind != "L"
    return False
