"""What the models expect at a place of the tree: used by merging, overrides, error messages and the schema.

A *shape* is a type annotation with its pydantic metadata, as the models wrote it. Walking a tree and the shapes side
by side says of every value which fields, names or words may stand there.
"""

from __future__ import annotations

import inspect
import types
from collections.abc import Callable
from functools import cache, wraps
from typing import Annotated, Any, Literal, NamedTuple, TypeVar, Union, get_args, get_origin

from pydantic import BaseModel, Discriminator, Tag
from pydantic.fields import FieldInfo

from rcj_challenges.rules.base import Vocabulary
from rcj_challenges.rules.refs import DrawnValue, Ref, SectionRef
from rcj_challenges.scenario.errors import nearest
from rcj_challenges.scenario.tree import Entries, Items, Leaf, Node, Path, Step, child, plain

Shape = Any
"""A type annotation; None where the models know nothing."""


_Result = TypeVar("_Result")


def _once_a_shape(work: Callable[[Shape], _Result]) -> Callable[[Shape], _Result]:
    """Keep what was found out about a shape, by identity: metadata of pydantic has no hash.

    The shapes are those of the models, a fixed few hundred; each is kept, so that its identity stays its own.
    """
    known: dict[int, tuple[Shape, _Result]] = {}

    @wraps(work)
    def look_up(shape: Shape) -> _Result:
        found = known.get(id(shape))
        if found is None:
            found = known[id(shape)] = (shape, work(shape))
        return found[1]

    return look_up


class Bare(NamedTuple):
    """A shape without its wrapping.

    Attributes:
        kind: the type itself: a class, a Literal, or a dict, tuple or union with its arguments.
        discriminator: what distinguishes the members of a union: a key, a function of the plain value, or None.
    """

    kind: Any
    discriminator: str | Callable[[Any], str | None] | None


@_once_a_shape
def bare(shape: Shape) -> Bare:
    """Strip ``Annotated`` and ``None`` from a shape."""
    discriminator: Any = None
    while True:
        if hasattr(shape, "__metadata__"):
            for extra in shape.__metadata__:
                found = extra.discriminator if isinstance(extra, (FieldInfo, Discriminator)) else None
                found = found.discriminator if isinstance(found, Discriminator) else found
                discriminator = found or discriminator
            words = next((extra for extra in shape.__metadata__ if isinstance(extra, Vocabulary)), None)
            shape = get_args(shape)[0] if words is None else words.shape
        elif (rest := without_none(shape)) is not shape:
            shape = rest
        else:
            return Bare(shape, discriminator)


@_once_a_shape
def without_none(shape: Shape) -> Shape:
    """Return the shape of a place without its ``None``; metadata is kept."""
    if not is_union(shape) or type(None) not in get_args(shape):
        return shape
    rest = tuple(member for member in get_args(shape) if member is not type(None))
    return rest[0] if len(rest) == 1 else Union[rest]  # noqa: UP007 - built at run time


def is_union(shape: Shape) -> bool:
    """Return whether a shape is a union (``X | None`` included)."""
    origin: Any = get_origin(shape)
    return origin is Union or origin is types.UnionType


def is_model(shape: Shape) -> bool:
    """Return whether a bare shape is one of the models."""
    return isinstance(shape, type) and issubclass(shape, BaseModel)


@cache
def fields(model: type[BaseModel]) -> dict[str, Shape]:
    """Return the shapes of a model's fields by the key that the file uses."""
    hints: dict[str, Shape] = {}
    for base in reversed(model.__mro__):  # `typing.get_type_hints` would look for names in texts, and there are none
        hints |= inspect.get_annotations(base)
    return {info.alias or name: _without_reference(hints[name]) for name, info in model.model_fields.items()}


def _without_reference(shape: Shape) -> Shape:
    """Return a field's shape without what it names, which is of the field and not of the values that it may have."""
    if not hasattr(shape, "__metadata__"):
        return shape
    kind, *extras = get_args(shape)
    kept = [extra for extra in extras if not isinstance(extra, Ref | SectionRef | DrawnValue)]
    for extra in kept:
        kind = Annotated[kind, extra]
    return kind


@_once_a_shape
def members(shape: Shape) -> tuple[Shape, ...]:
    """Return the members of a union, or the shape alone."""
    kind = bare(shape).kind
    return get_args(kind) if is_union(kind) else (shape,)


@_once_a_shape
def tags(shape: Shape) -> dict[str, Shape]:
    """Return the members of a discriminated union by their tag; empty for anything else."""
    kind, discriminator = bare(shape)
    if discriminator is None:
        return {}
    found: dict[str, Shape] = {}
    for member in members(kind):
        model = bare(member).kind
        if isinstance(discriminator, str):
            found.update(dict.fromkeys(get_args(model.model_fields[discriminator].annotation), member))
        else:
            found.update({extra.tag: member for extra in get_args(member)[1:] if isinstance(extra, Tag)})
    return found


