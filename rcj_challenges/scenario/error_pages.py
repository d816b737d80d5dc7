"""The pages of the codes that files of scenarios and tournaments bring: errors, and the warnings of lint."""

from __future__ import annotations

import inspect

from rcj_challenges.scenario.lint.base import LintRule
from rcj_challenges.scenario.lint.registry import LINT_RULES

_READING = {
    "ambiguous-name": """
The name of something shipped is also that of a file of yours, so that it is not clear which of them you want.
Write the file with its ending, or give it another name.""",
    "duplicate-key": """
A key stands twice in one mapping.
Only one of them could count; take the other one out, or put both contents under one key.""",
    "empty-file": """
There is nothing in the file.
A scenario begins with schema_version, id and title; 'rcj-challenge new challenge NAME' writes one to start from.""",
    "invalid-yaml": """
The file is not YAML as it is read here: YAML 1.2, one document, without anchors, aliases, tags and directives.
The place is where the reader gave up; the mistake may be a little above it: a quote or bracket that is not closed, a
missing blank after ':', or lines that are not indented alike. Texts with ': ' in them stand in quotes.""",
    "missing-value": """
A key has no value, or a list an empty entry.
Write the value, or leave the key out. What begins with # is a comment unless it stands in quotes; a blank comes after
the ':'. An entry of a base is taken away by null, which must be written.""",
    "newer-version": """
The file is written for a newer version of rcj-challenges.
Update with 'pip install --upgrade rcj-challenges'.""",
    "no-such-file": """
There is no file of this name, and nothing of this name is shipped.
Check the folder in which you are, and the ending .yaml.""",
    "not-utf8": """
The file is saved in another encoding than UTF-8.
Save it as UTF-8; each editor has this in its menu for saving.""",
    "scenario-too-large": """
The scenario has more bytes, entries or values than any contest needs, with those of the files it extends.
Leave out what the challenge does not need; repeat_for and groups say the same of several things at once.""",
    "unknown-base": """
'extends' names a file, preset or scenario that does not exist.
A shipped one is named without folder and ending; a file of yours by its path from the file that extends it.""",
    "unknown-param": """
{param: NAME} stands where no param of this name exists.
Declare it under 'params'. In a rule with repeat_for, 'this' and the keys beside its names are params too.""",
    "unreadable-file": """
The file exists and cannot be read.
Check that it is a file, and that you may read it.""",
    "wrong-extends": """
What 'extends' says cannot be extended.
It is the name of a shipped preset or scenario, or a relative path with / to a .yaml file; none extends itself.""",
    "wrong-null": """
null stands where it takes nothing away.
It removes entries of a base that have names of their own: rules, zones, robots, tests.
A list is replaced as a whole.""",
    "wrong-override": """
'--set PATH=VALUE' leads nowhere.
PATH is the name of a param, or a path such as match.half_s or rules.goal.actions[0].points.""",
    "wrong-param-use": """
A param is used in a way in which it cannot be computed.
{param: NAME, times: 2, plus: 1} is for params that are numbers; times and plus are numbers themselves.""",
    "wrong-repeat": """
'repeat_for' cannot be read.
It is a list of names, or a mapping of names in which all have the same keys; each name makes one rule.""",
}
_FORM = {
    "missing-key": """
A key is missing that must be there, or one of several of which one must be there.
The help says what it is for.""",
    "unknown-key": """
A key is not known in its place.
Keys are spelled as in the reference; the help lists those that may stand here. It may also be indented wrongly, so
that it belongs to another mapping than it seems.""",
    "unknown-word": """
A word for a trigger, condition, action, shape, device or the like is not known.
The help lists the words that may stand here, or says what others call so.""",
    "wrong-name": """
A name has other letters than names may have.
Names have the letters a to z in both cases, digits and _, and do not begin with a digit.""",
    "wrong-value": """
A value is of another kind or size than is needed.
The message says what is expected and what was found, the help what the value is for.""",
}
_NAMES = {
    "group-in-itself": """
A group leads back to itself through its members.
Take the member out that closes the circle.""",
    "mixed-group": """
A group gathers different kinds of things, such as robots and zones.
Robots, balls and obstacles may share a group; zones, gates and spots have groups of their own.""",
    "name-taken": """
A name is used twice, or has a meaning of its own.
All that is on the field shares one namespace with the groups and the colours of robots, in which upper and lower case
make no difference; 'each', 'other', 'robots', 'balls', 'obstacles' and 'walls' are reserved.""",
    "unknown-name": """
Something is named that does not exist, or not any more.
Check the spelling, or whether a file that extends another one has removed it: what still names it must go too.""",
    "unbound-name": """
'each' or 'other' is used where it stands for nothing.
'each' is the member for which a rule with for_each (or a timer with per) exists; 'other' is what was touched, in a rule
whose triggers are all touches.""",
    "wrong-kind": """
A name exists, and names another kind of thing than is needed: a group instead of one entity, a zone instead of a robot.
The message says what is expected. A group fits if each of its members does.""",
}
_SENSE = {
    "cannot-swap": """
'swap_sides' needs exactly two entrants.
Write swap_sides: false, or give the match two entrants.""",
    "conflicting-keys": """
Two keys exclude each other.
Leave one of them out.""",
    "driven-twice": """
A robot has more than one program, or is idle and has one.
Each robot is driven by one entrant at most, and an idle one by none.""",
    "empty-range": """
No number lies between the two bounds.
The lower one is above the upper one: swap or correct them.""",
    "empty-shape": """
A shape has no inside: its ends are at one point, its bounds are swapped, or its outline crosses itself.
Give the corners of an outline in order.""",
    "entrant-without-robots": """
An entrant drives no robot.
Give it one, or remove it by null under 'entrants'.""",
    "missing-entity": """
Something is kept for each member of a group, and it is not said of which member.
Say it with 'entity', such as entity: each in a rule with for_each, or with 'of' how many of several.""",
    "never-drawn": """
A rule or test expects from a draw or a spot what chance never brings.
Check the values of the draw, their spelling, and not_last and not_again.""",
    "never-holds": """
More is asked of a group than it has members.
Lower the number, or name a larger group.""",
    "never-touches": """
Two things never touch: one is the other, or neither can move.
Name something that moves.""",
    "no-centre": """
A zone has no centre: it is inverted, a polygon, or without an end in some direction.
Use a spot or a point instead.""",
    "no-room": """
A goal or a corner does not fit into the walls of the field.
Make it smaller, or the field larger.""",
    "not-per-entity": """
Something is kept once, and it is used as if each entity had its own.
Leave 'entity' out, or give the counter, flag, timer or sequence a group with 'per'.""",
    "nothing-moves": """
There is neither a robot nor a ball.
Give at least one of them.""",
    "out-of-range": """
A length, angle, duration or mass is far beyond what fits into a hall, or below what can be simulated.
Check the unit: lengths are in m, angles in rad, times in s, masses in kg.""",
    "outside-field": """
A body stands outside the field or in a wall at the start.
Move it inside. A chassis is wider than the place that 'start' names.""",
    "overlapping-bodies": """
Two bodies stand in each other at the start.
Move one of them; what comes later is put there by a rule.""",
    "same-channel": """
Two entrants have the same radio channel, so that each would hear the other's robots.
Give one of them another channel.""",
    "too-early": """
A keyframe of a test comes before the one above it.
Keyframes stand in the order of time.""",
    "too-late": """
Something is to happen after the half, or the test, is over.
Make the half or the test longer, or let it happen earlier. A param or --set that shortens halves does not count.""",
    "unbounded-zone": """
A random point is to be drawn from a zone that has no end in some direction.
Give the zone all its bounds, or name another zone.""",
}


def _page(rule: LintRule) -> str:
    texts = f"warning: {rule.message}\nhelp: {rule.help}".replace("{{", "{").replace("}}", "}")
    return f"{inspect.getdoc(type(rule))}\n\n{texts}"


PAGES: dict[str, str] = {
    **{
        code: text.strip().replace("\n", "\n\n", 1)
        for table in (_READING, _FORM, _NAMES, _SENSE)
        for code, text in table.items()
    },
    **{rule.code: _page(rule) for rule in LINT_RULES},
}
