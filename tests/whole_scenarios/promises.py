"""What holds for every file that somebody may write, and cannot be argued with.

Each promise raises `BrokenPromiseError`, with the scenario, so that whoever sees it can try it.
"""

from __future__ import annotations

import json
import re
import time
from collections.abc import Iterator
from contextlib import contextmanager
from html.parser import HTMLParser
from pathlib import Path
from typing import Any
from xml.etree import ElementTree as ET

import jsonschema

from rcj_challenges.core.diagnostics import Diagnostic
from rcj_challenges.expect.runner import run_test
from rcj_challenges.scenario.errors import ScenarioError, place_of
from rcj_challenges.scenario.json_schema import scenario_schema
from rcj_challenges.scenario.lint.registry import lint
from rcj_challenges.scenario.load import Loaded, load, load_resolved, load_text
from rcj_challenges.scenario.reading.yaml_strict import parse_text
from rcj_challenges.scenario.tree import plain
from rcj_challenges.views.drawing import draw_scenario
from rcj_challenges.views.replay.page import write_replay
from rcj_challenges.views.sheet import sheet_html, sheet_markdown
from rcj_challenges.views.stats.run import run_stats
from tests.judging_again import judged_again, reflog_of
from tests.whole_scenarios.contradicting import contradictions
from tests.whole_scenarios.playing import played, puppet_show
from tests.whole_scenarios.wholes import without_what_is_refused

MAX_CPU_S = 2.0
FILE = "made_up.yaml"
_SCHEMA = jsonschema.Draft202012Validator(scenario_schema())
_OURS = re.compile(
    r"Traceback|<class|<function| object at 0x|pydantic|ValidationError|Entries\(|Leaf\(|Mark\(|Items\(|type=|"
    r"HowMany|NoneType|\bNone\b(?!')|Input should"
)
"""What only contributors to the project can read."""
_MEANT = re.compile(r"'([^']*)'[^']*; did you mean '([^']*)'\?")


class BrokenPromiseError(AssertionError):
    """Something that was promised does not hold."""

    def __init__(self, what: str, text: str) -> None:
        super().__init__(f"{what}\n--- the scenario, as {FILE}: ---\n{text}")
        self.what = what


@contextmanager
def promised(what: str, text: str, most_cpu_s: float = MAX_CPU_S) -> Iterator[None]:
    """Turn whatever goes wrong, and what takes too long, into a broken promise."""
    began = time.process_time()
    try:
        yield
    except BrokenPromiseError:
        raise
    except Exception as error:
        raise BrokenPromiseError(f"{what}: {type(error).__name__}: {error}", text) from error
    took_s = time.process_time() - began
    if took_s > most_cpu_s:
        raise BrokenPromiseError(f"{what}: took {took_s:.1f} s", text)


def check_all(text: str, folder: Path, seed: int, *, mend: bool = False, play: bool = False) -> bool:
    """Look at any text, and at all that comes of it.

    Args:
        text: the scenario.
        folder: for what is written.
        seed: of what is random in a match.
        mend: take out what is refused, until something is left that is taken.
        play: also play a match, and extend it.

    Returns:
        Whether it was taken.

    Raises:
        BrokenPromiseError: with the scenario.
    """
    loaded = look_at(text)
    if loaded is None and mend:
        refused: list[tuple[str, ScenarioError]] = []
        with promised("load", text, most_cpu_s=30):
            left = without_what_is_refused(text, refused)
        for one, error in refused:
            check_refusal(one, error)
        text, loaded = left or (text, None)
    if loaded is None:
        return False
    check_reading(text, loaded)
    check_judging(text, loaded, seed)
    if play:
        check_extending(text, loaded, folder)
        check_playing(text, folder, seed)
    return True


# --- any text ---------------------------------------------------------------------------------------------------------


def look_at(text: str) -> Loaded | None:
    """Load any text: it is taken, or refused in words; returns what was loaded."""
    with promised("load", text):
        try:
            loaded = load_text(text, file=FILE)
        except ScenarioError as error:
            check_refusal(text, error)
            return None
    return loaded


def check_refusal(text: str, error: ScenarioError) -> None:
    """Look at the messages with which a text was refused."""
    lines = len(re.split("\r\n|\r|\n|\x85|\u2028|\u2029", text)) + 1
    if not error.diagnostics:
        raise BrokenPromiseError("refused without a word", text)
    for problem in error.diagnostics:
        wrong = _wrong_with(problem, lines)
        if wrong:
            raise BrokenPromiseError(f"{wrong}: {problem}", text)


