"""Tables: the order of teams by tie-breaks."""

from collections import defaultdict
from itertools import combinations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rcj_challenges.tournament.seeds import lot
from rcj_challenges.tournament.standings import Match, TableRules, table
from tests.tournament.seasons import names


def rules(*words):
    return TableRules(3, 1, 0, words, lambda team: lot(1, "test", team))


def matches(text):
    """Return matches written as ``ab 2:1, bc 0:0``."""
    found = []
    for one in text.split(", "):
        teams, _, goals = one.partition(" ")
        first, _, second = goals.partition(":")
        found.append(Match((teams[0], teams[1]), (float(first), float(second))))
    return found


def ranked(teams, text, *words):
    """Return the teams by place: ``a bc d`` if b and c share the second."""
    rows = table("", list(teams), matches(text), rules(*words), complete=True).rows
    by_place = defaultdict(str)
    for row in rows:
        by_place[row.place] += row.team
        assert row.shared == (sum(other.place == row.place for other in rows) > 1)
    return " ".join(by_place[place] for place in sorted(by_place))


@pytest.mark.parametrize(
    ("text", "words", "expected"),
    [
        ("ab 1:0, ac 0:0, bc 0:0", ["points"], "a c b"),
        ("ab 1:0, cd 3:0", ["points"], "ac bd"),
        ("ab 1:0, cd 3:0", ["points", "goal_difference"], "c a b d"),
        ("ab 4:3, cd 3:2", ["points", "goal_difference", "goals"], "a c b d"),
        ("ab 1:0, cd 5:4", ["wins", "goals"], "c a d b"),
        # A win against two draws and a loss: wins and points differ.
        ("ab 1:0, ac 0:1, ad 0:1, bc 0:0, bd 0:0, cd 0:0", ["wins", "points"], "cd a b"),
        ("ab 0:1, ac 3:0, bc 0:3", ["points"], "abc"),
        ("ab 0:1, ac 9:0, bc 0:1", ["points", "goal_difference"], "a b c"),
    ],
)
def test_teams_are_ranked_by_tie_breaks_in_their_order(text, words, expected):
    assert ranked("abcd" if "d" in text else "abc", text, *words) == expected


def test_head_to_head_of_two_is_their_match_whatever_the_goals_against_others():
    text = "ab 1:0, bc 9:0"
    assert ranked("abc", text, "points", "goal_difference") == "b a c"
    assert ranked("abc", text, "points", "head_to_head") == "a b c"


def test_head_to_head_of_three_is_a_table_of_their_own_matches():
    # a, b and c have beaten each other in turn, a by most; all three beat d, c by far the highest.
    text = "ab 3:0, bc 1:0, ca 1:0, ad 1:0, bd 1:0, cd 9:0"
    assert ranked("abcd", text, "points", "head_to_head") == "a c b d"
    assert ranked("abcd", text, "points", "goal_difference") == "c a b d"


def test_two_of_three_that_are_level_in_their_own_table_are_compared_by_their_own_match():
    # In the table of the three b and c have 3 points, 2:3 goals each; b beat c.
    assert ranked("abc", "ab 3:0, ca 2:1, bc 2:0", "points", "head_to_head") == "a b c"


def test_head_to_head_is_skipped_if_not_all_teams_have_met():
    assert ranked("abcd", "ab 5:0, bc 1:0, cd 1:0, da 1:0", "points", "head_to_head") == "abcd"


def test_a_shared_place_leaves_out_the_next_ones():
    rows = table("", list("abc"), matches("ac 1:0, bc 1:0"), rules("points"), complete=True).rows
    assert [(row.team, row.place, row.shared, row.by_lot) for row in rows] == [
        ("a", 1, True, False), ("b", 1, True, False), ("c", 3, False, False)
    ]  # fmt: skip


def test_lot_leaves_no_shared_place_and_is_marked_and_waits_for_the_last_match():
    text = "ac 1:0, bc 1:0"
    complete = table("", list("abc"), matches(text), rules("points", "lot"), complete=True).rows
    assert [(row.place, row.shared, row.by_lot) for row in complete] == [
        (1, False, True), (2, False, True), (3, False, False)
    ]  # fmt: skip
    running = table("", list("abc"), matches(text), rules("points", "lot"), complete=False).rows
    assert [row.place for row in running] == [1, 1, 3]


