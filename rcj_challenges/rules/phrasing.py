"""Numbers, names and lists as parts of sentences."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

from rcj_challenges.core.amounts import measure_words, number_words
from rcj_challenges.rules.fields import Names

_DIGITS = 9  # behind the point: to so many scores and counters are exact
_MOST = 1e15  # what neither a score nor a counter exceeds

USUALLY_FREE_M = 0.08
"""A spot is free if no centre is nearer than this, in m, unless the scenario says otherwise."""

# Notes of several words.
FREE_SPOT_NOTE = (
    "A spot is free when the centre of no robot and of no ball is nearer to it than the given distance, by default "
    "8 cm. A robot or ball that is put there counts too where it is now, and needs room."
)
LAST_TOUCH_NOTE = (
    "The last to touch something is the robot that touched it last since a rule put it where it is. If there is none, "
    "points for its team are not given."
)
WAITING_NOTE = (
    "What a rule puts somewhere waits until there is room, in a phase in which that rule counts; until then it stays "
    "where it is, or off the field."
)


@dataclass(frozen=True)
class Subject:
    """What a sentence is about, ``the robots``, and whether its verb is in the plural and negated."""

    text: str
    plural: bool = False
    negated: bool = False

    def does(self, one: str, several: str) -> str:
        """Return it with its verb: ``the robots move``, ``Y1 does not move``; ``several`` follows ``does not``."""
        if not self.negated:
            return f"{self.text} {several if self.plural else one}"
        if several in ("are", "were"):
            return f"{self.text} {several if self.plural else one} not"
        return f"{self.text} {'do' if self.plural else 'does'} not {several}"


class Clause(NamedTuple):
    """What a comparison says of things.

    Attributes:
        names: the things.
        how: what follows the verb, with a blank for the comparison: ``at a speed of {}``.
        unit, where: what follows each bound.
        or_off: what the opposite of it says of what is off the field, for which no bound holds.
    """

    names: Names
    does: str
    do: str
    how: str
    unit: str = ""
    where: str = ""
    or_off: str = ""


def plain(name: str) -> str:
    """Return a name as people write it: ``blue goal``."""
    return name.replace("_", " ")


def spelled(value: object) -> str:
    """Return a single value as it stands in a file, without quotes."""
    return str(value).lower() if isinstance(value, bool) else str(value)


def quoted(name: str) -> str:
    """Return the name of something that cannot be seen on the field, in quotes: ``“goal pause”``."""
    return f"“{plain(name)}”"


def quoted_measure(name: str) -> str:
    """Return the name of what is counted or drawn, with its unit if it ends with one: ``“best (s)”``."""
    return f"“{measure_words(name)}”"


def what_drawn(draw: str) -> str:
    """Return a draw's value in words: ``what was drawn as “target”``."""
    return f"what was drawn as {quoted_measure(draw)}"


def listed(parts: Sequence[str], last: str) -> str:
    """Return parts as a list: ``Y1, Y2 or Y3``."""
    return f" {last} ".join(part for part in (", ".join(parts[:-1]), *parts[-1:]) if part)


def number(value: float) -> str:
    """Return a number without superfluous zeros: ``0.5``, ``1234567``.

    All its digits are there: people compare it, and not all of them read ``1.23457e+06``.
    """
    if value and not 10**-_DIGITS <= abs(value) <= _MOST:
        return f"{value:g}"
    return number_words(value, _DIGITS)


def counted(count: float, what: str) -> str:
    """Return so many of something: ``1 point``, ``360 points``."""
    many = number(count)
    return f"{many} {what}{'' if many == '1' else 's'}"


def seconds(value: float) -> str:
    """Return a duration: ``15 s``, ``10 min``."""
    return f"{value / 60:g} min" if value >= 120 and value % 60 == 0 else f"{value:g} s"


def metres(value: float) -> str:
    """Return a length in m, or in cm below 10 cm."""
    return f"{value * 100:g} cm" if value < 0.1 else f"{value:g} m"


def metres_alike(values: Sequence[float]) -> list[str]:
    """Return lengths that stand side by side in one unit: in m, or all in cm where one is below 10 cm, none 1 m."""
    small = any(0 < value < 0.1 for value in values) and all(value < 1 for value in values)
    return [f"{value * 100:g} cm" if small else f"{value:g} m" for value in values]


def within_words(clearance_m: float) -> str:
    """Return within which distance a spot must be free, if it is not the usual one: `` within 5 cm``."""
    return "" if clearance_m == USUALLY_FREE_M else f" within {metres(clearance_m)}"


def degrees(value_rad: float) -> str:
    """Return an angle in rad as degrees, to a tenth, small ones to three digits: ``34.4°``, ``0.573°``."""
    value = math.degrees(value_rad)
    return f"{value:.3g}°" if abs(value) < 10 else f"{round(value, 1):g}°"


def heading(yaw_rad: float) -> str:
    """Return a direction on the floor: ``90° counter-clockwise from +x``."""
    return f"{degrees(abs(yaw_rad))} {'clockwise' if yaw_rad < 0 else 'counter-clockwise'} from +x"
