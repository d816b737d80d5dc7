"""Write docs/reference-scenario.md: every word of the scenario language, from the models and the examples.

Also the table of docs/submission.md, from the codes.

Sentences, types, units and defaults come from the models; the examples from the words themselves
and, for what is not a word of rules, from ``docs/words/*.yaml``. Tests run all of them.

Usage: ``python scripts/write_reference.py [--check]``; with ``--check`` nothing is written, exit status 1 if stale.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal, get_args, get_origin

from pydantic import BaseModel
from pydantic.fields import FieldInfo
from pydantic_core import PydanticUndefined

from rcj_challenges.chassis import CHASSIS, AnyChassis
from rcj_challenges.cli.explain import all_codes
from rcj_challenges.devices import DEVICES, AnyDevice
from rcj_challenges.rules.actions import ACTIONS, AnyAction
from rcj_challenges.rules.base import Vocabulary
from rcj_challenges.rules.comparison import Compared
from rcj_challenges.rules.conditions import CONDITIONS, AnyCondition
from rcj_challenges.rules.fields import NAME_RULE, Colour, DurationS, EventName, Name, Names, Point
from rcj_challenges.rules.number import NumberValue
from rcj_challenges.rules.placement import Facing, Kick, Mirror, Towards
from rcj_challenges.rules.places import PLACES, At
from rcj_challenges.rules.ranked import AnyRanked, Ranked
from rcj_challenges.rules.several_conditions import Alternative
from rcj_challenges.rules.triggers import TRIGGERS, AnyTrigger
from rcj_challenges.rules.triggers.tips_over import TipsOver
from rcj_challenges.rules.values import VALUES, Amount, Lasts, Limit, Value, Waits
from rcj_challenges.rules.values.counter import CounterValue
from rcj_challenges.rules.values.draw import DrawValue
from rcj_challenges.rules.values.flag import FlagValue
from rcj_challenges.rules.values.folded import Several
from rcj_challenges.scenario.json_schema import keywords, sentence_of
from rcj_challenges.scenario.models import designs, field, places, robots, scenario, state
from rcj_challenges.scenario.shape import bare, fields, is_model, is_union, members, tags, without_none
from scripts.sheet_sentences import sheet_sentences

ROOT = Path(__file__).resolve().parents[1]
PAGE = ROOT / "docs" / "reference-scenario.md"
SUBMISSION = ROOT / "docs" / "submission.md"
WORDS = ROOT / "docs" / "words"
VOCABULARIES: dict[str, Vocabulary] = {
    "places": PLACES,
    "values": VALUES,
    "triggers": TRIGGERS,
    "conditions": CONDITIONS,
    "actions": ACTIONS,
    "chassis": CHASSIS,
    "devices": DEVICES,
}
"""The words with an example of their own, by kind."""
STAGE = """schema_version: 2
id: example
title: An example
extends: soccersim_v2
match: {half_s: 60}
"""
"""What stands above every example."""

_INTRO = f"""# Reference: scenario keywords

This page is generated from the models by `python scripts/write_reference.py`; do not edit it.
[authoring.md](authoring.md) leads from an idea to a published challenge; [recipes.md](recipes.md) has complete
examples.

Lengths are in metres, times in seconds and angles in radians. The origin is the centre of the field, x runs along its
short side and y along its long side; blue defends the goal at +y. Field names carry their unit: `_m`, `_s`, `_rad`,
`_mps`. Durations are rounded up to ticks of 0.032 s. A field marked *required* has no default. Any single value may be
`{{param: NAME}}`; a number may also be `{{param: NAME, times: -1, plus: 0.02}}`: the param multiplied by `times`, plus
`plus` (either can be omitted). Named things are entries of mappings, with their names as keys:
{NAME_RULE}.

With these lines above it, each example is a complete scenario; all of them run as tests:

