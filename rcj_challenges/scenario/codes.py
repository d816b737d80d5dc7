"""Codes about files of scenarios and tournaments; those of lint are defined by its rules."""

from rcj_challenges.core.code import Code

# fmt: off
AMBIGUOUS_NAME = Code("ambiguous-name", page="""
The name belongs to something that is shipped and also to a file of yours, so it is not clear which of them you want.
Write the file with its ending, or give it another name.""")
DUPLICATE_KEY = Code("duplicate-key", page="""
A key occurs twice in one mapping.
Only one of them could count; remove the other one, or put both contents under one key.""")
EMPTY_FILE = Code("empty-file", page="""
The file is empty.
A scenario begins with schema_version, id and title; 'rcj-challenge new challenge NAME' writes one to start from.""")
INVALID_YAML = Code("invalid-yaml", page="""
The file is not valid YAML: YAML 1.2, one document, without anchors, aliases, tags or directives.
The position is where reading stopped; the mistake may be a little above it: a quote or bracket that is not closed,
a missing space after ':', or inconsistent indentation. Texts that contain ': ' need quotes.""")
MISSING_VALUE = Code("missing-value", page="""
A key has no value, or a list an empty entry.
Write the value, or leave the key out. Text after # is a comment unless it is in quotes; a space must follow the
':'. To remove an entry of a base, write null.""")
NEWER_VERSION = Code("newer-version", page="""
The file is written for a newer version of rcj-challenges.
Update with 'pip install --upgrade rcj-challenges'.""")
NO_SUCH_FILE = Code("no-such-file", page="""
There is no file with this name, and nothing with this name is shipped.
Check the current folder, and the ending .yaml.""")
NOT_UTF8 = Code("not-utf8", page="""
The file is not saved in UTF-8.
Save it as UTF-8; editors offer this when they save a file.""")
OLD_LANGUAGE = Code("old-language", page="""
Something is written as in version 1 of the language. A file without schema_version counts as one of version 1.
The help shows what to write instead. Change schema_version last: until then, all that is different in version 2 is
reported. Records and tournaments that were made with version 1 open as they are.""")
SCENARIO_TOO_LARGE = Code("scenario-too-large", page="""
The scenario, with the files that it extends, has more bytes, entries or values than any contest needs.
Leave out what the challenge does not need; repeat_for and groups avoid repetition.""")
UNKNOWN_BASE = Code("unknown-base", page="""
'extends' names a file, preset or scenario that does not exist.
Name a shipped one without folder and ending, and a file of yours by its path relative to the file that extends it.""")
UNKNOWN_PARAM = Code("unknown-param", page="""
{param: NAME} refers to a param that does not exist.
Declare it under 'params'. In an entry with repeat_for, 'this' and the columns of its table are params too.""")
UNREADABLE_FILE = Code("unreadable-file", page="""
The file exists but cannot be read.
Check that it is a file, and that you have permission to read it.""")
WRONG_EXTENDS = Code("wrong-extends", page="""
The value of 'extends' cannot be extended.
It must be the name of a shipped preset or scenario, or a relative path with / to a .yaml file. No file may extend
itself.""")
WRONG_NULL = Code("wrong-null", page="""
null is written where it cannot remove anything.
It removes named entries of a base: rules, zones, robots, tests. A list is replaced as a whole.""")
WRONG_OVERRIDE = Code("wrong-override", page="""
The PATH of '--set PATH=VALUE' does not exist.
PATH is the name of a param, or a path such as match.half_s or rules.goal.actions[0].points.""")
WRONG_PARAM_USE = Code("wrong-param-use", page="""
The value of a param cannot be computed.
In {param: NAME, times: 2, plus: 1} the param, times and plus must all be numbers.""")
WRONG_REPEAT = Code("wrong-repeat", page="""
The value of 'repeat_for' is wrong, or its table is.
It must be the name of a table, or a list of tables; all rows of a table have the same columns.""")
MISSING_KEY = Code("missing-key", page="""
A required key is missing, or one of several keys of which one is required.
The help says what it is for.""")
UNKNOWN_KEY = Code("unknown-key", page="""
A key is not allowed here.
Keys are spelled as in the reference; the help lists those that are allowed here. The key may also be indented
wrongly, so that it belongs to another mapping.""")
UNKNOWN_WORD = Code("unknown-word", page="""
A keyword for a trigger, condition, action, shape, device or the like is unknown.
The help lists the keywords that are allowed here, or suggests the nearest one.""")
WRONG_NAME = Code("wrong-name", page="""
A name contains characters that are not allowed.
Names consist of letters from a to z in either case, digits and _, and do not begin with a digit.""")
WRONG_VALUE = Code("wrong-value", page="""
A value is of the wrong kind or size.
The message says what is expected and what was found, the help what the value is for.""")
GROUP_IN_ITSELF = Code("group-in-itself", page="""
A group contains itself through its members.
Remove the member that closes the circle.""")
MIXED_GROUP = Code("mixed-group", page="""
A group contains different kinds of things, such as robots and zones.
Robots, balls and obstacles may share a group; zones, gates and spots have groups of their own.""")
NAME_TAKEN = Code("name-taken", page="""
A name is used twice, or is reserved.
Everything on the field shares one namespace with the groups and the colours of robots, in which upper and lower
case make no difference; 'each', 'other', 'robots', 'balls', 'obstacles' and 'walls' are reserved.""")
UNKNOWN_NAME = Code("unknown-name", page="""
A name refers to something that does not exist.
Check the spelling. If a file that extends another one has removed the thing, remove or change everything that names
it.""")
UNBOUND_NAME = Code("unbound-name", page="""
'each' or 'other' is used where it has no meaning.
'each' is the member for which a rule with for_each (or a timer with per) exists; 'other' is the touched thing, in a
rule whose triggers are all touches.""")
WRONG_KIND = Code("wrong-kind", page="""
A name refers to the wrong kind of thing: a group instead of one entity, a zone instead of a robot.
The message says what is expected. A group fits if each of its members does.""")
CANNOT_SWAP = Code("cannot-swap", page="""
'swap_sides' needs exactly two entrants.
Write swap_sides: false, or give the match two entrants.""")
CONFLICTING_KEYS = Code("conflicting-keys", page="""
Two keys exclude each other.
Leave one of them out.""")
DRIVEN_TWICE = Code("driven-twice", page="""
A robot has more than one program, or is idle and has one.
Each robot is driven by at most one entrant, and an idle robot by none.""")
EMPTY_RANGE = Code("empty-range", page="""
No number lies between the two bounds.
The lower bound is above the upper one: swap or correct them.""")
EMPTY_SHAPE = Code("empty-shape", page="""
A shape has no area: its ends coincide, its bounds are swapped, or its outline crosses itself.
Give the corners of an outline in order.""")
ENTRANT_WITHOUT_ROBOTS = Code("entrant-without-robots", page="""
An entrant drives no robot.
Give it one, or remove it with null under 'entrants'.""")
MISSING_ENTITY = Code("missing-entity", page="""
Something is kept for each member of a group, but the member is not given.
Give it as 'entity', such as entity: each in a rule with for_each, or say with 'of' how many members are needed.""")
NEVER_DRAWN = Code("never-drawn", page="""
A rule or test expects a result of a draw or a random spot that cannot occur.
Check the values of the draw, their spelling, and not_last and not_again.""")
NEVER_HOLDS = Code("never-holds", page="""
A condition requires more members than the group has.
Lower the number, or name a larger group.""")
NEVER_TOUCHES = Code("never-touches", page="""
Two things never touch: one is the other, or neither can move.
Name something that moves.""")
NO_CENTRE = Code("no-centre", page="""
A zone has no centre: it is inverted, a polygon, unbounded in some direction, or it has an anchor.
Use a spot or a point instead.""")
NOT_PER_ENTITY = Code("not-per-entity", page="""
Something is kept only once, but is used as if each entity had its own.
Leave 'entity' out, or give the counter, flag, timer or sequence a group with 'per'.""")
NOTHING_MOVES = Code("nothing-moves", page="""
There is neither a robot nor a ball.
Give at least one of them.""")
OUT_OF_RANGE = Code("out-of-range", page="""
A length, angle, duration or mass is too large for a sports hall, or too small to be simulated.
Check the unit: lengths are in m, angles in rad, times in s, masses in kg.""")
OUTSIDE_FIELD = Code("outside-field", page="""
A body is outside the field or in a wall at the start.
Move it inside. 'start' gives the centre of a robot; the chassis extends around it.""")
OVERLAPPING_BODIES = Code("overlapping-bodies", page="""
Two bodies overlap at the start.
Move one of them; if it should appear later, let a rule place it.""")
SAME_CHANNEL = Code("same-channel", page="""
Two entrants have the same radio channel, so each would receive the other's messages.
Give one of them another channel.""")
TOO_EARLY = Code("too-early", page="""
A keyframe of a test comes before the one above it.
Keyframes must be in the order of time.""")
TOO_LATE = Code("too-late", page="""
Something should happen after the half, or the test, is over.
Make the half or the test longer, or let it happen earlier. Halves shortened by a param or --set do not count here.""")
UNBOUNDED_ZONE = Code("unbounded-zone", page="""
A random point should be drawn from a zone that is unbounded in some direction, or that has an anchor.
Give the zone all its bounds, or name another zone.""")
DOES_NOT_FIT = Code("does-not-fit", page="""
A goal or a cut corner does not fit into the field, or another goal stands there.
Make it smaller, put it elsewhere, or make the field larger.""")
DESIGN_UNREADABLE = Code("design.unreadable", page="""
robot.yaml cannot be read: it is not strict YAML, or something in it has another form.
Correct the line that is named. Names are texts, and a robot has at most 32 devices.""")
DESIGN_OVER_BUDGET = Code("design.over_budget", page="""
A design costs more points than the guidelines allow.
Leave something out, or choose a cheaper part.""")
DESIGN_TOO_WIDE = Code("design.too_wide", page="""
A robot does not fit in the cylinder of the guidelines.
Make the part smaller that reaches furthest.""")
DESIGN_TOO_HIGH = Code("design.too_high", page="""
A robot is higher than the guidelines allow.
Choose a smaller `size_m`.""")
DESIGN_TOO_HEAVY = Code("design.too_heavy", page="""
A robot weighs more than the guidelines allow.
Choose a smaller `mass_kg`, or lighter wheels.""")
DESIGN_MOUTH = Code("design.mouth", page="""
A ball enters the jaws of a robot too far.
Make the jaws shorter, or closer to each other.""")
DESIGN_NOT_ALLOWED = Code("design.not_allowed", page="""
The guidelines do not allow a part.
Choose one of those that the message lists.""")
DESIGN_TOO_MANY = Code("design.too_many", page="""
There are more parts of a kind, or more designs, than the guidelines allow.
Leave some out.""")
DESIGN_OUT_OF_RANGE = Code("design.out_of_range", page="""
A field of a part is smaller or larger than the guidelines allow, or may not be chosen.
Choose another value, or leave the field out.""")
DESIGN_CANNOT_DRIVE = Code("design.cannot_drive", page="""
The wheels cannot drive the robot in every direction and turn it.
Let three wheels stand in different directions.""")
DESIGN_CONTRADICTION = Code("design.contradiction", page="""
Parts of a design do not fit together.
The message says why.""")
DESIGN_OUTSIDE = Code("design.outside", page="""
A device sits outside of the body.
Move it inwards.""")
DESIGN_NAME_TAKEN = Code("design.name_taken", page="""
A device has the name of one that every robot keeps.
Give it another name.""")
DESIGN_NO_MOTOR = Code("design.no_motor", level="warning", page="""
A wheel has no motor and never turns.
Add a motor with the number of the wheel, unless it shall not turn.""")
DESIGN_UNKNOWN_DESIGN = Code("design.unknown_design", page="""
`robots` names a design that does not exist.
Correct the name.""")
DESIGN_ROBOTS = Code("design.robots", page="""
Not every robot has a design.
Name one for each robot in `robots`, in their order.""")
