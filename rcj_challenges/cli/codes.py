"""Codes about the command line."""

from rcj_challenges.core.code import Code

# fmt: off
_SCENARIO_HAS = "The help of the error lists the names that the scenario has."

BAD_ARGUMENTS = Code("bad-arguments", page="""
The command has an option or an argument that it does not know.
`--help` lists all of them.""")
BAD_FPS = Code("bad-fps", page="""
A video cannot have this number of pictures per second.
Give --fps from 1 to 240.""")
BAD_OUT = Code("bad-out", page="""
The file to write has a wrong ending, or its folder does not exist.
The message says what fits.""")
BAD_SPEED = Code("bad-speed", page="""
A speed cannot be read, or is out of range.
The message says what is allowed.""")
BAD_DURATION = Code("bad-duration", page="""
A time cannot be read.
Write 90, 90s or 1:30.""")
BAD_NAME = Code("bad-name", page="""
A name cannot be the name of a file on every computer.
Use letters, digits and _.""")
BAD_SEEDS = Code("bad-seeds", page="""
The seeds cannot be read.
Write 1..10, 3 or 1,4,7..9.""")
BAD_TEAM_NAME = Code("bad-team-name", page="""
The name of a team has no characters that can be shown.
Use letters.""")
CANNOT_WRITE_OUTPUT = Code("cannot-write-output", page="""
The output of the command cannot be written.
Free some space, or print elsewhere.""")
NOT_TAKEN = Code("not-taken", page="""
The site did not take the archive. The message says why.
Do what it says, and hand it in again.""")
SITE_UNREACHABLE = Code("site-unreachable", page="""
The site does not answer at this address.
Compare the address with the card, and check your connection. What was handed in is what you have a receipt for.""")
WRONG_CARD = Code("wrong-card", page="""
The code is not that of any card.
Compare it with the card; a mentor can replace a lost one.""")
BAD_URL = Code("bad-url", page="""
The address of a site cannot be one.
Begin it with https:// or http://.""")
DEVICE_NAME = Code("device-name", page="""
A file has the name of a Windows device, such as CON or AUX.
Choose another name.""")
INTERNAL_ERROR = Code("internal-error", page="""
Something went wrong in this program, not in your input.
Please send the report that the message names to the people of this project.""")
MISSING_PACKAGE = Code("missing-package", page="""
A package that this program needs is not installed.
Install it as the README says.""")
NO_SAMPLE_TEAM = Code("no-sample-team", page="""
No team was given for a seat, and no sample team fits.
Give one with --team SEAT=PATH.""")
OPTION_DOES_NOT_FIT = Code("option-does-not-fit", page="""
An option needs another one, or does not fit the others.
The help of the error says which.""")
OPTION_GIVEN_TWICE = Code("option-given-twice", page="""
An option is given twice.
Leave one out.""")
OPTIONS_CONTRADICT = Code("options-contradict", page="""
Two options contradict each other.
Give one of them.""")
SET_ON_TOURNAMENT = Code("set-on-tournament", page="""
--set changes scenarios, and a tournament file was given.
Change the file.""")
UNKNOWN_CODE = Code("unknown-code", page="""
There is no page for a code.
`rcj-challenge explain` lists all codes.""")
UNKNOWN_ENTRANT = Code("unknown-entrant", page=f"""
An option names an entrant that the scenario does not have.
{_SCENARIO_HAS}""")
UNKNOWN_PRESET = Code("unknown-preset", page="""
There is no such preset for a new challenge.
The help of the error lists them.""")
UNKNOWN_ROBOT = Code("unknown-robot", page=f"""
An option names a robot that the scenario does not have.
{_SCENARIO_HAS}""")
