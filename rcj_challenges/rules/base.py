"""What all words share: how they are listed, compiled by the referee and explained by the sheet.

A word is one file: its model, what the referee makes of it, its sentence on the sheet, and its example. Such a file
imports neither the referee nor the sheet, only the protocols `Binder` and `Phrases`.
"""

from collections.abc import Callable, Mapping, Sequence
from types import MappingProxyType
from typing import Annotated, Any, ClassVar, Union, get_args

from pydantic import Discriminator, Field, GetCoreSchemaHandler, Tag
from pydantic_core import CoreSchema, core_schema

from rcj_challenges.rules.binder import Binder, Scope
from rcj_challenges.rules.effects import Effect, Moment, Writes, declared
from rcj_challenges.rules.fields import Name, Names, Point, Scalar, Strict, described
from rcj_challenges.rules.phrases import Phrases
from rcj_challenges.rules.refs import SectionRef, refs_of
from rcj_challenges.tracking.bound_rules import Act, Firing, Reader, Test
from rcj_challenges.tracking.places import PlaceRequest, PlaceResolver
from rcj_challenges.tracking.state import Number

# What the files of words import from here.
__all__ = (
    "ENTITY_DESCRIPTION", "Act", "Action", "Binder", "Condition", "Firing", "KeyedVocabulary", "KeyedWord", "Number",
    "Phrases", "PlaceRequest", "PlaceResolver", "PlaceWord", "Reader", "Scope", "Test", "Trigger", "ValueWord",
    "Vocabulary", "Word",
)  # fmt: skip

ENTITY_DESCRIPTION = "an entity (a robot, a ball or a movable obstacle), a group (any member), or each"


class Word(Strict):
    """A word of the language.

    Attributes:
        KEY: the field that says which word it is: ``trigger``.
        EXAMPLE: sections of a scenario that show it; run as a test, and printed in the reference with the sentences of
            the rule sheet about it.
    """

    # ClassVar alone: pydantic would evaluate ClassVar[str] again for each word.
    KEY: ClassVar = ""
    EXAMPLE: ClassVar = ""
    READS_MESSAGES: ClassVar = False

    @classmethod
    def name(cls) -> str:
        """Return the word as the file writes it."""
        return str(get_args(cls.model_fields[cls.KEY].annotation)[0])

    def stands_for(self, _bound: str) -> bool:
        """Return whether it is about ``each`` or about ``other`` without naming it in a field."""
        return False

    def distances_m(self) -> tuple[tuple[Name | Point, float], ...]:
        """Return the fixed distances in m that it compares with, each with the name or point it is measured from."""
        return ()


class Vocabulary:
    """The words of one kind, in the order in which the schema and the reference list them.

    It stands in annotations, ``Annotated[Trigger, TRIGGERS]``, where it is the union of its words, discriminated by
    their key. That is built when a model is first used, so words can be added until then.

    Args:
        otherwise: the word that is meant without the key; empty: the key is required.
    """

    def __init__(
        self,
        key: str,
        otherwise: str = "",
    ) -> None:
        self.key = key
        self._words: list[type[Word]] = []
        self._otherwise = otherwise or None

    def add(self, *words: type[Word]) -> None:
        """Add words at the end."""
        self._words += words

    def words(self) -> tuple[type[Word], ...]:
        """Return all words."""
        return tuple(self._words)

    @property
    def shape(self) -> Any:
        """The union of the words, as a type annotation."""
        return Annotated[Union[self.words()], Field(discriminator=self.key)]  # noqa: UP007 - built at run time

    def __get_pydantic_core_schema__(self, _source: Any, handler: GetCoreSchemaHandler) -> CoreSchema:
        """Return the schema of the union."""
        # A word is dumped as what it is: for its tag pydantic would call us, and swallow a Ctrl-C that comes meanwhile.
        as_it_is = core_schema.simple_ser_schema("any")
        return core_schema.tagged_union_schema(self._choices(handler), self._discriminator(), serialization=as_it_is)

    def _discriminator(self) -> Any:
        return self.key if self._otherwise is None else self.tag_of

    def tag_of(self, value: Any) -> str | None:
        """Return the word to which a value belongs; None: to none."""
        if isinstance(value, Word):
            return value.name()
        return value.get(self.key, self._otherwise) if isinstance(value, dict) else None

    def _choices(self, _handler: GetCoreSchemaHandler) -> dict[Any, CoreSchema]:
        """Return the schemas by word: the validator of a word is built when a file first has that word."""
        return {word.name(): core_schema.no_info_plain_validator_function(word.model_validate) for word in self.words()}


