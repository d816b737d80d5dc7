"""Why a program came to its end while the match goes on, or its robot stands: what its lines tell of it.

Lines are looked at as text: strange programs are parsed in a process of their own only (`reader`).
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass
from itertools import islice
from pathlib import PurePosixPath

from rcj_challenges.checker.mains import reached_from
from rcj_challenges.facts.shown import shown

_MOST_BYTES = 1_000_000  # of a file; a longer one is no program by hand
_MOST_LINE_BYTES = 300
_MOST_EXCEPTS, _MOST_LINES_ABOVE = 50, 2000  # that are looked at; a program by hand has fewer

_STEP = rb"[\w.]{1,80}\.step\([\w\s.*/+,=-]{0,80}(?:\([\w\s.*/+-]{0,80}\))?\)"
# Loops that go on only as long as step returns something other than 0, which it does at the end of the match.
_ENDS_AT_ZERO = re.compile(rb"while[ \t(]{1,4}" + _STEP + rb"[ \t]{0,4}(?:==[ \t]?-?1|!=[ \t]?0|>[ \t]?0)?[ \t)]{0,4}:")
# Whether the file is the one that was started; of another name it is so for no program.
_ASKS_ITS_NAME = re.compile(rb"""if[ \t(]{1,4}__name__[ \t]{0,4}==[ \t]{0,4}["'](?P<name>[^"']{0,80})["']""")
_FUNCTION = re.compile(rb"def[ \t]+(\w{1,80})[ \t]*\(")
_CLASS = re.compile(rb"class[ \t]+(\w{1,80})")
_TEXT = re.compile(rb"""\"{3}|'{3}""")
_VOWELS = frozenset("AEIOaeio")
# Whatever happens is taken by it; whether it tells it, is for the lines below it to say.
_TAKES_ALL = re.compile(
    rb"except[ \t]{0,4}\(?[ \t]{0,4}(?:(?:Base)?Exception)?[ \t]{0,4}\)?(?:[ \t]{1,4}as[ \t]{1,4}(?P<name>\w{1,80}))?"
    rb"[ \t]{0,4}:(?P<rest>.*)"
)
_PASSES_ON = re.compile(rb"\braise\b")
_TELLS = re.compile(rb"\b(?:exc_info|exception|print_exc\w*|format_exc\w*|print_last|excepthook)\b")
_DRIVE = frozenset((b"setVelocity", b"setPosition", b"velocity", b"target_velocity", b"target_position"))
_LEAVES = re.compile(rb"\b(?:break|return)\b")
_LOOP = re.compile(rb"(?:while|for)\b")
_SETS = re.compile(rb"(?:^|;)[ \t]{0,4}(?:self\.)?(\w{1,80})[ \t]{0,4}[+-]?=(?!=)")
_WORD = re.compile(rb"\w+")
_Line = tuple[int, int, bytes]
"""Number, indentation and code."""
_NAME = re.compile(rb"(?:[\w.]{1,80}\.)?(\w{1,80})")
_USE = re.compile(rb"(?<!def )(?<!class )\b\w+")


def why_it_ended(files: Mapping[PurePosixPath, bytes], entry: PurePosixPath, *, has_stepped: bool = False) -> str:
    """Return what to do about a program that ended without a fault; empty if its lines do not tell.

    Args:
        files: of its team.
        entry: the file that was started.
        has_stepped: whether it called step: then it came to a loop, if there is any that it can come to.
    """
    programs = {path: files[path] for path in reached_from(entry, files) if len(files[path]) <= _MOST_BYTES}
    for path, content in programs.items():
        for number, _, code in _lines(content):
            if _ENDS_AT_ZERO.match(code):
                place = "" if path == entry else f" of {shown(path)}"
                return (
                    f"step returns 0 while the match goes on and -1 at its end, so the loop in line {number}{place} "
                    "ends at once: write while robot.step(32) != -1:"
                )
    loops = list(_loops_with_step(programs.get(entry, b"")))
    used_times = Counter(name[0] for content in programs.values() for name in _USE.finditer(content) if loops)
    unreached = [loop for loop in loops if loop.name and loop.is_reached_by not in used_times]
    if unreached and not (has_stepped and len(unreached) < len(loops)):
        return _told(unreached[0])
    begun = programs.get(entry, b"")
    named = _only_named(loops, begun, used_times) if loops and not has_stepped else ""
    return named or _on_its_name(begun) or _on_except(programs, entry)


@dataclass(frozen=True)
class _Loop:
    """A loop with step.

    Attributes:
        name: of the function or method that it is in; empty outside of them.
        owner: class of the method; empty of a function.
        line: where the function begins, or the loop.
    """

    name: bytes
    owner: bytes
    line: int

    @property
    def is_reached_by(self) -> bytes:
        """The name that must be used for it to be reached: methods with underscores are called by Python itself."""
        return self.owner if self.owner and self.name.startswith(b"__") else self.name


