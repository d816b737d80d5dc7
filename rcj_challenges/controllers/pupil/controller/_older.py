"""What the standard library had in Python 3.8, for which the programs of 2021 to 2023 were written, and has no more."""

# ruff: noqa: PLC0415 - each import costs every program, so there are few, and late ones

from __future__ import annotations

from typing import Any

from ._hooks import Patch


def _collections(module: Any) -> None:
    import _collections_abc

    for name in _collections_abc.__all__:
        vars(module).setdefault(name, getattr(_collections_abc, name))


def _random(module: Any) -> None:
    real = module.Random.sample

    def sample(self: Any, population: Any, k: int, **more: Any) -> Any:
        return real(self, tuple(population) if isinstance(population, (set, frozenset)) else population, k, **more)

    module.Random.sample = sample
    module.sample = module._inst.sample  # noqa: SLF001 - `random.sample` is this method, bound when it was imported


def _inspect(module: Any) -> None:
    from collections import namedtuple

    ArgSpec = namedtuple("ArgSpec", "args varargs keywords defaults")  # noqa: PYI024 - as it was

    def getargspec(func: Any) -> Any:
        return ArgSpec(*module.getfullargspec(func)[:4])

    vars(module).setdefault("getargspec", getargspec)


def _threading(module: Any) -> None:
    if not hasattr(module.Thread, "isAlive"):
        module.Thread.isAlive = module.Thread.is_alive


def _fractions(module: Any) -> None:
    from math import gcd

    vars(module).setdefault("gcd", gcd)


def _base64(module: Any) -> None:
    vars(module).setdefault("encodestring", module.encodebytes)
    vars(module).setdefault("decodestring", module.decodebytes)


PATCHES: dict[str, Patch] = {
    "collections": _collections,
    "random": _random,
    "inspect": _inspect,
    "threading": _threading,
    "fractions": _fractions,
    "base64": _base64,
}
"""By module: what to do when a program has imported it."""
