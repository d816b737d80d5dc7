"""The rule sheet says what people would say: who wins, in which phase a rule counts, how often, and each thing once."""

import pytest

from rcj_challenges.scenario.load import load_text
from rcj_challenges.views.sheet.page import sheet_markdown
from tests.views.sheets import sentence, sheet

pytestmark = pytest.mark.usefixtures("without_drawing")

END = "actions: [{action: end}]"
GOAL = "triggers: [{trigger: enters, entity: ball, zone: blue_goal}]"
PER = (
    "timers: {rest: {lasts_s: 3, per: yellow}}\nflags: {out: {per: robots}}\n"
    "counters: {n: {per: robots}, wide: {initial: 0.3}}\n"
)


def condition(written: str, more: str = PER) -> str:
    """Return a condition in words."""
    said = sentence(f"triggers: [{{trigger: half_started}}], conditions: [{{{written}}}], {END}", more)
    return said.removeprefix("When a half starts, provided that ").removesuffix(": the half ends.")


# --- phases -------------------------------------------------------------------------------------------------------------

ONLY_PLAY = "Where nothing else is said, a rule counts in the phase “play” only; what happens in another phase is not"


def test_where_there_are_other_phases_the_sheet_says_in_which_a_rule_counts():
    pause = "phases: {pause: {lasts_s: 3}}\n"
    assert f"{ONLY_PLAY} made up for later." in sheet(f"{pause}rules: {{it: {{{GOAL}, {END}}}}}\n")
    assert ONLY_PLAY not in sheet(f"{pause}rules: {{it: {{phases: any, {GOAL}, {END}}}}}\n")
    assert ONLY_PLAY not in sheet(f"rules: {{it: {{{GOAL}, {END}}}}}\n")


# --- who wins -----------------------------------------------------------------------------------------------------------


def test_where_points_decide_the_sheet_says_so_though_nobody_wrote_it_down():
    points = f"rules: {{it: {{{GOAL}, actions: [{{action: score, entrant: yellow}}]}}}}\n"
    assert "The better one has more points." in sheet(points)
    assert "The better one" not in sheet(f"rules: {{it: {{{GOAL}, {END}}}}}\n")


def points_of(*scores: str) -> list[str]:
    """Return the rows of the table of points for a rule that gives these."""
    actions = ", ".join(f"{{action: score, {score}}}" for score in scores)
    text = sheet(f"rules: {{it: {{{GOAL}, actions: [{actions}], says: A goal.}}}}\n")
    return text.partition("## Scoring")[2].partition("| --- | --- | --- |\n")[2].partition("\n\n")[0].splitlines()


def test_points_for_the_same_team_stand_in_one_row():
    by_time = "entrant: yellow, points: {word: time_left_s}"
    rows = points_of("entrant: yellow, points: 10", by_time)
    assert rows == ["| A goal. | yellow | 10, plus the time left in full seconds |"]


def test_points_for_two_teams_stand_in_two_rows_of_which_one_says_when():
    rows = points_of("entrant: yellow, points: 1", "entrant: blue, points: -1")
    assert rows == ["| A goal. | yellow | 1 |", "| at the same time | blue | -1 |"]


# --- rules over each of a group -----------------------------------------------------------------------------------------


def test_a_rule_over_each_of_a_group_says_that_its_limits_count_for_each():
    often = "cooldown_s: 2, max_executions: 3, triggers: [{trigger: touches, entity: %s, other: ball}], %s"
    assert sentence("for_each: yellow, " + often % ("each", END)).endswith(
        "(for each of them at most once in 2 s and at most 3 times a half)."
    )
    assert sentence(often % ("yellow", END)).endswith("(at most once in 2 s and at most 3 times a half).")
    alone = "groups: {lone: [Y1]}\n"
    once = "for_each: lone, max_executions: 1, triggers: [{trigger: touches, entity: each, other: ball}], " + END
    assert sentence(once, alone).endswith("(at most once a half).")


RUNS_OUT = "triggers: [{trigger: timer_expired, timer: rest}], " + END


@pytest.mark.parametrize(
    ("each", "words"),
    [
        ("for_each: yellow, ", "For each of the yellow robots, when its timer “rest” runs out:"),
        ("", "When the timer “rest” of one of the yellow robots runs out:"),
    ],
)
def test_whose_timer_runs_out_is_said(each, words):
    rule = each + RUNS_OUT + (", conditions: [{condition: flag, flag: out, entity: each}]" if each else "")
    assert sentence(rule, PER).startswith(words.removesuffix(":"))


