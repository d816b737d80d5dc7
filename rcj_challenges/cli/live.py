"""``run --live``: the options of the live view, and showing a match from before its first tick to its end."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from typing import TYPE_CHECKING, Any, NamedTuple

from rcj_challenges.cli.help import Command
from rcj_challenges.cli.stdio import print_lines
from rcj_challenges.core.errors import RcjError

if TYPE_CHECKING:
    from rich.console import Console

    from rcj_challenges.scenario.models.scenario import Scenario
    from rcj_challenges.views.live import LiveShow


class LiveOptionError(RcjError):
    """An option of the live view that does not fit."""


class RunCommand(Command):
    """A command whose ``--live`` may stand without a port."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Parse the command line, ``--live`` alone being ``--live=0``."""
        return super().parse_args(ctx, with_port(args))


def with_port(arguments: list[str]) -> list[str]:
    """Return arguments in which ``--live`` has its port: the number that follows it, else 0."""
    found = list(arguments)
    for at, argument in enumerate(arguments):
        if argument == "--":
            break
        follower = arguments[at + 1] if at + 1 < len(arguments) else ""
        if argument == "--live" and not (follower.isascii() and follower.isdigit()):
            found[at] = "--live=0"
    return found


class LiveOptions(NamedTuple):
    """How a match is shown while it is played.

    Attributes:
        port: on loopback; 0 takes a free one.
        speed: simulated over wall time; infinity: as fast as it can.
        open: whether to open the page in the browser.
        for_s: how long to go on serving after the match; None: until interrupted.
    """

    port: int = 0
    speed: float = 1.0
    open: bool = False
    for_s: float | None = None

    @classmethod
    def of(cls, port: int | None, speed: str | None, for_s: float | None, *, open_: bool) -> LiveOptions | None:
        """Return the options as they were given; None if the match is not shown.

        Raises:
            LiveOptionError: they do not fit together.
        """
        if port is not None:
            return cls(port, _speed(speed), open_, for_s)
        given = {"--speed": speed is not None, "--live-for": for_s is not None}
        for option in (option for option, is_given in given.items() if is_given):
            message = f"{option} is for a match that is shown while it is played"
            raise LiveOptionError(message, "give --live too", code="option-does-not-fit")
        return None


@contextmanager
def on_air(
    options: LiveOptions | None,
    scenario: Scenario,
    titles: Mapping[str, str],
    logos: Mapping[str, bytes],
    seed: int,
    console: Console,
) -> Iterator[LiveShow | None]:
    """Show the match that is played in this context, and print its addresses. None if it is not shown.

    Raises:
        PortTakenError: the port is in use.
    """
    if options is None:
        yield None
        return
    import webbrowser

    from rcj_challenges.views.live import LiveShow

    with LiveShow(scenario, titles, seed, logos=logos, port=options.port, speed=options.speed) as show:
        print_lines(console, f"live:   {show.address}", f"steer:  {show.steering_address}")
        if options.open and not webbrowser.open(show.steering_address):
            print_lines(console, "no browser could be opened: open one of these addresses yourself")
        yield show


def stay_on_air(show: LiveShow, options: LiveOptions, console: Console) -> None:
    """Go on serving after the match, for as long as was asked for."""
    with suppress(KeyboardInterrupt):
        if options.for_s is None:
            print_lines(console, f"live:   the match is over; {show.address} shows it until Ctrl-C")
        show.linger(options.for_s)


def _speed(text: str | None) -> float:
    from rcj_challenges.views.live.pace import FASTEST, MAX_SPEED, SLOWEST

    if text == "max":
        return MAX_SPEED
    try:
        speed = float(text or 1)
    except ValueError:
        speed = 0.0
    if not SLOWEST <= speed <= FASTEST:
        allowed = f"give how many times real time, from {SLOWEST:g} to {FASTEST:g}, or max"
        raise LiveOptionError(f"--speed {text}: not a speed", allowed, code="bad-speed")
    return speed