```yaml
{STAGE}```
"""


@dataclass(frozen=True)
class Example:
    """A piece of a scenario that shows some words.

    Attributes:
        file: the stem of its file, or the kind of its word.
        words: what it shows.
        text: the sections, without the lines of `STAGE`.
    """

    file: str
    words: tuple[str, ...]
    text: str

    @property
    def whole(self) -> str:
        """The scenario as a whole."""
        own = set(re.findall(r"^(\w+):", self.text, re.MULTILINE))
        kept = [line for line in STAGE.splitlines() if line.partition(":")[0] not in own]
        return "\n".join([*kept, self.text])


@dataclass(frozen=True)
class Word:
    """A word of the language.

    Attributes:
        name: how the file writes it; of an entry without a word of its own: its section.
        model: what describes it.
        own_example: whether it needs an example of its own; parts are shown by that of the whole.
        example: the word under which its example stands, if not its name.
    """

    name: str
    model: type[BaseModel]
    own_example: bool = True
    example: str = ""


@dataclass(frozen=True)
class Chapter:
    """Words of one kind.

    Attributes:
        title: its heading.
        about: what they are for.
        words: in the order of the models.
        file: where their examples are looked for first.
        tag: the key that says the word, such as ``trigger``.
    """

    title: str
    about: str
    words: tuple[Word, ...]
    file: str
    tag: str = ""


def _tagged(union: Any) -> tuple[Word, ...]:
    return tuple(Word(name, bare(shape).kind) for name, shape in tags(union).items() if is_model(bare(shape).kind))


CHAPTERS = (
    Chapter(
        "Match, field, balls",
        "The setting: halves, field and balls.",
        (
            Word("match", field.Match),
            Word("field", field.FieldModel),
            Word("goals", field.Goal, own_example=False),
            Word("balls", field.Ball),
        ),
        "ground",
    ),
    Chapter(
        "Obstacles",
        "Section `obstacles`: boxes, cylinders and walls on the floor, by name.",
        _tagged(field.Obstacle),
        "ground",
        "shape",
    ),
    Chapter(
        "Robots and entrants",
        "Sections `kits`, `robots`, `entrants` and `guidelines`: the robots, their sensors, the teams that control "
        "them, and what teams may design.",
        (
            Word("kits", robots.Kit),
            Word("robots", robots.Robot),
            Word("start_pose", robots.StartPose, own_example=False),
            Word("entrants", robots.Entrant),
            Word("guidelines", designs.Guideline),
            Word("part", designs.Part, own_example=False),
            Word("allowance", designs.Allowance, own_example=False),
        ),
        "devices",
    ),
    Chapter(
        "Chassis",
        "Entry `chassis` of a kit: its body and wheels.",
        _tagged(AnyChassis),
        "chassis",
        "drive",
    ),
    Chapter(
        "Devices",
        "Entries of `devices` in a kit or a robot, by the name that programs pass to `getDevice`.",
        _tagged(AnyDevice),
        "devices",
        "device",
    ),
    Chapter(
        "Zones",
        "Section `zones`: regions of the floor; an entity is in a zone if its centre is.",
        _tagged(places.Zone),
        "ground",
        "shape",
    ),
    Chapter(
        "Gates, spots, groups",
        "Section `gates`: lines to cross. Section `spots`: named points. Section `groups`: several robots, "
        "balls, obstacles, zones, gates or spots under one name; the groups `robots`, `balls`, "
        "`obstacles`, `walls` and one for each robot colour always exist.",
        (Word("gates", places.Gate), Word("spots", places.Spot, example="spot")),
        "ground",
    ),
    Chapter(
        "Placements",
        "Section `placements`: layouts by name; each is a list of the following entries, carried out in order.",
        (
            Word("placements", places.Placing),
            Word("mirror", Mirror),
            Word("facing", Towards),
            Word("kick", Kick),
        ),
        "places",
    ),
    Chapter("Where things go", "The forms of `at`; the bare word `start` is also allowed.", _tagged(At), "places"),
    Chapter(
        "What rules remember",
        "Sections `draws`, `counters`, `flags`, `timers` and `sequences`.",
        (
            Word("draws", state.Draw),
            Word("counters", state.Counter),
            Word("flags", state.Flag, example="flag"),
            Word("timers", state.Timer),
            Word("sequences", state.Sequence),
            Word("any_of", state.AnyStep, own_example=False, example="sequences"),
        ),
        "conditions",
    ),
    Chapter("Phases", "Section `phases`: phases other than `play`.", (Word("phases", state.Phase),), "rules"),
    Chapter(
        "Rules",
        "Section `rules`: rules, in the order in which they are judged.",
        (Word("rules", scenario.Rule),),
        "rules",
    ),
    Chapter("Triggers", "Moments at which a rule may fire.", _tagged(AnyTrigger), "triggers", "trigger"),
    Chapter(
        "Conditions",
        "What must hold when a trigger fires. A [value](#values) that is a number, with `at_least`, `at_most`, "
        "`above`, `below` or `equals`, is a condition; these keys are described under `at_least`, and the value with "
        "its example. A flag and a timer need no comparison: it is set, it is running. Every condition has `negate`.",
        (
            Word("at_least", Compared, own_example=False),
            *(word for word in _tagged(AnyCondition) if word.model.EXAMPLE),
        ),
        "conditions",
    ),
    Chapter("Actions", "What a rule does, in order, when it fires.", _tagged(AnyAction), "actions", "action"),
    Chapter(
        "Values",
        "A payload or a broadcast may contain literals and any of these values. Wherever a rule has a *number*, it "
        "may be any of them but `position_of`, `role` and `last_touch`; a flag is 1 or 0. What stands beside such a "
        "value is described under `otherwise`. What does not exist is *none*: the distance to what is off the field, "
        "a message that never came, the lowest of an empty group. Calculating with none gives none; no comparison "
        "with it holds; an action whose number is none does nothing; programs receive null.",
        (*_tagged(Value), Word("otherwise", NumberValue, own_example=False)),
        "values",
    ),
    Chapter(
        "Broadcast, result, limits",
        "What programs receive, how entrants are ranked, and what programs may use.",
        (
            Word("broadcast", scenario.Broadcast),
            Word("result", scenario.Result),
            Word("better", Ranked, own_example=False),
            Word("limits", scenario.Limits),
        ),
        "rules",
    ),
    Chapter(
        "Tests",
        "Section `expect`: tests, in which a script moves things and the referee's decisions are "
        "compared with the expected ones.",
        (
            Word("expect", scenario.Expectation),
            Word("halves", scenario.MatchExpectation),
            Word("given", scenario.Given),
            Word("keyframes", scenario.Keyframe, own_example=False),
            Word("events", scenario.ExpectedEvent, own_example=False),
        ),
        "rules",
    ),
)


def read_examples() -> list[Example]:
    """Return all examples: of the words, then those in files, in the order of files and lines."""
    of_words: dict[type, Example] = {}
    for kind, vocabulary in VOCABULARIES.items():
        for word in vocabulary.words():
            if word.EXAMPLE:
                of_words.setdefault(word, Example(kind, (word.name(),), word.EXAMPLE.strip("\n") + "\n"))
    found = list(of_words.values())
    for path in sorted(WORDS.glob("*.yaml")):
        text = path.read_text(encoding="utf-8")
        parts = re.split(r"^--- # (.+)\n", text, flags=re.MULTILINE)[1:]
        found += [
            Example(path.stem, tuple(words.split()), body) for words, body in zip(parts[::2], parts[1::2], strict=True)
        ]
    return found


def example_of(word: Word, chapter: Chapter, examples: list[Example]) -> Example | None:
    """Return the example of a word: from the chapter's own file if it is there, of few words rather than many."""
    name = word.example or word.name
    fitting = [example for example in examples if name in example.words]
    return min(fitting, key=lambda example: (example.file != chapter.file, len(example.words)), default=None)


