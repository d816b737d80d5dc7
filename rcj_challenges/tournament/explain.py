"""From pydantic's errors to problems with a code, the place in the file, and what to do."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, get_args

from pydantic import ConfigDict, TypeAdapter, ValidationError

from rcj_challenges.facts.diagnostics import Diagnostic
from rcj_challenges.scenario.errors import listing, nearest
from rcj_challenges.scenario.messages.wording import expected, refusal
from rcj_challenges.scenario.shape import Shape, bare, chosen, fields, is_model, is_union, shape_at, step_into, tags
from rcj_challenges.scenario.tree import Entries, Items, Leaf, Node, Path, child, in_names, mark_of, node_at, plain
from rcj_challenges.tournament.errors import did_you_mean, problem_at

_KEY = "[key]"
"""What pydantic appends to the place of a mapping's entry if its key is wrong."""


def explain(error: ValidationError, root: Entries, shape: Shape) -> list[Diagnostic]:
    """Return what pydantic refused as problems, each at its place.

    Args:
        error: of validating the plain data of ``root``.
        root: the file, with positions.
        shape: the model of the whole file.
    """
    mistakes = list(_located(error, root, shape, ()))
    unknown = [one.path for one in mistakes if one.kind == "extra_forbidden"]
    problems = [_problem(one, root, shape) for one in mistakes if not _is_misspelt(one, unknown)]
    return list(dict.fromkeys(problems))


@dataclass(frozen=True)
class _Mistake:
    kind: str
    details: Any
    path: Path
    shape: Shape
    is_of_key: bool = False


def _is_misspelt(mistake: _Mistake, unknown: list[Path]) -> bool:
    """Return whether a missing key is there, misspelt: that is reported already."""
    above, key = mistake.path[:-1], str(mistake.path[-1]) if mistake.path else ""
    return mistake.kind == "missing" and any(
        path[:-1] == above and bool(nearest(str(path[-1]), [key])) for path in unknown
    )


def _located(error: ValidationError, root: Entries, shape: Shape, base: Path) -> Iterator[_Mistake]:
    for details in error.errors(include_url=False, include_input=False):
        mistake = _walk(details, root, shape, base)
        node = node_at(root, mistake.path)
        member = chosen(mistake.shape, node) if node is not None and _is_plain_union(mistake.shape) else None
        if member is None:
            if not _counts_wrong_entries(mistake, node):
                yield mistake
            continue
        config = None if is_model(bare(member).kind) else ConfigDict(strict=True, allow_inf_nan=False)
        adapter: TypeAdapter[Any] = TypeAdapter(member, config=config)
        try:
            adapter.validate_python(plain(node) if node is not None else None)
        except ValidationError as inner:
            yield from _located(inner, root, member, mistake.path)


def _walk(details: Any, root: Entries, shape: Shape, base: Path) -> _Mistake:
    """Follow pydantic's ``loc``; stop at a union without a discriminator, whose members it names in its own way."""
    path, is_of_key = base, False
    for element in details["loc"]:
        if element == _KEY:
            is_of_key = True
        elif is_union(bare(shape).kind):
            if _is_plain_union(shape):
                break
            shape = tags(shape).get(str(element))
        else:
            node = node_at(root, path)
            shape = step_into(shape, node, element) if node is not None else None
            path = (*path, element)
    return _Mistake(str(details["type"]), details, path, shape, is_of_key)


def _counts_wrong_entries(mistake: _Mistake, node: Node | None) -> bool:
    """Return whether a list is called too short only because entries in it are wrong: those are reported."""
    least = mistake.details.get("ctx", {}).get("min_length", 0)
    return mistake.kind == "too_short" and isinstance(node, Items) and len(node.items) >= least


def _is_plain_union(shape: Shape) -> bool:
    kind, discriminator = bare(shape)
    return is_union(kind) and discriminator is None


def _problem(mistake: _Mistake, root: Entries, whole: Shape) -> Diagnostic:
    above, key = mistake.path[:-1], str(mistake.path[-1]) if mistake.path else ""
    node = node_at(root, mistake.path)
    if mistake.kind in ("extra_forbidden", "missing") and mistake.path and isinstance(mistake.path[-1], int):
        shape = shape_at(whole, root, above)  # a list of a fixed length
        said = expected(shape, node_at(root, above))
        return problem_at(mark_of(root, above), "wrong-value", said, _description(shape), in_names(root, above))
    if mistake.kind == "extra_forbidden":
        allowed = list(_model_fields(root, whole, above))
        mark = mark_of(root, mistake.path, at_key=True)
        help_ = did_you_mean(key, allowed, f"Keys here: {listing(allowed, 40)}")
        return problem_at(mark, "unknown-key", f"unknown key '{key[:64]}'", help_, in_names(root, above))
    if mistake.kind == "missing":
        about = _sentence_about(root, whole, above, key)
        mark = mark_of(root, above, at_key=True)
        return problem_at(mark, "missing-key", f"'{key}' is missing", f"{key}: {about}", in_names(root, above))
    code, message, help_ = _of_value(mistake, node, key)
    path = mistake.path
    if mistake.kind == "union_tag_invalid" and isinstance(node, Entries):
        path = (*path, str(bare(mistake.shape).discriminator))
    return problem_at(mark_of(root, path, at_key=mistake.is_of_key), code, message, help_, in_names(root, mistake.path))


def _of_value(mistake: _Mistake, node: Node | None, key: str) -> tuple[str, str, str]:
    """Return code, message and help for a value or a name that does not fit."""
    if mistake.is_of_key:
        return "wrong-name", f"'{key[:64]}' is not a name", "use letters, digits and _ only"
    discriminator = bare(mistake.shape).discriminator
    if isinstance(discriminator, str) and isinstance(node, Entries):
        return _of_kind(discriminator, list(tags(mistake.shape)), child(node, discriminator))
    if isinstance(node, Leaf) and node.value is None:
        return "missing-value", f"'{key}' has no value", "write one, or leave the key out"
    said = refusal(mistake.kind, mistake.details, mistake.shape, node)
    if mistake.kind == "literal_error":
        said = expected(mistake.shape, node)
    what, _, help_ = said.partition("; ")
    return "wrong-value", what, help_ or _description(mistake.shape)


def _of_kind(discriminator: str, words: list[str], tag: Node | None) -> tuple[str, str, str]:
    known = f"There are {listing(words, 40)}"
    if not isinstance(tag, Leaf) or tag.value is None:
        return "missing-key", f"'{discriminator}' is missing", known
    written = str(tag.value)
    message = f"unknown {discriminator} '{written[:64]}'"
    return f"unknown-{discriminator}", message, did_you_mean(written, words, known)


def _description(shape: Shape) -> str:
    extras = get_args(shape)[1:] if hasattr(shape, "__metadata__") else ()
    found = (extra.description for extra in extras if getattr(extra, "description", None))
    return next(found, "rcj-challenge schema --tournament prints all keys and values")


def _model_fields(root: Entries, whole: Shape, path: Path) -> dict[str, Any]:
    node = node_at(root, path)
    shape = shape_at(whole, root, path)
    kind = bare(chosen(shape, node)).kind if node is not None and shape is not None else None
    return dict.fromkeys(fields(kind), kind) if kind is not None and is_model(kind) else {}


def _sentence_about(root: Entries, whole: Shape, path: Path, key: str) -> str:
    model = _model_fields(root, whole, path).get(key)
    infos = model.model_fields.items() if model is not None else ()
    return next((info.description or "" for name, info in infos if (info.alias or name) == key), "")
