"""What is on the rule sheet, and where."""

import re
from collections import Counter
from html.parser import HTMLParser
from pathlib import Path

import pytest

from rcj_challenges.scenario.load import load, load_text
from rcj_challenges.views.sheet import sheet_html, sheet_markdown
from rcj_challenges.views.sheet.page import sheet_of
from tests.views.sheets import HEAD, section, sentence, sheet

ROOT = Path(__file__).resolve().parents[2]
SHIPPED = sorted((ROOT / "scenarios").rglob("*.yaml"))
RECIPES = sorted((ROOT / "docs" / "recipes").glob("*.yaml"))
IT = "triggers: [{trigger: half_started}]"
END = "actions: [{action: end}]"
RULE = f"rules: {{it: {{{IT}, {END}}}}}\n"


class _Tags(HTMLParser):
    def __init__(self):
        super().__init__()
        self.open, self.seen, self.text = [], set(), ""

    def handle_starttag(self, tag, attrs):
        self.seen.add(tag)
        if tag not in ("meta", "br"):
            self.open.append(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        self.text += data


def read(page: str) -> _Tags:
    tags = _Tags()
    tags.feed(page)
    return tags


# --- the page ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("path", SHIPPED, ids=lambda path: path.stem)
def test_page_is_well_formed_needs_nothing_from_elsewhere_and_has_the_legend(path):
    loaded = load(path, ["title='A <b>bold</b> title'"])
    tags = read(sheet_html(loaded.scenario, loaded.roster))
    assert tags.open == []
    assert not tags.seen & {"script", "link", "img", "iframe", "b"}
    assert all(f"{name}: " in tags.text for name in (*loaded.scenario.zones, *loaded.scenario.robots))


def test_markdown_has_a_picture_or_what_stands_for_it():
    loaded = load("match")
    assert "\n\n![The field](a.svg)\n\n" in sheet_markdown(loaded.scenario, loaded.roster, "![The field](a.svg)")
    inline = sheet_markdown(loaded.scenario, loaded.roster).partition("<svg")[2].partition("</svg>")[0]
    assert "\n\n" not in inline


def test_rows_of_markdown_tables_have_as_many_cells_as_their_heads():
    loaded = load("match")
    text = sheet_markdown(loaded.scenario, loaded.roster, "")
    tables = [block.splitlines() for block in text.split("\n\n") if block.startswith("|")]
    assert len(tables) == 2
    for head, *rows in tables:
        assert {row.replace("\\|", "").count("|") for row in rows} == {head.count("|")}


# --- for people, and the appendix -------------------------------------------------------------------------------------


def test_players_read_description_scoring_and_what_rules_say_before_the_appendix():
    loaded = load("match")
    text = sheet_markdown(loaded.scenario, loaded.roster, "").replace("\\", "")
    lead, _, appendix = text.partition("\n## Appendix")
    assert re.findall("^## (.*)$", lead, re.MULTILINE) == ["How to win", "Scoring", "Rules", "Field", "Programs"]
    assert loaded.scenario.rules["kickoff_blue"].says in section(lead, "Rules")
    assert "[kickoff_blue]" not in lead
    assert "[kickoff_blue] When" in appendix


@pytest.mark.parametrize("path", SHIPPED, ids=lambda path: path.stem)
def test_every_rule_that_has_a_sentence_is_on_the_sheet(path):
    loaded = load(path)
    text = sheet_markdown(loaded.scenario, loaded.roster, "").replace("\\", "")
    assert all(f"[{name}] " in text for name, rule in loaded.scenario.rules.items() if rule.says)


def test_rule_with_sheet_false_is_nowhere_on_it():
    surprise = "actions: [{action: score, entrant: blue, points: 7}, {action: emit, event: SURPRISE}], says: A gift."
    shown = sheet(f"rules: {{surprise: {{{IT}, {surprise}}}}}\n")
    assert "[surprise]" in shown
    assert "| A gift. | 7 for blue |" in shown
    hidden = sheet(f"rules: {{surprise: {{{IT}, {surprise}, sheet: false}}}}\n")
    assert not re.search("surprise|gift|7 points", hidden, re.IGNORECASE)


def test_rules_that_only_keep_books_are_left_out_unless_they_have_a_sentence():
    counters = "counters: {laps: {}}\n"
    count = f"{IT}, actions: [{{action: count, counter: laps}}, {{action: emit, event: E}}]"
    assert "[it]" not in sheet(f"{counters}rules: {{it: {{{count}}}}}\n")
    assert "[it]" in sheet(f"{counters}rules: {{it: {{{count}, says: A lap.}}}}\n")
    assert "[it]" in sheet(RULE)


def test_limits_phases_and_exclusions_of_a_rule_stand_with_it():
    rule = f"cooldown_s: 3, max_executions: 2, phases: [pause], exclusive: x, {IT}, {END}"
    text = sheet(f"phases: {{pause: {{}}}}\nrules: {{a: {{{rule}}}, b: {{{rule}}}}}\n")
    assert (
        "[a] When a half starts: the half ends (at most once in 3 s; at most 2 times a half; in the phase “pause”)."
        in text
    )
    assert "Of [a] and [b] only the first" in text


@pytest.mark.parametrize("path", [*SHIPPED, *RECIPES], ids=lambda path: path.stem)
def test_no_sentence_is_on_a_sheet_twice(path, without_drawing):
    loaded = load(path)
    page = sheet_of(loaded.scenario, loaded.roster)
    texts = [page.description]
    for block in (block for part in (*page.lead, *page.appendix) for block in part.blocks):
        texts += [block] if isinstance(block, str) else getattr(block, "entries", ())
        texts += [row[0] for row in getattr(block, "rows", ()) if " " in row[0]]
    found = Counter(one for text in texts for one in re.split(r"(?<=[.!?]) ", text))
    assert [one for one, times in found.items() if times > 1] == []


def test_rules_that_are_worded_alike_are_in_full_once():
    rule = "triggers: [{{trigger: enters, entity: ball, zone: {0}_goal}}], actions: [{{action: score, entrant: {0}, points: {1}}}]"
    both = [f"{one}: {{{rule.format(one, points)}}}" for one, points in (("blue", 2), ("yellow", 3))]
    lines = section(sheet(f"rules: {{{', '.join(both)}}}\n"), "Rules in full").splitlines()
    assert lines[-1] == "2. [yellow] As [blue], with yellow for blue; 3 for 2."


# --- the appendix and the page of a preset ------------------------------------------------------------------------------


def test_the_appendix_has_what_the_preset_has_not_and_what_is_missing():
    changes = """
balls: {ball: {mass_kg: 0.06}, red: {start_m: [0.3, 0]}}
robots: {Y3: null, Y1: {without: [gps], start: {x_m: 0.2}}}
entrants: {yellow: {robots: {Y3: null}}}
"""
    text = sheet(changes + RULE).partition("# Appendix")[2]
    assert [line for line in text.splitlines() if line.startswith("| ") and "---" not in line] == [
        "| ball | start | diameter | mass | sends infra-red |",
        "| ball | (0, 0) | 4.2 cm | 0.06 kg | yes |",
        "| red | (0.3, 0) | 4.2 cm | 0.05 kg | yes |",
        "| robot | colour | program | kit | start (x, y in m) |",
        "| Y1 | yellow | of yellow | v2 | (0.2, -0.3), ± 7.5 cm in x, ± 7.5 cm in y, facing 90° counter-clockwise from +x |",
        "| device of v2 | robots | what it is |",
        "| gps | B1, B2, B3, Y2 | position of the robot |",
    ]  # fmt: skip
    assert "Not here: Y3." in text
    assert "rcj-challenge sheet soccersim_v2" in text


@pytest.mark.parametrize(("base", "text"), [("soccersim_2021", RULE), ("empty_field", RULE), ("soccersim_v2", RULE)])
def test_the_base_is_the_preset_that_leaves_least_to_say(base, text):
    loaded = load_text(HEAD.replace("soccersim_v2", base) + text)
    assert sheet_of(loaded.scenario, loaded.roster).base == base


def test_the_page_of_a_preset_has_all_of_it_and_how_rules_are_judged():
    titles = re.findall("^## (.*)$", sheet(""), re.MULTILINE)
    assert titles == [
        "The match", "Field", "Programs", "Field in full", "Robots", "What programs receive", "How rules are judged",
        "Limits of programs",
    ]  # fmt: skip
    assert "Zones that are named together count as one" in section(sheet(""), "How rules are judged")


# --- scoring ----------------------------------------------------------------------------------------------------------


def test_points_of_rules_that_say_the_same_are_one_row_with_whose_they_are():
    gives = "{IT}, actions: [{{action: score, entrant: {0}, points: {1}}}], says: A gift."
    rules = [gives.format(*one, IT=IT) for one in (("blue", 7), ("yellow", 7), ("yellow", 9))]
    same, other = (
        ", ".join(f"{name}: {{{rule}}}" for name, rule in zip("ab", pair, strict=True))
        for pair in (rules[:2], rules[::2])
    )
    assert "| A gift. | 7 |" in sheet(f"rules: {{{same}}}\n")
    assert "| A gift. | 7 for blue; 9 for yellow |" in sheet(f"rules: {{{other}}}\n")
    counted = gives.format(
        "{param: this}", "{flag: bold, entity: {param: this}, plus: 1}", IT="repeat_for: teams, " + IT
    )
    calculated = sheet(
        f"tables: {{teams: {{blue: {{}}, yellow: {{}}}}}}\nflags: {{bold: {{per: entrants}}}}\nrules: {{a: {{{counted}}}}}\n"
    )
    plus = "1, plus 1 if the flag “bold” of"
    assert f"| A gift. | blue: {plus} blue is set; yellow: {plus} yellow is set |" in calculated
    alone = sheet(f"entrants: {{yellow: null}}\nrules: {{a: {{{rules[0]}}}}}\n")
    assert "| A gift. | 7 |" in alone


def test_programs_are_where_no_other_colour_has_its_name():
    rows = section(
        sheet(f"entrants: {{blue: null, yellow: {{robots: {{Y1: null, Y2: null}}}}}}\n{RULE}"), "Programs"
    ).splitlines()
    assert rows[2:] == ["| Y3 | yellow | robot3/robot3.py, else robot.py |"]
    both = section(sheet(RULE), "Programs").splitlines()[2]
    assert both.startswith("| B1 and Y1 | blue and yellow | rcj_soccer_team_blue/rcj_soccer_team_blue.py, else robot1/")


def test_rules_that_give_no_points_are_not_ranked_unless_the_scenario_says_how():
    assert section(sheet(RULE), "Scoring") == "No rule gives points."
    assert "The team with fewer points wins." in sheet(f"{RULE}result: {{rank: [{{score: each, better: less}}]}}\n")


# --- robots, field and programs -----------------------------------------------------------------------------------------


def test_devices_of_single_robots_are_rows_of_their_kit():
    text = sheet(
        "robots: {Y1: {devices: {eye: {device: sonar, bearing_rad: 0, range_m: 2}}, without: [supervisor receiver]}}\n"
        + RULE
    )
    rows = [line for line in section(text, "Robots").splitlines() if line.startswith(("| eye |", "| supervisor"))]
    assert [row.split(" | ")[1] for row in rows] == ["B1, B2, B3, Y2, Y3", "Y1"]


def test_params_in_the_description_are_those_that_are_played():
    text = f"params: {{n: 3}}\ndescription: Collect {{n}} of them.\n{RULE}"
    loaded = load_text(HEAD + text, ["n=4"])
    assert "Collect 4 of them." in sheet_markdown(loaded.scenario, loaded.roster)


def test_course_lists_what_runs_beside_the_rules():
    text = sheet(f"""
phases: {{pause: {{lasts_s: 3, clock: stops, robots: held}}}}
timers: {{rest: {{lasts_s: 4, per: robots, starts: true}}}}
counters: {{laps: {{per: robots, initial: 2}}, none: {{}}}}
draws: {{side: {{values: [west, east, west], not_last: true}}}}
sequences: {{way: {{entity: ball, steps: [blue_goal, yellow_goal], wrong_step: break}}}}
{RULE}""")
    entries = section(text, "Course").splitlines()[2:]
    assert [entry.partition(";")[0].partition(",")[0] for entry in entries] == [
        "- The phase “pause” lasts 3 s",
        "- The timer “rest” lasts 4 s",
        "- The counter “laps” of each of the robots is 2 when a half starts.",
        "- Chance decides “side” when a half starts: west (2 of 3) or east (1 of 3)",
        "- The sequence “way” of the ball: the blue goal",
    ]


def test_a_role_that_begins_with_nothing_may_be_left_to_chance():
    role = "roles: {{called: {{of: [Y1, Y2], initial: none, order: {}}}}}\n"
    by_chance = section(sheet(role.format("random, not_last: true") + RULE), "Course")
    assert by_chance == (
        "- Nothing is “called” when a half starts; rules say when that is Y1 or Y2, or let chance decide, never the same twice "
        "running."
    )
    assert "chance" not in section(sheet(role.format("listed") + RULE), "Course")


def test_a_period_has_its_name_in_full_rules_too():
    more = "match: {halves: 3, half_s: 60, called: hole}\ncounters: {n: {}}"
    rule = f"{IT}, actions: [{{action: count, counter: n, to: {{word: halftime}}}}, {{action: end}}], says: T."
    assert sentence(rule, more).endswith("is set to the number of the hole, then the hole ends.")


def test_a_ball_is_kicked_at_the_speed_of_a_counter():
    kick = "{towards: {spot: centre}, speed_mps: {counter: power}}"
    rule = f"triggers: [{{trigger: half_started}}], actions: [{{action: place, entity: ball, at: start, kick: {kick}}}]"
    rolls = "and rolls with the counter “power” as its speed in m/s (at most 3) towards the spot “centre”."
    assert sentence(rule, "counters: {power: {initial: 1}}").endswith(rolls)


@pytest.mark.parametrize(
    ("condition", "words"),
    [
        ("timer: run, above: {timer: run, entity: others}",
         "the time in s that its timer “run” has run is more than the time in s that the timer “run” of the other team has run"),
        ("flag: lit, entity: others, negate: true", "the flag “lit” of the other team is not set"),
    ],
)  # fmt: skip
def test_of_two_teams_the_other_one_is_compared(condition, words):
    more = "timers: {run: {per: entrants}}\nflags: {lit: {per: entrants}}"
    rule = f"for_each: entrants, {IT}, conditions: [{{{condition}}}], actions: [{{action: end}}], says: T."
    assert f"provided that {words}: " in sentence(rule, more)


def test_how_to_win_is_of_whole_sentences():
    text = "result: {rank: [{score: each, times: 2, better: more, says: points count twice}, {word: time_s, better: less, says: time!}]}\n"
    assert "Points count twice. Time!" in section(sheet(text + RULE), "How to win")


def test_what_a_timer_of_each_lasts_is_read_for_each():
    more = "counters: {laps: {per: robots}}\ntimers: {t: {per: robots, lasts_s: {counter: laps, plus: 1}}}"
    used = f"rules: {{it: {{for_each: robots, {IT}, actions: [{{action: timer, timer: t}}]}}}}"
    course = section(sheet(f"{more}\n{used}\n"), "Course")
    assert "The timer “t” lasts as many s as 1, plus its counter “laps”; there is one for each of the robots." in course


def test_what_is_calculated_stands_in_brackets_in_a_list():
    points = "{highest: [{counter: n, times: 2, plus: 3}, 1]}"
    rule = f"{IT}, actions: [{{action: score, entrant: blue, points: {points}}}], says: T."
    assert "the highest of (3, plus 2 times the counter “n”) and 1" in sentence(rule, "counters: {n: {}}")


def test_a_timer_of_each_is_its_own():
    more = "timers: {run: {per: entrants}}\ncounters: {run_s: {per: entrants}}"
    counts = "for_each: entrants, triggers: [{trigger: half_ended}], actions: [{action: count, counter: run_s, to: {timer: run}}]"
    assert sentence(f"{counts}, says: T.", more).endswith("is set to the time in s that its timer “run” has run.")


def test_a_counter_that_keeps_the_best_is_explained():
    words = "The counter “best (s)” has no value when a half starts; of the values that it is given, the lowest counts."
    assert words in sheet(f"counters: {{best_s: {{keeps: lowest}}}}\n{RULE}")


def test_guidelines_are_listed_with_limits_and_prices():
    loaded = load("workshop")
    text = section(sheet_markdown(loaded.scenario, loaded.roster).replace("\\", ""), "Robots that teams design")
    rows = [[cell.strip() for cell in line.split("|")[1:-1]] for line in text.splitlines() if line.startswith("|")]
    parts = {row[0]: row[1:] for row in rows}
    guideline = loaded.scenario.guidelines["workshop"]
    assert {f"drive {name}" for name in guideline.drives} | set(guideline.devices) <= parts.keys()
    assert parts["kicker"][:2] == ["400", "1"]
    assert "up to 0.8, up to 1: 100 points more" in parts["kicker"][2]
    assert all(words in text for words in ("3000 points", "diameter of 0.12 m", "up to 0.4 kg", "up to 3 designs"))