@st.composite
def played(draw):
    """Draw teams, some of their matches and a list of tie-breaks."""
    teams = names(draw(st.integers(2, 9)))
    scores = st.integers(0, 2)
    pairs = [pair for pair in combinations(teams, 2) if draw(st.booleans())]
    words = draw(st.lists(st.sampled_from(["points", "goal_difference", "goals", "wins"]), unique=True, min_size=1))
    return teams, [Match(pair, (float(draw(scores)), float(draw(scores)))) for pair in pairs], words


@given(played())
def test_table_is_that_of_a_count_by_hand(drawn):
    teams, games, words = drawn
    by_hand = dict.fromkeys(teams, (0, 0, 0, 0))  # points, goal difference, goals, wins
    for game in games:
        for team, own, other in ((game.teams[0], *game.goals), (game.teams[1], *game.goals[::-1])):
            points, difference, goals, wins = by_hand[team]
            won = own > other
            by_hand[team] = (points + 3 * won + (own == other), difference + own - other, goals + own, wins + won)
    columns = ["points", "goal_difference", "goals", "wins"]
    keys = {team: [by_hand[team][columns.index(word)] for word in words] for team in teams}
    rows = table("", teams, games, rules(*words), complete=True).rows
    for row in rows:
        assert row.place == 1 + sum(keys[other] > keys[row.team] for other in teams)
        assert row.shared == (list(keys.values()).count(keys[row.team]) > 1)
        assert (row.points, row.goals - row.conceded, row.goals, row.won) == by_hand[row.team]
    assert [row.place for row in rows] == sorted(row.place for row in rows)


@given(played())
def test_table_does_not_depend_on_the_order_of_matches(drawn):
    teams, games, words = drawn
    whole = rules(*words, "head_to_head", "lot")
    assert table("", teams, games, whole, complete=True) == table("", teams, games[::-1], whole, complete=True)


OPPONENT_WORDS = ("buchholz", "median_buchholz", "sonneborn_berger")


def by_opponents(matches, **extra):
    """Return the order of the teams a to d by each of the tie-breaks by opponents."""
    return {word: "".join(row.team for row in table(
        "", "abcd", matches, TableRules(3, 1, 0, (word,), str), complete=True, **extra).rows)
        for word in OPPONENT_WORDS}  # fmt: skip


def test_opponents_decide_by_their_points():
    # a beats b and draws with c; b beats c and d; c beats d; d beats a: 4, 6, 4 and 3 points
    matches = [Match(tuple(pair), goals) for pair, goals in (
        ("ab", (1, 0)), ("ac", (0, 0)), ("bc", (1, 0)), ("bd", (1, 0)), ("cd", (1, 0)), ("da", (1, 0)),
    )]  # fmt: skip
    assert by_opponents(matches) == {
        "buchholz": "dacb",  # 14, 13, 13, 11
        "median_buchholz": "abcd",  # 4 each
        "sonneborn_berger": "abcd",  # 8, 7, 5, 4
    }


def test_a_match_that_both_forfeit_gives_neither_a_share_of_the_points_of_the_other():
    # d beats a and c; b beats c; d and b both forfeit
    matches = [Match(("d", "a"), (1, 0)), Match(("d", "c"), (1, 0)), Match(("b", "c"), (1, 0))]
    both = Match(("b", "d"), (0, 0), is_lost_by_both=True)
    assert by_opponents([*matches, both])["sonneborn_berger"] == by_opponents(matches)["sonneborn_berger"] == "abcd"


def test_a_bye_is_no_opponent_but_its_points_count_for_the_opponents_of_its_team():
    # a beats b, c beats d; then b has a bye, and c beats a: a 3, b 3, c 6, d 0
    matches = [Match(tuple(pair), (1, 0)) for pair in ("ab", "cd", "ca")]
    assert by_opponents(matches, extra_points={"b": 3}) == {
        "buchholz": "adbc",  # 9, 6, 3, 3
        "median_buchholz": "adbc",
        "sonneborn_berger": "acbd",  # 3, 3, 0, 0
    }
