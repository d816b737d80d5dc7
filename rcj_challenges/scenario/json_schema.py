"""The JSON schema of scenario files, for completion and hints in editors.

Written from the models by this module and not by pydantic's own generator, for three reasons: ``{param: NAME}`` may
stand for any single value; a file that extends another one may leave out what its base brings and remove entries by
``null``; and the file must not change with pydantic's version, since CI compares it.

What sits in lists never merges with a base, so it must always be complete there. Everything else may be partial if
the file says ``extends``; if it does not, the ``else`` part of the schema demands what is required.
"""

from __future__ import annotations

import inspect
import json
from collections.abc import Iterable
from typing import Any, Literal, get_args, get_origin

from pydantic import BaseModel, StringConstraints
from pydantic.fields import FieldInfo
from pydantic_core import PydanticUndefined

from rcj_challenges.rules.fields import DurationS, EventName, Name, Names, Point
from rcj_challenges.rules.values import Amount, Lasts, Limit, Waits
from rcj_challenges.scenario.models.scenario import Scenario
from rcj_challenges.scenario.shape import Shape, bare, fields, is_model, is_union, members, without_none

FILE = "scenario.schema.json"
_Json = dict[str, Any]

_PARAM = {
    "type": "object",
    "description": "The value of a param: {param: NAME} stands for any single value; of a number also computed.",
    "properties": {
        "param": {"type": "string", "description": "a name of the section params"},
        "times": {"type": "number", "description": "the param times this number; left out: 1"},
        "plus": {"type": "number", "description": "and this number added; left out: 0"},
        "of": {"const": "other", "description": "in a repeated entry: that of the other row of a table of two"},
    },
    "required": ["param"],
    "additionalProperties": False,
}
_REPEATED = {
    "type": "object",
    "description": "An entry that is copied for each row of a table, or of tables that are crossed.",
    "properties": {
        "repeat_for": {
            "description": "a table, or a list of tables",
            "anyOf": [{"type": "string"}, {"type": "array", "items": {"type": "string"}, "minItems": 1}],
        }
    },
    "required": ["repeat_for"],
}
_REPEATED_REF = {"$ref": "#/$defs/repeated"}
_PARAM_REF = {"$ref": "#/$defs/param"}
_NULL = {"type": "null", "description": "null removes this entry of the base"}
_TYPES = {str: "string", int: "integer", float: "number", bool: "boolean"}
_BOUNDS = {"gt": "exclusiveMinimum", "ge": "minimum", "lt": "exclusiveMaximum", "le": "maximum"}
_SHARED: tuple[tuple[Shape, str], ...] = (
    (Names, "names"), (Name, "name"), (EventName, "event_name"), (DurationS, "duration_s"), (Point, "point"),
    (Amount, "amount"), (Lasts, "lasts"), (Limit, "limit"), (Waits, "waits"),
)  # fmt: skip
"""Shapes that stand in so many places that the schema defines them once."""

_WITHOUT_PARAM = frozenset({"extends", "params"})
"""Sections that must be known before params are, or are the params themselves."""
_NEVER_REPEATED = frozenset({"params", "tables", "groups"})


def scenario_schema() -> _Json:
    """Return the JSON schema (draft 2020-12) of a scenario file."""
    writer, properties, partial = SchemaWriter(), {}, None
    while writer.partial_models != partial:  # once more if a model turned out to be partial somewhere
        partial = frozenset(writer.partial_models)
        writer = SchemaWriter(partial_models=partial)
        properties = writer.properties(Scenario, partial=True)
    plain = SchemaWriter(with_params=False).properties(Scenario, partial=True)
    properties |= {section: plain[section] for section in _WITHOUT_PARAM}
    fields_sent = writer.definitions["Broadcast"]["properties"]["fields"]
    for section, schema in [("fields", fields_sent), *properties.items()]:
        options = {} if section in _NEVER_REPEATED else schema.get("additionalProperties", {})
        for option in options.get("anyOf", ()) if section == "placements" else ():
            if "items" in option:
                option["items"] = {"anyOf": [option["items"], _REPEATED_REF]}
        if "anyOf" in options and section != "placements":
            options["anyOf"].append(_REPEATED_REF)
    return {
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "RCJ Challenges scenario",
        "description": sentence_of(Scenario),
        "type": "object",
        "properties": properties,
        "additionalProperties": False,
        "$defs": {"param": _PARAM, "repeated": _REPEATED, **dict(sorted(writer.definitions.items()))},
    }


def schema_text() -> str:
    """Return the schema as it is committed."""
    return json.dumps(scenario_schema(), indent=1, ensure_ascii=False) + "\n"


def sentence_of(model: type[BaseModel]) -> str:
    """Return the first paragraph of a model's docstring on one line."""
    return " ".join((inspect.getdoc(model) or "").partition("\n\n")[0].split()).replace("``", "`")


