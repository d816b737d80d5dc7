"""The console for people: letters that its encoding lacks are replaced, and it falls silent when its reader is gone."""

from __future__ import annotations

import contextlib
import sys
from collections.abc import Iterable

from rich.console import Console, ConsoleOptions, RenderableType
from rich.segment import Segment

from rcj_challenges.core.letters import READABLE
from rcj_challenges.core.sanitize import sanitize_lines


class PatientConsole(Console):
    """A console that falls silent when its reader has seen enough (``| head``): a match goes on to its end.

    Whatever it prints may hold text of strangers, so characters that would steer the terminal become visible.
    """

    def render(self, renderable: RenderableType, options: ConsoleOptions | None = None) -> Iterable[Segment]:
        """Return what is printed, in pieces."""
        for piece in super().render(renderable, options):
            yield piece if piece.is_control else piece._replace(text=sanitize_lines(piece.text))

    def on_broken_pipe(self) -> None:
        """Say nothing more. Rich would end the command, with exit status 1."""
        with contextlib.suppress(SystemExit):
            super().on_broken_pipe()


def console_for(*, to_stderr: bool = False) -> Console:
    """Return the console for people; output that the terminal's encoding lacks is replaced, never an error."""
    stream = sys.stderr if to_stderr else sys.stdout
    reconfigure = getattr(stream, "reconfigure", None)
    if reconfigure is not None:
        reconfigure(errors=READABLE)
    return PatientConsole(file=stream, soft_wrap=False)
