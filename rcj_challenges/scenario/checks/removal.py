"""What to do about a place that names something which was removed from a base."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from rcj_challenges.scenario.tree import Entries, Mark, Path, mark_of


def of_removed(name: str, sections: Iterable[str], path: Path, root: Entries, removed: Mapping[Path, Mark]) -> str:
    """Return what to do about a place that names something removed from a base; empty: it was not removed.

    Args:
        name: what is named.
        sections: in which it may have been.
        path: the place.
        root: the finished tree.
        removed: where entries of a base were removed.
    """
    at = next((removed[section, name] for section in sections if (section, name) in removed), None)
    if at is None:
        return ""
    where = f"it was removed in {at.file}{f':{at.line}' if at.line else ''}; "
    if mark_of(root, path, at_key=True).file == mark_of(root, ("id",)).file:
        return f"{where}name another one, or take this line out"
    if path[-1] == name and not any(isinstance(step, int) for step in path):
        return f"{where}write '{name}: null' under {'.'.join(map(str, path[:-1]))} too"
    # Mappings are merged and lists are not.
    whole = path[: next((i for i, step in enumerate(path) if isinstance(step, int)), len(path))]
    is_named = path[0] not in ("kits", "robots", "entrants", "match", "result", "broadcast") and len(path) > 1
    instead = f", or '{path[1]}: null' under {path[0]}" if is_named else ""
    return f"{where}write {'.'.join(map(str, whole))} without it{instead}"
