"""What pydantic refuses, said so that the author of the file knows what to do.

One mistake gives one problem: where pydantic tries every member of a union in turn and reports them all, the member
that fits the written form is found first, and only what it lacks is reported; a misspelt key is not also a missing one.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any, get_args, get_origin

from pydantic import ConfigDict, TypeAdapter, ValidationError

from rcj_challenges.rules.actions import AnyAction
from rcj_challenges.rules.conditions import AnyCondition
from rcj_challenges.rules.places import At
from rcj_challenges.rules.triggers import AnyTrigger
from rcj_challenges.rules.triggers.timer_expired import TimerExpired
from rcj_challenges.rules.values.timer import TimerValue
from rcj_challenges.rules.values.word import WordValue
from rcj_challenges.scenario.catalogue import texts
from rcj_challenges.scenario.errors import MAX_FOUND, Problem, cut, in_plain_letters, listing, nearest
from rcj_challenges.scenario.messages.named_places import for_place
from rcj_challenges.scenario.messages.other_names import other_name
from rcj_challenges.scenario.messages.taken_away import for_nothing
from rcj_challenges.scenario.messages.units import for_unit
from rcj_challenges.scenario.messages.values_instead import for_reckoned, for_value
from rcj_challenges.scenario.messages.ways_out import (
    for_coordinates,
    for_degrees,
    for_key,
    for_named,
    for_pair,
    for_param,
    for_rank,
    for_repeated,
    for_several,
)
from rcj_challenges.scenario.messages.wording import expectation, expected, found_text, is_fixed, no_name, refusal
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
from rcj_challenges.scenario.tree import Entries, Items, Leaf, Node, Path, child, in_names, mark_of, node_at, plain

_OF_PRESETS = "; a preset brings them: extends: soccersim_v2"
_OF_MISSING: dict[Path, str] = {
    ("robots",): _OF_PRESETS,
    ("entrants",): _OF_PRESETS,
    ("broadcast", "fields"): "; write fields: {} for none",
}
"""What to do about keys that are missing."""

_KEY = "[key]"
"""What pydantic appends to the place of a mapping's entry if its key is wrong."""


def explain(error: ValidationError, root: Entries, shape: Shape) -> list[Problem]:
    """Return a validation error as problems, each at its place in the file.

    Args:
        error: what validating the plain data of ``root`` as ``shape`` raised.
        root: the tree with its marks.
        shape: the model of the whole tree.
    """
    explainer = _Explainer(root, shape)
    mistakes = list(_without_echoes(list(explainer.mistakes(error, shape, ()))))
    return [explainer.problem(mistake) for mistake in explainer.without_strangers(mistakes)]


@dataclass(frozen=True)
class _Mistake:
    """One complaint of pydantic and where it is.

    Attributes:
        kind: pydantic's type of the error.
        details: pydantic's description.
        path: where, unions and tags left out; of a missing key: where it should stand.
        shape: what is expected there; the whole union where a value fits no member.
        union: the widest union of which ``shape`` is a member, if there is one.
        of_key: it is about the entry's key.
    """

    kind: str
    details: Mapping[str, Any]
    path: Path
    shape: Shape
    of_key: bool = False
    union: Shape = None


def _without_echoes(mistakes: list[_Mistake]) -> Iterator[_Mistake]:
    """Leave out missing keys that stand there misspelt."""
    misspelt = [mistake.path for mistake in mistakes if mistake.kind == "extra_forbidden"]
    for mistake in mistakes:
        above, key = mistake.path[:-1], mistake.path[-1:]
        echo = mistake.kind == "missing" and any(
            path[:-1] == above and nearest(str(path[-1]), map(str, key)) for path in misspelt
        )
        if not echo:
            yield mistake


