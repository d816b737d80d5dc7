"""What pydantic refuses, as errors with a code, a place in the file, and help.

One mistake gives one error: where pydantic tries every member of a union in turn and reports them all, the member that
fits the written form is found first, and only what it lacks is reported; a misspelt key is not also a missing one.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from pydantic import ConfigDict, TypeAdapter, ValidationError

from rcj_challenges.core.code import Code
from rcj_challenges.core.diagnostics import Diagnostic
from rcj_challenges.rules.actions import AnyAction
from rcj_challenges.rules.conditions import AnyCondition
from rcj_challenges.rules.fields import NAME_RULE
from rcj_challenges.rules.places import At
from rcj_challenges.rules.ranked import AnyRanked
from rcj_challenges.rules.triggers import AnyTrigger
from rcj_challenges.scenario.codes import MISSING_KEY, MISSING_VALUE, UNKNOWN_KEY, UNKNOWN_WORD, WRONG_NAME, WRONG_VALUE
from rcj_challenges.scenario.errors import MAX_FOUND, choice_of, did_you_mean, nearest
from rcj_challenges.scenario.messages.synonyms import OTHER_KEYS, OTHER_WORDS
from rcj_challenges.scenario.messages.wording import expected, format_node, is_fixed, quoted, refusal
from rcj_challenges.scenario.shape import (
    Shape,
    bare,
    chosen,
    fields,
    is_model,
    is_union,
    members,
    shape_at,
    step_into,
    tags,
    without_none,
)
from rcj_challenges.scenario.tree import (
    Entries,
    Items,
    Leaf,
    Node,
    Path,
    child,
    entries_of,
    in_names,
    mark_of,
    node_at,
    note_at,
    plain,
    value_of,
)

_KEY = "[key]"
"""What pydantic appends to the place of a mapping's entry if its key is wrong."""
_LISTS: dict[str, Any] = {"trigger": AnyTrigger, "condition": AnyCondition, "action": AnyAction}
_KEYED: dict[str, Any] = {"condition": AnyCondition, "value": AnyRanked}
_PLACES = {"spots": "spot", "zones": "uniform_in", "robots": "relative_to", "balls": "relative_to"}
"""How the place of a name is written, by the section that defines it."""


def explain(
    error: ValidationError, root: Entries, shape: Shape, *, are_empty_reported: bool = True
) -> list[Diagnostic]:
    """Return a validation error as problems, each at its place in the file.

    Args:
        error: what validating the plain data of ``root`` as ``shape`` raised.
        root: the tree with its marks.
        shape: the model of the whole tree.
        are_empty_reported: whether it has been reported already where a value is empty or null.
    """
    explainer = _Explainer(root, shape, are_empty_reported=are_empty_reported)
    mistakes = list(explainer.mistakes(error, shape, ()))
    return list(dict.fromkeys(explainer.problem(one) for one in explainer.without_repeats(mistakes)))


@dataclass(frozen=True)
class _Mistake:
    """One complaint of pydantic and where it is."""

    kind: str  # pydantic's type of the error
    details: Mapping[str, Any]  # its description
    path: Path  # unions and tags left out; of a missing key: where it should stand
    shape: Shape  # what is expected there; the whole union if a value fits no member
    of_key: bool = False
    union: Shape = None  # the widest union of which the shape is a member