class KeyedVocabulary(Vocabulary):
    """Words that are mappings with a key of their own, such as ``{spot: centre}``, beside plain values.

    Args:
        plain: the shapes of plain values by their tag.
        tag_plain: returns the tag of a plain value; None: it is not one of them.
        rest: the shapes of plain values that messages name after the words, by their tag.
    """

    def __init__(
        self,
        plain: Mapping[str, Any],
        tag_plain: Callable[[Any], str | None],
        rest: Mapping[str, Any] = MappingProxyType({}),
    ) -> None:
        super().__init__("")
        self._plain = plain
        self._rest = rest
        self._tag_plain = tag_plain
        self._like: KeyedVocabulary | None = None

    def beside(
        self,
        plain: Mapping[str, Any],
        tag_plain: Callable[[Any], str | None],
        *instead: type[Word],
        rest: Mapping[str, Any] = MappingProxyType({}),
    ) -> "KeyedVocabulary":
        """Return the same words, also those that are added later, beside other plain values; some in other forms."""
        found = KeyedVocabulary(plain, tag_plain, rest=rest)
        found._like = self
        found.add(*instead)
        return found

    def words(self) -> tuple[type[Word], ...]:
        """Return all words."""
        if self._like is None:
            return super().words()
        instead = {word.name(): word for word in self._words}
        return tuple(instead.get(word.name(), word) for word in self._like.words())

    @property
    def shape(self) -> Any:
        """The union of the plain shapes and the words, as a type annotation."""
        shapes = {**self._plain, **{word.name(): word for word in self.words()}, **self._rest}
        members = tuple(Annotated[shape, Tag(tag)] for tag, shape in shapes.items())
        return Annotated[Union[members], Discriminator(self.tag_of)]  # noqa: UP007 - built at run time

    def _discriminator(self) -> Any:
        return self.tag_of

    def _choices(self, handler: GetCoreSchemaHandler) -> dict[Any, CoreSchema]:
        """Return the schemas by word and by tag of the plain values."""
        plain, rest = (
            {tag: handler.generate_schema(shape) for tag, shape in shapes.items()}
            for shapes in (self._plain, self._rest)
        )
        return {**plain, **super()._choices(handler), **rest}

    def tag_of(self, value: Any) -> str | None:
        """Return the word to which a value belongs, or the tag of a plain value; None: neither."""
        if isinstance(value, Word):
            return value.name()
        if isinstance(value, dict):
            return next((word.name() for word in self.words() if word.name() in value), None)
        return self._tag_plain(value)


class Trigger(Word):
    """A moment at which a rule may fire.

    Attributes:
        MEASURED: what it measures, as the sheet says it; empty: nothing.
        LIMIT: the field with the limit that it measures against; empty: none.
        REASON: what follows the entity where a replay says why it fired, with its fields, `measured` and `limit`.
        ABOUT: the field with what it can be about; it need not have one.
        BINDS_OTHER: whether it brings ``entity`` and ``other`` together, so that its rules may name ``other``.
        MUST_EXCEED: whether what it measures must be more than its limit.
        MOMENT: what it waits for, if readers of rules need it; what that has is in the fields of the same names.
        IS_TIME: whether a time sets it off, so that its rules fire after all else of their priority.
    """

    KEY = "trigger"
    ABOUT: ClassVar = "entity"
    MOMENT: ClassVar[type[Moment] | None] = None
    BINDS_OTHER: ClassVar = False
    MUST_EXCEED: ClassVar = False
    IS_TIME: ClassVar = False
    MEASURED: ClassVar = ""
    LIMIT: ClassVar = ""
    REASON: ClassVar = ""

    def bind(self, to: Binder) -> None:
        """Bind a rule to this trigger: to a tracker, or to the clock's events."""
        raise NotImplementedError

    def moment(self) -> Moment | None:
        """Return its moment, if readers of rules need it."""
        return None if self.MOMENT is None else declared(self.MOMENT, self)

    def describe(self, phrases: Phrases) -> str:
        """Return the part of a sentence that follows ``When``."""
        raise NotImplementedError

    def about(self, _phrases: Phrases) -> Names | None:
        """Return the names that it can be about; None: it has none."""
        names: Names | None = getattr(self, self.ABOUT, None)
        return names

    def limit(self, _phrases: Phrases) -> float | None:
        """Return the limit of its measurement; None: it has none, or it is not known before."""
        limit = getattr(self, self.LIMIT) if self.LIMIT else None
        return float(limit) if isinstance(limit, int | float) else None

    def measures_its_limit(self) -> bool:
        """Return whether what it measures is always the limit: it fires when something has lasted so long."""
        return False


class KeyedWord(Word):
    """A word that has a key of its own: its ``KEY`` is its name."""

    @classmethod
    def name(cls) -> str:
        """Return the key that the file writes."""
        return cls.KEY