def _wrong_with(problem: Diagnostic, lines: int) -> str:
    message, place = problem.message, place_of(problem)
    meant = _MEANT.search(f"{message}; {problem.help}")
    expected = re.search(r"expected (.+?), found (.+)$", message)
    wrongs = {
        "a line that is not in the file": place.file == FILE and not 1 <= (place.line or 0) <= lines,
        "a column that is none": place.line and (place.column or 0) < 1,
        "no readable message": not message.strip()
        or message != message.strip()
        or "\n" in message
        or len(str(problem)) > 1500,
        "a message for programmers": _OURS.search(re.sub(r"'[^']*'", "''", message)),
        "what was written is what is meant": meant and meant[1] == meant[2],
        "what was found is what is expected": expected and expected[1] == expected[2],
    }
    return next((what for what, wrong in wrongs.items() if wrong), "")


# --- what is taken ----------------------------------------------------------------------------------------------------


def check_reading(text: str, loaded: Loaded) -> None:
    """Look at a scenario that was taken, without playing it."""
    with promised("schema", text):
        data = plain(parse_text(text, FILE))
        error = jsonschema.exceptions.best_match(_SCHEMA.iter_errors(data))
        if error is not None:
            where = f"{error.json_path}: {error.message[-300:]}"
            raise BrokenPromiseError(f"the schema refuses what is taken: {where}", text)
    with promised("lint", text):
        findings = list(map(str, lint(loaded)))
        if findings != list(map(str, lint(loaded))):
            raise BrokenPromiseError("lint says something else the second time", text)
        for one in findings:
            form = r"warning\[[a-z-]+\]: .+\n  --> \S+:\d+:\d+.*\nhelp: .+$"
            if not re.match(form, one) or _OURS.search(re.sub(r"'[^']*'", "''", one)):
                raise BrokenPromiseError(f"no readable finding: {one}", text)
    with promised("draw", text):
        check_drawing(text, loaded)
    with promised("sheet", text):
        check_sheet(text, loaded)
    with promised("read again", text):
        again = load_resolved(json.loads(json.dumps(loaded.resolved)))
        if again.resolved != loaded.resolved:
            raise BrokenPromiseError("what a record holds is another scenario", text)
        whole = json.dumps(_given({**loaded.resolved, "extends": None}), ensure_ascii=False)
        if load_text(whole, file=FILE).resolved | {"extends": 0} != loaded.resolved | {"extends": 0}:
            raise BrokenPromiseError("with all that its base brings in one file it is another scenario", text)


def _given(node: Any) -> Any:
    """Return data without what is null, which in a file would remove something."""
    if isinstance(node, dict):
        return {key: _given(inner) for key, inner in node.items() if inner is not None}
    return [_given(inner) for inner in node] if isinstance(node, list) else node


def check_drawing(text: str, loaded: Loaded) -> None:
    """Look at the drawing: well formed, the same each time, and everything written inside."""
    svg = draw_scenario(loaded.scenario, loaded.roster)
    if svg != draw_scenario(loaded.scenario, loaded.roster):
        raise BrokenPromiseError("two drawings differ", text)
    root = ET.fromstring(svg)
    _, _, width, height = map(float, root.attrib["viewBox"].split())
    for one in (one for one in root.iter() if one.tag.endswith("}text")):
        words, (x, y) = "".join(one.itertext()), (float(one.attrib["x"]), float(one.attrib["y"]))
        if not (0 <= x <= width and 0 <= y <= height):
            raise BrokenPromiseError(f"{words!r} at ({x}, {y}) is not within {width} x {height}", text)
    numbers = " ".join(value for one in root.iter() for key, value in one.attrib.items() if key != "aria-label")
    if re.search(r"\b(nan|inf)\b", numbers):
        raise BrokenPromiseError("a number of the drawing is none", text)


