"""``rcj-challenge video`` and ``snapshot``: a recorded run as an MP4, a moment of it as a picture."""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

if TYPE_CHECKING:
    from rich.console import Console

    from rcj_challenges.views.video.footage import Footage

_SLOWEST, _FASTEST = 0.05, 100.0
_MOST_FPS = 240

_Run = Annotated[
    Path | None, typer.Argument(help="A record's folder or the beginning of its name; left out: the newest.")
]
_Half = Annotated[
    int | None, typer.Option("--half", metavar="N", help="Only this half; times count from its beginning.")
]
_Size = Annotated[str, typer.Option("--size", metavar="WxH", help="Pixels: 1280x720, or 480p, 720p, 1080p, 2160p.")]
_Camera = Annotated[
    str, typer.Option("--camera", metavar="NAME", help="field, top, side, follow-ball or behind:ROBOT, as behind:Y1.")
]
_Renderer = Annotated[
    str, typer.Option("--renderer", metavar="auto|top|3d", help="3-D by MuJoCo, or from above without a GPU library.")
]
_Runs = Annotated[Path, typer.Option("--runs", metavar="DIR", help="Where the records are.")]


@dataclass(frozen=True)
class VideoOptions:
    """What ``video`` was asked for, as it was written."""

    run: Path | None
    runs: Path
    out: Path | None
    from_: str | None
    to: str | None
    half: int | None
    size: str
    fps: float
    camera: str
    renderer: str
    speed: float
    highlights: bool
    quiet: bool


@dataclass(frozen=True)
class SnapshotOptions:
    """What ``snapshot`` was asked for, as it was written."""

    run: Path | None
    runs: Path
    out: Path | None
    at: str
    half: int | None
    size: str
    camera: str
    renderer: str


def register(app: typer.Typer) -> None:
    """Add both commands to the command line."""

    @app.command()
    def video(
        run: _Run = None,
        out: Annotated[
            Path | None, typer.Option("--out", "-o", metavar="FILE", help=".mp4; left out: video.mp4 in the record.")
        ] = None,
        from_: Annotated[
            str | None, typer.Option("--from", metavar="TIME", help="Where it begins: 113.9 or 1:53.9.")
        ] = None,
        to: Annotated[str | None, typer.Option("--to", metavar="TIME", help="Where it ends.")] = None,
        half: _Half = None,
        size: _Size = "1280x720",
        fps: Annotated[float, typer.Option("--fps", metavar="N", help="Pictures in a second of video.")] = 30.0,
        camera: _Camera = "field",
        renderer: _Renderer = "auto",
        speed: Annotated[
            float, typer.Option("--speed", metavar="X", help="4: four times as fast; 0.25: slow motion.")
        ] = 1.0,
        highlights: Annotated[
            bool, typer.Option("--highlights", help="Only the 6 s before each change of the score, and 1 s after.")
        ] = False,
        runs: _Runs = Path("runs"),
        quiet: Annotated[bool, typer.Option("--quiet", "-q", help="No progress bar, no notes.")] = False,
    ) -> None:
        """Make an MP4 of a record, with scoreboard and captions."""
        raise typer.Exit(
            make_video(
                VideoOptions(run, runs, out, from_, to, half, size, fps, camera, renderer, speed, highlights, quiet)
            )
        )

    @app.command()
    def snapshot(
        at: Annotated[str, typer.Option("--at", metavar="TIME", help="Which moment: 113.9 or 1:53.9.")],
        run: _Run = None,
        out: Annotated[
            Path | None, typer.Option("--out", "-o", metavar="FILE", help=".png; left out: into the record.")
        ] = None,
        half: _Half = None,
        size: _Size = "1280x720",
        camera: _Camera = "field",
        renderer: _Renderer = "auto",
        runs: _Runs = Path("runs"),
    ) -> None:
        """Make a picture of one moment of a record."""
        raise typer.Exit(make_snapshot(SnapshotOptions(run, runs, out, at, half, size, camera, renderer)))