# --- conditions ---------------------------------------------------------------------------------------------------------

LEVELS = {
    "condition: flag, flag: out, entity: blue, of: all, negate: true": "not all of the blue robots have the flag “out” set",
    "condition: flag, flag: out, entity: blue, of: all": "all of the blue robots have the flag “out” set",
    "condition: flag, flag: out, entity: blue, of: none": "none of the blue robots has the flag “out” set",
    "condition: flag, flag: out, entity: Y1, negate: true": "the flag “out” of Y1 is not set",
    "condition: counter, counter: n, entity: blue, of: {at_least: 2}, equals: 2": (
        "at least 2 of the blue robots have a counter “n” of exactly 2"
    ),
    "condition: timer, timer: rest, of: all, at_least: 2": (
        "all of the yellow robots have a timer “rest” that has run for at least 2 s"
    ),
    "condition: timer, timer: rest, entity: Y1, at_most: 20, negate: true": "the timer “rest” of Y1 has run for more than 20 s",
    "condition: timer, timer: rest, entity: Y1, at_least: 2, negate: true": "the timer “rest” of Y1 has run for less than 2 s",
    "condition: timer, timer: rest, entity: Y1, at_least: 2, at_most: 5, negate: true": (
        "the timer “rest” of Y1 has not run for at least 2 s and at most 5 s"
    ),
    "condition: timer, timer: rest, entity: Y1, at_most: {counter: wide}, negate: true": (
        "the timer “rest” of Y1 has run longer than the counter “wide” says in s"
    ),
    "condition: timer, timer: rest, of: all, negate: true": "not all of the yellow robots have the timer “rest” running",
    "condition: distance, entity: Y1, to: ball, at_most: 0.5, negate: true": "Y1 is more than 0.5 m from the ball",
    "condition: distance, entity: Y1, to: ball, at_least: 0.5, negate: true": "Y1 is less than 0.5 m from the ball",
    "condition: distance, entity: Y1, to: ball, at_least: 0.2, at_most: 0.5, negate: true": (
        "Y1 is not at least 0.2 m and at most 0.5 m from the ball"
    ),
    "condition: distance, entity: yellow, to: ball, at_most: 0.5, negate: true": (
        "none of the yellow robots is at most 0.5 m from the ball"
    ),
    "condition: distance, entity: Y1, to: [0, 0], at_least: {counter: wide}": (
        "Y1 is at least as many m from (0, 0) as the counter “wide” says"
    ),
    "condition: distance, entity: Y1, to: [0, 0], at_most: {counter: wide}, negate: true": (
        "Y1 is further from (0, 0) than the counter “wide” says in m"
    ),
    "condition: speed, entity: Y1, at_most: {counter: wide}": (
        "Y1 moves at a speed of at most as many m/s as the counter “wide” says"
    ),
    "condition: speed, entity: Y1, at_most: {counter: wide}, negate: true": (
        "Y1 moves faster than the counter “wide” says in m/s"
    ),
    "condition: counter, counter: wide, at_most: 2, negate: true": "the counter “wide” is more than 2",
    "condition: counter, counter: wide, equals: 2, negate: true": "the counter “wide” is not exactly 2",
    "condition: counter, counter: blue, equals: {counter: yellow}, negate: true": "the scores of blue and yellow differ",
    "condition: counter, counter: blue, equals: {counter: yellow}": "the scores of blue and yellow are equal",
    "condition: counter, counter: blue, equals: {counter: wide}, negate: true": (
        "the score of blue differs from the counter “wide”"
    ),
}


@pytest.mark.parametrize(("written", "words"), LEVELS.items(), ids=list(LEVELS.values()))
def test_a_condition_is_said_as_people_say_it(written, words):
    assert condition(written) == words


def test_who_touched_last_is_it_where_a_rule_goes_over_each_of_a_group():
    rule = "for_each: yellow, %s, conditions: [{condition: last_touch, by: each%s}], %s"
    for negate, was in (("", "was"), (", negate: true", "was not")):
        said = sentence(rule % (GOAL, negate, END))
        assert f"provided that it {was} the last to touch the ball:" in said
    assert condition("condition: last_touch, by: Y1") == "the last to touch the ball was Y1"


def test_what_must_last_as_a_counter_says_tells_how_long_before_that():
    far = "condition: distance, entity: Y1, to: [0, 0], at_least: {counter: wide}"
    said = sentence(f"triggers: [{{trigger: holds, condition: {{{far}}}, for_s: 1}}], {END}", PER)
    assert said == "When for 1 s Y1 is at least as many m from (0, 0) as the counter “wide” says: the half ends."