# --- the page ---------------------------------------------------------------------------------------------------------


def page() -> str:
    """Return the whole page."""
    examples = read_examples()
    lines = [_INTRO, "## The file\n", sentence_of(scenario.Scenario) + "\n", *_table(scenario.Scenario, "")]
    for name in ("params", "groups"):
        example = next(one for one in examples if name in one.words)
        lines += [f"\nAn example of `{name}`:\n", "```yaml", example.text.rstrip(), "```"]
    shown: dict[str, str] = {}
    for chapter in CHAPTERS:
        lines += [f"\n## {chapter.title}\n", chapter.about]
        for word in chapter.words:
            heading = f"{word.name} (value)" if chapter.title == "Values" else word.name
            lines += [f"\n### {heading}\n", sentence_of(word.model) + "\n", *_table(word.model, chapter.tag)]
            example = example_of(word, chapter, examples)
            if example is None:
                continue
            if example.text in shown:
                lines.append(f"\nSee the example of {shown[example.text]}.")
            else:
                anchor = re.sub(r"[^a-z_ -]", "", heading).replace(" ", "-")
                shown[example.text] = f"[`{word.name}`](#{anchor})"
                lines += ["\n```yaml", example.text.rstrip(), "```"]
            if sentences := sheet_sentences(word.model, chapter.file, example.whole):
                lines += ["\nOn the rule sheet:\n", *(f"* {sentence}" for sentence in sentences)]
    return "\n".join(lines) + "\n"


