"""The pages of the codes about files of scenarios and tournaments: errors, and the warnings of lint."""

from __future__ import annotations

import inspect

from rcj_challenges.scenario.lint.base import LintRule
from rcj_challenges.scenario.lint.registry import LINT_RULES

_READING = {
    "ambiguous-name": """
The name belongs to something that is shipped and also to a file of yours, so it is not clear which of them you want.
Write the file with its ending, or give it another name.""",
    "duplicate-key": """
A key occurs twice in one mapping.
Only one of them could count; remove the other one, or put both contents under one key.""",
    "empty-file": """
The file is empty.
A scenario begins with schema_version, id and title; 'rcj-challenge new challenge NAME' writes one to start from.""",
    "invalid-yaml": """
The file is not valid YAML: YAML 1.2, one document, without anchors, aliases, tags or directives.
The position is where reading stopped; the mistake may be a little above it: a quote or bracket that is not closed, a
missing space after ':', or inconsistent indentation. Texts that contain ': ' need quotes.""",
    "missing-value": """
A key has no value, or a list an empty entry.
Write the value, or leave the key out. Text after # is a comment unless it is in quotes; a space must follow the ':'. To
remove an entry of a base, write null.""",
    "newer-version": """
The file is written for a newer version of rcj-challenges.
Update with 'pip install --upgrade rcj-challenges'.""",
    "no-such-file": """
There is no file with this name, and nothing with this name is shipped.
Check the current folder, and the ending .yaml.""",
    "not-utf8": """
The file is not saved in UTF-8.
Save it as UTF-8; editors offer this when they save a file.""",
    "scenario-too-large": """
The scenario, with the files that it extends, has more bytes, entries or values than any contest needs.
Leave out what the challenge does not need; repeat_for and groups avoid repetition.""",
    "unknown-base": """
'extends' names a file, preset or scenario that does not exist.
Name a shipped one without folder and ending, and a file of yours by its path relative to the file that extends it.""",
    "unknown-param": """
{param: NAME} refers to a param that does not exist.
Declare it under 'params'. In a rule with repeat_for, 'this' and the keys beside its names are params too.""",
    "unreadable-file": """
The file exists but cannot be read.
Check that it is a file, and that you have permission to read it.""",
    "wrong-extends": """
The value of 'extends' cannot be extended.
It must be the name of a shipped preset or scenario, or a relative path with / to a .yaml file. No file may extend itself.""",
    "wrong-null": """
null is written where it cannot remove anything.
It removes named entries of a base: rules, zones, robots, tests. A list is replaced as a whole.""",
    "wrong-override": """
The PATH of '--set PATH=VALUE' does not exist.
PATH is the name of a param, or a path such as match.half_s or rules.goal.actions[0].points.""",
    "wrong-param-use": """
The value of a param cannot be computed.
In {param: NAME, times: 2, plus: 1} the param, times and plus must all be numbers.""",
    "wrong-repeat": """
The value of 'repeat_for' is wrong.
It must be a list of names, or a mapping of names that all have the same keys; each name makes one rule.""",
}
_FORM = {
    "missing-key": """
A required key is missing, or one of several keys of which one is required.
The help says what it is for.""",
    "unknown-key": """
A key is not allowed here.
Keys are spelled as in the reference; the help lists those that are allowed here. The key may also be indented wrongly,
so that it belongs to another mapping.""",
    "unknown-word": """
A keyword for a trigger, condition, action, shape, device or the like is unknown.
The help lists the keywords that are allowed here, or suggests the nearest one.""",
    "wrong-name": """
A name contains characters that are not allowed.
Names consist of letters from a to z in either case, digits and _, and do not begin with a digit.""",
    "wrong-value": """
A value is of the wrong kind or size.
The message says what is expected and what was found, the help what the value is for.""",
}
_NAMES = {
    "group-in-itself": """
A group contains itself through its members.
Remove the member that closes the circle.""",
    "mixed-group": """
A group contains different kinds of things, such as robots and zones.
Robots, balls and obstacles may share a group; zones, gates and spots have groups of their own.""",
    "name-taken": """
A name is used twice, or is reserved.
Everything on the field shares one namespace with the groups and the colours of robots, in which upper and lower case
make no difference; 'each', 'other', 'robots', 'balls', 'obstacles' and 'walls' are reserved.""",
    "unknown-name": """
A name refers to something that does not exist.
Check the spelling. If a file that extends another one has removed the thing, remove or change everything that names it.""",
    "unbound-name": """
'each' or 'other' is used where it has no meaning.
'each' is the member for which a rule with for_each (or a timer with per) exists; 'other' is the touched thing, in a rule
whose triggers are all touches.""",
    "wrong-kind": """
A name refers to the wrong kind of thing: a group instead of one entity, a zone instead of a robot.
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
Each robot is driven by at most one entrant, and an idle robot by none.""",
    "empty-range": """
No number lies between the two bounds.
The lower bound is above the upper one: swap or correct them.""",
    "empty-shape": """
A shape has no area: its ends coincide, its bounds are swapped, or its outline crosses itself.
Give the corners of an outline in order.""",
    "entrant-without-robots": """
An entrant drives no robot.
Give it one, or remove it with null under 'entrants'.""",
    "missing-entity": """
Something is kept for each member of a group, but the member is not given.
Give it as 'entity', such as entity: each in a rule with for_each, or say with 'of' how many members are needed.""",
    "never-drawn": """
A rule or test expects a result of a draw or a random spot that cannot occur.
Check the values of the draw, their spelling, and not_last and not_again.""",
    "never-holds": """
A condition requires more members than the group has.
Lower the number, or name a larger group.""",
    "never-touches": """
Two things never touch: one is the other, or neither can move.
Name something that moves.""",
    "no-centre": """
A zone has no centre: it is inverted, a polygon, or unbounded in some direction.
Use a spot or a point instead.""",
    "no-room": """
A goal or a corner does not fit into the walls of the field.
Make it smaller, or the field larger.""",
    "not-per-entity": """
Something is kept only once, but is used as if each entity had its own.
Leave 'entity' out, or give the counter, flag, timer or sequence a group with 'per'.""",
    "nothing-moves": """
There is neither a robot nor a ball.
Give at least one of them.""",
    "out-of-range": """
A length, angle, duration or mass is too large for a sports hall, or too small to be simulated.
Check the unit: lengths are in m, angles in rad, times in s, masses in kg.""",
    "outside-field": """
A body is outside the field or in a wall at the start.
Move it inside. 'start' gives the centre of a robot; the chassis extends around it.""",
    "overlapping-bodies": """
Two bodies overlap at the start.
Move one of them; if it should appear later, let a rule place it.""",
    "same-channel": """
Two entrants have the same radio channel, so each would receive the other's messages.
Give one of them another channel.""",
    "too-early": """
A keyframe of a test comes before the one above it.
Keyframes must be in the order of time.""",
    "too-late": """
Something should happen after the half, or the test, is over.
Make the half or the test longer, or let it happen earlier. Halves shortened by a param or --set do not count here.""",
    "unbounded-zone": """
A random point should be drawn from a zone that is unbounded in some direction.
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