# --- what is put and drawn ----------------------------------------------------------------------------------------------


def test_a_ball_that_is_kicked_where_it_is_rolls_on():
    on = "{action: place, entity: ball, at: {relative_to: ball}, kick: {towards: {spot: centre}, speed_mps: [0.15, 0.3]}}"
    assert sentence(f"triggers: [{{trigger: half_started}}], actions: [{on}]") == (
        "When a half starts: the ball rolls on from where it is, at 0.15 to 0.3 m/s towards the spot “centre”."
    )


@pytest.mark.parametrize(
    ("speed", "words"),
    [
        ("{draw: power}", "at 0.5 or 1 m/s, as “power” is drawn, towards the spot “centre”."),
        ("{counter: hits}", "at as many m/s as the counter “hits” tells, 3 at most, towards the spot “centre”."),
    ],
)
def test_a_kick_tells_by_what_its_speed_is_decided(speed, words):
    kick = f"{{action: place, entity: ball, at: {{relative_to: ball}}, kick: {{towards: {{spot: centre}}, speed_mps: {speed}}}}}"
    said = sentence(
        f"triggers: [{{trigger: half_started}}], actions: [{kick}]",
        "draws: {power: {values: [1, 0.5]}}\ncounters: {hits: {}}\n",
    )
    assert said == f"When a half starts: the ball rolls on from where it is, {words}"


def test_the_last_of_several_is_told_by_its_counter():
    last = "{condition: counter, counter: laps, entity: each, %s: {%s: laps}}"
    rule = "for_each: robots, triggers: [{trigger: half_started}], conditions: [%s], actions: [{action: remove, entity: each}]"
    laps = "counters: {laps: {per: robots}}\n"
    assert (
        "provided that its counter “laps” is at most the lowest counter “laps” of all others on the field"
        in sentence(rule % (last % ("at_most", "lowest")), laps)
    )
    assert (
        "provided that its counter “laps” is exactly the highest counter “laps” of all others on the field"
        in sentence(rule % (last % ("equals", "highest")), laps)
    )


@pytest.mark.parametrize(
    ("each", "owners", "words"),
    [
        ("", "robots", "at most the lowest counter “laps” of the robots on the field"),
        ("for_each: balls, ", "robots", "at most the lowest counter “laps” of the robots on the field"),
        ("for_each: yellow, ", "robots", "at most the lowest counter “laps” of all others on the field"),
        ("", "penalty_areas", "at most the lowest counter “laps” of the penalty areas"),
        ("for_each: penalty_areas, ", "penalty_areas", "at most the lowest counter “laps” of all others"),
    ],
)
def test_whose_lowest_counter_is_meant(each, owners, words):
    low = "{condition: counter, counter: level, at_most: {lowest: laps}}"
    rule = f"{each}triggers: [{{trigger: half_started}}], conditions: [{low}], actions: [{{action: end}}]"
    said = sentence(rule, f"counters: {{level: {{}}, laps: {{per: {owners}}}}}\n")
    assert f"provided that the counter “level” is {words}: " in said


def test_a_counter_may_be_set_to_what_is_reckoned():
    count = "{action: count, counter: sum, to: [20, {counter: laps, weight: -2}]}"
    said = sentence(f"triggers: [{{trigger: half_started}}], actions: [{count}]", "counters: {sum: {}, laps: {}}\n")
    assert said == "When a half starts: the counter “sum” is set to 20, minus 2 times the counter “laps”."


def test_a_draw_that_rules_repeat_is_not_made_once():
    draws = "draws: {gain: {values: [1, 5]%s}}\nrules: {it: {%s, actions: [{action: draw, draw: gain%s}]}}\n"
    again = "Chance decides “gain” when a half starts, and again when a rule says so: 1 or 5."
    assert again in sheet(draws % ("", GOAL, ""))
    whole = "Chance decides “gain” when the match starts, and again when a rule says so: 1 or 5."
    assert whole in sheet(draws % (", keep: match", GOAL, ""))
    set_too = "Chance decides “gain” once a match: 1 or 5; rules set it as well."
    assert set_too in sheet(draws % (", keep: match", GOAL, ", as: 5"))


