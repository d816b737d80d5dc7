"""What the site is made from, and which results it may show already."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, field
from datetime import datetime, timedelta, tzinfo

from rcj_challenges.tournament.played import Played, PlayedMatch
from rcj_challenges.tournament.season import Fixture, SeasonState

HALF_TIME_S = 30.0
"""Break between the halves of a premiere."""


@dataclass(frozen=True, slots=True)
class RoundTime:
    """When the results of a stage, or of one of its rounds, are released.

    Attributes:
        stage: its name.
        round: from 1; 0 for the whole stage.
        at: with a time zone.
    """

    stage: str
    round: int
    at: datetime


@dataclass(frozen=True, slots=True)
class SiteSource:
    """All that the site shows.

    Attributes:
        id: of the tournament, safe as a file name.
        title, description: in the words of the organizer.
        seed: of the tournament, as its file has it.
        time_zone: in which times are shown.
        state: of the released outcomes only, so that no table, bracket or pairing says more than the results do.
        played: everything that was played, also what is not released.
        now: when the site is published, with a time zone.
        releases: by fixture id, when its result is released; what is missing is released as soon as it is played.
        rounds: when stages and rounds are released, for the schedule.
        premieres: names of the stages whose matches are shown as a premiere when they are released.
        url: where the site will be on the web, ending in ``/``; empty if that is unknown.
    """

    id: str
    title: str
    description: str
    seed: str
    time_zone: tzinfo
    state: SeasonState
    played: Played
    now: datetime
    releases: Mapping[str, datetime] = field(default_factory=dict)
    rounds: tuple[RoundTime, ...] = ()
    premieres: frozenset[str] = frozenset()
    url: str = ""

    @property
    def is_over(self) -> bool:
        """Whether all results are released: only then the seed is."""
        return all(stage.status == "finished" for stage in self.state.stages)


def premiere_length(match: PlayedMatch) -> timedelta:
    """Return how long the premiere of a match lasts, with the breaks between its halves."""
    breaks = max(0, len(match.result.get("halves", ())) - 1)
    return timedelta(seconds=float(match.result.get("simulated_s", 0)) + breaks * HALF_TIME_S)


def hidden_fixtures(
    fixtures: Collection[Fixture],
    played: Played,
    releases: Mapping[str, datetime],
    now: datetime,
    premieres: Collection[str] = (),
) -> frozenset[str]:
    """Return the ids of the fixtures whose results may not be shown yet.

    A result is shown from its release on; if its stage has premieres, from the end of its premiere on.

    Args:
        fixtures: all that are known.
        played: what was played.
        releases: by fixture id.
        now: the time of publishing.
        premieres: names of the stages whose matches have a premiere.
    """
    hidden = set()
    for fixture in fixtures:
        at = releases.get(fixture.id)
        if at is None:
            continue
        match = played.matches.get(fixture.id)
        if fixture.stage in premieres and match is not None and match.record is not None:
            at += premiere_length(match)
        if at > now:
            hidden.add(fixture.id)
    return frozenset(hidden)
