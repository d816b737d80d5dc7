"""Slips that every pupil makes once: what Python says of them, and what to do."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import PurePosixPath

from rcj_challenges.checker.advice.crash_lines import PLACE, CrashLine, crash_line, set_in, text_of, used_none
from rcj_challenges.checker.advice.unknown_names import on_unknown_name
from rcj_challenges.checker.advice.unset_attributes import on_unset_attribute
from rcj_challenges.checker.modules import instead_of_the_folder
from rcj_challenges.facts.shown import shown

_MOST_NAME = 100  # letters
_CIRCLE = re.compile(
    r"partially initialized module '(?P<module>[\w.]+)' .{0,200}\(most likely due to a circular import\)"
)
_NO_PACKAGE = re.compile(
    r"^ModuleNotFoundError: No module named '(?P<whole>[\w.]{1,200})'; '(?P<file>[\w.]{1,200})' is not a package"
)
_UNSET = re.compile(
    rf"^UnboundLocalError: (?:cannot access local variable|local variable) '(?P<name>\w{{1,{_MOST_NAME}}})' "
)
_UNKNOWN = re.compile(rf"^NameError: name '(?P<name>\w{{1,{_MOST_NAME}}})' is not defined")
_TOO_MANY = re.compile(r"^ValueError: too many values to unpack \(expected 2[,)]")
_ONE_TOO_MANY = re.compile(
    rf"^TypeError: \w{{1,{_MOST_NAME}}}\.(?P<method>\w{{1,{_MOST_NAME}}})\(\) takes (?P<takes>[0-9]{{1,3}}) positional "
    r"arguments? but (?P<given>[0-9]{1,3}) were given"
)
_THREE = re.compile(r"\b(?:getValues|getEmitterDirection)\b|\.(?:values|emitter_direction)\b(?!\()")
_TAKES_A_NAME = re.compile(rf"=[ \t]{{0,20}}(?P<name>\w{{1,{_MOST_NAME}}})[ \t]{{0,20}}(?:#|$)")
_OF_THREE = r"(?:(?:getValues|getEmitterDirection)\(\)|values|emitter_direction)[ \t]{0,20}(?:#|$)"
_THREE_NUMBERS = "these are three numbers: x, y, z = gps.getValues()"
_NO_VECTORS = (
    "lists do not reckon as vectors: take their numbers one by one (p[0] - q[0]), or make arrays of them: "
    "numpy.array(p) - numpy.array(q)"
)
_NO_FACTOR = (
    "a list or a text can be taken twice (2 * p), but not 2.5 times: take the numbers of a list one by one "
    "(2.5 * p[0]), or make an array of it (2.5 * numpy.array(p)); float(x) makes a number of a text"
)
_TEXT_AND_NUMBER = "text and numbers do not add up: print('x:', x), or str(x) makes text of a number"
_WHOLE = "a whole number is wanted: 10 // 2 gives one, 10 / 2 does not; int(x) makes one of x"
_NAME_IS_NO_NUMBER = "a robot's name is a letter and a number: int(robot.getName()[1])"
_GO_ROUND = (
    "a function calls itself over and over (its name comes again and again in the report below): write a while loop"
)
_BRACKETS = "a call needs brackets: receiver.getQueueLength(), gps.getValues()[0]"
_SELF = "a method has self as its first argument: def run(self):"
_AN_OBJECT = "the class itself is no object: make one, with brackets: robot = Robot()"
_NO_TEXT = (
    'what is read is no UTF-8 text: save the file as UTF-8, or name how it was saved, open(…, encoding="cp1252"); '
    "get a packet that is no text by receiver.getBytes(), for struct.unpack or pickle.loads, as it was sent"
)
_BYTES_OR_TEXT = (
    "bytes and text are two things: getBytes() gives bytes, getString() text, getData() bytes (messages v2.1) or text "
    "(v2.2); data.decode() makes text of bytes, text.encode() bytes of text"
)
_OTHER_LENGTH = (
    "the packet has another length than the format: where robots send packets of several kinds, compare len(data) with "
    "struct.calcsize(format) first"
)
_OUT_OF_BOUNDS = (
    "math.acos and math.asin take numbers from -1 to 1, math.sqrt and math.log none below 0, and rounding leads beyond "
    "by a hair: math.acos(max(-1, min(1, x)))"
)
NOTHING_THERE = (
    "something in this line is None: a ball that is not in sight, what has not come yet, what a function without "
    "return gives; ask first: if ball is not None:"
)
# Calls of devices that give nothing, at the end of a line that sets a name.
_GIVES_NOTHING = re.compile(
    r"=[^;]{1,200}\.(?P<call>enable|disable|setPosition|setVelocity|nextPacket|setChannel)\([^()]{0,60}(?:\([^()]{0,40}\))?\)"
    r"[ \t]{0,20}(?:[;#]|$)"
)
_NO_SUCH_LETTER = (
    'each letter of the format takes one kind: whole numbers for "i" (int(x)), any for "f" and "d", True or False for '
    '"?"; None fits no letter: of a ball that is not in sight send a number that stands for it'
)
_NO_END = (
    "this number is infinite: so is what a lidar gives beyond its range, and a division by 0 in numpy; ask first: "
    "if math.isfinite(x):"
)
_NO_SCREEN = "there is no screen in a match: do without windows (tkinter, turtle)"
_NO_DEBUGGER = (
    "nobody types in a match: leave out breakpoint() and pdb.set_trace(); "
    "they work in a run with --debug and the robot's name, as in rcj-challenge run match --debug Y1"
)
_STEP_FIRST = (
    "this number is NaN: so is what a sensor gives before its first sample (enable it, and call robot.step(32) before "
    "it is read), and getSignalStrength() where no packet waits (ask getQueueLength() first)"
)
_NO_FUNCTION = (
    "what stands before the brackets is no function: is there a variable of a function's name (max = 10), "
    "or is a * missing?"
)
_THREADS_ONCE = (
    "start a thread once, before the loop, and not in every step: a match allows 32 at a time, unless its scenario "
    "says otherwise"
)
_REMEDIES = (
    (
        re.compile(r"^TypeError: '(?:int|float|complex|bool|str|bytes|list|tuple|dict|set)' object is not callable"),
        _NO_FUNCTION,
    ),
    (
        re.compile(r"^AttributeError: type object '\w{1,100}' has no attribute '\w{1,100}'(?: \(|$)"),
        "the class has no such name: write it as it stands there, capital and small letters count",
    ),
    (re.compile(r"^RuntimeError: can't start new thread"), _THREADS_ONCE),
    (re.compile(r"^RecursionError: maximum recursion depth exceeded"), _GO_ROUND),
    (re.compile(r"^TypeError: .{1,100}'(?:builtin_function_or_)?method' and '"), _BRACKETS),
    (re.compile(r"^TypeError: .{1,100}' and '(?:builtin_function_or_)?method'"), _BRACKETS),
    (re.compile(r"^TypeError: '(?:builtin_function_or_)?method' object is not (?:subscriptable|iterable)"), _BRACKETS),
    (re.compile(r"^TypeError: cannot unpack non-iterable (?:builtin_function_or_)?method object"), _BRACKETS),
    (re.compile(r"^TypeError: \w{1,100}\.\w{1,100}\(\) takes 0 positional arguments but "), _SELF),
    (re.compile(r"^TypeError: .{1,200} missing 1 required positional argument: 'self'"), _AN_OBJECT),
    (re.compile(r"^TypeError: .{0,300}\bNoneType\b"), NOTHING_THERE),
    (re.compile(r"^struct\.error: required argument is not an? (?:integer|float)"), _NO_SUCH_LETTER),
    (re.compile(r"^OverflowError: cannot convert float infinity to integer"), _NO_END),
    (re.compile(r"^_tkinter\.TclError: "), _NO_SCREEN),
    (re.compile(r"^bdb\.BdbQuit\b"), _NO_DEBUGGER),
    (re.compile(r"^UnicodeDecodeError: 'utf-8' codec can't decode "), _NO_TEXT),
    (
        re.compile(r"^TypeError: (?:a bytes-like object is required, not 'str'|can't concat str to bytes)"),
        _BYTES_OR_TEXT,
    ),
    (re.compile(r"^AttributeError: '(?:str' object .{1,40}'decode'|bytes' object .{1,40}'encode')"), _BYTES_OR_TEXT),
    (re.compile(r"^struct\.error: unpack requires a buffer of "), _OTHER_LENGTH),
    (
        re.compile(r"^ValueError: (?:math domain error|expected a (?:number in range|nonnegative|positive) )"),
        _OUT_OF_BOUNDS,
    ),
    (re.compile(r"^ValueError: cannot convert float NaN to integer"), _STEP_FIRST),
    (re.compile(r"^TypeError: unsupported operand type\(s\) for \S{1,4}: '(?:list|tuple)' and '"), _NO_VECTORS),
    (
        re.compile(r"^TypeError: unsupported operand type\(s\) for \S{1,4}: '\w{1,20}' and '(?:list|tuple)'"),
        _NO_VECTORS,
    ),
    (re.compile(r"^TypeError: can't multiply sequence by non-int of type 'float'"), _NO_FACTOR),
    (re.compile(r"^TypeError: can only concatenate str \(not \"(?:float|int)\"\) to str"), _TEXT_AND_NUMBER),
    (re.compile(r"^TypeError: unsupported operand type\(s\) for \+: '(?:float|int)' and 'str'"), _TEXT_AND_NUMBER),
    (re.compile(r"^TypeError: 'float' object cannot be interpreted as an integer"), _WHOLE),
    (re.compile(r"^TypeError: (?:list|tuple|string) indices must be integers(?: or slices)?, not '?float"), _WHOLE),
    (re.compile(r"^ValueError: invalid literal for int\(\) with base 10: '[BY][0-9]'"), _NAME_IS_NO_NUMBER),
)


def on_slip(detail: str, files: Mapping[PurePosixPath, bytes]) -> str:
    """Return what to do about a crash of a kind that many programs have; nothing if it is none.

    Args:
        detail: the last line of what the program told of its end, and its place.
        files: of the team.
    """
    if found := _NO_PACKAGE.match(detail) or _CIRCLE.search(detail):
        return _on_import(found, detail, files)
    if found := _UNSET.match(detail):
        return _on_unset(found["name"], detail, files)
    if found := _UNKNOWN.match(detail):
        return on_unknown_name(found["name"], detail, files)
    if _TOO_MANY.match(detail):
        line = crash_line(detail, files)
        return _THREE_NUMBERS if line is not None and _takes_a_place(line, files) else ""
    if (found := _ONE_TOO_MANY.match(detail)) and int(found["given"]) == int(found["takes"]) + 1:
        return _on_self(found["method"], files)
    told = next((remedy for words, remedy in _REMEDIES if words.match(detail)), "")
    return told or _on_nothing_given(detail, files) or on_unset_attribute(detail, files)


def _on_nothing_given(detail: str, files: Mapping[PurePosixPath, bytes]) -> str:
    """Tell of a crash over None which a name was given by a call of a device that gives nothing."""
    holder = used_none(detail, files)[1]
    found = next(filter(None, map(_GIVES_NOTHING.search, set_in(holder, files))), None)
    if found is None:
        return ""
    return (
        f'{found["call"]}() gives nothing back, so "{holder}" is None: keep what getDevice gives, '
        f"{holder} = robot.getDevice(…), and call {holder}.{found['call']}(…) in a line of its own"
    )


def _on_import(found: re.Match[str], detail: str, files: Mapping[PurePosixPath, bytes]) -> str:
    return (
        _on_circle(found["module"], detail) if found.re is _CIRCLE else _on_no_package(**found.groupdict(), files=files)
    )


def _takes_a_place(line: CrashLine, files: Mapping[PurePosixPath, bytes]) -> bool:
    """Return whether a line takes apart what a sensor gives for a place or a direction, or a name that was given it."""
    if _THREE.search(line.code):
        return True
    if (taken := _TAKES_A_NAME.search(line.code)) is None:
        return False
    gives = rf"^[ \t]{{0,100}}{taken['name']}[ \t]{{0,20}}=[ \t]{{0,20}}[\w.]{{1,{_MOST_NAME}}}\.{_OF_THREE}"
    return re.search(gives, text_of(files[line.file]), re.MULTILINE) is not None


def _on_circle(module: str, detail: str) -> str:
    place = PLACE.search(detail)
    importer = PurePosixPath(place["file"]).name if place is not None else "another file"
    file = f"{module.rpartition('.')[2]}.py"
    if importer == file:
        return f"{shown(file)} imports itself: leave out that import, or give the file another name"
    return (
        f"{shown(file)} and {shown(importer)} import each other, in a circle: move what both need into a third file, "
        "or write the import into the function that needs it"
    )


def _on_no_package(whole: str, file: str, files: Mapping[PurePosixPath, bytes]) -> str:
    program = next((path for path in files if path.parts[-2:] == (file, f"{file}.py")), None)
    part = whole.removeprefix(f"{file}.").partition(".")[0]
    return "" if program is None else instead_of_the_folder(program, part, files)


def _on_unset(name: str, detail: str, files: Mapping[PurePosixPath, bytes]) -> str:
    """Tell of a variable that is set outside of a function as well: what most likely is meant is that one."""
    place = crash_line(detail, files)
    if place is None or not re.search(
        rf"^{name}[ \t]{{0,20}}(?::[^=\n]{{1,100}})?=(?!=)", text_of(files[place.file]), re.MULTILINE
    ):
        return ""
    return (
        f'"{name}" outside of the function is another variable, as long as the function sets one of that name itself: '
        f'write "global {name}" as its first line'
    )


def _on_self(method: str, files: Mapping[PurePosixPath, bytes]) -> str:
    """Tell of a method whose first argument is none for the object, if all of its name are so."""
    first = rf"^[ \t]{{1,40}}def[ \t]{{1,4}}{method}[ \t]{{0,4}}\([ \t]{{0,4}}(\w{{0,{_MOST_NAME}}})"
    programs = [text_of(content) for path, content in files.items() if path.suffix == ".py"]
    if any(words in program for words in ("staticmethod", "classmethod") for program in programs):
        return ""
    named = {found for program in programs for found in re.findall(first, program, re.MULTILINE)}
    if not named or any(rf"{name}." in program for name in named if name for program in programs):
        return ""  # whatever it is called, it is taken for the object
    return f"a method has self as its first argument: def {method}(self, …):" if "self" not in named else ""
