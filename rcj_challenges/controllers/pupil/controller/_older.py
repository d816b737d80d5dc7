"""What the standard library had in Python 3.8, for which the programs of 2021 to 2023 were written, and has no more."""

# ruff: noqa: PLC0415 - each import costs every program, so there are few, and late ones

from __future__ import annotations

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

    from ._hooks import Patch


def _collections(module: Any) -> None:
    import _collections_abc

    for name in _collections_abc.__all__:
        vars(module).setdefault(name, getattr(_collections_abc, name))


def _random(module: Any) -> None:
    from collections.abc import Set as AbstractSet

    kind = module.Random
    seed, sample, shuffle, randrange, randint = kind.seed, kind.sample, kind.shuffle, kind.randrange, kind.randint

    def seeded(self: Any, a: Any = None, version: int = 2) -> None:
        """Take whatever has a hash: a moment, a tuple. Those of the match's programs are the same in every run."""
        known = a is None or isinstance(a, (int, float, str, bytes, bytearray))
        seed(self, a if known else hash(a) % 2**64, version)

    def sampled(self: Any, population: Any, k: int, **more: Any) -> Any:
        return sample(self, tuple(population) if isinstance(population, AbstractSet) else population, k, **more)

    def shuffled(self: Any, x: Any, random: Any = None) -> None:
        """Take a function that draws numbers from 0 to 1, too."""
        if random is None:
            shuffle(self, x)
            return
        for last in range(len(x) - 1, 0, -1):
            drawn = int(random() * (last + 1))
            x[last], x[drawn] = x[drawn], x[last]

    def drawn_of_range(self: Any, start: Any, stop: Any = None, step: Any = 1) -> Any:
        """Take 4.0 for 4."""
        return randrange(self, _whole(start), _whole(stop), _whole(step))

    def drawn_between(self: Any, a: Any, b: Any) -> Any:
        """Take 4.0 for 4; since Python 3.14 this does not ask `randrange` any more."""
        return randint(self, _whole(a), _whole(b))

    kind.seed, kind.sample, kind.shuffle = seeded, sampled, shuffled
    kind.randrange, kind.randint = drawn_of_range, drawn_between
    for name in ("seed", "sample", "shuffle", "randrange", "randint"):
        # `random.sample` is that method of one object, bound when the module was imported.
        setattr(module, name, getattr(module._inst, name))  # noqa: SLF001


def _whole(given: Any) -> Any:
    return int(given) if isinstance(given, float) and given.is_integer() else given


def _dataclasses(module: Any) -> None:
    """Let a default be what has no hash, as an array or an object of another dataclass, but no list, dict or set."""
    real = module._get_field  # noqa: SLF001 - where Python refuses it since 3.11

    def get_field(cls: Any, name: str, *more: Any) -> Any:
        given: Any = getattr(cls, name, None)
        is_field = isinstance(given, module.Field)
        default = given.default if is_field else given
        if type(default).__hash__ is not None or isinstance(default, (list, dict, set)):
            return real(cls, name, *more)
        if is_field:
            given.default = None
        else:
            setattr(cls, name, None)
        made = real(cls, name, *more)
        made.default = default
        setattr(cls, name, default)
        return made

    module._get_field = get_field  # noqa: SLF001


def _json(module: Any) -> None:
    real = module.JSONDecoder.__init__

    def init(self: Any, **more: Any) -> None:
        more.pop("encoding", None)  # it said nothing since Python 3.1, and was an error from 3.9 on
        real(self, **more)

    module.JSONDecoder.__init__ = init


def _asyncio(module: Any) -> None:
    from . import _coroutines

    _coroutines.restore_old_names(module)


def _array(module: Any) -> None:
    from ._methods import restore_methods

    kind = module.array
    restore_methods(kind, {"tostring": kind.tobytes, "fromstring": kind.frombytes})


def _elements(module: Any) -> None:
    from ._methods import restore_methods

    def getchildren(element: Any) -> list[Any]:
        return list(element)

    restore_methods(module.Element, {"getchildren": getchildren, "getiterator": module.Element.iter})


def _math(module: Any) -> None:
    real = module.factorial

    def factorial(x: Any) -> int:
        """Take 4.0 for 4."""
        return real(_whole(x))  # type: ignore[no-any-return]

    module.factorial = factorial


def _configparser(module: Any) -> None:
    if not hasattr(module, "SafeConfigParser"):
        module.SafeConfigParser = module.ConfigParser
        module.RawConfigParser.readfp = module.RawConfigParser.read_file


def _inspect(module: Any) -> None:
    from collections import namedtuple

    ArgSpec = namedtuple("ArgSpec", "args varargs keywords defaults")  # noqa: PYI024 - as it was

    def getargspec(func: Any) -> Any:
        return ArgSpec(*module.getfullargspec(func)[:4])

    vars(module).setdefault("getargspec", getargspec)


def _threading(module: Any) -> None:
    if not hasattr(module.Thread, "isAlive"):
        module.Thread.isAlive = module.Thread.is_alive


def _enum(module: Any) -> None:
    """Let a member that is a text or a number stand in an f-string by its value, and be its name elsewhere."""
    kind = module.Enum
    named = (kind.__str__, module.Flag.__str__)

    def formatted(self: Any, format_spec: str) -> Any:
        member_type = self._member_type_
        if member_type is object or type(self).__str__ not in named:
            return format(str(self), format_spec)
        return member_type.__format__(self._value_, format_spec)

    kind.__format__ = formatted
    for numbers in (module.IntEnum, module.IntFlag):
        numbers.__format__, numbers.__str__ = formatted, kind.__str__


def _traceback(module: Any) -> None:
    """Let the kind of an error be named, which needs no name since Python 3.10."""

    def with_etype(real: Callable[..., Any]) -> Callable[..., Any]:
        def function(*given: Any, **named: Any) -> Any:
            kind = (named.pop("etype"),) if "etype" in named else ()
            return real(*kind, *given, **named)

        return function

    for name in ("print_exception", "format_exception", "format_exception_only"):
        setattr(module, name, with_etype(getattr(module, name)))


def _pool(module: Any) -> None:
    """Let a pool of threads do without the locks of processes, which a match refuses."""
    import threading
    from multiprocessing.queues import SimpleQueue

    class OfThreads:
        Lock = staticmethod(threading.Lock)

        def SimpleQueue(self) -> Any:
            return SimpleQueue(ctx=self)

    def init(self: Any, processes: Any = None, initializer: Any = None, initargs: Any = ()) -> None:
        module.Pool.__init__(self, processes, initializer, initargs, context=OfThreads())

    module.ThreadPool.__init__ = init


def _fractions(module: Any) -> None:
    from math import gcd

    vars(module).setdefault("gcd", gcd)


def _base64(module: Any) -> None:
    vars(module).setdefault("encodestring", module.encodebytes)
    vars(module).setdefault("decodestring", module.decodebytes)


PATCHES: dict[str, Patch] = {
    "collections": _collections,
    "array": _array,
    "math": _math,
    "xml.etree.ElementTree": _elements,
    "random": _random,
    "dataclasses": _dataclasses,
    "json": _json,
    "asyncio": _asyncio,
    "configparser": _configparser,
    "inspect": _inspect,
    "threading": _threading,
    "enum": _enum,
    "traceback": _traceback,
    "multiprocessing.pool": _pool,
    "fractions": _fractions,
    "base64": _base64,
}
"""By module: what to do when a program has imported it."""