class _Explainer:
    """Explains the errors of one tree."""

    def __init__(self, root: Entries, shape: Shape, *, are_empty_reported: bool) -> None:
        self.root = root
        self.shape = shape
        self.are_empty_reported = are_empty_reported

    def mistakes(self, error: ValidationError, shape: Shape, base: Path, union: Shape = None) -> Iterator[_Mistake]:
        """Yield the mistakes of a value at ``base``, of which ``shape`` is expected, a member of ``union`` if given."""
        unions: set[Path] = set()
        for details in error.errors(include_url=False, include_input=False)[:MAX_FOUND]:
            mistake, in_union = self._located(details, shape, base, union)
            node = node_at(self.root, mistake.path)
            if self.are_empty_reported and (_is_null(node) or _is_null(_tag(mistake.shape, node))):
                continue
            if in_union and mistake.path not in unions:
                unions.add(mistake.path)
                yield from self._of_union(mistake, node)
            elif not in_union and not _counts_wrong_entries(mistake, node):
                yield mistake

    def _located(self, details: Any, shape: Shape, base: Path, union: Shape) -> tuple[_Mistake, bool]:
        """Walk pydantic's ``loc`` along tree and shapes; True if it leads into a union without discriminator."""
        path, of_key = base, False
        for element in details["loc"]:
            kind, discriminator = bare(shape)
            if element == _KEY:
                of_key = True
            elif is_union(kind) and discriminator is None:
                return _Mistake(str(details["type"]), details, path, shape, union=union or shape), True
            elif discriminator is not None:
                union = union or shape
                shape = tags(shape).get(str(element))
            else:
                node = node_at(self.root, path)
                shape = step_into(shape, node, element) if node is not None else None
                path, union = (*path, element), None
        error = str(details["type"])
        fits_none = union is not None and error.endswith(("_type", "_error"))
        return _Mistake(error, details, path, union if fits_none else shape, of_key), False

    def _of_union(self, mistake: _Mistake, node: Node | None) -> Iterator[_Mistake]:
        """Explain a value by the one member of a plain union that has its form."""
        member = chosen(mistake.shape, node) if node is not None else None
        if node is not None and member is not None:
            config = None if is_model(bare(member).kind) else ConfigDict(strict=True, allow_inf_nan=False)
            adapter: TypeAdapter[Any] = TypeAdapter(member, config=config)
            try:
                adapter.validate_python(plain(node, tuple))
            except ValidationError as error:
                yield from self.mistakes(error, member, mistake.path, mistake.union)
                return
        yield _Mistake("union_type", mistake.details, mistake.path, mistake.union)

    def without_repeats(self, mistakes: list[_Mistake]) -> Iterator[_Mistake]:
        """Leave out missing keys that are there, misspelt; if no key fits, put what may stand there for all of them."""
        unknown = {mistake.path for mistake in mistakes if mistake.kind == "extra_forbidden"}
        missing = {mistake.path for mistake in mistakes if mistake.kind == "missing"}
        missing -= {
            path
            for path in missing
            if any(one[:-1] == path[:-1] and nearest(str(one[-1]), [str(path[-1])]) for one in unknown)
        }
        strangers = {path[:-1] for path in missing if self._fits_nothing(path[:-1], unknown)}
        for mistake in mistakes:
            above = mistake.path[:-1]
            if mistake.kind in {"missing", "extra_forbidden"} and above in strangers:
                yield _Mistake("union_type", mistake.details, above, shape_at(self.shape, self.root, above))
            elif mistake.kind != "missing" or mistake.path in missing:
                yield mistake

    def _fits_nothing(self, path: Path, unknown: set[Path]) -> bool:
        """Return whether no member of the union at a path knows a key of the mapping that stands there."""
        node = node_at(self.root, path)
        keys = entries_of(node).items()
        are_unknown = all((*path, key) in unknown or _is_null(entry) for key, entry in keys)
        return bool(keys) and are_unknown and len(members(shape_at(self.shape, self.root, path))) > 1

    # --- one mistake --------------------------------------------------------------------------------------------------

    def problem(self, mistake: _Mistake) -> Diagnostic:
        """Return a mistake in words."""
        above, key = mistake.path[:-1], (mistake.path or ("",))[-1]
        if mistake.of_key:
            message = f"{quoted(str(key))} is not a name"
            return self._at(mistake.path, WRONG_NAME, message, f"write {NAME_RULE}", at_key=True)
        if mistake.kind in {"missing", "extra_forbidden"} and isinstance(key, int):  # a list of a fixed length
            shape = shape_at(self.shape, self.root, above)
            return self._at(above, WRONG_VALUE, expected(shape, node_at(self.root, above)))
        if mistake.kind == "missing":
            return self._at(above, MISSING_KEY, f"'{key}' is missing", self._about(above, str(key)), at_key=True)
        if mistake.kind == "extra_forbidden":
            return self._unknown_key(above, str(key))
        return self._wrong_value(mistake)

    def _at(self, path: Path, code: Code, message: str, help_: str = "", *, at_key: bool = False) -> Diagnostic:
        message += note_at(self.root, path)
        return mark_of(self.root, path, at_key=at_key).error(code, message, help_, in_names(self.root, path))

    def _model_at(self, path: Path) -> Any:
        node = node_at(self.root, path)
        shape = shape_at(self.shape, self.root, path)
        kind = bare(chosen(shape, node)).kind if node is not None and shape is not None else None
        return kind if is_model(kind) else None

    def _about(self, above: Path, key: str) -> str:
        """The description of a key in its model."""
        model = self._model_at(above)
        infos = model.model_fields.items() if model else ()
        text = next((info.description for name, info in infos if (info.alias or name) == key), None)
        return f"{key}: {text}" if text else ""

    def _unknown_key(self, above: Path, key: str) -> Diagnostic:
        model, node = self._model_at(above), node_at(self.root, above)
        allowed = list(fields(model)) if model else []
        given = node.key_marks if isinstance(node, Entries) else {}
        # A key that stands beside it is not the intended one; a key that a base has may be.
        others = [one for one in allowed if one not in given or given[one].file != given[key].file]
        near = next((one for one in OTHER_KEYS.get(key, ()) if one in others), None) or nearest(key, others)
        help_ = f"did you mean '{near}'? " if near else ""
        mark = mark_of(self.root, (*above, key), at_key=True)
        names = in_names(self.root, above)
        if key == "condition" and isinstance(child(node, key), Leaf):
            written = str(value_of(child(node, key)))
            foreign = OTHER_WORDS.get((key, written.casefold())) or _of_another_list(written, key)
            help_ = f"{foreign or 'a condition has no such key'}; "
        return mark.error(UNKNOWN_KEY, f"unknown key '{key[:64]}'", help_ + choice_of("", allowed), names)

    def _wrong_value(self, mistake: _Mistake) -> Diagnostic:
        node = node_at(self.root, mistake.path)
        key = str(mistake.path[-1]) if mistake.path else ""
        if _is_null(node):
            return self._at(mistake.path, MISSING_VALUE, f"'{key}' has no value", "write one, or leave the key out")
        own_help = self._of_param(node) or self._of_place(mistake.shape, node)
        if mistake.kind.startswith("union_tag") or mistake.kind == "model_attributes_type":
            return self._wrong_word(mistake, node, own_help)
        message, help_ = refusal(mistake.kind, mistake.details, mistake.shape, node)
        return self._at(mistake.path, WRONG_VALUE, message, own_help or help_ or self._about(mistake.path[:-1], key))

    def _wrong_word(self, mistake: _Mistake, node: Node | None, own_help: str) -> Diagnostic:
        discriminator = bare(mistake.shape).discriminator
        words = list(tags(mistake.shape))
        kind = next((kind for kind, shape in _KEYED.items() if words == list(tags(shape))), "")
        keys = [key.casefold() for key in entries_of(node)]
        if kind and isinstance(node, Entries) and not isinstance(discriminator, str):
            foreign = (OTHER_WORDS.get((kind, key), "") for key in keys)
            near = (did_you_mean(key, words) for key in keys)
            help_ = next(filter(None, (*foreign, *near)), choice_of("", words))
            return self._at(mistake.path, UNKNOWN_WORD, f"no {kind} has {format_node(node)}", help_)
        its_key = _with_its_key(mistake.shape, node)
        if not isinstance(discriminator, str) or not isinstance(node, Entries):
            return self._at(mistake.path, WRONG_VALUE, expected(mistake.shape, node), own_help or its_key)
        tag = child(node, discriminator)
        if tag is None:
            return self._at(mistake.path, MISSING_KEY, f"'{discriminator}' is missing", its_key or choice_of("", words))
        written = str(tag.value) if isinstance(tag, Leaf) else format_node(tag)
        help_ = OTHER_WORDS.get((discriminator, written.casefold())) or _of_another_list(written, discriminator)
        mark = mark_of(self.root, (*mistake.path, discriminator))
        message = f"unknown {discriminator} '{written[:64]}'"
        return mark.error(UNKNOWN_WORD, message, help_ or choice_of(written, words), in_names(self.root, mistake.path))

    def _of_param(self, node: Node | None) -> str:
        """The form of a param whose name stands alone; empty: it is not the name of one."""
        name = str(value_of(node)).strip("${} ")
        is_param = node_at(self.root, ("params", name)) is not None
        return f"the value of that param is {{param: {name}}}" if is_param else ""

    def _of_place(self, shape: Shape, node: Node | None) -> str:
        """The form of a place that is a name or two numbers alone; empty: no place is expected."""
        if node is None or without_none(shape) != At:
            return ""
        if isinstance(node, Items):
            return "a point is written {point: [x, y]}"
        key, value = next(iter(node.entries.items()), ("", node)) if isinstance(node, Entries) else ("", node)
        name = str(value_of(value))
        known = next((key for section, key in _PLACES.items() if node_at(self.root, (section, name)) is not None), None)
        return f"write {{{known}: {name}}}" if known is not None else did_you_mean(key or name, tags(shape))


