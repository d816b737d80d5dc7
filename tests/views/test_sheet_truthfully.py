"""The rule sheet tells what teams cannot guess: what counters begin at, whose they are, what breaks a sequence."""

import re

import pytest

from tests.views.sheets import sentence, sheet

pytestmark = pytest.mark.usefixtures("without_drawing")

DOES = "actions: [{action: end}]"


def condition(written: str, more: str = "") -> str:
    """Return a condition in words."""
    said = sentence(f"triggers: [{{trigger: half_started}}], conditions: [{{{written}}}], {DOES}", more)
    return said.removeprefix("When a half starts, provided that ").removesuffix(": the half ends.")


# --- what counters and flags begin at -----------------------------------------------------------------------------------

BEGINNINGS = {
    "counters: {missed: {initial: 4}}": "- The counter “missed” is 4 when a half starts.",
    "counters: {lives: {initial: 3, per: robots}}": (
        "- There is a counter “lives” for each of the robots; it is 3 when a half starts."
    ),
    "counters: {laps: {keep: match}}": "- The counter “laps” is 0 when the match starts; it goes on from half to half.",
    "counters: {fuel_m: {initial: 20, per: robots, keep: match}}": (
        "- There is a counter “fuel (m)” for each of the robots; it is 20 when the match starts; it goes on from half to half."
    ),
    "flags: {open: {initial: true}}": "- The flag “open” is set when a half starts.",
    "flags: {handed_over: {keep: match}}": "- The flag “handed over” is not set when the match starts; it stays as it is from half to half.",
    "flags: {fresh: {per: yellow, initial: true}}": (
        "- There is a flag “fresh” for each of the yellow robots; it is set when a half starts."
    ),
}


@pytest.mark.parametrize(("written", "words"), BEGINNINGS.items(), ids=list(BEGINNINGS.values()))
def test_the_course_tells_what_a_counter_or_flag_begins_at(written, words):
    assert words in sheet(f"match: {{halves: 2}}\n{written}\n").splitlines()


def test_halves_of_different_length_are_told_one_by_one():
    text = sheet("match: {halves: 2, half_s: [600, 90], swap_sides: true}\n")
    assert "2 halves of 10 min and 90 s; the teams change sides between halves. " in text
    assert "2 halves of 5 min." in sheet("match: {halves: 2, half_s: [300, 300]}\n")


def test_in_a_match_of_one_half_nothing_is_said_about_the_next():
    text = sheet(
        "match: {halves: 1}\nflags: {open: {initial: true, keep: match}}\ncounters: {laps: {initial: 2, keep: match}}\n"
    )
    assert "The flag “open” is set when a half starts." in text
    assert "The counter “laps” is 2 when a half starts." in text
    assert "half to half" not in text


def test_a_counter_that_begins_at_0_and_a_flag_that_begins_unset_need_no_line():
    text = sheet(
        "match: {halves: 2}\ncounters: {goals: {}, laps: {per: robots}}\nflags: {away: {}, tired: {per: yellow}}\n"
    )
    assert not re.search("“(goals|laps|away|tired)”", text)


ANEW = {
    "counters: {stolen: {}}": "- A counter begins at 0 in every half.",
    "flags: {torn: {per: robots}}": "- A flag is not set when a half starts.",
    "counters: {stolen: {}}\nflags: {torn: {}}": "- A counter begins at 0 in every half. A flag is not set when a half starts.",
    "counters: {stolen: {}, laps: {keep: match}}": "- Any other counter begins at 0 in every half.",
    "flags: {torn: {}, open: {initial: true}}": "- Any other flag is not set when a half starts.",
}


@pytest.mark.parametrize(("written", "words"), ANEW.items(), ids=list(ANEW.values()))
def test_of_several_halves_it_is_said_that_each_begins_anew(written, words):
    assert words in sheet(f"match: {{halves: 2}}\n{written}\n").splitlines()
    assert words not in sheet(f"match: {{halves: 1}}\n{written}\n").splitlines()


def test_where_all_are_told_one_by_one_nothing_is_said_of_others():
    text = sheet("match: {halves: 2}\ncounters: {laps: {keep: match}}\nflags: {open: {initial: true}}\n")
    assert "Any other" not in text
    assert "A counter begins" not in text


# --- phases and draws -------------------------------------------------------------------------------------------------


def test_a_phase_that_a_rule_ends_promises_nothing_about_what_follows():
    text = sheet("phases: {first_task: {}}\nfirst_phase: first_task\n")
    assert "- The phase “first task” lasts until a rule begins another; the clock goes on." in text.splitlines()