def _told(loop: _Loop) -> str:
    name, owner, place = shown(loop.name), shown(loop.owner), f"line {loop.line}"
    one = f"{'an' if owner[:1] in _VOWELS else 'a'} {owner}"
    if not owner:
        return (
            f"the loop with step is in {name}(), {place}, and nothing calls it: call {name}() at the end of the program"
        )
    if loop.is_reached_by == loop.owner:
        return (
            f"the loop with step is in {name}() of {owner}, {place}, and nothing makes {one}: make one at the "
            "end of the program"
        )
    return (
        f"the loop with step is in the method {name}() of {owner}, {place}, and nothing calls it: make {one} at "
        f"the end of the program and call its {name}()"
    )


def _only_named(loops: Sequence[_Loop], content: bytes, used_times: Mapping[bytes, int]) -> str:
    """Return what to do about a function whose name stands in a line alone, without brackets; empty if it is called."""
    wanted = {loop.is_reached_by for loop in loops if loop.name and used_times[loop.is_reached_by] == 1}
    for number, _, code in _lines(content):
        if (alone := _NAME.fullmatch(code)) is not None and alone[1] in wanted:
            name = shown(code)
            return f"line {number} names {name} and does not call it: a call needs brackets, {name}()"
    return ""


def _on_its_name(content: bytes) -> str:
    """Return what to do about a program that does something only under a name which it has not when it is started."""
    asked = [(number, found["name"]) for number, _, code in _lines(content) if (found := _ASKS_ITS_NAME.match(code))]
    if not asked or b"__main__" in (name for _, name in asked):
        return ""
    return (
        f'a program that is started has the name "__main__", so nothing comes to what is under line {asked[0][0]}: '
        'write if __name__ == "__main__":'
    )


def _on_except(programs: Mapping[PurePosixPath, bytes], entry: PurePosixPath) -> str:
    """Return what to do about an ``except`` that takes every error and may have ended all; one that is quiet first."""
    told = ""
    for path, number, tells in _ending_excepts(programs):
        place = "" if path == entry else f" of {shown(path)}"
        named = f'the "except" in line {number}{place} takes every error: if one ended the program,'
        if not tells:
            return f"{named} it kept quiet about it. Write traceback.print_exc() there, and import traceback at the top"
        told = told or (
            f"{named} what was printed of it stands in the program's output (--show-output). Without try and except "
            "Python tells its line as well"
        )
    return told


def why_it_stands(files: Mapping[PurePosixPath, bytes], entry: PurePosixPath) -> str:
    """Return what to do about an ``except`` that may keep a robot from driving without a word; empty if there is none.

    Args:
        files: of its team.
        entry: the file that was started.
    """
    programs = {path: files[path] for path in reached_from(entry, files) if len(files[path]) <= _MOST_BYTES}
    driving = _with_callers(_DRIVE, programs.values())
    for path, one in _excepts(programs):
        if not one.tells and any(not driving.isdisjoint(_WORD.findall(code)) for code in _tried(one.lines, one.at)):
            place = "" if path == entry else f" of {shown(path)}"
            return (
                f'the "except" in line {one.number}{place} takes every error and keeps quiet about it: write '
                "traceback.print_exc() there, and import traceback at the top"
            )
    return ""


@dataclass(frozen=True)
class _Except:
    """An ``except`` that takes every error, and lets none pass.

    Attributes:
        lines: of its file.
        at: which of them it is.
        handler: what is done then.
        tells: whether that tells the error.
    """

    lines: Sequence[_Line]
    at: int
    handler: Sequence[bytes]
    tells: bool

    @property
    def number(self) -> int:
        """Of its line, as editors show it."""
        return self.lines[self.at][0]


def _excepts(programs: Mapping[PurePosixPath, bytes]) -> Iterator[tuple[PurePosixPath, _Except]]:
    """Yield each ``except`` of programs that takes every error, with its file."""
    for path, content in programs.items():
        lines = list(_lines(content))
        found = ((at, taken) for at, line in enumerate(lines) if (taken := _TAKES_ALL.fullmatch(line[2])) is not None)
        for at, taken in islice(found, _MOST_EXCEPTS):
            handler = [taken["rest"], *_inside(lines, at)]
            if not any(_PASSES_ON.search(code) for code in handler):
                tells = any(_TELLS.search(code) or taken["name"] in _WORD.findall(code) for code in handler)
                yield path, _Except(lines, at, handler, tells)


def _ending_excepts(programs: Mapping[PurePosixPath, bytes]) -> Iterator[tuple[PurePosixPath, int, bool]]:
    """Yield file and line of each ``except`` that takes every error and may end the loop, and whether it tells any."""
    looping = {path: list(_loops_with_step(content)) for path, content in programs.items()}
    holding = {name for loops in looping.values() for loop in loops for name in (loop.name, loop.owner)} - {b""}
    held_by = _with_callers(holding, programs.values())
    for path, one in _excepts(programs):
        # A file does not import itself: in robot.py, robot is that of the match.
        files = {other.stem.encode("utf-8", "surrogateescape") for other in looping if looping[other] and other != path}
        if _may_end_it(one.lines, one.at, one.handler, held_by | files):
            yield path, one.number, one.tells