def _with_its_key(shape: Shape, node: Node | None) -> str:
    """The form of a word that stands alone, or behind another key: `enters`, `enters: …`, `type: enters`."""
    listed = entries_of(node)
    word = next((one for one in (*listed, *map(value_of, (*listed.values(), node))) if one in tags(shape)), None)
    return f"write {{{bare(shape).discriminator}: {word}, …}}" if word is not None else ""


def _of_another_list(word: str, where: str) -> str:
    """Return where a trigger, condition or action belongs that stands in the place of another of them."""
    kind = next((kind for kind, shape in _LISTS.items() if word in tags(shape)), None)
    if where not in _LISTS or kind is None:
        return ""
    if kind == "condition" and where == "trigger":
        return f"'{word}' is a condition; {{trigger: holds, conditions: [{{{word}: …}}]}} waits for it"
    return f"'{word}' cannot stand here" if kind == where else f"'{word}' is of the kind {kind}: it stands in '{kind}s'"


def _is_null(node: Node | None) -> bool:
    return isinstance(node, Leaf) and node.value is None


def _tag(shape: Shape, node: Node | None) -> Node | None:
    discriminator = bare(shape).discriminator
    return child(node, discriminator) if isinstance(discriminator, str) else None


def _counts_wrong_entries(mistake: _Mistake, node: Node | None) -> bool:
    """Return whether a list is called too short only because entries in it are wrong: those are reported."""
    if mistake.kind != "too_short" or not isinstance(node, Items) or is_fixed(mistake.shape):
        return False
    return len(node.items) >= int(mistake.details["ctx"]["min_length"])