COUNTED = {
    "phases: {pause: {lasts_s: {counter: long_s}}}": (
        "- The phase “pause” lasts as many s as the counter “long (s)” says when it begins, then “play” follows; "
        "the clock goes on."
    ),
    "timers: {rest: {lasts_s: {counter: long_s}}}": (
        "- The timer “rest” lasts as many s as the counter “long (s)” says when it starts."
    ),
    "timers: {rest: {lasts_s: {counter: own_s, entity: Y1}, per: robots}}": (
        "- The timer “rest” lasts as many s as the counter “own (s)” of Y1 says when it starts; "
        "there is one for each of the robots."
    ),
    "timers: {rest: {lasts_s: {counter: own_s, entity: each}, per: robots, starts: true}}": (
        "- There is a timer “rest” for each of the robots, which lasts as many s as its counter “own (s)” says when it "
        "starts; it starts with the half."
    ),
    "timers: {rest: {lasts_s: {counter: yellow}}}": "- The timer “rest” lasts as many s as the score of yellow says when it starts.",
}


@pytest.mark.parametrize(("written", "words"), COUNTED.items(), ids=list(COUNTED))
def test_a_length_from_a_counter_is_told_with_the_moment_in_which_it_is_read(written, words):
    counters = "counters: {long_s: {initial: 4}, own_s: {per: robots, initial: 4}}\n"
    assert words in sheet(f"{counters}{written}\n").splitlines()


def test_a_drawn_length_is_told_with_all_that_it_can_be():
    draws = "draws: {long: {values: [8, 5, 0.5, 8]}}\n"
    lasts = "lasts 0.5 s, 5 s or 8 s, as “long” is drawn"
    text = sheet(draws + "phases: {pause: {lasts_s: {draw: long}}}\n")
    assert f"- The phase “pause” {lasts}, then “play” follows; the clock goes on." in text.splitlines()
    text = sheet(draws + "timers: {rest: {lasts_s: {draw: long}}}\n")
    assert f"- The timer “rest” {lasts}." in text.splitlines()


def test_a_drawn_length_is_no_limit_that_a_rule_could_say_beforehand():
    text = sheet(
        "draws: {long: {values: [5, 8]}}\ntimers: {rest: {lasts_s: {draw: long}, starts: true}}\nrules:\n"
        "  over: {triggers: [{trigger: timer_expired, timer: rest}], actions: [{action: end}], says: 'After {limit} s.'}\n"
    )
    assert "[over] After … s. When the timer “rest” runs out" in text


@pytest.mark.parametrize(("reach", "where"), [("half", "in a half"), ("match", "in the match")])
def test_a_draw_without_repetition_is_told(reach, where):
    text = sheet(f"draws: {{gate: {{values: [west, east], not_again: {reach}}}}}\n")
    assert f"west or east; {where} none comes again before all have been drawn." in text


@pytest.mark.parametrize(
    ("asked", "told"),
    [
        ("equals: 2", "it is half 2"),
        ("equals: 2, negate: true", "it is not half 2"),
        ("at_least: 2", "it is half 2 or a later one"),
        ("at_most: 2", "it is half 2 or an earlier one"),
        ("at_least: 2, at_most: 3", "it is one of the halves 2 to 3"),
    ],
)
def test_the_number_of_the_half_is_told(asked, told):
    assert condition(f"condition: half, {asked}") == told


def test_a_phase_says_that_it_holds_the_robots():
    text = sheet("phases: {countdown: {lasts_s: 3, robots: held}}\nfirst_phase: countdown\n")
    assert (
        "- The phase “countdown” lasts 3 s, then “play” follows; the clock goes on. All robots are held meanwhile: their "
        "wheels stand still, whatever their programs say."
    ) in text.splitlines()
    assert "held" not in sheet("phases: {countdown: {lasts_s: 3, robots: free}}\nfirst_phase: countdown\n")


def test_a_phase_with_a_length_says_what_follows():
    text = sheet("phases: {pause: {lasts_s: 5, clock: stops}}\n")
    assert "- The phase “pause” lasts 5 s, then “play” follows; the clock stands still." in text.splitlines()


def test_yes_or_no_by_chance_is_written_as_in_the_scenario():
    text = sheet("draws: {doubled: {values: [true, false]}}\n")
    assert "Chance decides “doubled” when a half starts: true or false." in text
    drawn = condition("condition: drawn, draw: doubled, equals: true", "draws: {doubled: {values: [true, false]}}")
    assert drawn == "“true” was drawn as “doubled”"


