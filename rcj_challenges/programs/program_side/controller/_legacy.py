"""What Python 3.8, numpy 1.19 to 1.24 and scipy 1.5 to 1.10 had: programs of 2021 to 2023 were written for them."""

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
    seed, sample, randrange, randint = kind.seed, kind.sample, kind.randrange, kind.randint

    def seeded(self: Any, a: Any = None, version: int = 2) -> None:
        """Take whatever has a hash: a moment, a tuple. Those of the match's programs are the same in every run."""
        is_known = a is None or isinstance(a, (int, float, str, bytes, bytearray))
        seed(self, a if is_known else hash(a) % 2**64, version)

    def sampled(self: Any, population: Any, k: int, **more: Any) -> Any:
        return sample(self, tuple(population) if isinstance(population, AbstractSet) else population, k, **more)

    def drawn_of_range(self: Any, start: Any, stop: Any = None, step: Any = 1) -> Any:
        return randrange(self, _whole(start), _whole(stop), _whole(step))

    def drawn_between(self: Any, a: Any, b: Any) -> Any:
        """Take 4.0 for 4; since Python 3.14 this does not call `randrange` any more."""
        return randint(self, _whole(a), _whole(b))

    kind.seed, kind.sample, kind.randrange, kind.randint = seeded, sampled, drawn_of_range, drawn_between
    for name in ("seed", "sample", "randrange", "randint"):
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
    # It said nothing since Python 3.1, and was an error from 3.9 on.
    module.JSONDecoder.__init__ = _ignoring("encoding", module.JSONDecoder.__init__)


def _asyncio(module: Any) -> None:
    """Bring back coroutines of generators, ``loop=``, and the main thread's loop, which ended with Python 3.14."""
    import inspect
    import threading
    import types
    from functools import wraps

    present, real_wait = module.get_event_loop, module.wait

    def coroutine(func: Any) -> Any:
        if inspect.iscoroutinefunction(func):
            return func
        real = types.coroutine(func)

        @wraps(func)
        async def coro(*given: Any, **named: Any) -> Any:
            made = real(*given, **named)
            return await made if inspect.isawaitable(made) else made

        return coro

    def get_event_loop() -> Any:
        try:
            return present()
        except RuntimeError:
            if threading.current_thread() is not threading.main_thread():
                raise
            module.set_event_loop(module.new_event_loop())
            return present()

    async def wait(fs: Any, **named: Any) -> Any:
        """Wait for coroutines too, not for tasks alone."""
        return await real_wait({module.ensure_future(one) for one in set(fs)}, **named)

    vars(module).setdefault("coroutine", coroutine)
    module.get_event_loop, module.wait = get_event_loop, wait
    for name in ("sleep", "gather", "wait", "wait_for", "shield", "as_completed"):
        setattr(module, name, _ignoring("loop", getattr(module, name)))
    for name in ("Lock", "Event", "Condition", "Semaphore", "BoundedSemaphore", "Queue"):
        kind = getattr(module, name)
        kind.__init__ = _ignoring("loop", kind.__init__)


def _ignoring(name: str, real: Callable[..., Any]) -> Callable[..., Any]:
    """Return a function that takes an argument of this name too, which has no effect."""
    from functools import wraps

    @wraps(real)
    def function(*given: Any, **named: Any) -> Any:
        named.pop(name, None)
        return real(*given, **named)

    return function


def _inspect(module: Any) -> None:
    from collections import namedtuple

    ArgSpec = namedtuple("ArgSpec", "args varargs keywords defaults")  # noqa: PYI024 - as it was

    def getargspec(func: Any) -> Any:
        return ArgSpec(*module.getfullargspec(func)[:4])

    vars(module).setdefault("getargspec", getargspec)


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


def _aliases(**names: str) -> Patch:
    """Return a patch that gives a module or its classes attributes under their old names: ``Thread__isAlive``."""

    def patch(module: Any) -> None:
        for old, new in names.items():
            kind, _, name = old.rpartition("__")
            place = getattr(module, kind) if kind else module
            if not hasattr(place, name):
                setattr(place, name, getattr(place, new))

    return patch


def _of_numpy(name: str) -> Patch:
    """Return a patch of `_legacy_numpy`, which is imported when a program imports numpy or scipy: most do not."""

    def patch(module: Any) -> None:
        from . import _legacy_numpy

        getattr(_legacy_numpy, name)(module)

    return patch


PATCHES: dict[str, Patch] = {
    "collections": _collections,
    "random": _random,
    "dataclasses": _dataclasses,
    "json": _json,
    "asyncio": _asyncio,
    "inspect": _inspect,
    "enum": _enum,
    "traceback": _traceback,
    "multiprocessing.pool": _pool,
    "threading": _aliases(Thread__isAlive="is_alive"),
    "configparser": _aliases(SafeConfigParser="ConfigParser", RawConfigParser__readfp="read_file"),
    "base64": _aliases(encodestring="encodebytes", decodestring="decodebytes"),
    "numpy": _of_numpy("patch_numpy"),
    "scipy": _of_numpy("patch_scipy"),
    "scipy.integrate": _of_numpy("patch_integrate"),
    "scipy.interpolate": _of_numpy("patch_interpolate"),
    "scipy.misc": _of_numpy("patch_misc"),
    "scipy.stats": _of_numpy("patch_stats"),
}
"""By module: what to do when a program has imported it."""
