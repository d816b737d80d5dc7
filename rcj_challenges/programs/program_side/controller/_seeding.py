"""Repeatable randomness: ``random`` and ``numpy.random`` are seeded by the match instead of the system."""

from __future__ import annotations

from ._hooks import Unbound

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable
    from typing import Any

_MASK = 2**64 - 1


class Seeds:
    """An endless sequence of 64-bit seeds, derived from one.

    SplitMix64 (Steele, Lea, Flood 2014): small enough to need no import.
    """

    def __init__(self, seed: int) -> None:
        self._state = seed & _MASK

    def draw(self) -> int:
        """Return the next seed."""
        self._state = (self._state + 0x9E3779B97F4A7C15) & _MASK
        mixed = self._state
        mixed = ((mixed ^ (mixed >> 30)) * 0xBF58476D1CE4E5B9) & _MASK
        mixed = ((mixed ^ (mixed >> 27)) * 0x94D049BB133111EB) & _MASK
        return mixed ^ (mixed >> 31)

    def bits(self, count: int) -> int:
        """Return ``count`` random bits, as ``secrets.randbits`` does."""
        drawn = 0
        for _ in range(-(-count // 64)):
            drawn = (drawn << 64) | self.draw()
        return drawn & ((1 << count) - 1)


def seed_random(seeds: Seeds) -> Callable[[Any], None]:
    """Return a patch: the module ``random`` draws its seeds, where none is given, from ``seeds``."""

    def patch(module: Any) -> None:
        real_seed = module.Random.seed

        def seed(self: Any, a: Any = None, version: int = 2) -> None:
            real_seed(self, seeds.draw() if a is None else a, version)

        module.Random.seed = seed
        module.seed = module._inst.seed  # noqa: SLF001 - `random.seed` is this method, bound when it was imported
        module.seed()

    return patch


def seed_numpy_entropy(seeds: Seeds) -> Callable[[Any], None]:
    """Return a patch: ``numpy.random.bit_generator``, where all unseeded generators of numpy ask, uses ``seeds``."""

    def patch(module: Any) -> None:
        module.randbits = seeds.bits

    return patch


def seed_numpy_global(seeds: Seeds) -> Callable[[Any], None]:
    """Return a patch: ``numpy.random.seed()`` without argument draws from ``seeds``."""

    def patch(module: Any) -> None:
        real_seed = module.seed

        def seed(seed: Any = None) -> None:
            real_seed(seeds.draw() & 0xFFFFFFFF if seed is None else seed)

        module.seed = Unbound(seed, "seed")
        module.seed()

    return patch
