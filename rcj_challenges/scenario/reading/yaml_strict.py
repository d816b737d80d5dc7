"""YAML, strictly: the scalars of YAML 1.2's core schema, one document, nothing that hides or refers.

PyYAML reads YAML 1.1, in which ``on`` is True, ``12:30`` is 750, ``010`` is 8, ``1e3`` is text and a repeated key wins
silently. Here only its event stream is used; scalars are resolved and the tree is built by this module, with line and
column of every key and value. Anchors, aliases, tags, directives and further documents are refused as they pass by,
before anything is built from them.
"""

from __future__ import annotations

import json
import math
import re
from contextlib import suppress
from math import inf
from typing import Any

import yaml

from rcj_challenges.core.code import Code
from rcj_challenges.core.diagnostics import Diagnostic
from rcj_challenges.scenario.codes import DUPLICATE_KEY, EMPTY_FILE, INVALID_YAML, NOT_UTF8
from rcj_challenges.scenario.errors import ScenarioError
from rcj_challenges.scenario.tree import MAX_VALUES, Entries, Items, Leaf, Mark, Node, check_amount, too_large

MAX_BYTES = 1_000_000
"""A scenario of a whole tournament is under 50 kB; ten times the largest sensible file is still read in a second."""

MAX_DEPTH = 30
"""The deepest value of the vocabulary stands 12 levels deep."""

_LOADER: Any = getattr(yaml, "CSafeLoader", yaml.SafeLoader)

# YAML 1.2.2, section 10.3.2 (core schema).
_WORDS: dict[str, bool | None] = {
    **dict.fromkeys(("", "~", "null", "Null", "NULL"), None),
    **dict.fromkeys(("true", "True", "TRUE"), True),
    **dict.fromkeys(("false", "False", "FALSE"), False),
}
_INT = re.compile(r"[-+]?[0-9]+|0o[0-7]+|0x[0-9a-fA-F]+")
_FLOAT = re.compile(r"[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?")
_NOT_FINITE = re.compile(r"[-+]?\.(inf|Inf|INF)|\.(nan|NaN|NAN)")
INT_LIMIT = 2**63

_SURROGATE = re.compile("[\ud800-\udfff]")
# Listed one by one: the complement of what YAML 1.2 prints (section 5.1) takes 20 times as long to compile.
_UNPRINTABLE = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x84\x86-\x9f\ud800-\udfff\ufeff\ufffe\uffff]")

_MAX_WRITTEN = 40  # characters of a value that a message repeats as they are
_UNCLOSED = "a ',' or the closing bracket is missing, or a text with ': ', {, [ or # in it is not in quotes"
_OFF = "the indentation is off, a quote or bracket before it is not closed, or a '- ' or ': ' is missing"
# What PyYAML's parsers say, and what an author should do about it.
_HINTS = (
    ("cannot start any token", "a tab, or a character that YAML reserves: indent with spaces, put texts in quotes"),
    ("mapping values are not allowed", "a ': ' inside a text needs quotes around the text; or the indentation is off"),
    ("expected ',' or", _UNCLOSED),
    ("node content", "a value is missing; what begins with # is a comment, unless it is in quotes: '#ff8800'"),
    ("end of stream", "a quote that is not closed"),
    ("expected", _OFF),
)


def parse_bytes(data: bytes, file: str) -> Node:
    """Return the tree of a file's contents: UTF-8, with or without a byte-order mark, any line ends.

    Raises:
        ScenarioError: it is too large, not UTF-8, or not strict YAML; all that is known to be wrong.
    """
    refuse_size(len(data), file)
    try:
        text = data.decode("utf-8")
    except UnicodeDecodeError as error:
        mark = _mark_after(data[: error.start].decode("utf-8", "replace"), file)
        message = f"not UTF-8: byte 0x{data[error.start]:02x}"
        raise ScenarioError([mark.error(NOT_UTF8, message, "save the file as UTF-8")]) from None
    return parse_text(text, file)