def check_sheet(text: str, loaded: Loaded) -> None:
    """Look at the rule sheet: the same each time, every rule with a sentence is in it, and no Python."""
    scenario, roster = loaded.scenario, loaded.roster
    markdown, html = sheet_markdown(scenario, roster), sheet_html(scenario, roster)
    if markdown != sheet_markdown(scenario, roster) or html != sheet_html(scenario, roster):
        raise BrokenPromiseError("two sheets differ", text)
    for name, rule in scenario.rules.items():
        if rule.says and rule.sheet and f"[{name}]" not in markdown.replace("\\", ""):
            raise BrokenPromiseError(f"the sheet does not speak of the rule {name}", text)
    if re.search(r"<class| object at 0x|Entries\(|(?<![\w'“\[])None(?![\w'”\]])", re.sub(r"“[^”]*”", "", markdown)):
        found = re.search(r".{60}(<class| object at 0x|Entries\(|(?<![\w'“])None(?![\w'”])).{60}", markdown, re.DOTALL)
        raise BrokenPromiseError(f"a sheet for programmers: {found and found[0]}", text)
    _Balanced(text).feed(html)


class _Balanced(HTMLParser):
    """Looks whether all that is opened is closed."""

    _EMPTY = frozenset({"meta", "br", "img", "link", "hr", "col", "input"})

    def __init__(self, text: str) -> None:
        super().__init__()
        self._text = text
        self._open: list[str] = []

    def handle_starttag(self, tag: str, attrs: Any) -> None:
        if tag not in self._EMPTY:
            self._open.append(tag)
        if tag == "script":
            raise BrokenPromiseError("the sheet has a script in it", self._text)

    def handle_endtag(self, tag: str) -> None:
        if not self._open or self._open.pop() != tag:
            raise BrokenPromiseError(f"the sheet closes {tag} which was not opened", self._text)


def check_judging(text: str, loaded: Loaded, seed: int) -> None:
    """Let the referee judge the tests of a scenario, and scripted nonsense; twice the same."""
    # With the inherited tests of the match that may be half an hour of play, in which robots wait for room.
    with promised("test", text, most_cpu_s=40):
        for name in loaded.scenario.expect:
            if run_test(loaded, name) != run_test(loaded, name):
                raise BrokenPromiseError(f"the test {name} comes out otherwise the second time", text)
    if not loaded.roster.entities:
        return
    with promised("judge", text, most_cpu_s=15):
        (first, play), (second, _) = (puppet_show(loaded, seed, 250) for _ in range(2))
        if not loaded.repeated:
            for wrong in contradictions(lint(loaded), loaded.scenario, play):
                raise BrokenPromiseError(f"lint was wrong: {wrong} (seed {seed})", text)
        if first != second:
            raise BrokenPromiseError(f"the referee judges otherwise the second time (seed {seed})", text)


def check_playing(text: str, out: Path, seed: int) -> None:
    """Play a short match: the same digest twice, and the record judged again gives the same reflog."""
    short = load_text(text, ["match.half_s=2"] if seed % 2 else ["match.halves=2", "match.half_s=1"], file=FILE)
    with promised("play", text, most_cpu_s=60):
        (folder, result), (_, again) = (played(short, out, seed) for _ in range(2))
        if result["digest"] != again["digest"] or not result["complete"]:
            raise BrokenPromiseError(f"the match comes out otherwise the second time (seed {seed})", text)
        if judged_again(folder) != reflog_of(folder):
            raise BrokenPromiseError(f"judged again the reflog is another one (seed {seed})", text)
        for line in (folder / "referee.jsonl").read_text("utf-8").splitlines():
            json.loads(line, parse_constant=_no_number)
    if not any(half["ticks"] for half in result["halves"]):
        return
    with promised("tell", text, most_cpu_s=30):
        page = write_replay(folder).read_text("utf-8")
        if "NaN" in page.partition('type="application/json">')[2][:100_000] and "NaN" not in text:
            raise BrokenPromiseError(f"the page has a number that is none (seed {seed})", text)
        run_stats(folder)


def _no_number(word: str) -> float:
    raise ValueError(f"{word} is no JSON")


def check_extending(text: str, loaded: Loaded, folder: Path) -> None:
    """Write a scenario that extends this one and says nothing else: it must be the same."""
    (folder / "base.yaml").write_text(text, encoding="utf-8")
    more = folder / "more.yaml"
    scenario = loaded.scenario
    more.write_text(
        f"schema_version: 2\nid: {scenario.id}\ntitle: {json.dumps(scenario.title, ensure_ascii=False)}\nextends: ./base.yaml\n",
        encoding="utf-8",
    )
    with promised("extend", text):
        extended = load(more)
        if extended.resolved != loaded.resolved | {"extends": extended.resolved["extends"]}:
            raise BrokenPromiseError("what extends it and says nothing else is another scenario", text)
        lint(extended)
