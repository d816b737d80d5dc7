"""Commands for authors: ``draw`` and ``sheet``. They look at the scenario alone; no physics, no programs."""

from __future__ import annotations

import sys
from pathlib import Path

from rcj_challenges.cli.output_paths import refuse_devices
from rcj_challenges.cli.stdio import shell_quoted
from rcj_challenges.facts.errors import RcjError, format_error, room_help

_HTML = (".html", ".htm")


class OutputError(RcjError):
    """A file that cannot be written."""

    CODE = "cannot-write"


def draw(scenario: str, out: Path | None, overrides: list[str]) -> int:
    """Write the drawing of a scenario: PNG if the file is called ``.png``, SVG if ``.svg``; returns the exit code.

    Raises:
        RcjError: wrong input; also a file that is called otherwise, or that cannot be written.
    """
    from rcj_challenges.scenario.load import load
    from rcj_challenges.views.drawing import draw_scenario

    _check_ending(out, (".svg", ".png"), "its name must end in .svg or .png")
    loaded = load(scenario, overrides)
    picture = draw_scenario(loaded.scenario, loaded.roster)
    if out is not None and out.suffix.lower() == ".png":
        from rcj_challenges.views.drawing.png import png_from_svg, written_with

        done = _deliver(png_from_svg(picture), out)
        if written_with() is None:
            sys.stderr.write(
                f"{out.name} has no words, for no font for them was found on this computer: take --out "
                f"{out.stem}.svg, or install a font, such as DejaVu Sans or Noto Sans\n"
            )
        return done
    return _deliver(picture, out)


def sheet(scenario: str, out: Path | None, overrides: list[str]) -> int:
    """Write the rule sheet of a scenario: HTML if the file is called ``.html``, Markdown if ``.md``.

    HTML has the drawing in it. Beside Markdown it is a file of its own: sites that show Markdown show no inline SVG.

    Raises:
        RcjError: wrong input; also a file that is called otherwise, or that cannot be written.
    """
    from rcj_challenges.scenario.load import load
    from rcj_challenges.views.sheet import sheet_html, sheet_markdown

    _check_ending(out, (".md", *_HTML), "its name must end in .md or .html")
    loaded = load(scenario, overrides)
    if out is None:
        # Who reads it in a terminal does not read a drawing's source; a file or another program gets all of it.
        command = f"rcj-challenge draw {shell_quoted(scenario)} --out field.svg"
        picture = f"The drawing: `{command}`" if sys.stdout.isatty() else None
        return _deliver(sheet_markdown(loaded.scenario, loaded.roster, picture), None)
    if out.suffix.lower() in _HTML:
        return _deliver(sheet_html(loaded.scenario, loaded.roster), out)
    from urllib.parse import quote

    from rcj_challenges.views.drawing import draw_scenario

    drawing = out.with_suffix(".svg")
    _deliver(draw_scenario(loaded.scenario, loaded.roster), drawing)
    return _deliver(sheet_markdown(loaded.scenario, loaded.roster, f"![The field]({quote(drawing.name)})"), out)


def _to_stdout(document: str) -> None:
    """Write a document as other files of it are, in UTF-8; a terminal gets the letters that it has."""
    if sys.stdout.isatty():
        sys.stdout.write(document)
    else:
        sys.stdout.flush()
        sys.stdout.buffer.write(document.encode("utf-8"))


def _check_ending(out: Path | None, endings: tuple[str, ...], told: str) -> None:
    """Refuse a file whose name would promise something else than what is written, or is none everywhere.

    Raises:
        OutputError: it has none of these endings.
        OutputNameError: it is the name of a device.
    """
    refuse_devices(out=out)
    if out is not None and out.suffix.lower() not in endings:
        raise OutputError(f"--out {out}: {told}", code="bad-out")


def _deliver(content: str | bytes, out: Path | None) -> int:
    if out is None:
        _to_stdout(str(content))  # pictures of bytes always have a file
        return 0
    try:
        # Bytes, so that no system changes the ends of lines.
        out.write_bytes(content.encode("utf-8") if isinstance(content, str) else content)
    except OSError as error:
        raise OutputError(f"{out}: cannot be written: {format_error(error)}", room_help(error)) from error
    sys.stdout.write(f"{out}\n")
    return 0
