"""Random values of any shape of the models, with names that refer to what exists.

Walks the models as they are: a word that is added to the language is made up from its first day on. Only what no type
says stands here by hand, in `fitting`.
"""

from __future__ import annotations

import random
from contextlib import suppress
from typing import Any, Literal, get_args, get_origin

from pydantic import BaseModel
from pydantic.fields import FieldInfo

from rcj_challenges.rules.actions.score import Score
from rcj_challenges.rules.conditions.any_of import AnyOf
from rcj_challenges.rules.number import NumberValue
from rcj_challenges.rules.placement import DrawnSpeed
from rcj_challenges.rules.refs import KEEPERS, Ref, Reference, SectionRef, ref_of
from rcj_challenges.rules.values.draw import DrawnDuration, NumberDraw
from rcj_challenges.scenario.models.scenario import Rule
from rcj_challenges.scenario.shape import Shape, bare, fields, is_model, is_union, members, tags, without_none
from tests.whole_scenarios.fitting import FIT, sentence
from tests.whole_scenarios.staging import COLOURS, Data, Stage, point

_BOUNDS = ("gt", "ge", "lt", "le", "min_length", "max_length", "pattern")
_DRAWN_NUMBERS = {NumberDraw: 1e9, DrawnDuration: 100, DrawnSpeed: 3}
"""Where a draw's name stands for a number, and how large that may be."""
_RARELY = 0.3
"""How often a key is given that may be left out."""
_DEEPEST = 3
_TEXTS = ("yes", "Hello", "7", "0.1 0.2", "-", "ä€😀", "{x}", "a: b", "#", "' \"", "<b>&amp;", "null", "1e400", "\\")


class ImpossibleError(Exception):
    """Nothing that exists could stand there."""


def _is_deep(kind: Any) -> bool:
    return isinstance(kind, type) and issubclass(kind, AnyOf | NumberValue)


