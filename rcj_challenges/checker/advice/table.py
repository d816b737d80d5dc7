"""The hints that need only the last line of a traceback, as data.

The first row whose pattern is found in that line gives the hint. ``{name}`` in a help text is the group of that name.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import NamedTuple

from rcj_challenges.core.sanitize import sanitize

_MAX_GROUP_LETTERS = 80
_NAME = r"(?P<name>\w{1,100})"


@dataclass(frozen=True)
class Hint:
    """The cause of a fault.

    Attributes:
        code: identifies the hint.
        remedy: what to do.
        message: what to append to the message of the fault; mostly empty.
    """

    code: str
    remedy: str
    message: str = ""


class Row(NamedTuple):
    """One hint.

    Attributes:
        code: identifies the hint.
        error: pattern of the last line of a traceback.
        help: what to do.
    """

    code: str
    error: str
    help: str


class OldName(NamedTuple):
    """A name that a library no longer has.

    Attributes:
        last_in: the last version that had it.
        instead: what to write now.
    """

    last_in: str
    instead: str


_NUMPY_1 = "numpy 1.x"
_ABSTRACT_CLASSES = ("Callable", "Hashable", "Iterable", "Iterator", "Mapping", "MutableMapping", "Sequence", "Set")

OLD_NAMES: dict[str, OldName] = {
    "numpy.mat": OldName(_NUMPY_1, "np.asmatrix(…)"),
    "numpy.asscalar": OldName(_NUMPY_1, "a.item()"),
    "numpy.bool": OldName(_NUMPY_1, "bool"),
    "numpy.float_": OldName(_NUMPY_1, "np.float64"),
    "numpy.product": OldName(_NUMPY_1, "np.prod(…)"),
    "numpy.trapz": OldName("numpy 2.3", "np.trapezoid(…)"),
    "numpy.in1d": OldName("numpy 2.3", "np.isin(…)"),
    "scipy.misc": OldName("scipy 1.x", "the same with numpy or another part of scipy"),
    "scipy.interpolate.interp2d": OldName("scipy 1.13", "scipy.interpolate.RegularGridInterpolator(…)"),
    "scipy.integrate.simps": OldName("scipy 1.13", "scipy.integrate.simpson(…)"),
    "scipy.integrate.trapz": OldName("scipy 1.13", "scipy.integrate.trapezoid(…)"),
    "scipy.integrate.cumtrapz": OldName("scipy 1.13", "scipy.integrate.cumulative_trapezoid(…)"),
    **{f"collections.{name}": OldName("Python 3.9", f"collections.abc.{name}") for name in _ABSTRACT_CLASSES},
    "fractions.gcd": OldName("Python 3.8", "math.gcd(…)"),
    "time.clock": OldName("Python 3.7", "time.perf_counter()"),
}
OLD_METHODS: dict[str, OldName] = {
    "tostring": OldName("numpy 2.2 and Python 3.8", ".tobytes()"),
    "isAlive": OldName("Python 3.8", ".is_alive()"),
    "iteritems": OldName("Python 2", ".items()"),
    "has_key": OldName("Python 2", '"key in dictionary"'),
    "xrange": OldName("Python 2", "range(…)"),
    "unicode": OldName("Python 2", "str(…)"),
}

_IN_A_MATCH = "in a match there are only Python's own library, numpy and scipy"
_BRACKETS = "a call needs brackets: receiver.getQueueLength(), gps.getValues()[0]"
_NOTHING_THERE = (
    "something in this line is None: a ball that is not in sight, or a function without return; ask first: "
    "if ball is not None:"
)
_VECTORS = (
    "lists are not vectors: use their numbers one by one (p[0] - q[0], 2.5 * p[0]), or arrays: "
    "numpy.array(p) - numpy.array(q)"
)
_WHOLE = "a whole number is needed here: 10 // 2 gives one, 10 / 2 does not; int(x) converts x"
_ADD_TEXT = "text and numbers cannot be added: print('x:', x), or str(x) converts a number to text"
_BYTES_OR_TEXT = (
    "bytes and text are different: getBytes() gives bytes, getString() text, getData() bytes (messages v2.1) or text "
    "(v2.2); data.decode() converts bytes to text, text.encode() text to bytes"
)

TABLE: tuple[Row, ...] = (
    Row(
        "missing_module",
        r"^ModuleNotFoundError: No module named '(?P<name>[\w.]{1,100})'",
        f'put the file or folder "{{name}}" beside the program, or do without it; {_IN_A_MATCH}',
    ),
    Row(
        "syntax",
        r"^(?:SyntaxError|IndentationError|TabError): ",
        "correct this line, or the one before it: is a bracket or a colon missing, or a line indented too far?",
    ),
    Row(
        "not_imported",
        r"^NameError: name '(?P<name>math|time|struct|json|random|sys|os|re|copy|itertools)' is not defined",
        'write "import {name}" at the top of the file',
    ),
    Row(
        "numpy_not_imported",
        r"^NameError: name 'np' is not defined",
        'write "import numpy as np" at the top of the file',
    ),
    Row(
        "unknown_name",
        rf"^NameError: name '{_NAME}' is not defined",
        'is "{name}" misspelled, defined further down, or in another file? Methods are called self.{name}(…)',
    ),
    Row(
        "local_variable",
        rf"^UnboundLocalError: \D{{1,40}} '{_NAME}' ",
        'a function that sets "{name}" has a variable of its own: write "global {name}" as its first line for the one '
        "outside",
    ),
    Row("no_brackets", r"^TypeError: .{0,100}'(?:builtin_function_or_)?method'", _BRACKETS),
    Row("no_brackets", r"^TypeError: cannot unpack non-iterable (?:builtin_function_or_)?method", _BRACKETS),
    Row(
        "not_callable",
        r"^TypeError: '(?:int|float|bool|str|bytes|list|tuple|dict)' object is not callable",
        "what stands before the brackets is not a function: is a variable called so (max = 10), or is a * missing?",
    ),
    Row("none", r"^(?:TypeError: .{0,300}\bNoneType\b|AttributeError: 'NoneType' object )", _NOTHING_THERE),
    Row("add_text", r"^TypeError: can only concatenate str \(not \"(?:float|int)\"\) to str", _ADD_TEXT),
    Row("add_text", r"^TypeError: unsupported operand type\(s\) for \+: '(?:float|int)' and 'str'", _ADD_TEXT),
    Row("vectors", r"^TypeError: unsupported operand .{1,60}'(?:list|tuple)'", _VECTORS),
    Row("vectors", r"^TypeError: can't multiply sequence by non-int of type 'float'", _VECTORS),
    Row("whole_number", r"^TypeError: 'float' object cannot be interpreted as an integer", _WHOLE),
    Row(
        "whole_number",
        r"^TypeError: (?:list|tuple|string) indices must be integers(?: or slices)?, not '?float",
        _WHOLE,
    ),
    Row(
        "too_many_values",
        r"^ValueError: too many values to unpack \(expected 2[,)]",
        "positions have three numbers: x, y, z = gps.getValues()",
    ),
    Row(
        "empty_queue",
        r"^RuntimeError: .{1,200} with an empty queue",
        "read packets in a loop: while receiver.getQueueLength() > 0: … receiver.nextPacket()",
    ),
    Row(
        "encoding",
        r"^UnicodeDecodeError: ",
        'this is not UTF-8 text: save the file as UTF-8, or open(…, encoding="cp1252"); read a packet that is not text '
        "with receiver.getBytes()",
    ),
    Row(
        "bytes_or_text",
        r"^TypeError: (?:a bytes-like object is required, not 'str'|can't concat str to bytes)",
        _BYTES_OR_TEXT,
    ),
    Row(
        "bytes_or_text",
        r"^AttributeError: '(?:str' object .{1,40}'decode'|bytes' object .{1,40}'encode')",
        _BYTES_OR_TEXT,
    ),
    Row(
        "packet_size",
        r"^struct\.error: unpack requires a buffer of ",
        "the packet and the format differ in length: if robots send several kinds of packets, first compare len(data) "
        "with struct.calcsize(format)",
    ),
    Row(
        "not_a_number",
        r"^ValueError: cannot convert float NaN to integer",
        "this number is NaN: sensors give it before their first sample (enable the sensor and call robot.step(32) "
        "before reading it)",
    ),
    Row(
        "debugger",
        r"^bdb\.BdbQuit\b",
        "write breakpoint() instead of pdb.set_trace(): it stops only in the robot that is debugged, rcj-challenge run "
        "match --yellow my_team --debug Y1",
    ),
    Row(
        "refused",
        r"^(?:PermissionError: \[Errno 1\] |PermissionError: \[Errno 13\] |OSError: \[Errno 30\] )",
        "a program may write only into its own folder, which is the current one (the files are deleted after the "
        "half), and can use neither other programs nor the network; threads can do the work of multiprocessing",
    ),
)
"""In this order: the more special before the more general."""

_COMPILED = tuple((row, re.compile(row.error)) for row in TABLE)
_DOTTED = re.compile(
    r"`(?P<numpy>np)\.(?P<a>\w{1,100})` was removed"
    r"|[Mm]odule '(?P<m1>[\w.]{1,100})' has no attribute '(?P<b>\w{1,100})'"
    r"|cannot import name '(?P<c>\w{1,100})' from '(?P<m2>[\w.]{1,100})'"
    r"|No module named '(?P<m3>[\w.]{1,100})\.(?P<d>\w{1,100})'"
)
_METHOD = re.compile(r"object has no attribute '(?P<name>\w{1,100})'|name '(?P<bare>\w{1,100})' is not defined")


def find_row(detail: str) -> Hint | None:
    """Return the hint of the first row that fits the last line of a traceback; None if none does."""
    for row, pattern in _COMPILED:
        if found := pattern.search(detail):
            groups = {name: sanitize(text, _MAX_GROUP_LETTERS) for name, text in found.groupdict().items()}
            return Hint(row.code, row.help.format(**groups))
    return None


def find_old_name(detail: str) -> str:
    """Return what to write for a name that numpy, scipy or Python no longer have; empty if that is not the reason."""
    if (found := _METHOD.search(detail)) and (old := OLD_METHODS.get(name := found["name"] or found["bare"])):
        return _format_old_name(name, old)
    if (found := _DOTTED.search(detail)) is None:
        return ""
    module = "numpy" if found["numpy"] else found["m1"] or found["m2"] or found["m3"]
    name = f"{module}.{found['a'] or found['b'] or found['c'] or found['d']}"
    known = next((known for known in (name, module) if known in OLD_NAMES), None)
    if known is not None:
        return _format_old_name(known, OLD_NAMES[known])
    library = module.partition(".")[0]
    if library not in ("numpy", "scipy"):
        return ""
    return f"if {name} is spelled correctly, an older {library} had it: look for its successor in the documentation"


def _format_old_name(name: str, old: OldName) -> str:
    return f"{old.last_in} was the last version with {name}; write {old.instead} instead"