class SchemaWriter:
    """Writes shapes as schemas and collects the definitions that they refer to, one for each model.

    Args:
        with_params: whether ``{param: NAME}`` may stand for a single value.
        partial_models: models of which a base may bring a part somewhere; wherever it may not, what they require stands
            beside the reference. Those that are met are added.
    """

    def __init__(self, *, with_params: bool = True, partial_models: Iterable[type[BaseModel]] = ()) -> None:
        self.definitions: dict[str, _Json] = {}
        self.partial_models = set(partial_models)
        self._with_params = with_params

    def properties(self, model: type[BaseModel], *, partial: bool) -> _Json:
        """Return the schemas of a model's fields."""
        shapes = fields(model)
        return {
            (info.alias or name): self._property(model, info, shapes[info.alias or name], partial=partial)
            for name, info in model.model_fields.items()
        }

    def _property(self, model: type[BaseModel], info: FieldInfo, shape: Shape, *, partial: bool) -> _Json:
        schema = self.schema(shape, partial=partial)
        if "$ref" not in schema:
            schema = _bounded(schema, keywords([info], shape))
        is_word = "const" in schema
        if self._with_params and is_word and not (info.is_required() and isinstance(schema["const"], str)):
            schema = _or_param(schema)  # for a word that distinguishes forms `_of_any_form` does it
        found: _Json = {}
        if description := info.description or (sentence_of(model) if is_word else ""):
            found["description"] = description
        if info.default not in (PydanticUndefined, None):
            found["default"] = _jsonable(info.default)
        if info.examples:
            found["examples"] = info.examples
        return found | {key: value for key, value in schema.items() if key not in found}

    def schema(self, shape: Shape, *, partial: bool) -> _Json:
        """Return the schema of a shape; ``partial`` if a base may bring the rest of it."""
        shape = without_none(shape)
        shared = next((name for known, name in _SHARED if shape == known), None)
        if shared is None:
            return self._with_param(shape, partial=partial)
        if shared not in self.definitions:
            self.definitions[shared] = {}  # claimed first, as what it contains may contain it
            self.definitions[shared] = found = self._with_param(shape, partial=False)
            if shape == Point and self._with_params:  # a column of a table may hold a list of two numbers
                self.definitions[shared] = _or_param(found)
        return {"$ref": f"#/$defs/{shared}"}

    def _with_param(self, shape: Shape, *, partial: bool) -> _Json:
        plain = self._plain(shape, partial=partial)
        if not self._with_params:
            return plain
        options = plain.get("anyOf", [plain])
        # A word alone distinguishes one form of a mapping from the others; beside other things it is an ordinary value.
        words = {"enum", "const"} if len(options) > 1 else {"enum"}
        scalar = any(option.get("type") in _TYPES.values() or words & option.keys() for option in options)
        return _or_param(plain) if scalar and _PARAM_REF not in options else plain

    def _plain(self, shape: Shape, *, partial: bool) -> _Json:
        kind, discriminator = bare(shape)
        extras = get_args(shape)[1:] if hasattr(shape, "__metadata__") else ()
        texts = [extra.description for extra in extras if isinstance(extra, FieldInfo) and extra.description]
        described = {"description": texts[-1]} if texts else {}
        if is_union(kind):
            options = self._options(shape, partial=partial)
            if isinstance(discriminator, str) and self._with_params:
                options.append(_of_any_form(discriminator))
            word = "oneOf" if isinstance(discriminator, str) and not partial else "anyOf"
            return {**described, word: _flat(options)}
        if is_model(kind):
            return {**described, **self._reference(kind, partial=partial)}
        if get_origin(kind) is dict:
            key, value = get_args(kind)
            inner = self.schema(value, partial=partial)
            inner = {"anyOf": [*inner.get("anyOf", [inner]), _NULL]} if partial else inner
            names = {k: v for k, v in self._plain(key, partial=False).items() if k != "type"}
            return {**described, "type": "object", "propertyNames": names, "additionalProperties": inner}
        if get_origin(kind) is tuple:
            return _bounded({**described, **self._array(get_args(kind))}, keywords(extras, shape))
        if get_origin(kind) is Literal:
            words = list(get_args(kind))
            return {**described, **({"const": words[0]} if len(words) == 1 else {"enum": words})}
        return {**described, "type": _TYPES[kind], **keywords(extras, shape)}

    def _options(self, shape: Shape, *, partial: bool) -> list[_Json]:
        """Return the schemas of a union's members.

        Those with keys in common are one: what stands under these keys is looked at once, and not once for each.
        """
        alike: dict[tuple[type[BaseModel], ...], list[_Json]] = {}
        options: list[_Json] = []
        for member in members(shape):
            option, parts = self._plain(member, partial=partial), _parts_of(bare(member).kind)
            (alike.setdefault(parts, []) if parts else options).append(option)
        for parts, words in alike.items():
            common = [self._reference(part, partial=False) for part in parts]
            options.append({"type": "object", "allOf": [*common, {"anyOf": words}], "unevaluatedProperties": False})
        return options

    def _array(self, arguments: tuple[Any, ...]) -> _Json:
        if len(arguments) == 2 and arguments[1] is Ellipsis:
            return {"type": "array", "items": self.schema(arguments[0], partial=False)}
        items = [self.schema(argument, partial=False) for argument in arguments]
        return {"type": "array", "prefixItems": items, "items": False, "minItems": len(items), "maxItems": len(items)}

    def _reference(self, model: type[BaseModel], *, partial: bool) -> _Json:
        model = getattr(model, "DEFINED_AS", model)
        name = model.__name__.removesuffix("Model")
        required = [info.alias or key for key, info in model.model_fields.items() if info.is_required()]
        demand = {"required": required} if required else {}
        if partial:
            self.partial_models.add(model)
        is_partial = model in self.partial_models
        if name not in self.definitions:
            self.definitions[name] = {}  # claimed first, so that a model may contain itself
            parts = _parts_of(model)
            shared = {key for part in parts for key in fields(part)}
            properties = self.properties(model, partial=is_partial)
            self.definitions[name] = {
                "type": "object",
                "description": sentence_of(model),
                "properties": {key: one for key, one in properties.items() if key not in shared},
                **({} if is_partial else demand),
                **({"additionalProperties": False} if not parts and "IS_PART" not in vars(model) else {}),
            }
        return {"$ref": f"#/$defs/{name}", **(demand if is_partial and not partial else {})}