class _Explainer:
    """Explains the errors of one tree."""

    def __init__(self, root: Entries, shape: Shape) -> None:
        self.root = root
        self.shape = shape

    def mistakes(self, error: ValidationError, shape: Shape, base: Path, union: Shape = None) -> Iterator[_Mistake]:
        """Yield the mistakes of a value at ``base``, of which ``shape`` is expected, a member of ``union`` if given."""
        unions: set[Path] = set()
        for details in error.errors(include_url=False, include_input=False)[:MAX_FOUND]:
            mistake, in_union = self._located(details, shape, base, union)
            node = node_at(self.root, mistake.path)
            if _is_null(node) or _is_null(_tag(mistake.shape, node)):
                continue  # has been reported as an empty value, or an unknown param
            if in_union:
                if mistake.path not in unions:
                    unions.add(mistake.path)
                    yield from self._of_union(mistake, node)
            elif not _counts_wrong_entries(mistake, node):
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
            elif is_union(kind):
                union = union or shape
                shape = tags(shape).get(str(element))
            else:
                node = node_at(self.root, path)
                shape = step_into(shape, node, element) if node is not None else None
                path, union = (*path, element), None
        kind_of_error = str(details["type"])
        fits_none = union is not None and kind_of_error.endswith(("_type", "_error"))
        return _Mistake(kind_of_error, details, path, union if fits_none else shape, of_key), False

    def _of_union(self, mistake: _Mistake, node: Node | None) -> Iterator[_Mistake]:
        """Explain a value by the one member of a plain union that has its form."""
        member = chosen(mistake.shape, node) if node is not None else None
        if node is None or member is None:
            yield _Mistake("union_type", mistake.details, mistake.path, mistake.union)
            return
        config = None if is_model(bare(member).kind) else ConfigDict(strict=True, allow_inf_nan=False)
        adapter: TypeAdapter[Any] = TypeAdapter(member, config=config)
        try:
            adapter.validate_python(plain(node))
        except ValidationError as error:
            yield from self.mistakes(error, member, mistake.path, mistake.union)
        else:
            yield _Mistake("union_type", mistake.details, mistake.path, mistake.union)

    def without_strangers(self, mistakes: list[_Mistake]) -> Iterator[_Mistake]:
        """Put one mistake for a mapping of which no member of its union knows a key: what may stand there."""
        unknown = {mistake.path for mistake in mistakes if mistake.kind == "extra_forbidden"}
        lacking = {mistake.path[:-1] for mistake in mistakes if mistake.kind == "missing"}
        strangers = {path: shape for path in lacking if (shape := self._union_of_stranger(path, unknown)) is not None}
        told: set[Path] = set()
        for mistake in mistakes:
            above = mistake.path[:-1]
            if above not in strangers or mistake.kind not in {"missing", "extra_forbidden"}:
                yield mistake
            elif above not in told:
                told.add(above)
                yield _Mistake("union_type", mistake.details, above, strangers[above])

    def _union_of_stranger(self, path: Path, unknown: set[Path]) -> Shape:
        """Return the union in whose place a mapping stands of which all keys are unknown; None if it is not so."""
        node = node_at(self.root, path)
        if (
            not isinstance(node, Entries)
            or not node.entries
            # What stands there without a value is reported as that, and is as strange: {NAME} for {param: NAME}.
            or not all((*path, key) in unknown or _is_null(entry) for key, entry in node.entries.items())
        ):
            return None
        shape = shape_at(self.shape, self.root, path)
        return shape if len(members(shape)) > 1 else None

    def problem(self, mistake: _Mistake) -> Problem:
        """Return a mistake in words."""
        above, key = mistake.path[:-1], (mistake.path or ("",))[-1]
        if mistake.of_key:
            return self._at(mistake.path, no_name(str(key)), at_key=True)
        if mistake.kind in {"missing", "extra_forbidden"} and isinstance(key, int):
            return self._at(above, expected(shape_at(self.shape, self.root, above), node_at(self.root, above)))
        if mistake.kind == "missing":
            hint = _OF_MISSING.get((*above, key), "")
            return self._at(above, f"'{key}' is missing{self._sentence_about(above, str(key))}{hint}")
        if mistake.kind == "extra_forbidden":
            return self._unknown_key(above, str(key))
        return self._wrong_value(mistake)

    def _wrong_value(self, mistake: _Mistake) -> Problem:
        node = node_at(self.root, mistake.path)
        place = for_place(mistake.path, node, self.root) if without_none(mistake.shape) == At else ""
        if place:
            return self._at(mistake.path, f"expected {expectation(mistake.shape)}, found {found_text(node)}{place}")
        if mistake.kind.startswith("union_tag") or mistake.kind == "model_attributes_type":
            return self._wrong_tag(mistake)
        message = refusal(mistake.kind, mistake.details, mistake.shape, node)
        hints = for_value(mistake.path, node) + for_several(mistake.path, node) + self._for_nothing(mistake.path)
        hints += for_pair(mistake.path, node, self.root) + for_rank(mistake.path, node, self.root)
        hints += for_param(node, self.root) or for_named(mistake.path, node, self.root, message)
        kind = bare(mistake.shape).kind
        hints += for_coordinates(mistake.path, node, fields(kind) if is_model(kind) else ())
        return self._at(mistake.path, message + hints + for_degrees(mistake.path, node, mistake.kind))

    def _for_nothing(self, path: Path) -> str:
        above = node_at(self.root, path[:-1])
        around = shape_at(self.shape, self.root, path[:-1])
        return for_nothing(path, node_at(self.root, path), chosen(around, above) if above is not None else None)

    def _at(self, path: Path, message: str, *, at_key: bool = False) -> Problem:
        node = node_at(self.root, path)
        note = f" ({node.note})" if isinstance(node, Leaf) and node.note else ""
        return mark_of(self.root, path, at_key=at_key).problem(in_names(self.root, path), message + note)

    def _model_at(self, path: Path) -> Any:
        node = node_at(self.root, path)
        shape = shape_at(self.shape, self.root, path)
        kind = bare(chosen(shape, node)).kind if node is not None and shape is not None else None
        return kind if is_model(kind) else None

    def _sentence_about(self, above: Path, key: str) -> str:
        """Return the model's own sentence about a field."""
        model = self._model_at(above)
        infos = model.model_fields.items() if model else ()
        text = next((info.description for name, info in infos if (info.alias or name) == key), None)
        return f": {text}" if text else ""

    def _unknown_key(self, above: Path, key: str) -> Problem:
        model = self._model_at(above)
        allowed = list(fields(model)) if model else []
        why = " (a param stands for a single value only)" if key == "param" else ""
        if model is TimerExpired and key == "entity":
            why = "; of a timer kept per entity for_each says whose is meant, without it any of them"
        if model in (TimerValue, WordValue) and key == "fraction":
            why = "; a payload and the broadcast tell times with their fraction anyway: leave it out"
        called = for_unit(key, node_at(self.root, (*above, key)), allowed) or for_key(key, above, allowed, self.root)
        meant = called or self._meant_by(key, above, allowed)
        message = f"unknown key '{key[:64]}'; allowed are {listing(allowed, 40)}{meant}{why}"
        reckoned = "" if called else for_reckoned(above, key, node_at(self.root, above))
        message += for_repeated(above, key) or reckoned or self._as_list(above, key)
        return mark_of(self.root, (*above, key), at_key=True).problem(in_names(self.root, above), message)

    def _meant_by(self, key: str, above: Path, allowed: list[str]) -> str:
        """Return which key is meant, or that the author gives that one already; what a base gives may be given anew."""
        word, colon, rest = key.partition(":")
        if colon and word in allowed:  # score:{yellow: 1}
            return f"; a blank comes after the ':', {word}: {cut(rest)}"
        hint, node = nearest(key, allowed), node_at(self.root, above)
        marks = node.key_marks if isinstance(node, Entries) else {}
        given = next((name for name in marks if name in allowed and hint == nearest(name, [name])), None)
        if given is None or key not in marks or marks[given].file != marks[key].file or not marks[given].line:
            return hint
        return f"; '{given}' is given already, in line {marks[given].line}"

    def _as_list(self, above: Path, key: str) -> str:
        """Return how a mapping with this key is written where a list of such mappings may stand as well."""
        node, shape = node_at(self.root, above), shape_at(self.shape, self.root, above)
        written = set(node.entries) if isinstance(node, Entries) else {key}
        if not any(written <= fields(model).keys() for member in members(shape) for model in _entry_models(member)):
            return ""
        return f"; with '{key}' it stands in a list: [{{{', '.join(f'{name}: …' for name in sorted(written))}}}]"

    def _wrong_tag(self, mistake: _Mistake) -> Problem:
        node = node_at(self.root, mistake.path)
        discriminator = bare(mistake.shape).discriminator
        words = list(tags(mistake.shape))
        if not isinstance(discriminator, str) or not isinstance(node, Entries):
            hints = (nearest(key, words) for key in node.entries) if isinstance(node, Entries) else ()
            hint = next(filter(None, hints), "") or _instead_of_list(mistake.path, node, words)
            hint = hint or _with_its_key(mistake.shape, node)
            hint = for_value(mistake.path, node) or for_param(node, self.root) or hint + self._for_nothing(mistake.path)
            return self._at(mistake.path, expected(mistake.shape, node) + hint)
        tag = child(node, discriminator)
        if tag is None:
            message = f"'{discriminator}' is missing; it is one of {listing(words, 40)}"
            hint = _of_condition(node, words) or _turned_over(node, words) or _with_its_key(mistake.shape, node)
            return self._at(mistake.path, message + (hint or self._of_the_kit(mistake.path)))
        written = str(tag.value) if isinstance(tag, Leaf) else found_text(tag)
        message = f"unknown {discriminator} '{written[:64]}'; there are {listing(words, 40)}"
        message += (
            self._in_itself(mistake.path, written)
            or other_name(written, discriminator, words)
            or _of_another_list(written, discriminator)
            or nearest(written, words, _LIKE)
        )
        return mark_of(self.root, (*mistake.path, discriminator)).problem(in_names(self.root, mistake.path), message)

    def _of_the_kit(self, path: Path) -> str:
        """Return under which name a device of the kit is changed, where that name was written in other letters."""
        if path[-2:-1] != ("devices",):
            return ""
        robot = node_at(self.root, path[:-2])
        kits = texts(child(robot, "kit")) or path[1:2]
        known = [name for kit in kits for name in _names_in(node_at(self.root, ("kits", str(kit), "devices")))]
        mine = str(path[-1])
        meant = next(
            (name for name in known if name != mine and in_plain_letters(name) == in_plain_letters(mine)), None
        )
        return f"; one that the kit has is changed under its own name, '{meant}'" if meant else ""

    def _in_itself(self, path: Path, word: str) -> str:
        """Return what to do about an any_of within an any_of, or an all_of within an all_of."""
        around = child(node_at(self.root, path[:-2]), "condition") if path[-2:-1] == ("conditions",) else None
        if not isinstance(around, Leaf) or around.value != word:
            return ""
        return f"; '{word}' cannot stand in itself: write all conditions into one list"