class Condition(KeyedWord):
    """What must hold when a trigger fires."""

    negate: bool = described(False, "True: the opposite must hold")

    def compile(self, to: Binder) -> Test:
        """Return the test of the condition, turned over if it is negated."""
        test = to.by_role(self, lambda word: word.test(to), otherwise=False)
        return (lambda: not test()) if self.negate else test

    def test(self, to: Binder) -> Test:
        """Return the test of the condition as it is without ``negate``."""
        raise NotImplementedError

    def watched(self, _to: Binder) -> tuple[int, ...]:
        """Return the entities whose placement changes it: a trigger that follows it is reset then."""
        return ()

    def describe(self, phrases: Phrases) -> str:
        """Return the condition, or the opposite of a negated one, as the part of a sentence that follows ``if``."""
        raise NotImplementedError

    def about(self) -> Names | None:
        """Return the entities whose place it reads, if it names them."""
        return None

    def grouped(self) -> Names | None:
        """Return the names of which it must hold of so many; None: it names none."""
        names = getattr(self, "entity" if "entity" in type(self).model_fields else self.KEY)
        return names if isinstance(names, str | tuple) else None

    def is_always(self) -> bool:
        """Return whether it holds at any time."""
        return False

    def is_several(self) -> bool:
        """Return whether it is made of more than one condition."""
        return False

    def compares_with_value(self) -> bool:
        """Return whether it compares with a value, not with a number."""
        return False


class Action(Word):
    """What a rule does when it fires.

    Attributes:
        EFFECT: what it changes, if that is one thing, with the fields of the same names.
    """

    KEY = "action"
    EFFECT: ClassVar[type[Effect] | None] = None

    def compile(self, to: Binder) -> Act:
        """Return the function that carries out the action when its rule fires."""
        raise NotImplementedError

    def effects(self) -> tuple[Effect, ...]:
        """Return its effects: its ``EFFECT``, or the entries that its fields mark as written."""
        if self.EFFECT is not None:
            return (declared(self.EFFECT, self),)
        return tuple(
            Writes(one.sections[0], getattr(self, name))
            for name, _, one in refs_of(type(self))
            if isinstance(one, SectionRef) and one.is_written
        )

    def describe(self, phrases: Phrases) -> str:
        """Return the action as a clause: ``yellow gets 1 point``."""
        raise NotImplementedError

    def points_row(self, _phrases: Phrases) -> tuple[str, str] | None:
        """Return entrant and points for the table of points; None: it gives none."""
        return None


class PlaceWord(KeyedWord):
    """A place where something is put, ``at: {spot: centre}``, or that a kick is aimed at.

    Attributes:
        IS_SPREAD: whether it may be anywhere in the zones, or between the points, that are its options.
    """

    IS_SPREAD: ClassVar[bool] = False

    def compile(self, to: Scope, entity: int) -> PlaceResolver:
        """Return the resolver of the point for an entity, given by its index."""
        raise NotImplementedError

    def describe(self, phrases: Phrases) -> str:
        """Return the place as the part of a sentence that follows ``put``: ``on the spot “centre”``."""
        raise NotImplementedError

    def options(self) -> tuple[Name | Point, ...]:
        """Return the names and points among which it chooses; none if what is put there decides."""
        names = getattr(self, self.KEY)
        return names if isinstance(names, tuple) else (names,)

    def aim(self, phrases: Phrases) -> str:
        """Return the place as what a kick is aimed at: ``a random point of the blue goal``."""
        return self.describe(phrases).removeprefix("on ")

    def describe_placement(self, phrases: Phrases, _entity: Names, *, plural: bool) -> str:
        """Return the placement in words: ``put on the spot “centre”``, ``each put on the spot “centre”``."""
        return f"{'each ' if plural else ''}put {self.describe(phrases)}"

    def fixed(self) -> Name | Point | None:
        """Return the spot or the point that it always is; None: it is one of several, or moves."""
        return None

    def is_where_it_is(self, _entity: Names) -> bool:
        """Return whether an entity is put right where it is already."""
        return False

    def mirrored(self, _phrases: Phrases) -> str | None:
        """Return the part that a mirror changes: an empty text for all of it, `` as seen from Y1``; None: nothing."""
        return ""


class ValueWord(KeyedWord):
    """A value that rules name, ``{counter: laps}``."""

    UNIT: ClassVar = ""

    def read(self, to: Scope) -> Reader:
        """Return a function that reads the value when a rule fires; it can be written as JSON."""
        raise NotImplementedError

    def describe(self, phrases: Phrases) -> str:
        """Return the value in words: ``whether the flag “out” is set``."""
        raise NotImplementedError

    def exactly(self, _phrases: Phrases) -> str | Sequence[Scalar]:
        """Return for programs that receive the value its form, or all that it may be; empty: the words suffice."""
        return ""