def test_a_value_that_is_written_more_than_once_is_told_once_with_how_often_it_comes():
    draws = "draws: {gain: {values: [1, 5, 1, 1]}, way: {values: [a, b]}}\n"
    text = sheet(f"{draws}rules: {{it: {{{GOAL}, actions: [{{action: end}}]}}}}\n")
    assert "Chance decides “gain” when a half starts: 1 (in 3 of 4 cases) or 5 (in 1 of 4 cases)." in text
    assert "Chance decides “way” when a half starts: a or b." in text
    # What was drawn before decides as well: no share is right in all draws.
    goes_on = f"rules: {{it: {{{GOAL}, actions: [{{action: draw, draw: gain}}]}}}}\n"
    text = sheet(f"draws: {{gain: {{values: [1, 5, 1, 2], not_last: true}}}}\n{goes_on}")
    assert "so: 1 (with 2 chances), 5 (with 1 chance) or 2 (with 1 chance), never the same twice running." in text
    text = sheet(f"draws: {{gain: {{values: [1, 5, 1], not_again: half}}}}\n{goes_on}")
    assert "so: 1 (twice) or 5 (once); in a half none comes more often before all have been drawn." in text
    text = sheet(f"draws: {{gain: {{values: [1, 5, 1, 1], not_again: match}}}}\n{goes_on}")
    assert "so: 1 (3 times) or 5 (once); in the match none comes more often before all have been drawn." in text
    timer = "draws: {long_s: {values: [1, 1, 2]}}\ntimers: {rest: {lasts_s: {draw: long_s}, starts: true}}\n"
    assert "lasts 1 s or 2 s, as “long (s)” is drawn" in sheet(
        f"{timer}rules: {{it: {{{GOAL}, actions: [{{action: end}}]}}}}\n"
    )
    kick = "{action: place, entity: ball, at: {spot: centre}, kick: {towards: {spot: middle_blue}, speed_mps: {draw: fast}}}"
    fast = "draws: {fast: {values: [0.5, 0.5, 1]}}\n"
    assert "at 0.5 or 1 m/s, as “fast” is drawn" in sheet(f"{fast}rules: {{it: {{{GOAL}, actions: [{kick}]}}}}\n")


KING = (
    "draws: {king: {values: [nobody, Y1, Y2, Y3]}}\n"
    "zones: {hill: {shape: circle, centre_m: [0, 0], radius_m: 0.1}}\n"
    "broadcast: {fields: {king: {draw: king}}}\n"
)
BEGIN = "  begin: {triggers: [{trigger: half_started}], actions: [{action: draw, draw: king, as: nobody}%s]%s}\n"
TAKES = (
    "  takes:\n    for_each: yellow\n    triggers: [{trigger: enters, entity: each, zone: hill}]\n"
    "    conditions: [{condition: drawn, draw: king, equals: nobody}, {condition: drawn, draw: king, equals: each, negate: true}]\n"
    "    actions: [{action: draw, draw: king, as: each}]\n"
)


class TestADrawThatRulesSetFromTheStart:
    def test_nothing_is_said_of_chance(self):
        text = sheet(f"{KING}rules:\n{BEGIN % ('', '')}{TAKES}")
        assert "- “king” is nobody, Y1, Y2 or Y3, as rules set it." in text.splitlines()
        assert "provided that “king” is “nobody” and that it is not “king”: it becomes “king”." in text
        assert '| king | what “king” is: "nobody", "Y1", "Y2" or "Y3" |' in text
        assert "drawn" not in text.partition("## Course")[2]

    @pytest.mark.parametrize(
        "begin",
        [
            BEGIN % ("", ", conditions: [{condition: half, equals: 1}]"),
            BEGIN % ("", ", phases: [other]"),
            # What is asked in the same tick is what was drawn.
            BEGIN % (", {action: emit, event: IS, payload: {king: {draw: king}}}", ""),
            BEGIN % ("", "") + "  again: {triggers: [{trigger: half_ended}], actions: [{action: draw, draw: king}]}\n",
        ],
    )
    def test_where_chance_may_be_seen_it_is_told(self, begin):
        text = sheet(f"{KING}phases: {{other: {{}}}}\nrules:\n{begin}{TAKES}")
        assert "Chance decides “king” when a half starts" in text
        assert "provided that “nobody” was drawn as “king” and that it was not drawn as “king”" in text

    def test_so_it_is_where_something_lasts_as_long_as_it_says(self):
        draws = "draws: {long_s: {values: [1, 2]}}\ntimers: {rest: {lasts_s: {draw: long_s}, starts: true}}\n"
        rule = "  begin: {triggers: [{trigger: half_started}], actions: [{action: draw, draw: long_s, as: 2}]}\n"
        assert "Chance decides “long (s)”" in sheet(f"{draws}rules:\n{rule}")

    def test_a_zone_that_rules_choose_is_named_so(self):
        zones = "zones: {a: {shape: circle, centre_m: [0, 0], radius_m: 0.1}, b: {shape: circle, centre_m: [0.3, 0], radius_m: 0.1}}\n"
        begin = "  begin: {triggers: [{trigger: half_started}], actions: [{action: draw, draw: safe, as: a}]}\n"
        out = "  out: {triggers: [{trigger: leaves, entity: Y1, zone: safe}], actions: [{action: draw, draw: safe, as: b}]}\n"
        text = sheet(f"{zones}draws: {{safe: {{values: [a, b]}}}}\nrules:\n{begin}{out}")
        assert "When Y1 leaves the zone that is “safe” (the zone “a” or the zone “b”): “safe” becomes “b”." in text


