"""``run --live``: its options, and showing a match from before its first tick to its end."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager, suppress
from typing import TYPE_CHECKING, Any

from rcj_challenges.cli.app import Command
from rcj_challenges.cli.codes import BAD_SPEED, OPTION_DOES_NOT_FIT
from rcj_challenges.cli.stdio import print_lines
from rcj_challenges.core.errors import RcjError

if TYPE_CHECKING:
    from rich.console import Console

    from rcj_challenges.match.runner import MatchPlan
    from rcj_challenges.views.live import LiveShow


class RunCommand(Command):
    """A command whose ``--live`` may stand without a port."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Parse the command line, ``--live`` alone being ``--live=0``."""
        return super().parse_args(ctx, with_port(args))


def with_port(arguments: list[str]) -> list[str]:
    """Arguments in which ``--live`` has its port: the number that follows it, else 0."""
    found = list(arguments)
    for at, argument in enumerate(arguments):
        if argument == "--":
            break
        follower = arguments[at + 1] if at + 1 < len(arguments) else ""
        if argument == "--live" and not (follower.isascii() and follower.isdigit()):
            found[at] = "--live=0"
    return found


def live_speed(port: int | None, speed: str | None, for_s: float | None) -> float:
    """Simulated over wall time of a match that is shown while it is played; infinity: as fast as it can.

    Raises:
        RcjError: it is no speed, or an option needs ``--live``.
    """
    if port is None:
        for option, given in (("--speed", speed), ("--live-for", for_s)):
            if given is not None:
                message = f"{option} is for a match that is shown while it is played"
                raise RcjError(message, "give --live too", code=OPTION_DOES_NOT_FIT)
        return 1.0
    from rcj_challenges.views.live.pace import FASTEST, MAX_SPEED, SLOWEST

    if speed == "max":
        return MAX_SPEED
    try:
        factor = float(speed or 1)
    except ValueError:
        factor = 0.0
    if not SLOWEST <= factor <= FASTEST:
        allowed = f"give how many times real time, from {SLOWEST:g} to {FASTEST:g}, or max"
        raise RcjError(f"--speed {speed}: not a speed", allowed, code=BAD_SPEED)
    return factor


@contextmanager
def shown_live(
    port: int | None, speed: float, plan: MatchPlan, console: Console, *, open_: bool
) -> Iterator[LiveShow | None]:
    """Show the match that is played in this context, and print its addresses.

    The port is one of loopback: 0 takes a free one, None shows nothing. The speed is simulated over wall time.

    Raises:
        RcjError: the port is in use.
    """
    if port is None:
        yield None
        return
    import webbrowser

    from rcj_challenges.views.live import LiveShow

    titles = {seat: plan.name_of(seat) for seat in plan.teams}
    with LiveShow(plan.loaded.scenario, titles, plan.seed, logos=plan.logos, port=port, speed=speed) as show:
        print_lines(console, f"live:   {show.address}", f"steer:  {show.steering_address}")
        if open_ and not webbrowser.open(show.steering_address):
            print_lines(console, "no browser could be opened: open one of these addresses yourself")
        yield show


def serve_after_match(show: LiveShow, for_s: float | None, console: Console) -> None:
    """Go on serving after the match, for ``for_s``; None: until Ctrl-C."""
    with suppress(KeyboardInterrupt):
        if for_s is None:
            print_lines(console, f"live:   the match is over; {show.address} shows it until Ctrl-C")
        show.linger(for_s)