# --- what is kept per entity and read as one ----------------------------------------------------------------------------

KEPT = "counters: {tries: {per: robots}, all: {}}\nflags: {armed: {per: yellow}}\ntimers: {rest: {lasts_s: 3, per: robots}}"


def test_a_broadcast_says_that_it_sums_and_that_any_is_enough():
    text = sheet(f"{KEPT}\nbroadcast: {{fields: {{n: {{counter: tries}}, f: {{flag: armed}}, a: {{counter: all}}}}}}\n")
    assert "| n | the sum of the counters “tries” of the robots |" in text
    assert "| f | whether the flag “armed” of any of the yellow robots is set |" in text
    assert "| a | the counter “all” |" in text


def test_points_say_that_they_sum():
    points = "[{counter: tries, weight: -1}, {flag: armed, weight: 2}]"
    said = sentence(
        f"triggers: [{{trigger: half_started}}], actions: [{{action: score, entrant: blue, points: {points}}}]", KEPT
    )
    assert "-1 times the sum of the counters “tries” of the robots" in said
    assert "2 if the flag “armed” of any of the yellow robots is set" in said


@pytest.mark.parametrize(
    ("written", "words"),
    [
        ("condition: counter, counter: tries, at_least: 2", "the sum of the counters “tries” of the robots is at least 2"),
        ("condition: flag, flag: armed", "any of the yellow robots has the flag “armed” set"),
        ("condition: flag, flag: armed, negate: true", "none of the yellow robots has the flag “armed” set"),
        ("condition: timer, timer: rest", "any of the robots has the timer “rest” running"),
        ("condition: timer, timer: rest, negate: true", "none of the robots has the timer “rest” running"),
        ("condition: timer, timer: rest, at_least: 2", "the longest running timer “rest” of the robots has run for at least 2 s"),
        ("condition: counter, counter: tries, entity: Y1, at_least: 2", "the counter “tries” of Y1 is at least 2"),
    ],
)  # fmt: skip
def test_a_condition_says_whether_it_sums_or_asks_for_any(written, words):
    assert condition(written, KEPT) == words


def test_a_rank_by_a_counter_kept_per_robot_says_that_it_sums_those_of_ones_own_robots():
    text = sheet(f"{KEPT}\nresult: {{rank: [{{counter: tries, order: ascending}}]}}\n")
    assert "a smaller value of the sum of the counters “tries” of its own robots" in text
    text = sheet(f"{KEPT}\nresult: {{rank: [{{time: ascending, plus: [{{counter: tries, weight: 3}}]}}]}}\n")
    assert "with 3 s added for each count of the sum of the counters “tries” of its own robots" in text


def test_a_bonus_in_seconds_is_taken_off_and_several_are_strung_together():
    plus = "[{counter: changes, weight: -5}, {counter: repeats, weight: 2}]"
    text = sheet(f"counters: {{changes: {{}}, repeats: {{}}}}\nresult: {{rank: [{{time: ascending, plus: {plus}}}]}}\n")
    assert (
        "The better one has a shorter time, with 5 s taken off for each count of the counter “changes” "
        "and 2 s added for each count of the counter “repeats”."
    ) in text


# --- sequences --------------------------------------------------------------------------------------------------------

WAY = "zones: {a: {shape: circle, centre_m: [0, 0], radius_m: 0.1}, b: {shape: circle, centre_m: [0, 0.3], radius_m: 0.1}, end: {shape: circle, centre_m: [0, -0.3], radius_m: 0.1}}\n"


def way(more: str) -> str:
    text = sheet(f"{WAY}sequences: {{abc: {{entity: Y1, steps: [a, b, end]{more}}}}}\n")
    return next(line for line in text.splitlines() if line.startswith("- The sequence "))


def test_a_sequence_that_breaks_says_what_breaks_it_and_what_follows():
    assert way(", wrong_step: break") == (
        "- The sequence “abc” is the way of Y1: the zone “a”, then the zone “b”, then the end; after the first step, "
        "entering one of these which is neither the last reached nor the next breaks it: it begins anew. "
        "It begins anew also when it is complete, and when a rule puts Y1 somewhere or takes it off the field."
    )


