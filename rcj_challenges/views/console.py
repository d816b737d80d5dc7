"""The console for people: it replaces characters that its encoding lacks, and stops writing when its reader is gone."""

from __future__ import annotations

import contextlib
import sys
from collections.abc import Iterable

from rich.console import Console, ConsoleOptions, RenderableType
from rich.segment import Segment

from rcj_challenges.core.letters import READABLE
from rcj_challenges.core.sanitize import sanitize_lines


class PatientConsole(Console):
    """A console that stops writing when its reader is gone (``| head``); the match goes on to its end.

    It prints text of strangers, so control characters are made visible.
    """

    def render(self, renderable: RenderableType, options: ConsoleOptions | None = None) -> Iterable[Segment]:
        """Yield pieces of output."""
        for piece in super().render(renderable, options):
            yield piece if piece.is_control else piece._replace(text=sanitize_lines(piece.text))

    def on_broken_pipe(self) -> None:
        """Print nothing more. Rich would end the command, with exit status 1."""
        with contextlib.suppress(SystemExit):
            super().on_broken_pipe()


def console_for(*, to_stderr: bool = False) -> Console:
    """Return the console for people; output that the terminal's encoding lacks is replaced, never an error."""
    stream = sys.stderr if to_stderr else sys.stdout
    if (reconfigure := getattr(stream, "reconfigure", None)) is not None:
        reconfigure(errors=READABLE)
    return PatientConsole(file=stream, soft_wrap=False)