def _of_condition(node: Entries, words: list[str]) -> str:
    """Return how a condition becomes a trigger where it stands in the place of one; empty: it is none, or elsewhere."""
    condition = node.entries.get("condition")
    if "holds" not in words or not isinstance(condition, Leaf):
        return ""
    written = f"{{condition: {cut(str(condition.value))}, …}}"
    return f"; to wait until a condition comes true: {{trigger: holds, condition: {written}}}"


def _turned_over(node: Entries, words: list[str]) -> str:
    """Return how a condition is turned over that stands within a ``not``; empty: it is none."""
    if "in_zone" not in words or "not" not in node.entries:
        return ""
    return "; its opposite is the condition itself, with negate: true"


def _names_in(node: Node | None) -> Iterator[str]:
    yield from node.entries if isinstance(node, Entries) else ()


def _with_its_key(shape: Shape, node: Node | None) -> str:
    """Return how a word is written that stands without its key: `enters`, or `enters: …` for `trigger: enters`."""
    discriminator, models = bare(shape).discriminator, tags(shape)
    alone = [node.value] if isinstance(node, Leaf) and isinstance(node.value, str) else []
    given = node.entries if isinstance(node, Entries) else {}
    # Behind another key, as in `type: enters`; what stands behind a key of the word itself is a name.
    behind = [one.value for key, one in given.items() if key in _KEYS_OF_WORDS and isinstance(one, Leaf)]
    word = next((one for one in (*alone, *behind, *given) if one in models), None)
    if word is None:
        return other_name(alone[0], str(discriminator), list(models)) if alone else ""
    more = ", …" if fields(bare(models[word]).kind).keys() - {discriminator} else ""
    return f"; write {{{discriminator}: {word}{more}}}"


