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
from dataclasses import dataclass, field
from typing import Any

import yaml

from rcj_challenges.core.diagnostics import Diagnostic
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
_INT = re.compile(r"[-+]?[0-9]+")
_OCTAL = re.compile(r"0o[0-7]+")
_HEX = re.compile(r"0x[0-9a-fA-F]+")
_FLOAT = re.compile(r"[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?")
_NOT_FINITE = re.compile(r"[-+]?\.(inf|Inf|INF)|\.(nan|NaN|NAN)")
INT_LIMIT = 2**63

_SURROGATE = re.compile("[\ud800-\udfff]")
# Listed one by one: the complement of what YAML 1.2 prints (section 5.1) takes 20 times as long to compile.
_UNPRINTABLE = re.compile("[\x00-\x08\x0b\x0c\x0e-\x1f\x7f-\x84\x86-\x9f\ud800-\udfff\ufeff\ufffe\uffff]")

_OFF = (
    "the indentation is off, a quote or bracket before it is not closed, or a text that begins with { or [ is not in "
    "quotes"
)
_UNCLOSED = (
    "a ',' or the closing bracket is missing, or a text that has ': ' in it or begins with {, [ or # is not in quotes"
)
_NO_VALUE = "a value is missing; what begins with # is a comment, unless it is in quotes: '#ff8800'"
# What both of PyYAML's parsers say, and what an author should do about it.
_HINTS = (
    ("cannot start any token", "a tab, or a character that YAML reserves: indent with spaces, put texts in quotes"),
    ("mapping values are not allowed", "a ': ' inside a text needs quotes around the text; or the indentation is off"),
    ("could not find expected ':'", "a key without ': ' after it"),
    ("did not find expected key", _OFF),
    ("expected <block end>", _OFF),
    ("did not find expected '-' indicator", "a list entry that does not begin with '- ', or the indentation is off"),
    ("did not find expected ',' or", _UNCLOSED),
    ("expected ',' or", _UNCLOSED),
    ("did not find expected node content", _NO_VALUE),
    ("expected the node content", _NO_VALUE),
    ("unexpected end of stream", "a quote that is not closed"),
)


def parse_bytes(data: bytes, file: str) -> Node:
    """Return the tree of a file's contents.

    Args:
        data: UTF-8, with or without a byte-order mark, any line ends.
        file: how messages name the file.

    Raises:
        ScenarioError: it is too large, not UTF-8, or not strict YAML; all that is known to be wrong.
    """
    refuse_size(len(data), file)
    try:
        text = data.decode("utf-8")
    except UnicodeDecodeError as error:
        before = data[: error.start]
        line = before.count(b"\n") + 1
        column = len(before.rpartition(b"\n")[2].decode("utf-8", "replace")) + 1
        raise ScenarioError(
            [
                Mark(file, line, column).error(
                    "not-utf8", f"not UTF-8: byte 0x{data[error.start]:02x}", "save the file as UTF-8"
                )
            ]
        ) from None
    return parse_text(text, file)


def parse_text(text: str, file: str, loader: Any = None) -> Node:
    """Return the tree of a YAML text.

    Args:
        text: the document.
        file: how messages name it.
        loader: the PyYAML loader whose parser is used; by default the fast one where there is one.

    Raises:
        ScenarioError: it is not strict YAML; all that is known to be wrong.
    """
    text = text.removeprefix("\ufeff")
    refuse_size(len(text), file)
    bad = _UNPRINTABLE.search(text)
    if bad is not None:
        before = text[: bad.start()].replace("\r\n", "\n").replace("\r", "\n")
        line, column = before.count("\n") + 1, len(before.rpartition("\n")[2]) + 1
        message = f"character U+{ord(bad.group()):04X} is not allowed in YAML"
        raise ScenarioError([Mark(file, line, column).error("invalid-yaml", message)])
    builder = _Builder(file)
    try:
        for event in yaml.parse(text, Loader=loader or _LOADER):
            builder.take(event)
    except yaml.MarkedYAMLError as error:
        builder.problems.append(_syntax_error(error, file))
    except yaml.YAMLError as error:
        message = f"not valid YAML: {' '.join(str(error).split())}"
        builder.problems.append(Mark(file, 1, 1).error("invalid-yaml", message))
    except _HopelessError:
        pass
    if builder.problems:
        raise ScenarioError(builder.problems)
    if builder.root is None:
        raise ScenarioError([Mark(file, 1, 1).error("empty-file", "the file is empty")])
    return builder.root


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


def _syntax_error(error: yaml.MarkedYAMLError, file: str) -> Diagnostic:
    mark = error.problem_mark or error.context_mark
    message = " ".join(str(part) for part in (error.context, error.problem) if part) or "not valid YAML"
    help_ = next((text for found, text in _HINTS if found in message), "")
    at = Mark(file, mark.line + 1, mark.column + 1) if mark is not None else Mark(file, 1, 1)
    # libyaml reads ahead as far as a key may be long, and from 0.2.6 on it has a limit of its own.
    if "maximum nesting depth" in message:
        return at.error("invalid-yaml", f"nested deeper than {MAX_DEPTH} levels")
    return at.error("invalid-yaml", f"not valid YAML: {message}", help_)


