"""The formats of stages: from the teams and the outcomes so far to fixtures, tables, brackets and places.

Each format is a class (`formats.stage`) in a file of its own, and has its line here. Formats are pure, and know the
file and the store of results only through a `StageContext`.
"""

from typing import Annotated

from pydantic import Field

from rcj_challenges.tournament.formats.challenge import Challenge
from rcj_challenges.tournament.formats.double_elimination import DoubleElimination
from rcj_challenges.tournament.formats.knock_out import KnockOut
from rcj_challenges.tournament.formats.round_robin import RoundRobin
from rcj_challenges.tournament.formats.super_team import SuperTeam
from rcj_challenges.tournament.formats.swiss import Swiss

Stage = Annotated[
    RoundRobin | Swiss | KnockOut | DoubleElimination | Challenge | SuperTeam, Field(discriminator="stage")
]
