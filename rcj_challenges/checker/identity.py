"""A team's name and logo."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import PurePosixPath

from rcj_challenges.checker import codes
from rcj_challenges.checker.images import Picture, identify
from rcj_challenges.core.diagnostics import Diagnostic
from rcj_challenges.records.logos import MAX_LOGO_BYTES, MAX_LOGO_SIDE, LogoError, checked_png
from rcj_challenges.submissions.problems import safe_text
from rcj_challenges.submissions.team import LOGO_FILE, Opening, may_be_logo

_AS_PNG = "save it as a PNG"


@dataclass(frozen=True)
class Logo:
    """A team's logo.

    Attributes:
        path: the logo, or the file that is probably the logo; None without one.
        shown: the picture as it may be shown; None if there is none that may be.
        findings: what is odd about it.
    """

    path: PurePosixPath | None
    shown: bytes | None
    findings: tuple[Diagnostic, ...]


def name_findings(opening: Opening) -> list[Diagnostic]:
    """Return the team's name with findings on it."""
    found = list(opening.name.problems)
    if opening.name.given:
        found.append(Diagnostic(codes.IDENTITY_NAME, f"the team is called {opening.name.text}"))
    return found


def find_logo(files: Mapping[PurePosixPath, bytes]) -> Logo:
    """Find the logo among a team's files and look at it."""
    path = _logo_file(files)
    if path is None:
        return Logo(None, None, (Diagnostic(codes.IDENTITY_LOGO_MISSING, f"there is no {LOGO_FILE}: none is needed"),))
    findings = []
    taken = path.name.casefold() == LOGO_FILE
    if path != PurePosixPath(LOGO_FILE):
        message = f"the logo is {safe_text(path)}" + ("" if taken else ", which is not shown")
        help_ = f"call it {LOGO_FILE} and put it beside the programs' folders"
        findings.append(Diagnostic(codes.IDENTITY_LOGO_FILE, message, help_, safe_text(path)))
    data = files[path]
    shown = None
    try:
        picture = checked_png(data)  # whatever it is called: a JPEG is none as logo.png either
        shown = picture if taken else None
    except LogoError as error:
        findings.append(_refused(path, identify(data), data, str(error)))
    else:
        findings += _accepted(path, identify(data))
    return Logo(path, shown, tuple(findings))


def _logo_file(files: Mapping[PurePosixPath, bytes]) -> PurePosixPath | None:
    exact = [path for path in files if path.name.casefold() == LOGO_FILE]
    near = [path for path in files if len(path.parts) == 1 and may_be_logo(path)]
    ranked = sorted(exact, key=lambda path: (len(path.parts), path.name != LOGO_FILE)) + sorted(near)
    return next(iter(ranked), None)


def _refused(path: PurePosixPath, picture: Picture | None, data: bytes, reason: str) -> Diagnostic:
    """Return why a logo is not shown."""
    name = safe_text(path)
    if picture is None:
        return Diagnostic(codes.IDENTITY_LOGO_NO_PICTURE, f"{name} is no picture: {reason}", _AS_PNG, name)
    if picture.kind != "PNG":
        message = f"{name} is a {picture.kind}, not a PNG, and is not shown"
        return Diagnostic(codes.IDENTITY_LOGO_TYPE, message, _AS_PNG, name)
    if max(picture.width, picture.height) > MAX_LOGO_SIDE:
        message = f"{name} has {picture.width} x {picture.height} pixels and is not shown"
        help_ = f"make it at most {MAX_LOGO_SIDE} pixels wide and high"
        return Diagnostic(codes.IDENTITY_LOGO_SIZE, message, help_, name)
    if len(data) > MAX_LOGO_BYTES:
        message = f"{name} has {len(data) / 1e6:.1f} MB and is not shown"
        help_ = f"make it at most {MAX_LOGO_BYTES / 1e6:.0f} MB"
        return Diagnostic(codes.IDENTITY_LOGO_BYTES, message, help_, name)
    return Diagnostic(codes.IDENTITY_LOGO_DAMAGED, f"{name} is not shown: {reason}", _AS_PNG, name)


def _accepted(path: PurePosixPath, picture: Picture | None) -> list[Diagnostic]:
    if picture is None or path.name.casefold() != LOGO_FILE:
        return []
    if picture.animated:
        message = f"{safe_text(path)} moves: only its first picture is shown"
        return [Diagnostic(codes.IDENTITY_LOGO_ANIMATED, message, _AS_PNG, safe_text(path))]
    message = f"the logo has {picture.width} x {picture.height} pixels"
    return [Diagnostic(codes.IDENTITY_LOGO, message, where=safe_text(path))]