def test_a_sequence_that_ignores_says_that_nothing_is_lost():
    assert way("") == (
        "- The sequence “abc” is the way of Y1: the zone “a”, then the zone “b”, then the end; entering one of these out "
        "of turn changes nothing. It begins anew when it is complete, and when a rule puts Y1 somewhere or takes it off "
        "the field."
    )


STEPS_KEPT = "When a rule puts Y1 somewhere or takes it off the field, the steps made so far are kept."


@pytest.mark.parametrize(
    ("more", "again"),
    [
        ("", f"It begins anew when it is complete. {STEPS_KEPT}"),
        (", wrong_step: break", f"It begins anew also when it is complete. {STEPS_KEPT}"),
        (", cyclic: true", f"Back at the first step it is complete, and the next round has begun. {STEPS_KEPT}"),
    ],
)
def test_a_sequence_that_goes_on_where_its_entity_is_put_says_that_nothing_is_lost(more, again):
    assert way(f", when_placed: goes_on{more}").endswith(again)


def test_a_sequence_says_in_which_phases_it_is_followed_unless_it_is_in_all():
    heard = "triggers: [{trigger: sequence_completed, sequence: abc}], " + DOES
    text = (
        WAY + "phases: {pause: {lasts_s: 5}}\nsequences: {abc: {entity: Y1, steps: [a, b, end]}}\nrules: {it: {%s}}\n"
    )
    told = "It is followed in the phase “play” only, and begins anew after every other phase."
    assert told in sheet(text % heard)
    assert told not in sheet(text % f"phases: any, {heard}")


def test_a_sequence_of_each_says_whose_it_is_and_who_loses_his_steps():
    text = sheet(f"{WAY}sequences: {{abc: {{per: yellow, steps: [a, b, end]}}, one: {{per: ball, steps: [a, b]}}}}\n")
    told = "the zone “a”, then the zone “b”, then the end; entering one of these out of turn changes nothing. It begins anew"
    assert (
        f"- Each of the yellow robots has a sequence “abc” of its own: {told} when it is complete, and when a rule puts "
        "that robot somewhere or takes it off the field."
    ) in text
    assert "- The sequence “one” is the way of the ball: the zone “a”, then the zone “b”; " in text
    assert "when a rule puts the ball somewhere" in text


OWN = "sequences: {round: {per: robots, steps: [blue_goal, yellow_goal], wrong_step: break}}"
OF_EACH = {
    "trigger: sequence_completed, sequence: round": "the sequence “round” of one of the robots is complete",
    "trigger: sequence_completed, sequence: round, entity: Y1": "the sequence “round” of Y1 is complete",
    "trigger: sequence_broken, sequence: round, entity: [yellow, B1]": (
        "the sequence “round” of one of the yellow robots or B1 is broken"
    ),
}


@pytest.mark.parametrize(("trigger", "words"), OF_EACH.items(), ids=list(OF_EACH.values()))
def test_a_trigger_says_whose_sequence_it_hears(trigger, words):
    assert sentence(f"triggers: [{{{trigger}}}], {DOES}", OWN) == f"When {words}: the half ends."


AT_STEP = {
    "": "any of the robots has a sequence “round” that stands at the blue goal",
    ", negate: true": "none of the robots has a sequence “round” that stands at the blue goal",
    ", entity: Y1": "the sequence “round” of Y1 stands at the blue goal",
    ", entity: Y1, negate: true": "the sequence “round” of Y1 does not stand at the blue goal",
    ", of: all, entity: yellow": "all of the yellow robots have a sequence “round” that stands at the blue goal",
    ", of: {at_least: 2}": "at least 2 of the robots have a sequence “round” that stands at the blue goal",
}


@pytest.mark.parametrize(("whose", "words"), AT_STEP.items(), ids=list(AT_STEP.values()))
def test_a_condition_says_whose_sequence_it_asks_for(whose, words):
    assert condition(f"condition: sequence_at, sequence: round, step: blue_goal{whose}", OWN) == words


def test_a_rule_for_each_speaks_of_its_own_sequence():
    said = sentence(
        "for_each: robots, triggers: [{trigger: sequence_completed, sequence: round, entity: each}], conditions: "
        "[{condition: sequence_at, sequence: round, step: blue_goal, entity: each}], actions: "
        "[{action: sequence, sequence: round, entity: each}, {action: sequence, sequence: round}]",
        OWN,
    )
    assert said == (
        "For each of the robots, when its sequence “round” is complete, provided that its sequence “round” stands at the "
        "blue goal: its sequence “round” begins anew, then the sequence “round” of each of the robots begins anew."
    )