def _with_callers(names: AbstractSet[bytes], contents: Iterable[bytes]) -> AbstractSet[bytes]:
    """Return names of functions and classes, and of those that call them, directly or by way of others."""
    callers: dict[bytes, set[bytes]] = {}  # by what they mention
    for content in contents:
        for caller, code in _code_of_functions(content):
            for word in _WORD.findall(code):
                callers.setdefault(word, set()).add(caller)
    found, todo = set(names), list(names)
    while todo:
        more = callers.get(todo.pop(), set()) - found
        found |= more
        todo += more
    return found


def _code_of_functions(content: bytes) -> Iterator[tuple[bytes, bytes]]:
    """Yield the lines inside of functions, each with the function's name; of an ``__init__`` with that of its class."""
    around: list[tuple[int, bytes, bool]] = []  # indentation, name, and whether it is a class
    for _, depth, code in _lines(content):
        while around and depth <= around[-1][0]:
            around.pop()
        if (found := _FUNCTION.match(code)) is not None:
            made = found[1] == b"__init__" and bool(around)
            around.append((depth, around[-1][1] if made else found[1], False))
        elif (found := _CLASS.match(code)) is not None:
            around.append((depth, found[1], True))
        elif around and not around[-1][2]:
            yield around[-1][1], code


def _may_end_it(lines: Sequence[_Line], at: int, handler: Sequence[bytes], to_loops: AbstractSet[bytes]) -> bool:
    """Return whether the loop with step is over after an ``except``: mostly a program just goes on below it.

    Args:
        lines: of the program.
        at: which of them is the ``except``.
        handler: what is done then.
        to_loops: names of functions, classes and files that hold a loop with step.
    """
    tried = list(_tried(lines, at))
    leaves = any(_LEAVES.search(line) for line in handler)
    if any(b".step(" in code for code in tried) and (leaves or any(_LOOP.match(code) for code in tried)):
        return True
    if any(not to_loops.isdisjoint(_WORD.findall(code)) for code in tried):
        return True
    around = _loop_around(lines, at)
    if around is None:
        return False
    head = lines[around][2]
    if b".step(" not in head and not any(b".step(" in code for code in _inside(lines, around)):
        return False
    asked = set(_WORD.findall(head))
    return leaves or any(name in asked for line in handler for name in _SETS.findall(line))


def _tried(lines: Sequence[_Line], at: int) -> Iterator[bytes]:
    """Return the code of the lines above an ``except``, its ``try`` included."""
    for above in range(at - 1, max(-1, at - 1 - _MOST_LINES_ABOVE), -1):
        _, depth, code = lines[above]
        if depth < lines[at][1]:
            return
        yield code  # behind a try as well: it may stand in one line
        if depth == lines[at][1] and code.startswith(b"try"):
            return


def _loop_around(lines: Sequence[_Line], at: int) -> int | None:
    """Return which line begins the innermost loop around one, in the same function."""
    depth = lines[at][1]
    for above in range(at - 1, max(-1, at - 1 - _MOST_LINES_ABOVE), -1):
        _, outer, code = lines[above]
        if outer < depth:
            depth = outer
            if _LOOP.match(code):
                return above
            if code.startswith((b"def ", b"class ")):
                return None
    return None


def _inside(lines: Sequence[_Line], at: int) -> Iterator[bytes]:
    """Return the code of the lines that are indented below one of them."""
    for below in range(at + 1, len(lines)):
        _, depth, code = lines[below]
        if depth <= lines[at][1]:
            return
        yield code


def _lines(content: bytes) -> Iterator[_Line]:
    """Return number, indentation and code of each line that has any and is not too long to be looked at."""
    ends_text = b""
    for number, line in enumerate(content.splitlines(), start=1):
        code = line.strip()
        if ends_text:  # of several lines: a description, or a part of the program that is switched off
            ends_text = b"" if ends_text in code else ends_text
            continue
        if (quotes := _TEXT.search(code)) is not None and code.count(quotes[0]) % 2 and not code.startswith(b"#"):
            ends_text = quotes[0]
        if code and not code.startswith(b"#") and len(line) <= _MOST_LINE_BYTES:
            yield number, len(line) - len(line.lstrip()), code


def _loops_with_step(content: bytes) -> Iterator[_Loop]:
    """Return the functions and methods in which a loop calls step, and the first such loop outside of them."""
    around: list[tuple[int, bytes]] = []  # indentation, and name if it is a class, of what the line is in
    function, owner, at, loops, is_outside_told = b"", b"", 0, False, False
    for number, depth, code in _lines(content):
        while around and depth <= around[-1][0]:
            around.pop()
            function, loops = b"", False
        found = _FUNCTION.match(code)
        if found is not None:
            function, at, owner, loops = found[1], number, around[-1][1] if around else b"", False
            around.append((depth, b""))
        elif (found := _CLASS.match(code)) is not None:
            around.append((depth, found[1]))
        loops = loops or code.startswith(b"while")
        if loops and b".step(" in code:
            if function:
                yield _Loop(function, owner, at)
                function, loops = b"", False
            elif not around and not is_outside_told:
                is_outside_told = True
                yield _Loop(b"", b"", number)