def make_video(options: VideoOptions) -> int:
    """Make the MP4, print where it is; returns the exit code.

    Raises:
        RcjError: wrong input, a record that cannot be shown, or a missing extra.
    """
    from rcj_challenges.cli.outputs import refuse_devices
    from rcj_challenges.views.video.errors import FilmInterruptedError, need_extra

    refuse_devices(out=options.out)
    need_extra("av", "PIL")
    from rcj_challenges.views.scoreboard import console_for
    from rcj_challenges.views.video.make import Look, size_from, studio, write_video
    from rcj_challenges.views.video.timeline import frame_count, highlights, seconds_from, stretch

    size = size_from(options.size, even=True)
    fps = _fps(options.fps)
    _check_speed(options.speed)
    start, stop = (None if text is None else seconds_from(text) for text in (options.from_, options.to))
    console = console_for(to_stderr=True)
    folder, footage = _footage(options.run, options.runs)
    clips = stretch(footage, start, stop, options.half)
    if options.highlights:
        clips = highlights(footage, clips)
    out = _out(options.out, folder / ("highlights.mp4" if options.highlights else "video.mp4"))
    look = Look(size=size, camera=options.camera, renderer=options.renderer)
    with studio(footage, look) as made_in:
        _say(console, [*footage.warnings, *made_in.says], quiet=options.quiet)
        total = frame_count(clips, float(fps), options.speed)
        begin = time.perf_counter()
        try:
            with _progress(console, total, shown=not options.quiet) as progress:
                write_video(made_in, clips, out, size=size, fps=fps, speed=options.speed, progress=progress)
        except FilmInterruptedError as error:
            sys.stderr.write(f"interrupted: the first {error.frames / float(fps):.1f} s are kept in {error.kept}\n")
            return 130
        took_s = time.perf_counter() - begin
        _say(console, [made_in.unwritten()], quiet=options.quiet)
    _say(
        console,
        [f"{total / float(fps):.1f} s of video, {total} pictures, {total / took_s:.0f} a second"],
        quiet=options.quiet,
    )
    sys.stdout.write(f"{out}\n")
    return 0


def make_snapshot(options: SnapshotOptions) -> int:
    """Make the picture, print where it is; returns the exit code.

    Raises:
        RcjError: wrong input, a record that cannot be shown, or a missing extra.
    """
    from rcj_challenges.cli.outputs import refuse_devices
    from rcj_challenges.views.video.errors import need_extra

    refuse_devices(out=options.out)
    need_extra("PIL")
    from rcj_challenges.views.scoreboard import console_for
    from rcj_challenges.views.video.make import Look, size_from, studio, write_snapshot
    from rcj_challenges.views.video.timeline import moment_at, seconds_from

    size, at_s = size_from(options.size, even=False), seconds_from(options.at)
    folder, footage = _footage(options.run, options.runs)
    moment = moment_at(footage, at_s, options.half)
    name = f"snapshot-half{moment.half.info.half}-{moment.t_s:.3f}s.png"
    out = _out(options.out, folder / name)
    with studio(footage, Look(size, options.camera, options.renderer, shadows=True)) as made_in:
        write_snapshot(made_in, moment, out)
        _say(console_for(to_stderr=True), [*footage.warnings, *made_in.says, made_in.unwritten()])
    sys.stdout.write(f"{out}\n")
    return 0


def _footage(run: Path | None, runs: Path) -> tuple[Path, Footage]:
    from rcj_challenges.views.replay.browse import find_run
    from rcj_challenges.views.video.footage import Footage

    folder = find_run(run, runs)
    return folder, Footage.open(folder)


def _out(wanted: Path | None, default: Path) -> Path:
    """Return where the file goes.

    Raises:
        VideoError: it is a folder, lies in none, or its name says that it is something else.
    """
    from rcj_challenges.views.video.errors import VideoError

    out = wanted or default
    if out.is_dir():
        raise VideoError(f"--out {out} is a folder: give a file, such as {out / default.name}")
    if out.suffix.lower() != default.suffix:
        raise VideoError(f"--out {out}: only {default.suffix} can be written; its name must end in {default.suffix}")
    if not out.parent.is_dir():
        raise VideoError(f"--out {out}: there is no folder {out.parent}")
    return out


def _fps(fps: float) -> Fraction:
    from rcj_challenges.views.video.errors import VideoError

    if not 1 <= fps <= _MOST_FPS:
        raise VideoError(f"--fps {fps:g}: a second of video has 1 to {_MOST_FPS} pictures")
    return Fraction(str(fps)).limit_denominator(1001)


def _check_speed(speed: float) -> None:
    from rcj_challenges.views.video.errors import VideoError

    if not _SLOWEST <= speed <= _FASTEST:
        raise VideoError(f"--speed {speed:g}: it must be {_SLOWEST:g} (slow motion) to {_FASTEST:g}")


@contextmanager
def _progress(console: Console, total: int, *, shown: bool) -> Iterator[Callable[[int, int], None] | None]:
    """Show a bar with pictures a second and remaining time while the video is made; nothing where no terminal is."""
    if not shown or not console.is_terminal:
        yield None
        return
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeRemainingColumn

    columns = (
        TextColumn("video"),
        BarColumn(),
        MofNCompleteColumn(),
        TextColumn("{task.fields[rate]}"),
        TimeRemainingColumn(),
        TextColumn("left"),
    )
    with Progress(*columns, console=console, transient=True) as bars:
        task = bars.add_task("video", total=total, rate="")

        def show(done: int, _: int) -> None:
            speed = bars.tasks[0].speed
            bars.update(task, completed=done, rate=f"{speed:.0f} a second" if speed else "")

        yield show


def _say(console: Console, sentences: list[str], *, quiet: bool = False) -> None:
    for sentence in sentences:
        if sentence and not quiet:
            console.print(sentence, markup=False, highlight=False, soft_wrap=True)
