"""What is on the rule sheet, and where."""

import re
from html.parser import HTMLParser
from pathlib import Path

import pytest

from rcj_challenges.scenario.load import load, load_text
from rcj_challenges.views.sheet import sheet_html, sheet_markdown
from tests.views.sheets import HEAD, section, sheet

ROOT = Path(__file__).resolve().parents[2]
SHIPPED = sorted((ROOT / "scenarios").rglob("*.yaml"))
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
    assert len(tables) > 4
    for head, *rows in tables:
        assert {row.replace("\\|", "").count("|") for row in rows} == {head.count("|")}


# --- for people, and the appendix -------------------------------------------------------------------------------------


def test_players_read_description_scoring_and_what_rules_say_before_the_appendix():
    loaded = load("match")
    text = sheet_markdown(loaded.scenario, loaded.roster, "").replace("\\", "")
    lead, _, appendix = text.partition("\n## Appendix")
    assert re.findall("^## (.*)$", lead, re.MULTILINE) == ["The match", "Scoring", "Rules", "What to hand in"]
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
    assert "| A gift. | blue | 7 |" in shown
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


# --- scoring ----------------------------------------------------------------------------------------------------------


def test_rules_that_give_no_points_are_not_ranked_unless_the_scenario_says_how():
    assert section(sheet(RULE), "Scoring") == "No rule gives points."
    assert "Fewer points are better." in sheet(f"{RULE}result: {{rank: [{{score: each, better: less}}]}}\n")


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
    assert "up to 0.8: 0 points more, up to 1: 100 points more" in parts["kicker"][2]
    assert all(words in text for words in ("3000 points", "diameter of 0.12 m", "up to 0.4 kg", "up to 3 designs"))