def test_a_flag_or_sequence_with_the_name_of_an_entrant_is_no_score():
    flag = "flags: {blue: {}}\nsequences: {yellow: {entity: ball, steps: [blue_goal, yellow_goal]}}"
    assert condition("condition: flag, flag: blue", flag) == "the flag “blue” is set"
    at = condition("condition: sequence_at, sequence: yellow, step: blue_goal", flag)
    assert at == "the sequence “yellow” stands at the blue goal"


def test_a_sequence_over_gates_says_which_way_counts():
    gates = "gates: {gate_1: {from_m: [-0.5, 0], to_m: [0.5, 0]}, gate_2: {from_m: [-0.5, 0.2], to_m: [0.5, 0.2]}}\n"
    text = sheet(f"{gates}sequences: {{way: {{entity: ball, steps: [gate_1, gate_2], wrong_step: break}}}}\n")
    assert "crossing one of these forward which is neither the last reached nor the next breaks it" in text
    mixed = sheet(f"{gates}sequences: {{way: {{entity: ball, steps: [gate_1, blue_goal]}}}}\n")
    assert "entering one of these or crossing it forward out of turn changes nothing" in mixed


# --- gates ------------------------------------------------------------------------------------------------------------


def test_the_sheet_says_what_forward_means_for_a_gate():
    text = sheet("gates: {line: {from_m: [-0.5, 0], to_m: [0.5, 0]}}\n")
    assert "A gate is crossed forward towards the side to which its short mark in the drawing points." in text
    assert "crossed forward" not in sheet("")


# --- language ---------------------------------------------------------------------------------------------------------

PAIRS = {
    "of: all": "both the ball and Y2 are in the pitch",
    "of: all, negate: true": "not both the ball and Y2 are in the pitch",
    "of: any": "the ball or Y2 is in the pitch",
    "of: any, negate: true": "neither the ball nor Y2 is in the pitch",
    "of: none": "neither the ball nor Y2 is in the pitch",
    "of: none, negate: true": "the ball or Y2 is in the pitch",
}


@pytest.mark.parametrize(("of", "words"), PAIRS.items(), ids=list(PAIRS))
def test_two_single_things_are_both_or_neither(of, words):
    assert condition(f"condition: in_zone, entity: [ball, Y2], zone: pitch, {of}") == words


def test_a_group_with_a_name_of_two_letters_is_no_pair():
    assert condition("condition: in_zone, entity: lr, zone: pitch, of: all", "groups: {lr: [B1, B2]}") == (
        "all of the robots “lr” are in the pitch"
    )


ONE = {
    "of: any": "Y1 is in the pitch",
    "of: all, negate: true": "Y1 is not in the pitch",
    "of: {at_least: 1}": "Y1 is in the pitch",
    "of: none": "Y1 is not in the pitch",
    "of: none, negate: true": "Y1 is in the pitch",
}


@pytest.mark.parametrize("who", ["keepers", "[Y1]", "Y1"])
@pytest.mark.parametrize(("of", "words"), ONE.items(), ids=list(ONE))
def test_of_a_single_thing_none_is_the_opposite(of, words, who):
    assert condition(f"condition: in_zone, entity: {who}, zone: pitch, {of}", "groups: {keepers: [Y1]}") == words


def test_of_three_things_it_is_all_of_them():
    said = condition("condition: in_zone, entity: [ball, Y1, Y2], zone: pitch, of: all")
    assert said == "all of the ball, Y1 and Y2 are in the pitch"


def test_a_name_of_one_letter_says_of_what_kind_it_is():
    said = sentence(f"triggers: [{{trigger: enters, entity: ball, zone: b}}], {DOES}", WAY)
    assert said == "When the ball enters the zone “b”: the half ends."


OBSTACLES = """
obstacles:
  post: {shape: cylinder, centre_m: [0.45, 0], radius_m: 0.03, colour: red}
  fence: {shape: wall, from_m: [-0.6, 0.2], to_m: [-0.3, 0.55]}
"""


def test_colours_of_obstacles_stand_on_the_sheet_if_somebody_chose_one():
    text = sheet(OBSTACLES)
    assert "| obstacle | place | what it is | height | colour | can be moved |" in text
    assert "| post | (0.45, 0) | cylinder, radius 3 cm | 9 cm | red | no |" in text
    plain = sheet(OBSTACLES.replace(", colour: red", ""))
    assert "| obstacle | place | what it is | height | can be moved |" in plain
