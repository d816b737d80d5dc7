"""Few robots for checks that depend on no other robot.

A check of the match starts each program to see whether it starts, and plays as blue and as yellow, each time against
another team: 18 programs, or 6 if one robot on each side has one. For one robot that is alone it is 2.
"""

from rcj_challenges.scenario.load import Loaded, load_text

ONE_EACH = [
    f"entrants.{seat}.robots.{seat[0].upper()}{number}=null" for seat in ("blue", "yellow") for number in (2, 3)
]
"""Overrides of the match: one robot on each side has a program."""

_ALONE = """\
schema_version: 2
id: alone
title: Alone
extends: soccersim_v2
match: {swap_sides: false}
robots: {B2: null, B3: null, Y1: null, Y2: null, Y3: null}
entrants:
  blue: {robots: {B2: null, B3: null}}
  yellow: null
"""


def alone(*overrides: str) -> Loaded:
    """Load the field of the match with one robot and one team; overrides are as on the command line."""
    return load_text(_ALONE, overrides)