def parse_text(text: str, file: str) -> Node:
    """Return the tree of a YAML text.

    Raises:
        ScenarioError: it is not strict YAML; all that is known to be wrong.
    """
    text = text.removeprefix("\ufeff")
    refuse_size(len(text), file)
    bad = _UNPRINTABLE.search(text)
    if bad is not None:
        message = f"character U+{ord(bad.group()):04X} is not allowed in YAML"
        raise ScenarioError([_mark_after(text[: bad.start()], file).error(INVALID_YAML, message)])
    reader, root = _Reader(text, file), None
    with suppress(_HopelessError):
        try:
            root = reader.document()
        except yaml.MarkedYAMLError as error:
            reader.problems.append(_syntax_error(error, file))
        except yaml.YAMLError as error:
            message = f"not valid YAML: {' '.join(str(error).split())}"
            reader.problems.append(Mark(file, 1, 1).error(INVALID_YAML, message))
    if reader.problems:
        raise ScenarioError(reader.problems)
    if root is None:
        raise ScenarioError([Mark(file, 1, 1).error(EMPTY_FILE, "the file is empty")])
    return root


def parse_value(text: str, file: str) -> Node:
    """Return the tree of a value written on the command line: a scalar, or a list or mapping in brackets.

    Raises:
        ScenarioError: it is not strict YAML, or is empty.
    """
    # Comments are not expected there: a text that begins with # is a colour.
    return parse_text(json.dumps(text.strip(), ensure_ascii=False) if text.lstrip().startswith("#") else text, file)


def refuse_size(size: int, file: str) -> None:
    """Refuse a file or text of too many bytes.

    Raises:
        ScenarioError: it is larger than `MAX_BYTES`.
    """
    if size > MAX_BYTES:
        raise too_large(Mark(file), f"the scenario has {size} bytes; at most {MAX_BYTES} are read")


def on_one_line(data: Any) -> str:
    """Return data as an author writes it in one line."""
    return str(yaml.safe_dump(data, default_flow_style=True, sort_keys=False, width=inf)).strip()


def _mark_after(before: str, file: str) -> Mark:
    lines = before.replace("\r\n", "\n").replace("\r", "\n").split("\n")
    return Mark(file, len(lines), len(lines[-1]) + 1)


def _syntax_error(error: yaml.MarkedYAMLError, file: str) -> Diagnostic:
    mark = error.problem_mark or error.context_mark
    message = " ".join(str(part) for part in (error.context, error.problem) if part) or "not valid YAML"
    help_ = next((text for found, text in _HINTS if found in message), "")
    at = Mark(file, mark.line + 1, mark.column + 1) if mark is not None else Mark(file, 1, 1)
    # libyaml reads ahead as far as a key may be long, and from 0.2.6 on it has a limit of its own.
    if "maximum nesting depth" in message:
        return at.error(INVALID_YAML, f"nested deeper than {MAX_DEPTH} levels")
    return at.error(INVALID_YAML, f"not valid YAML: {message}", help_)


class _HopelessError(Exception):
    """Reading further makes no sense; the problem has been noted."""