class Maker:
    """Makes values.

    Args:
        chance: all that is random.
        stage: what exists.

    Attributes:
        each, other: the names that these stand for while a rule is made; None where they are not known.
    """

    def __init__(self, chance: random.Random, stage: Stage) -> None:
        self.chance = chance
        self.stage = stage
        self.each: tuple[str, ...] | None = None
        self.other: tuple[str, ...] | None = None
        self._depth = 0

    # --- models -----------------------------------------------------------------------------------------------------

    def model(self, model: type[BaseModel], without: tuple[str, ...] = (), often: float = _RARELY) -> Data:
        """Return a model as the file writes it.

        Args:
            model: which.
            without: keys that are left out.
            often: how often a key is given that may be left out.

        Raises:
            ImpossibleError: a required key would name something that does not exist.
        """
        data: Data = {}
        self._depth += 1
        try:
            for name, info in model.model_fields.items():
                key = info.alias or name
                if key in without or (not info.is_required() and self.chance.random() > often):
                    continue
                try:
                    data[key] = self.field(model, key)
                except ImpossibleError:
                    if info.is_required():
                        raise
        finally:
            self._depth -= 1
        fit = FIT.get(model)
        if fit is not None:
            fit(self, data)
        return data

    def field(self, model: type[BaseModel], key: str) -> Any:
        """Return a value of one field of a model.

        Raises:
            ImpossibleError: it would name something that does not exist.
        """
        name, info = next((name, info) for name, info in model.model_fields.items() if (info.alias or name) == key)
        return self.value(fields(model)[key], key, ref_of(model, name), info.metadata, model)

    # --- values -----------------------------------------------------------------------------------------------------

    def value(
        self, shape: Shape, key: str, reference: Reference | None = None, extras: Any = (),
        owner: type[BaseModel] | None = None,
    ) -> Any:  # fmt: skip
        """Return a value of a shape.

        Raises:
            ImpossibleError: it would name something that does not exist.
        """
        bounds = bounds_of(shape, extras)
        shape = without_none(shape)
        kind = bare(shape).kind
        if is_union(kind):
            options = list(dict.fromkeys(map(_Kept, tags(shape).values() or members(kind))))
            if self._depth > _DEEPEST:
                options = [one for one in options if not _is_deep(bare(one.shape).kind)] or options
            self.chance.shuffle(options)
            for option in options:
                with suppress(ImpossibleError):
                    return self.value(option.shape, key, reference, extras, owner)
            raise ImpossibleError
        if is_model(kind):
            return self.model(kind)
        origin = get_origin(kind)
        if origin is Literal:
            return self.chance.choice(get_args(kind))
        if origin is dict:
            return self._mapping(kind, key, reference, owner)
        if origin is tuple:
            return self._list(shape, kind, key, reference, bounds, owner)
        return self._scalar(kind, key, reference, bounds, owner)

    def _mapping(self, kind: Any, key: str, reference: Reference | None, owner: Any) -> Data:
        inner = get_args(kind)[1]
        keys = [
            self.chance.choice(("x", "y", "type", "Goal_2", "no", "k" * 64)) for _ in range(self.chance.randrange(4))
        ]
        if reference is not None and reference.keys:
            keys = [self._name(reference, owner) for _ in range(self.chance.choice((1, 1, 2)))]
        return {name: self.value(inner, key) for name in keys}

    def _list(
        self, shape: Shape, kind: Any, key: str, reference: Reference | None, bounds: Data, owner: Any
    ) -> list[Any]:
        arguments = get_args(kind)
        if arguments == (float, float) and reference is None:
            return self.chance.choice((point(self.chance), [0.05, 0.05])) if key != "noise_m" else [0.05, 0]
        if len(arguments) == 2 and arguments[1] is Ellipsis:
            least, most = bounds.get("min_length", 0), bounds.get("max_length", 4)
            if most == 3 and least == 2:
                return point(self.chance) + ([1.5] if self.chance.random() < 0.3 else [])
            count = max(least, min(most, self.chance.choice((1, 1, 1, 2, 3))))
            return [self.value(arguments[0], key, reference, (), owner) for _ in range(count)]
        return [self.value(one, key, reference, (), owner) for one in arguments]

    def _scalar(self, kind: Any, key: str, reference: Reference | None, bounds: Data, owner: Any) -> Any:
        if kind is str:
            if reference is not None and not reference.keys:
                return self._name(reference, owner)
            return self._text(key, bounds)
        if kind is bool:
            return self.chance.random() < 0.5
        return self._number(key, bounds, whole=kind is int)

    def _text(self, key: str, bounds: Data) -> str:
        pattern = bounds.get("pattern") or ""
        if pattern.startswith("^[A-Z]"):
            return self.chance.choice(self.stage.events)
        if key == "exclusive":
            return self.chance.choice(("one", "two"))
        if "#" in pattern:
            return self.chance.choice(COLOURS)
        if pattern.startswith("^[A-Za-z_]"):
            return self.chance.choice(("one", "two", "name_of_nobody"))
        if key == "says":
            return sentence(self)
        return self.chance.choice([text for text in _TEXTS if key != "text" or " " not in text])

    def _number(self, key: str, bounds: Data, *, whole: bool) -> float:
        least, most = bounds.get("ge", bounds.get("gt")), bounds.get("le", bounds.get("lt"))
        if whole:
            usual: tuple[float, ...] = (1, 2, 3, 5, 100, 1, 2)
        elif key.endswith("_s"):
            usual = (0.032, 0.05, 0.1, 0.5, 1, 2, 3.3)
        elif key.endswith(("_m", "_rad", "_mps")):
            usual = (0.01, 0.05, 0.1, 0.2, 0.5, 1, 0.3)
        else:
            usual = (0, 1, -1, 0.1, 2.5, 7, 10)
        if self.chance.random() < 0.04:
            usual = (0, -1, 1e-9, 1e15, 86_400, 1e308, least or 0, most or 1) if not whole else (0, 10**15, 10_000)
        number = self.chance.choice(usual)
        if least is not None and number <= least:
            number = least if "ge" in bounds else self.chance.choice((0.1, 0.5, 1))
        if most is not None and number >= most:
            number = most if "le" in bounds else most / 2
        return int(number) if whole else number

    # --- names ------------------------------------------------------------------------------------------------------

    def _name(self, reference: Reference, owner: Any) -> str:
        if isinstance(reference, SectionRef):
            return self._named(reference, owner)
        stage, chance = self.stage, self.chance
        bound = [
            name
            for name, members in (("each", self.each), ("other", self.other))
            if reference.each and members and all(stage.kinds.get(one) in reference.kinds for one in members)
        ]
        if bound and chance.random() < 0.6:
            return chance.choice(bound)
        known = [name for name, kind in stage.kinds.items() if kind in reference.kinds]
        if "walls" in reference.kinds and stage.data.get("field", {}).get("walls", True):
            known.append("walls")
        if reference.groups and chance.random() < 0.5:
            known += self._groups_of(reference)
        if reference.drawn and chance.random() < 0.2:
            known += [draw for draw, values in stage.draws.items() if self._may_be(values, reference)]
        if reference.takes_roles and chance.random() < 0.2:
            known += [role for role, members in stage.roles.items() if self._may_be(members, reference)]
        return chance.choice(known) if known else self._refused()

    def _groups_of(self, reference: Ref) -> list[str]:
        return [
            group for group, members in self.stage.groups.items() if members and self._may_be(list(members), reference)
        ]

    def _may_be(self, values: list[Any], reference: Ref) -> bool:
        return all(isinstance(one, str) and self.stage.kinds.get(one) in reference.kinds for one in values)

    def _named(self, reference: SectionRef, owner: Any) -> str:
        chance, stage = self.chance, self.stage
        if owner is Score and self.each and chance.random() < 0.3:
            return "each"
        if reference.sections == ("draws",) and owner in _DRAWN_NUMBERS:
            known = [draw for draw, values in stage.draws.items() if self._numbers(values, _DRAWN_NUMBERS[owner])]
            return chance.choice(known) if known else self._refused()
        known = [name for section in reference.sections for name in stage.named.get(section, [])]
        known += [word for word in reference.words if word not in ("each", "other", "any")]
        return chance.choice(known) if known else self._refused()

    @staticmethod
    def _numbers(values: list[Any], most: float) -> bool:
        return all(
            isinstance(one, int | float) and not isinstance(one, bool) and 0.032 <= one <= most for one in values
        )

    @staticmethod
    def _refused() -> str:
        raise ImpossibleError

    # --- rules ------------------------------------------------------------------------------------------------------

    def rule(self) -> Data:
        """Return a rule.

        Raises:
            ImpossibleError: nothing that exists could set it off.
        """
        shapes = fields(Rule)
        rule: Data = {}
        self.each = self.other = None
        try:
            if self.chance.random() < 0.4:
                group = self._name(KEEPERS, Rule)
                self.each = self.stage.groups.get(group, (group,))
                rule["for_each"] = group
            rule["triggers"] = self._some(shapes["triggers"], "triggers")
            if all(one["trigger"] == "touches" for one in rule["triggers"]):
                self.other = tuple(one for touch in rule["triggers"] for one in self._touched(touch))
            if self.chance.random() < 0.4:
                rule["conditions"] = self._some(shapes["conditions"], "conditions")
            rule["actions"] = self._some(shapes["actions"], "actions", (1, 1, 2, 3))
            rule |= self.model(Rule, without=("for_each", "triggers", "conditions", "actions"))
        finally:
            self.each = self.other = None
        return rule

    def _some(self, shape: Shape, key: str, counts: tuple[int, ...] = (1, 1, 2)) -> list[Any]:
        inner = get_args(bare(shape).kind)[0]
        return [self.value(inner, key) for _ in range(self.chance.choice(counts))]

    def _touched(self, touch: Data) -> list[str]:
        names = touch["other"] if isinstance(touch["other"], list) else [touch["other"]]
        return [
            one
            for name in names
            for one in ((self.each or ()) if name == "each" else self.stage.groups.get(name, (name,)))
        ]


class _Kept:
    """A shape that can stand in a set."""

    def __init__(self, shape: Shape) -> None:
        self.shape = shape


def bounds_of(shape: Shape, extras: Any = ()) -> Data:
    """Return the bounds that pydantic's metadata puts on a shape."""
    found: Data = {}
    layers = [list(extras)]
    while True:
        if hasattr(shape, "__metadata__"):
            layers.append(list(shape.__metadata__))
            shape = get_args(shape)[0]
        elif (rest := without_none(shape)) is not shape:
            shape = rest
        else:
            break
    for extra in (one for layer in layers for one in layer):
        for part in extra.metadata if isinstance(extra, FieldInfo) else [extra]:
            found |= {name: value for name in _BOUNDS if (value := getattr(part, name, None)) is not None}
    return found