_PARTS = (NumberValue, Compared, Ranked)
"""Whose fields many words have: they are described once."""


def _table(model: type[BaseModel], tag: str) -> Iterator[str]:
    rows = []
    shapes = fields(model)
    for name, info in model.model_fields.items():
        key = info.alias or name
        if key == tag or any(
            model is not one and issubclass(model, one) and name in one.model_fields for one in _PARTS
        ):
            continue
        kind = _type_text(shapes[key]) + _bounds(info, shapes[key])
        rows.append(f"| `{key}` | {kind} | {_default(info)} | {info.description or ''} |")
    if rows:
        yield from ("| field | value | default | meaning |", "|---|---|---|---|", *rows)
    elif tag:
        yield "No other fields."


_NAMED: tuple[tuple[Any, str], ...] = (
    (Names, "name, or list of names"), (Name, "name"), (EventName, "event"), (DurationS, "duration in s"),
    (Point, "[x, y] in m"), (Colour, "colour"), (Value, "value"),
    (Amount, "[number](#values)"), (Lasts, "duration in s, or [number](#values)"),
    (Limit, "[number](#values)"), (Waits, "[number](#values)"), (fields(TipsOver)["angle_rad"], "[number](#values)"),
    (Several, "[value](#values), or list of numbers"),
    (fields(Kick)["speed_mps"], "number, [lowest, highest], or [number](#values)"),
    (At, "[where](#where-things-go)"),
    (Facing, "`start`, `keep`, yaw in rad, {towards: …}, or {random: true}"),
    (AnyTrigger, "[trigger](#triggers)"), (AnyCondition, "[condition](#conditions)"),
    (Alternative, "[condition](#conditions), or list of conditions"),
    (AnyAction, "[action](#actions)"),
    (AnyRanked, "[value](#values) with [better](#better)"), (AnyDevice, "[device](#devices)"),
    (AnyChassis, "[chassis](#chassis)"), (places.Zone, "[zone](#zones)"),
    (field.Obstacle, "[obstacle](#obstacles)"), (places.Layout, "list of [placements](#placements)"),
    (robots.EntryPoints, "path, or list of paths"),
)  # fmt: skip
_SCALARS = {str: "text", int: "whole number", float: "number", bool: "true/false"}


