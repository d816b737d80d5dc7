"""The commonest errors of programs, recognized by the last line of the traceback."""

from __future__ import annotations

import re

from rcj_challenges.core.sanitize import sanitize

_MAX_GROUP_CHARACTERS = 80

HELP_BY_ERROR: dict[str, str] = {
    r"^ModuleNotFoundError: No module named '(?P<name>[\w.]{1,100})'": (
        'put the file or folder "{name}" beside the program, or do without it; in a match there are only Python\'s own '
        "library, numpy and scipy"
    ),
    r"^(?:AttributeError: (?:partially initialized )?module |ImportError: cannot import name '\w{1,100}' from )"
    r"'(?P<name>[\w.]{1,100})'": (
        'is there a file "{name}.py" in your folder? It hides the module of that name: rename it; else the name is '
        "misspelled, or only older versions have it"
    ),
    r"^(?:SyntaxError|IndentationError|TabError): ": (
        "correct this line, or the one before it: is a bracket or a colon missing, or a line indented too far?"
    ),
    r"^NameError: name '(?P<name>math|time|struct|json|random|sys|os|re|copy|itertools)' is not defined": (
        'write "import {name}" at the top of the file'
    ),
    r"^NameError: name '(?P<name>\w{1,100})' is not defined": (
        'is "{name}" misspelled, defined further down, or in another file? Methods are called self.{name}(…), and np '
        "needs import numpy as np"
    ),
    r"^UnboundLocalError: \D{1,40} '(?P<name>\w{1,100})' ": (
        'a function that sets "{name}" has a variable of its own: write "global {name}" as its first line for the one '
        "outside"
    ),
    r"^TypeError: (?:.{0,100}'(?:builtin_function_or_)?method'|cannot unpack non-iterable .{0,20}method)": (
        "a call needs brackets: receiver.getQueueLength(), gps.getValues()[0]"
    ),
    r"^TypeError: '(?:int|float|bool|str|bytes|list|tuple|dict)' object is not callable": (
        "what stands before the brackets is not a function: is a variable called so (max = 10), or is a * missing?"
    ),
    r"^AttributeError: (?:'numpy\.ndarray' object has no attribute 'tostring'|`ptp` was removed from the ndarray)": (
        "numpy has removed this method: write array.tobytes() for array.tostring(), and np.ptp(array) for array.ptp()"
    ),
    r"^(?:TypeError: .{0,300}\bNoneType\b|AttributeError: 'NoneType' object )": (
        "something in this line is None: a ball that is not in sight, or a function without return; test it first: if "
        "ball is not None:"
    ),
    r"^TypeError: (?:can only concatenate str |unsupported operand type\(s\) for \+: '(?:float|int)' and 'str')": (
        "text and numbers cannot be added: print('x:', x), or str(x) converts a number to text"
    ),
    r"^TypeError: (?:unsupported operand .{1,60}'(?:list|tuple)'|can't multiply sequence by non-int of type )": (
        "lists are not vectors: use their numbers one by one (p[0] - q[0], 2.5 * p[0]), or arrays: "
        "numpy.array(p) - numpy.array(q)"
    ),
    r"^TypeError: (?:'float' object cannot be interpreted as an integer|.{1,10} indices must be integers)": (
        "a whole number is needed here: 10 // 2 gives one, 10 / 2 does not; int(x) converts x"
    ),
    r"^ValueError: too many values to unpack \(expected 2[,)]": (
        "positions have three numbers: x, y, z = gps.getValues()"
    ),
    r"^(?:UnicodeDecodeError: |struct\.error: unpack requires a buffer"
    r"|TypeError: (?:a bytes-like object is required, not 'str'|can't concat str to bytes)"
    r"|AttributeError: '(?:str' object .{1,40}'decode'|bytes' object .{1,40}'encode'))": (
        "bytes and text are different: getBytes() gives bytes, getString() text, getData() bytes (messages v2.1) or "
        "text (v2.2); if robots send several kinds of packets, compare len(data) with struct.calcsize(format) first"
    ),
    r"^ValueError: cannot convert float NaN to integer": (
        "this number is NaN: sensors give it before their first sample (enable the sensor and call robot.step(32) "
        "before reading it)"
    ),
    r"^(?:PermissionError: \[Errno (?:1|13)\] |OSError: \[Errno 30\] )": (
        "a program may write only into its own folder, which is the current one (the files are deleted after the "
        "half), and can use neither other programs nor the network; threads can do the work of multiprocessing"
    ),
}
"""Help by a pattern of that line; ``{name}`` is the group of that name. The more special ones come first."""

_COMPILED = tuple((re.compile(pattern), help_) for pattern, help_ in HELP_BY_ERROR.items())


def help_for_error(detail: str) -> str:
    """Return the help of the first pattern that is found in the last line of a traceback; empty if none is."""
    for pattern, help_ in _COMPILED:
        if found := pattern.search(detail):
            groups = {name: sanitize(text, _MAX_GROUP_CHARACTERS) for name, text in found.groupdict().items()}
            return help_.format(**groups)
    return ""