def tag_of(shape: Shape, node: Node) -> str | None:
    """Return the tag that a value has in a discriminated union, or None if it shows none."""
    discriminator = bare(shape).discriminator
    if discriminator is None:
        return None
    if callable(discriminator):
        return discriminator(plain(node))
    tag = child(node, discriminator)
    return tag.value if isinstance(tag, Leaf) and isinstance(tag.value, str) else None


def chosen(shape: Shape, node: Node) -> Shape:
    """Return the member of a union that fits a value's form (not its content); None if none does."""
    options = members(shape)
    if len(options) == 1:
        return shape
    if bare(shape).discriminator is not None:
        return tags(shape).get(tag_of(shape, node) or usual_tag(shape) or "")
    fitting = [member for member in options if _fits(bare(member).kind, node)]
    if isinstance(node, Entries) and len(fitting) > 1:
        known = [sum(_weights(bare(member).kind).get(key, 0) for key in node.entries) for member in fitting]
        fitting = [member for member, count in zip(fitting, known, strict=True) if count == max(known)]
        # To look for misspelt keys takes long.
        return fitting[0] if len(fitting) == 1 else max(fitting, key=lambda one: _likeness(bare(one).kind, node))
    return fitting[0] if fitting else None


def usual_tag(shape: Shape) -> str | None:
    """Return the tag that is meant if a mapping has none; None: it must have one."""
    key = bare(shape).discriminator
    models = {tag: bare(member).kind for tag, member in tags(shape).items() if isinstance(key, str)}
    return next((tag for tag, model in models.items() if model.model_fields[key].default == tag), None)


@cache
def _weights(model: type[BaseModel]) -> dict[str, int]:
    """Return how much each key of a mapping speaks for a model: a required one twice as much."""
    return {info.alias or name: 1 + info.is_required() for name, info in model.model_fields.items()}


def _likeness(model: type[BaseModel], node: Entries) -> tuple[int, int]:
    """Return how likely a model is meant: it lacks few keys, and keys that it does not know are misspelt ones of it."""
    known = fields(model)
    missing = sum(weight > 1 and key not in node.entries for key, weight in _weights(model).items())
    return -missing, sum(key not in known and nearest(key, known) is not None for key in node.entries)


def _fits(kind: Any, node: Node) -> bool:
    if isinstance(node, Entries):
        return is_model(kind) or get_origin(kind) is dict
    if isinstance(node, Items):
        return get_origin(kind) is tuple
    value = node.value
    if get_origin(kind) is Literal:
        return any(type(value) is type(word) for word in get_args(kind))
    if kind is float:
        return isinstance(value, (int, float)) and not isinstance(value, bool)
    return isinstance(kind, type) and type(value) is kind


def step_into(shape: Shape, node: Node, step: Step) -> Shape:
    """Return the shape one step into a value; None where the models know nothing."""
    return _inside(chosen(shape, node))(step)


@_once_a_shape
def _inside(shape: Shape) -> Callable[[Step], Shape]:
    """Return a function from a step to what is there in a value of a shape that is no union."""
    kind = bare(shape).kind
    arguments = get_args(kind)
    if is_named(kind):
        return lambda step: arguments[1] if isinstance(step, str) else None
    if is_list(kind):
        return lambda step: arguments[0] if isinstance(step, int) else None
    known: dict[Any, Shape] = {}
    if is_model(kind):
        known = fields(kind)
    elif get_origin(kind) is tuple:
        known = dict(enumerate(arguments))
    return known.get


def shape_at(shape: Shape, root: Node, path: Path) -> Shape:
    """Return the shape at the end of a path of existing values."""
    node: Node | None = root
    for step in path:
        if node is None or shape is None:
            return None
        shape = step_into(shape, node, step)
        node = child(node, step)
    return shape


def may_be_scalar(shape: Shape) -> bool:
    """Return whether a single value may stand here, and with it ``{param: NAME}``. True where nothing is known."""
    return shape is None or any(
        not is_model(kind) and get_origin(kind) not in (dict, tuple)
        for kind in (bare(member).kind for member in members(shape))
    )


def is_named(shape: Shape) -> bool:
    """Return whether a shape is a mapping whose keys are names that authors choose."""
    return get_origin(bare(shape).kind) is dict


def is_list(shape: Shape) -> bool:
    """Return whether a shape is a list of any length."""
    kind = bare(shape).kind
    return get_origin(kind) is tuple and get_args(kind)[-1] is Ellipsis