_KEYS_OF_WORDS = ("type", "kind", "name", "event", "when", "on", "if", "do", "shape", "is")
"""Keys behind which others write which trigger, condition or action it is."""

_LIKE = 0.65
"""A word of the language is taken for another only if it is more like it than a name need be."""


_WORDS: tuple[tuple[str, Any], ...] = (("trigger", AnyTrigger), ("condition", AnyCondition), ("action", AnyAction))


def _of_another_list(word: str, where: str) -> str:
    """Return where a trigger, condition or action belongs that was written for another of them."""
    if where not in dict(_WORDS):
        return ""
    kind = next((kind for kind, shape in _WORDS if word in tags(shape)), None)
    if kind == "condition" and where == "trigger":
        return f"; '{word}' is a condition: {{trigger: holds, condition: {{condition: {word}, …}}}} waits for it"
    if kind == where:
        return f"; '{word}' cannot stand within another {kind}"
    article = "an" if kind == "action" else "a"
    return f"; '{word}' is {article} {kind}: it stands in '{kind}s'" if kind else ""


def _entry_models(shape: Shape) -> Iterator[Any]:
    """Yield the models of the entries of a list, if the shape is one."""
    entries = get_args(bare(shape).kind) if get_origin(bare(shape).kind) is tuple else ()
    models = (bare(member).kind for entry in entries[:1] for member in members(entry))
    return (model for model in models if is_model(model))


def _instead_of_list(path: Path, node: Node | None, words: list[str]) -> str:
    """Return what to do about a list of conditions where one condition stands."""
    if not isinstance(node, Items) or path[-1:] != ("condition",):
        return ""
    return (
        f"; it takes a single one of {listing(words, 40)} (its opposite by negate: true); for several write "
        "{condition: all_of, conditions: […]}; what else must hold when the rule fires stands in its 'conditions'"
    )


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
