"""Parts of sentences that several devices use on the rule sheet."""

from __future__ import annotations


def noise_words(*parts: str) -> str:
    """Return the noise of a device in brackets; empty if there is none."""
    stated = " and ".join(filter(None, parts))
    return f" (noise: standard deviation {stated})" if stated else ""


def percent_words(share: float, of: str) -> str:
    """Return a share of something: ``5 % of the value``; empty if it is 0."""
    return f"{100 * share:g} % of {of}" if share else ""


def order_words(frame: str, legacy: str) -> str:
    """Return the order in which numbers are given, where that is not the usual one."""
    return f"{legacy} as in the worlds of 2021" if frame == "legacy" else ""
