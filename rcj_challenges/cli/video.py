"""``rcj-challenge video``: a recorded run as an MP4."""

from __future__ import annotations

import sys
import time
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from rcj_challenges.cli.app import WATCH, app
from rcj_challenges.cli.codes import BAD_FPS, BAD_OUT, BAD_SPEED
from rcj_challenges.cli.options import Quiet, Run
from rcj_challenges.cli.stdio import print_lines
from rcj_challenges.core.errors import RcjError

if TYPE_CHECKING:
    from rcj_challenges.views.video.footage import Footage

MIN_SPEED, MAX_SPEED = 0.05, 100.0
MAX_FPS = 240

Half = Annotated[
    int | None, typer.Option("--half", metavar="N", help="Only this half; times count from its beginning.")
]
Size = Annotated[str, typer.Option("--size", metavar="WxH", help="Pixels: 1280x720, or 480p, 720p, 1080p, 2160p.")]
Camera = Annotated[
    str, typer.Option("--camera", metavar="NAME", help="field, top, side, follow-ball or behind:ROBOT, as behind:Y1.")
]
Records = Annotated[Path, typer.Option("--runs", metavar="DIR", help="Where the records are.")]


@app.register(WATCH, "rcj-challenge video --highlights")
def video(
    run: Run = None,
    out: Annotated[
        Path | None, typer.Option("--out", "-o", metavar="FILE", help=".mp4; default: video.mp4 in the record.")
    ] = None,
    from_: Annotated[
        str | None, typer.Option("--from", metavar="TIME", help="Where it begins: 113.9 or 1:53.9.")
    ] = None,
    to: Annotated[str | None, typer.Option("--to", metavar="TIME", help="Where it ends.")] = None,
    half: Half = None,
    size: Size = "1280x720",
    fps: Annotated[float, typer.Option("--fps", metavar="N", help="Pictures per second of video.")] = 30.0,
    camera: Camera = "field",
    speed: Annotated[
        float, typer.Option("--speed", metavar="X", help="4: four times as fast; 0.25: slow motion.")
    ] = 1.0,
    highlights: Annotated[
        bool, typer.Option("--highlights", help="Only the 6 s before each change of the score, and 1 s after.")
    ] = False,
    runs: Records = Path("runs"),
    quiet: Quiet = False,
) -> None:
    """Make an MP4 of a record, with scoreboard and captions."""
    from fractions import Fraction

    from rcj_challenges.cli.output_paths import refuse_devices
    from rcj_challenges.views.video.requirements import require_packages

    refuse_devices(out=out)
    require_packages("av", "PIL")
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TimeRemainingColumn

    from rcj_challenges.views.console import console_for
    from rcj_challenges.views.video import clips, make

    size_px = make.parse_size(size, even=True)
    if not 1 <= fps <= MAX_FPS:
        raise RcjError(f"--fps {fps:g}: a second of video has 1 to {MAX_FPS} pictures", code=BAD_FPS)
    rate = Fraction(str(fps)).limit_denominator(1001)
    if not MIN_SPEED <= speed <= MAX_SPEED:
        raise RcjError(f"--speed {speed:g}: it must be {MIN_SPEED:g} (slow motion) to {MAX_SPEED:g}", code=BAD_SPEED)
    start_s, stop_s = (None if text is None else clips.parse_seconds(text) for text in (from_, to))
    folder, footage = open_footage(run, runs)
    parts = clips.clips_between(footage, start_s, stop_s, half)
    if highlights:
        parts = clips.highlights(footage, parts)
    shown = clips.moments(footage, parts, float(rate), speed)
    path = output_file(out, folder / ("highlights.mp4" if highlights else "video.mp4"))
    console = console_for(to_stderr=True)
    with make.opened_renderer(footage, size_px, camera) as draw:
        if not quiet:
            print_lines(console, *footage.warnings)
        begin = time.perf_counter()
        with Progress(
            "video", BarColumn(), MofNCompleteColumn(), TimeRemainingColumn(), "left",
            console=console, transient=True, disable=quiet or not console.is_terminal,
        ) as bars:  # fmt: skip
            task = bars.add_task("", total=len(shown))
            make.write_video(
                draw, footage, shown, path, size=size_px, fps=rate,
                progress=lambda done: bars.update(task, completed=done),
            )  # fmt: skip
        took_s = time.perf_counter() - begin
    if not quiet:
        speed_note = f"{len(shown) / took_s:.0f} a second"
        print_lines(console, f"{len(shown) / float(rate):.1f} s of video, {len(shown)} pictures, {speed_note}")
    sys.stdout.write(f"{path}\n")


def open_footage(run: Path | None, runs: Path) -> tuple[Path, Footage]:
    """The folder of a record, and what is in it to be drawn.

    Raises:
        RcjError: there is no such record, or it cannot be drawn.
    """
    from rcj_challenges.views.replay.browse import find_run
    from rcj_challenges.views.video.footage import Footage

    folder = find_run(run, runs)
    return folder, Footage.open(folder)


def output_file(wanted: Path | None, default: Path) -> Path:
    """Where the file goes: as wanted, else to the default.

    Raises:
        RcjError: it is a folder, its folder is missing, or its name has another ending.
    """
    out = wanted or default
    if out.is_dir():
        raise RcjError(f"--out {out} is a folder", f"give a file, such as {out / default.name}", code=BAD_OUT)
    if out.suffix.lower() != default.suffix:
        raise RcjError(f"--out {out}: the name must end in {default.suffix}", f"--out {default.name}", code=BAD_OUT)
    if not out.parent.is_dir():
        raise RcjError(f"--out {out}: there is no folder {out.parent}", "make it first, or leave it out", code=BAD_OUT)
    return out
