"""``rcj-challenge snapshot``: a moment of a recorded run as a picture."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated

import typer

from rcj_challenges.cli.app import WATCH, app
from rcj_challenges.cli.options import Run
from rcj_challenges.cli.stdio import print_lines
from rcj_challenges.cli.video import Camera, Half, Records, Size, open_footage, output_file


@app.register(WATCH, "rcj-challenge snapshot --at 1:53.9")
def snapshot(
    at: Annotated[str, typer.Option("--at", metavar="TIME", help="Which moment: 113.9 or 1:53.9.")],
    run: Run = None,
    out: Annotated[
        Path | None, typer.Option("--out", "-o", metavar="FILE", help=".png; default: in the record.")
    ] = None,
    half: Half = None,
    size: Size = "1280x720",
    camera: Camera = "field",
    runs: Records = Path("runs"),
) -> None:
    """Make a picture of one moment of a record."""
    from rcj_challenges.cli.output_paths import refuse_devices
    from rcj_challenges.views.video.requirements import require_packages

    refuse_devices(out=out)
    require_packages("PIL")
    from rcj_challenges.views.console import console_for
    from rcj_challenges.views.video import clips, make

    size_px, at_s = make.parse_size(size, even=False), clips.parse_seconds(at)
    folder, footage = open_footage(run, runs)
    moment = clips.moment_at(footage, at_s, half)
    path = output_file(out, folder / f"snapshot-half{moment.half.info.half}-{moment.t_s:.3f}s.png")
    print_lines(console_for(to_stderr=True), *footage.warnings)
    with make.opened_renderer(footage, size_px, camera, fine=True) as draw:
        make.write_snapshot(draw, moment, path)
    sys.stdout.write(f"{path}\n")