class _HopelessError(Exception):
    """Reading further makes no sense; the problem has been noted."""


@dataclass(slots=True)
class _Open:
    """A list or mapping whose end has not come yet; ``key`` waits for its value."""

    node: Items | Entries
    key: str | None = None
    key_mark: Mark | None = None
    skipped: bool = False  # the key was refused: its value is read and dropped


@dataclass(slots=True)
class _Builder:
    """Takes parser events one by one and builds the tree."""

    file: str
    root: Node | None = None
    problems: list[Diagnostic] = field(default_factory=list)
    stack: list[_Open] = field(default_factory=list)
    documents: int = 0
    values: int = 0

    def take(self, event: yaml.Event) -> None:
        mark = self._mark(event)
        if isinstance(event, yaml.DocumentStartEvent):
            self._document(event, mark)
        elif isinstance(event, yaml.AliasEvent):
            self._refuse(mark, f"alias '*{event.anchor}': aliases are not allowed", "write the value out")
            raise _HopelessError
        elif isinstance(event, yaml.NodeEvent):
            self._node(event, mark)
        elif isinstance(event, yaml.CollectionEndEvent):
            self.stack.pop()

    def _mark(self, event: yaml.Event) -> Mark:
        start = event.start_mark
        return Mark(self.file, start.line + 1, start.column + 1) if start is not None else Mark(self.file, 1, 1)

    def _refuse(self, mark: Mark, message: str, help_: str = "", code: str = "invalid-yaml") -> None:
        self.problems.append(mark.error(code, message, help_))

    def _document(self, event: yaml.DocumentStartEvent, mark: Mark) -> None:
        self.documents += 1
        if self.documents > 1:
            self._refuse(mark, "a second document", "a file holds one scenario")
            raise _HopelessError
        if event.tags or (event.version is not None and tuple(event.version) != (1, 2)):
            self._refuse(mark, "directives (%YAML, %TAG) are not allowed", "the file is read as YAML 1.2")

    def _node(self, event: Any, mark: Mark) -> None:
        if event.anchor is not None:
            self._refuse(mark, f"anchor '&{event.anchor}': anchors are not allowed", "write the value out")
        if event.tag is not None:
            self._refuse(mark, f"tag '{event.tag}': tags are not allowed", "the value alone says what it is")
        if isinstance(event, yaml.ScalarEvent):
            self._scalar(event, mark)
            return
        if self._wants_key():
            self._refuse(mark, "a list or mapping cannot be a key", "keys are text")
            raise _HopelessError
        if len(self.stack) >= MAX_DEPTH:
            self._refuse(mark, f"nested deeper than {MAX_DEPTH} levels")
            raise _HopelessError
        node: Items | Entries = Items([], mark) if isinstance(event, yaml.SequenceStartEvent) else Entries({}, mark)
        self._place(node)
        self.stack.append(_Open(node))

    def _scalar(self, event: yaml.ScalarEvent, mark: Mark) -> None:
        if _SURROGATE.search(event.value):  # PyYAML's own parser lets escapes of half a character pass
            self._refuse(mark, "an escape stands for half a character", "write the character itself")
        # Only plain scalars may be anything but text. (libyaml says "", PyYAML's own parser None.)
        is_plain = not event.style
        value = event.value if not is_plain else self._resolve(event.value, mark)
        if self._wants_key():
            self._key(value, event.value, mark)
        else:
            self._place(Leaf(value, mark, empty=is_plain and not event.value))

    def _wants_key(self) -> bool:
        return bool(self.stack) and isinstance(self.stack[-1].node, Entries) and self.stack[-1].key_mark is None

    def _key(self, value: object, written: str, mark: Mark) -> None:
        top = self.stack[-1]
        top.key_mark = mark
        top.skipped = True
        if not isinstance(value, str):
            message = f"key {written} is not text" if written else "a key is missing before ':'"
            is_number = isinstance(value, int | float) and not isinstance(value, bool)
            help_ = "several numbers stand in brackets, [0.3, 0.2], and decimals are written with a point"
            self._refuse(mark, message, help_ if is_number else "keys are text; write it in quotes if it is one")
        elif isinstance(top.node, Entries) and value in top.node.entries:
            first = top.node.key_marks[value]
            self._refuse(mark, f"key '{value}' is already given in line {first.line}", "take one out", "duplicate-key")
        else:
            top.key = value
            top.skipped = False

    def _place(self, node: Node) -> None:
        self.values += 1
        if self.values > MAX_VALUES:
            raise too_large(node.mark, f"more than {MAX_VALUES} values in this file")
        if not self.stack:
            self.root = node
            return
        top = self.stack[-1]
        if isinstance(top.node, Items):
            top.node.items.append(node)
            check_amount(top.node)
            return
        if not top.skipped and top.key is not None and top.key_mark is not None:
            top.node.put(top.key, node, top.key_mark)
            check_amount(top.node)
        top.key = top.key_mark = None

    def _resolve(self, text: str, mark: Mark) -> str | int | float | bool | None:
        """Return what a plain scalar means in YAML 1.2's core schema."""
        if text in _WORDS:
            return _WORDS[text]
        if _INT.fullmatch(text) or _OCTAL.fullmatch(text) or _HEX.fullmatch(text):
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
