"""Codes of the findings of ``rcj-challenge check``."""

from rcj_challenges.core.code import Code

# fmt: off
_FIX = "`rcj-challenge check FILE --fix NEW.zip` repairs this."
_OURS = "This says nothing about the team: please send the submission to the people of this project."
_LOGO = f"Save the logo as a PNG called logo.png, next to the folders of the programs. {_FIX}"

CHECK_BROKEN = Code("check.broken", level="unchecked", page=f"""
The check itself failed.
{_OURS}""")
CHECK_IMPOSSIBLE = Code("check.impossible", level="unchecked", page="""
This stage is not possible with this scenario.
Check whether the scenario can be played here.""")
ARCHIVE_SOUND = Code("archive.sound", "The archive can be read.", level="passed")
LAYOUT_PROGRAM = Code("layout.program", "A program is where the scenario asks for it.", level="passed")
LAYOUT_SAME_PROGRAM = Code("layout.same_program", level="passed", page="""
A program that is never started is the same as one that is.
It can be deleted.""")
LAYOUT_SINGLE_PROGRAM = Code("layout.single_program", level="warning", repair="yes", page=f"""
A single file drives all robots.
A tournament wants a ZIP. {_FIX}""")
LAYOUT_NO_FOLDER = Code("layout.no_folder", level="warning", repair="yes", page=f"""
The programs are at the top level instead of in their folder; they are used anyway.
{_FIX}""")
LAYOUT_FOLDER_NAME = Code("layout.folder_name", level="warning", repair="yes", page=f"""
The only folder with programs does not have the name that the scenario asks for; it is used anyway.
{_FIX}""")
LAYOUT_TOP_FOLDER = Code("layout.top_folder", level="warning", repair="yes", page=f"""
Everything is in an extra folder, which is ignored.
Pack what is in it, not the folder itself. {_FIX}""")
LAYOUT_MISNAMED = Code("layout.misnamed", repair="yes ³", page=f"""
A program is in the wrong place or has the wrong name, such as `….py.txt`; the message says what to rename or move.
Rename it. If names are clear, {_FIX}""")
LAYOUT_EMPTY_ENTRY = Code("layout.empty_entry", repair="yes ⁴", page="""
The file that would be started is empty.
Put the program into it, or delete it.""")
LAYOUT_EMPTY_PROGRAM = Code("layout.empty_program", level="warning", repair="yes ³", page="""
A file that looks like a program is empty.
Delete it.""")
LAYOUT_NEVER_STARTED = Code("layout.never_started", level="warning", page="""
A program is never started: the scenario starts another one, whatever the colour.
Move its code into the program that is started, which can call robot.getName().""")
IDENTITY_NAME = Code("identity.name", "The team has a name.", level="passed")
IDENTITY_LOGO = Code("identity.logo", "The logo can be shown.", level="passed")
IDENTITY_LOGO_MISSING = Code("identity.logo_missing", level="passed", page="""
There is no logo.
None is needed.""")
IDENTITY_LOGO_FILE = Code("identity.logo_file", level="warning", repair="yes", page=f"""
The logo has another name or place than logo.png.
{_LOGO}""")
IDENTITY_LOGO_NO_PICTURE = Code("identity.logo_no_picture", level="warning", repair="yes ⁵", page=f"""
The logo is not a picture.
{_LOGO}""")
IDENTITY_LOGO_TYPE = Code("identity.logo_type", level="warning", repair="yes ⁵", page=f"""
The logo is not a PNG.
{_LOGO}""")
IDENTITY_LOGO_SIZE = Code("identity.logo_size", level="warning", repair="yes ⁵", page=f"""
The logo is more than 1024 pixels wide or high.
{_LOGO}""")
IDENTITY_LOGO_BYTES = Code("identity.logo_bytes", level="warning", repair="yes ⁵", page=f"""
The logo is larger than 1 MB.
{_LOGO}""")
IDENTITY_LOGO_DAMAGED = Code("identity.logo_damaged", level="warning", repair="yes ⁵", page=f"""
The logo is damaged.
{_LOGO}""")
IDENTITY_LOGO_ANIMATED = Code("identity.logo_animated", level="warning", repair="yes ⁵", page=f"""
The logo is animated; only its first picture is shown.
{_LOGO}""")
DESIGN_COST = Code("design.cost", "A design is within the budget; the finding has its price table.", level="passed")
DESIGN_UNUSED_DEVICE = Code("design.unused_device", level="warning", page="""
A design has a device that costs points, and no program has its name.
Leave it out, or ask for it with getDevice. If programs put the name together from parts, all is well.""")
DESIGN_UNUSED = Code("design.unused", level="warning", page="""
There is a robot.yaml, and the scenario has no guidelines for robots.
The robots are those of the scenario; the file does no harm.""")
SOURCES_OK = Code("sources.ok", "All Python files in use can be read, and their imports exist.", level="passed")
SOURCES_MORE = Code("sources.more", level="warning", page="""
There are more findings of this kind.
Start with those that are listed.""")
SOURCES_EMPTY = Code("sources.empty", page="""
A program is empty.
Put your program into this file.""")
SOURCES_SYNTAX = Code("sources.syntax", page="""
Python cannot read a file.
Correct this line, or the one before it.""")
SOURCES_ENCODING = Code("sources.encoding", page="""
A file has characters that Python cannot read: it is not saved as UTF-8.
Save it as UTF-8 in your editor.""")
SOURCES_ODD_ENCODING = Code("sources.odd_encoding", page="""
A file names an unusual encoding.
Save it as UTF-8, and remove the line that names it.""")
SOURCES_NULL_BYTES = Code("sources.null_bytes", page="""
A file has zero bytes in it, so it is not text.
Save it as UTF-8 text in your editor.""")
SOURCES_TOO_DEEP = Code("sources.too_deep", page="""
Brackets or blocks are nested too deeply for Python.
Write it in several smaller steps.""")
SOURCES_TOO_SLOW = Code("sources.too_slow", page="""
Python takes far too long to read a file.
Split it, or put data into another file.""")
SOURCES_LARGE = Code("sources.large", level="warning", page="""
A Python file has more than 64 kB; it is run, but not checked.
Put large data into a file that is not a program.""")
SOURCES_TOO_MANY_IMPORTS = Code("sources.too_many_imports", level="warning", page="""
The files import more than 5000 modules and names; the rest is not checked.
Leave out what is not needed.""")
SOURCES_UNREAD = Code("sources.unread", level="warning", page="""
The Python files have more than 192 kB, counting identical ones once; the rest is not checked.
Leave out what is not needed.""")
SOURCES_REFUSED_MODULE = Code("sources.refused_module", level="warning", page="""
A program imports a module for something that a match refuses: the network, other programs, windows.
Play without it; an import that is not used does no harm.""")
SOURCES_PASSED_OVER = Code("sources.passed_over", level="warning", page="""
A file has the name of a module that Python has loaded before any program, so it is never read.
Give it another name, and import it under that name.""")
SOURCES_SHADOWS = Code("sources.shadows", level="warning", page="""
A file hides a module of Python, numpy or scipy.
Give it another name, unless you want that.""")
SOURCES_MISSING_MODULE = Code("sources.missing_module", page="""
A program imports a module that does not exist.
Put the file next to the program, or do without it. Available are Python's library, numpy, scipy and controller.""")
SOURCES_WRONG_CASE = Code("sources.wrong_case", page="""
A module and its import differ in upper and lower case.
Write both in the same way.""")
SOURCES_ELSEWHERE = Code("sources.elsewhere", page="""
A module is not in a folder in which Python looks for it.
Move it next to the program.""")
SOURCES_MISSING_PART = Code("sources.missing_part", page="""
A file is missing from the folder that an import names: `from robots.robot1 import …` without `robot1.py`.
Add the file, or correct the import.""")
SOURCES_RELATIVE_IMPORT = Code("sources.relative_import", page="""
A file that is not in a package has a relative import.
Write it without the dots.""")
SOURCES_NOT_ON_THIS_COMPUTER = Code("sources.not_on_this_computer", page="""
A module exists on some operating systems only.
Do without it.""")
START_OK = Code("start.ok", "All robots start and answer.", level="passed")
START_SLOW = Code("start.slow", level="warning", page="""
A program comes near the time limit of its start.
Prepare less before the first step.""")
PLAY_PLAYED = Code("play.played", "A short match was played.", level="passed")
PLAY_ABSENT = Code("play.absent", level="warning", page="""
A program called robot.step very rarely.
Do not sleep or wait: call robot.step(32) in a loop instead.""")
PLAY_STANDS = Code("play.stands", level="warning", page="""
A robot did not move.
If it waits on purpose, this is fine; otherwise call setPosition(float("inf")) and setVelocity on both motors.""")
PLAY_NO_TOUCH = Code("play.no_touch", level="warning", page="""
No robot touched the ball.
Watch the replay (--replay DIR): do the robots find it?""")
PLAY_SLOW = Code("play.slow", page="""
A program would use up most of its time in a whole half.
Do less in each step.""")
PLAY_SLOW_STEP = Code("play.slow_step", level="warning", page="""
One step came near its time limit.
Spread long work over many steps.""")
PLAY_PRINTS_MUCH = Code("play.prints_much", page="""
A program prints so much that it may be stopped in a whole half.
Print less.""")
PLAY_THREAD = Code("play.thread", level="warning", page="""
A thread of a program ended with an error.
Correct the line in the report.""")
PLAY_COMPLAINT = Code("play.complaint", level="warning", page="""
The module controller refused or ignored a call.
Correct this call.""")

FAULTS = {
    "crash": "A program ended with an error.\nThe last line of the report says what is wrong, those above it where.",
    "exit": "A program ended while the match goes on.\nCall robot.step(32) in a loop until it returns -1.",
    "start_timeout": "A program took too long to reach its first step.\nCall robot.step(32) sooner; prepare less.",
    "step_timeout": "A program took too long between two steps.\nLook for a loop that never calls robot.step(32).",
    "half_timeout": "A program used too much time in a half.\nDo less in each step.",
    "memory": "A program used too much memory.\nKeep less: is there a list that grows in every step?",
    "output_flood": "A program printed or wrote too much.\nPrint only what changes, or in every 30th step.",
    "protocol": "A program wrote into the channel to the match.\nLeave that to the module controller.",
    "start": "A program could not be started.\nIf the files are in order, this computer may be the reason.",
}
"""Pages by the kind of `rcj_challenges.core.play.Fault`, for the codes of the stages start and play."""
for stage in ("start", "play"):
    for kind, page in FAULTS.items():
        Code(f"{stage}.{kind}", page)
    Code(f"{stage}.no_device", level="warning", page="""
A program asks for a device that its robot does not have.
Correct the name; the finding lists the devices.""")