def _type_text(shape: Any) -> str:
    shape = without_none(shape)
    known = next((text for one, text in _NAMED if shape == one), None)
    kind = bare(shape).kind
    known = known or next((text for one, text in _NAMED if kind == bare(one).kind and get_origin(kind)), None)
    if known is not None:
        return known
    arguments = get_args(kind)
    if is_union(kind):
        kinds = dict.fromkeys(_type_text(member) for member in members(shape))
        *most, last = (one for one in kinds if one != "whole number" or "number" not in kinds)
        text = f"{', '.join(most)} or {last}" if most else last
    elif is_model(kind):
        word = next((word.name for chapter in CHAPTERS for word in chapter.words if word.model is kind), None)
        is_value = kind in (CounterValue, FlagValue, DrawValue)
        text = f"[{word}](#{word}{'-value' * is_value})" if word else f"{{{', '.join(fields(kind))}}}"
    elif get_origin(kind) is dict:
        text = f"mapping of names to {_plural(_type_text(arguments[1]))}"
    elif get_origin(kind) is tuple:
        repeated = len(arguments) == 2 and arguments[1] is Ellipsis
        text = f"{'' if repeated else f'{len(arguments)}-element '}list of {_plural(_type_text(arguments[0]))}"
    elif get_origin(kind) is Literal:
        text = " or ".join(f"`{str(word).lower() if isinstance(word, bool) else word}`" for word in arguments)
    else:
        text = _SCALARS[kind]
    return text


def _plural(text: str) -> str:
    return re.sub(r"(^|, | or |element )(name|number|value|event|path|list|mapping|duration)\b", r"\1\2s", text)


def _bounds(info: FieldInfo, shape: Any) -> str:
    bounds = keywords([info, *(get_args(shape)[1:] if hasattr(shape, "__metadata__") else ())], shape)
    signs = {"exclusiveMinimum": "above", "minimum": "at least", "exclusiveMaximum": "below", "maximum": "at most"}
    if any(without_none(shape) == one for one, _ in _NAMED):
        return ""
    told = [f"{word} {bounds[key]:g}" for key, word in signs.items() if key in bounds]
    return f", {', '.join(told)}" if told else ""


def _default(info: FieldInfo) -> str:
    default = info.default
    if default is PydanticUndefined:
        return "required"
    if default is None or default in ({}, (), ""):
        return ""
    if isinstance(default, BaseModel):
        return "its defaults"
    if isinstance(default, tuple) and default and isinstance(default[0], BaseModel):
        return "`[{score: each, better: more}]`"
    text = str(default).lower() if isinstance(default, bool) else str(default).replace("'", "")
    return f"`{text.replace('(', '[').replace(')', ']').replace(',]', ']')}`"


def submission_page() -> str:
    """Return docs/submission.md with the table of what is checked before programs are started."""
    before, _, rest = SUBMISSION.read_text(encoding="utf-8").partition("<!-- codes")
    stages = ("archive", "layout", "identity", "sources")
    rows = [
        f"| `{code}` | {code.level} | {code.page.splitlines()[0]} | {code.repair} |"
        for stage in stages
        for code in all_codes().values()
        if code.partition(".")[0] == stage
    ]
    table = ["| code | level | what is wrong | fix |", "|---|---|---|---|", *rows]
    begin = "<!-- codes: python scripts/write_reference.py -->"
    return "\n".join(
        [before + begin, "", *table, "", "<!-- end of codes -->" + rest.partition("<!-- end of codes -->")[2]]
    )


def main(arguments: list[str]) -> int:
    """Write or check the pages; return the exit status."""
    stale = 0
    for path, text in ((PAGE, page()), (SUBMISSION, submission_page())):
        fresh = path.is_file() and path.read_text(encoding="utf-8") == text
        if "--check" in arguments:
            stale |= not fresh
            print(f"{path.name} is fresh" if fresh else f"{path.name} is stale: python scripts/write_reference.py")
        elif not fresh:
            path.write_text(text, encoding="utf-8", newline="\n")
            print(path.relative_to(ROOT).as_posix())
    return stale


if __name__ == "__main__":
    raise SystemExit(main(sys.argv[1:]))
