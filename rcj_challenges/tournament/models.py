"""The tournament file as models: teams, points and tie-breaks, and the keys that stages of all formats have.

The description of each key is its reference: editors show it, and the documentation is written from it.
"""

from typing import Annotated, Literal

from pydantic import Field, StringConstraints

from rcj_challenges.rules.fields import Name, One, Scalar, Strict, described

TeamId = Annotated[
    str,
    StringConstraints(pattern=r"^[A-Za-z0-9_]+$", max_length=40),
    Field(description="a team's id: letters, digits and _, unique without regard to case"),
]
Time = Annotated[
    str,
    Field(
        description="a date and time in the tournament's time zone: 2021-06-22 18:00",
        json_schema_extra={"pattern": r"^\d{4}-\d{2}-\d{2} \d{2}:\d{2}$"},  # `checks` refuses others with more help
    ),
]
PlaceRange = Annotated[
    str,
    StringConstraints(pattern=r"^[1-9]\d{0,3}-[1-9]\d{0,3}$"),
    Field(description="first and last place: 1-2"),
]
Place = Annotated[int, Field(ge=1, le=9999, description="one place")]
Settings = dict[str, Scalar]
TieBreak = Literal[
    "points",
    "head_to_head",
    "goal_difference",
    "goals",
    "wins",
    "buchholz",
    "median_buchholz",
    "sonneborn_berger",
    "lot",
]
Records = Literal["full", "replay", "result"]


class TeamModel(Strict):
    """One team: where its submission is, and what it is called."""

    path: str | None = described(
        None, "its ZIP or folder, relative to this file; if omitted: the one in teams_folder", min_length=1
    )
    sample: str | None = described(None, "instead of a submission: a sample team that comes with the package, by name")
    name: str | None = described(None, "the name shown; if omitted: the name in the submission", max_length=64)
    pot: int = described(0, "for drawing groups: 1 for the strongest teams; 0: in no pot", ge=0, le=64)


class Points(Strict):
    """Points for a match."""

    win: float = described(3.0, "for a win, also for a bye in a Swiss stage")
    draw: float = described(1.0, "for a draw")
    loss: float = described(0.0, "for a loss")


class LostBy(Strict):
    """The score of the matches that a withdrawn team does not play."""

    lost: tuple[int, int] = described(..., "goals of the withdrawn team and of its opponent: [0, 3]")


class TieScenario(Strict):
    """The scenario that decides a tie after extra time.

    With one seat, each of the two teams plays it once, with the same seed; with two seats they play it together.
    """

    scenario: str = described(..., "a file, relative to this one, or the name of a shipped scenario")
    set: Settings = described({}, "settings of that scenario: path -> value")


class DrawnMatches(Strict):
    """What decides a knock-out tie that is level, in this order; a lot is the last resort."""

    extra_time: Settings | None = described(
        None,
        "settings for an extra match that starts at 0:0, such as {match.half_s: 300}; the team that wins it advances",
    )
    tie_scenario: TieScenario | None = described(None, "then this scenario")


class StageModel(Strict):
    """What all stages have."""

    title: str = described("", "the title shown; if omitted: made from the stage's name", max_length=120)
    release: Time | Annotated[tuple[Time, ...], Field(min_length=1)] | None = described(
        None,
        "when `publish` shows the results: one time, or a list with one for each round; if omitted: as soon as"
        " they are known",
    )
    minutes_between: float = described(
        0.0, "the matches of a round are released one by one, this many minutes apart; 0: all together", ge=0, le=10_080
    )
    records: Records | None = described(None, "what is kept of its matches; if omitted: as for the whole tournament")


class FromModel(StageModel):
    """What stages have that may take their teams from an earlier one."""

    from_: Name | None = Field(
        None, alias="from", description="the earlier stage from which its teams come; if omitted: all teams take part"
    )
    places: Place | PlaceRange | None = described(
        None, "which places of that stage (of each of its groups, if it has groups): 1 or 1-2; if omitted: all"
    )

    def place_range(self, size: int) -> tuple[int, int]:
        """Return the first and the last place that the stage takes from a table of ``size`` teams."""
        if self.places is None:
            return 1, size
        first, _, last = str(self.places).partition("-")
        return int(first), int(last or first)

    def taken(self, size: int) -> range:
        """Return those of the places that there are."""
        first, last = self.place_range(size)
        return range(first, min(last, size) + 1)


class MatchesModel(FromModel):
    """What stages of matches have."""

    scenario: str | None = described(None, "if omitted: that of the tournament")
    set: Settings = described(
        {}, "settings for this stage; they are added to the tournament's, unless the stage has a scenario of its own"
    )


class ChallengeScenario(Strict):
    """One challenge."""

    scenario: str = described(..., "a file, relative to this one, or the name of a shipped scenario; it has one seat")
    set: Settings = described({}, "settings of that scenario: path -> value")
    teams_folder: str | None = described(
        None,
        "a folder, relative to this file, of the submissions for this challenge, named like the teams; a team "
        "that is not in it does not take part. If omitted: as for the matches, and for sample teams the sample"
        " team of the challenge",
        min_length=1,
    )


class General(Strict):
    """What a tournament file says besides its stages: teams, scenario, and what decides."""

    tournament_version: One = described(..., "version of this format: 1")
    title: str = described(..., "its title", min_length=1, max_length=120)
    description: str = described("", "for the site", max_length=4000)
    seed: int | Annotated[str, StringConstraints(min_length=1, max_length=200)] = described(
        ...,
        "a number or a text that determines all random choices: groups, pairings, lots, matches. Its hash is "
        "published in advance, so choose a text that cannot be guessed",
    )
    teams_folder: str | None = described(
        None,
        "a folder, relative to this file, in which each ZIP and each folder is a team; its name is the team's id",
        min_length=1,
    )
    teams: dict[TeamId, TeamModel] = described(
        {}, "teams by id; with teams_folder only those that need further settings", max_length=1024
    )
    scenario: str = described(
        "match", "what is played: a file, relative to this one, or the name of a shipped scenario"
    )
    set: Settings = described({}, "settings of the scenario: path -> value, as with --set: {match.half_s: 300}")
    points: Points = described(Points.model_construct(), "points for a match")
    tie_breaks: Annotated[tuple[TieBreak, ...], Field(min_length=1)] = described(
        ("points", "goal_difference", "goals", "head_to_head"),
        "how a table is ranked, first criterion first. head_to_head: a table of the matches between the teams "
        "that are level. buchholz: the sum of the points of a team's opponents; median_buchholz: without the best and "
        "the worst of them, if it has met three; sonneborn_berger: the points of those it beat, and half of those "
        "it drew with. In these three a bye counts as no opponent, and an opponent that has left counts with the "
        "points it has. Teams that remain level share their place, unless the last criterion is lot",
    )
    drawn: DrawnMatches = described(DrawnMatches.model_construct(), "what decides a knock-out tie that is level")
    withdrawn: Literal["annulled"] | LostBy = described(
        "annulled",
        "what happens if a team withdraws during the tournament. annulled: in an unfinished round robin none "
        "of its matches count; {lost: [0, 3]}: its remaining matches are lost. In a Swiss stage its played "
        "matches count; in a knock-out its opponent advances; if both teams of a tie leave, neither does, and "
        "the places below move up",
    )
    records: Records = described(
        "replay",
        "what is kept of each match: full: the whole record, with sensors; replay: what the replay page needs; result: "
        "the result only. `tournament rerun` recreates what is not kept",
    )
    time_zone: str = described("UTC", "time zone of all times in this file: Europe/Berlin", max_length=64)
