"""Changes to modules of the standard library and of numpy, made when the program imports them, not before."""

from __future__ import annotations

import sys

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from types import ModuleType
    from typing import Any

    Patch = Callable[[Any], None]


class Unbound:
    """A function that stays one when a class has it as an attribute, as those of the ``time`` module do.

    ``logging.Formatter`` keeps ``time.localtime`` that way: a plain function would be handed the formatter first.
    """

    def __init__(self, function: Callable[..., Any], name: str) -> None:
        self._function = function
        self.__name__ = name

    def __call__(self, *given: Any, **named: Any) -> Any:
        return self._function(*given, **named)


class _BuiltIn:
    """A loader of one module that is built into the interpreter: the system's is a class that loads all of them."""

    def __init__(self, kind: Any) -> None:
        self.create_module = kind.create_module
        self.exec_module = kind.exec_module


class AfterImport:
    """An import hook: runs a patch on a module right after its code has run.

    A file of the team that has the name of such a module is left alone. The package itself, which is in no folder that
    programs import from, is found here when it is reloaded (``importlib.reload``).
    """

    def __init__(self, patches: dict[str, Patch], team_root: str) -> None:
        self._patches = patches
        self._team_root = team_root
        self._ours = sys.modules[__package__].__spec__

    def install(self) -> None:
        """Patch what is imported already, and what will be."""
        for name in [name for name in self._patches if name in sys.modules]:
            self._patches.pop(name)(sys.modules[name])
        sys.meta_path.insert(0, self)

    def find_spec(self, name: str, path: Sequence[str] | None = None, target: ModuleType | None = None) -> Any:
        """Find a module as the other finders do; the import system calls this."""
        patch = self._patches.get(name)
        if patch is None:
            return self._ours if name == __package__ else None
        for finder in sys.meta_path:
            if finder is self:
                continue
            spec = finder.find_spec(name, path, target)
            if spec is not None:
                break
        else:
            return None
        if spec.loader is None or (spec.origin or "").startswith(self._team_root):
            return spec
        if isinstance(spec.loader, type):
            spec.loader = _BuiltIn(spec.loader)  # type: ignore[assignment]  # all that the import system asks of one
        loader: Any = spec.loader
        real = loader.exec_module

        def exec_module(module: ModuleType) -> None:
            real(module)
            patch(module)

        loader.exec_module = exec_module
        return spec