def test_a_layout_that_no_rule_uses_is_not_told():
    layout = "placements: {a: [{entity: Y1, at: start}], b: [{entity: Y2, at: start}]}\n"
    assert "Where things are put" not in sheet(layout)
    text = sheet(f"{layout}rules: {{it: {{{GOAL}, actions: [{{action: place, layout: b}}]}}}}\n")
    assert "“b”: Y2 is put at its start." in text
    assert "“a”" not in text


# --- robots that are held -----------------------------------------------------------------------------------------------

HOLD = "triggers: [{trigger: touches, entity: Y1, other: ball}], actions: [{action: %s}]"
MEANS = "A robot that is held still stands with braked wheels, whatever its program says, until its time is over or it is let go."


@pytest.mark.parametrize(
    ("action", "said"),
    [
        ("hold, entity: Y1, for_s: 5", "Y1 is held still for 5 s"),
        ("hold, entity: Y1", "Y1 is held still until it is let go"),
        ("hold, entity: Y1, for_s: {counter: n}", "Y1 is held still for as many s as the counter “n” says"),
        ("hold, entity: yellow", "the yellow robots are held still until they are let go"),
        ("release, entity: [Y1, B1]", "Y1 and B1 are let go"),
    ],
)
def test_who_is_held_for_how_long_and_who_is_let_go(action, said):
    assert sentence(HOLD % action, "counters: {n: {}}\n") == f"When Y1 touches the ball: {said}."


@pytest.mark.parametrize(
    ("written", "said"),
    [
        ("condition: held, entity: Y1", "Y1 is held"),
        ("condition: held, entity: Y1, negate: true", "Y1 is not held"),
        ("condition: held, entity: yellow, of: all", "all of the yellow robots are held"),
    ],
)
def test_who_must_be_held(written, said):
    assert condition(written) == said


def test_what_it_means_to_be_held_is_said_once_where_rules_hold_robots():
    told = sheet(f"rules: {{it: {{{HOLD % 'hold, entity: Y1'}}}, also: {{{HOLD % 'hold, entity: B1'}}}}}\n")
    assert told.count(MEANS) == 1
    assert MEANS not in sheet(f"rules: {{it: {{{GOAL}, {END}}}}}\n")


def test_where_who_does_not_move_is_judged_the_sheet_says_that_who_is_held_is_not():
    lazy = f"lazy: {{triggers: [{{trigger: no_progress, entity: Y1, distance_m: 0.1, within_s: 5}}], {END}}}"
    held = f"it: {{{HOLD % 'hold, entity: Y1'}}}"
    counts = f"{MEANS} That it does not move counts only from then on."
    assert counts in sheet(f"rules: {{{held}, {lazy}}}\n")
    assert counts not in sheet(f"rules: {{{held}}}\n")


def test_programs_are_told_who_is_held():
    assert "| Y1 | whether Y1 is held |" in sheet("broadcast: {fields: {Y1: {held: Y1}}}\n")


@pytest.mark.parametrize(("overrides", "told"), [((), "There are 7 shots"), (("params.shots=9",), "There are 9 shots")])
def test_params_in_the_description_are_filled_in_with_the_numbers_that_are_played(overrides, told):
    about = 'description: "There are {shots} shots; told is {\\"n\\": 1}."'
    text = f"schema_version: 1\nid: it\ntitle: It\nextends: soccersim_v2\n{about}\nparams: {{shots: 7}}\n"
    loaded = load_text(text, overrides)
    assert f'{told}; told is {{"n": 1}}.' in sheet_markdown(loaded.scenario, loaded.roster)