def _parts_of(model: Any) -> tuple[type[BaseModel], ...]:
    """Return the classes whose fields a model has in common with others of its kind."""
    above = model.__mro__[1:] if is_model(model) else ()
    return tuple(one for one in above if "IS_PART" in vars(one))


def _or_param(plain: _Json) -> _Json:
    """Return a schema in whose place the use of a param may stand."""
    described = {key: value for key, value in plain.items() if key == "description"}
    rest = {key: value for key, value in plain.items() if key != "description"}
    return {**described, "anyOf": [*plain.get("anyOf", [rest]), _PARAM_REF]}


def _of_any_form(discriminator: str) -> _Json:
    """Return the schema of a mapping whose form a param says: what else may stand in it only the loader knows.

    A choice of its own, so that the other forms are known by their word alone, as editors need it.
    """
    which = {"$ref": _PARAM_REF["$ref"], "description": f"a param whose value is the word for '{discriminator}'"}
    return {"type": "object", "properties": {discriminator: which}, "required": [discriminator]}


def _flat(options: Iterable[_Json]) -> list[_Json]:
    """Return options without unions in unions, each once."""
    found: list[_Json] = []
    for option in options:
        for part in option["anyOf"] if set(option) == {"anyOf"} else [option]:
            if part not in found:
                found.append(part)
    return found


def keywords(extras: Iterable[Any], shape: Shape) -> _Json:
    """Return the bounds that pydantic's metadata puts on a shape, as JSON-schema keywords."""
    kind = bare(shape).kind
    unit = {tuple: "Items", dict: "Properties"}.get(get_origin(kind), "Length")
    found: _Json = {}
    for extra in extras:
        parts = extra.metadata if isinstance(extra, FieldInfo) else [extra]
        if isinstance(extra, FieldInfo) and isinstance(extra.json_schema_extra, dict):
            found |= extra.json_schema_extra
        for part in parts:
            if isinstance(part, StringConstraints):
                found |= {"pattern": part.pattern} if part.pattern else {}
            for name, keyword in _BOUNDS.items():
                if getattr(part, name, None) is not None:
                    found[keyword] = getattr(part, name)
            for name in ("min_length", "max_length"):
                if getattr(part, name, None) is not None:
                    found[f"{name[:3]}{unit}"] = getattr(part, name)
    return found


def _bounded(schema: _Json, bounds: _Json) -> _Json:
    """Put bounds on a schema; in a choice with ``{param: …}`` on its first option, which is the value itself."""
    if not bounds:
        return schema
    if "anyOf" in schema:
        first, *rest = schema["anyOf"]
        return {**schema, "anyOf": [{**first, **bounds}, *rest]}
    return {**schema, **bounds}


def _jsonable(value: Any) -> Any:
    if isinstance(value, BaseModel):
        # Only what differs from the defaults of its own fields: those are described at the fields.
        return value.model_dump(mode="json", by_alias=True, exclude_defaults=True)
    if isinstance(value, tuple):
        return [_jsonable(part) for part in value]
    return value