class _Reader:
    """Builds the tree from the parser's events, and notes what is refused."""

    def __init__(self, text: str, file: str) -> None:
        self.problems: list[Diagnostic] = []
        self._events = yaml.parse(text, Loader=_LOADER)
        self._file = file
        self._values = 0

    def document(self) -> Node | None:
        """Return the tree of the only document; None if there is none."""
        root: Node | None = None
        for event in self._events:
            if isinstance(event, yaml.DocumentStartEvent):
                if root is not None:
                    self._refuse(self._mark(event), "a second document", "a file holds one scenario")
                    return root
                if event.tags or (event.version is not None and tuple(event.version) != (1, 2)):
                    message = "directives (%YAML, %TAG) are not allowed"
                    self._refuse(self._mark(event), message, "the file is read as YAML 1.2")
            elif isinstance(event, yaml.NodeEvent):
                root = self._node(event, 0)
        return root

    def _mark(self, event: yaml.Event) -> Mark:
        start = event.start_mark
        return Mark(self._file, start.line + 1, start.column + 1) if start is not None else Mark(self._file, 1, 1)

    def _refuse(self, mark: Mark, message: str, help_: str = "", code: Code = INVALID_YAML) -> None:
        self.problems.append(mark.error(code, message, help_))

    def _node(self, event: Any, depth: int) -> Node:
        mark = self._mark(event)
        self._refuse_extras(event, mark)
        self._values += 1
        if self._values > MAX_VALUES:
            raise too_large(mark, f"more than {MAX_VALUES} values in this file")
        if isinstance(event, yaml.ScalarEvent):
            written = event.value if not event.style and len(event.value) <= _MAX_WRITTEN else ""
            return Leaf(self._scalar(event, mark), mark, empty=not event.style and not event.value, written=written)
        if depth >= MAX_DEPTH:
            self._refuse(mark, f"nested deeper than {MAX_DEPTH} levels")
            raise _HopelessError
        if isinstance(event, yaml.SequenceStartEvent):
            items = Items([], mark)
            while not isinstance(inner := next(self._events), yaml.SequenceEndEvent):
                items.items.append(self._node(inner, depth + 1))
                check_amount(items)
            return items
        entries = Entries({}, mark)
        while not isinstance(inner := next(self._events), yaml.MappingEndEvent):
            key, key_mark = self._key(inner, entries), self._mark(inner)
            value = self._node(next(self._events), depth + 1)
            if key is not None:
                entries.put(key, value, key_mark)
                check_amount(entries)
        return entries

    def _refuse_extras(self, event: Any, mark: Mark) -> None:
        if isinstance(event, yaml.AliasEvent):
            self._refuse(mark, f"alias '*{event.anchor}': aliases are not allowed", "write the value out")
            raise _HopelessError
        if event.anchor is not None:
            self._refuse(mark, f"anchor '&{event.anchor}': anchors are not allowed", "write the value out")
        if event.tag is not None:
            self._refuse(mark, f"tag '{event.tag}': tags are not allowed", "the value alone says what it is")

    def _key(self, event: Any, entries: Entries) -> str | None:
        """Return a key; None if it is refused: its value is read and dropped."""
        mark = self._mark(event)
        self._refuse_extras(event, mark)
        if not isinstance(event, yaml.ScalarEvent):
            self._refuse(mark, "a list or mapping cannot be a key", "keys are text")
            raise _HopelessError
        key = self._scalar(event, mark)
        if not isinstance(key, str):
            message = f"key {event.value} is not text" if event.value else "a key is missing before ':'"
            help_ = "write it in quotes if it is one; several numbers stand in brackets: [0.3, 0.2]"
            self._refuse(mark, message, help_)
            return None
        if key in entries.entries:
            line = entries.key_marks[key].line
            self._refuse(mark, f"key '{key}' is already given in line {line}", "take one out", DUPLICATE_KEY)
            return None
        return key

    def _scalar(self, event: yaml.ScalarEvent, mark: Mark) -> str | int | float | bool | None:
        if _SURROGATE.search(event.value):  # PyYAML's own parser lets escapes of half a character pass
            self._refuse(mark, "an escape stands for half a character", "write the character itself")
        # Only plain scalars may be anything but text. (libyaml says "", PyYAML's own parser None.)
        return event.value if event.style else self._resolve(event.value, mark)

    def _resolve(self, text: str, mark: Mark) -> str | int | float | bool | None:
        """Return the value of a plain scalar in YAML 1.2's core schema."""
        if text in _WORDS:
            return _WORDS[text]
        if _INT.fullmatch(text):
            return self._integer(text, mark)
        if _FLOAT.fullmatch(text):
            number = float(text)
            if math.isfinite(number):
                return number
        elif not _NOT_FINITE.fullmatch(text):
            return text
        self._refuse(mark, f"{text[:40]} is not a finite number", "in quotes it is a text")
        return 0

    def _integer(self, text: str, mark: Mark) -> int:
        base = {"0o": 8, "0x": 16}.get(text[:2], 10)
        if len(text) <= 70:
            number = int(text, base)
            if -INT_LIMIT <= number < INT_LIMIT:
                return number
        self._refuse(mark, f"{text[:24]}… is too large", "whole numbers have at most 64 bits")
        return 0
