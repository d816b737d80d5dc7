"""What a message of a robot must be."""

from collections.abc import Callable, Mapping
from typing import Annotated, Literal

from pydantic import Field, StringConstraints

from rcj_challenges.core.messages import MAX_CHARACTERS, READS, matches_text
from rcj_challenges.rules.fields import Name, Scalar, Strict, described
from rcj_challenges.rules.phrases import Phrases
from rcj_challenges.rules.phrasing import listed, number, what_drawn
from rcj_challenges.rules.refs import DRAW

SaidText = Annotated[
    str,
    StringConstraints(min_length=1, max_length=MAX_CHARACTERS, pattern=r"^[^\s]+( [^\s]+)*$"),
    Field(description="text as a robot says it, with single blanks between its words"),
]
Said = SaidText | int | float
"""What a robot may say."""


class SaidDraw(Strict):
    """What a draw decided."""

    draw: Annotated[Name, DRAW] = described(..., "a draw")


class Message(Strict):
    """What a message of a robot must be."""

    text: Said | Annotated[tuple[Said, ...], Field(min_length=1)] | SaidDraw | None = described(
        None,
        "required content: text, a number, one of a list, or {draw: NAME} for the drawn value; surrounding "
        "spaces are ignored; if omitted: anything",
    )
    is_a: Literal["number", "position"] | None = described(
        None,
        "number: it must be one number; position: it must be two numbers, x and y in m, at most "
        "10 m from the centre along each axis; if "
        "omitted: anything",
    )

    def matcher(self, draws: Mapping[str, Scalar]) -> Callable[[str], bool]:
        """Return a function that decides whether a message is as it must be; draws are read when it comes."""
        text, parse = self.text, READS[self.is_a]

        def wanted() -> tuple[Scalar, ...]:
            if isinstance(text, SaidDraw):
                return (draws[text.draw],)
            return text if isinstance(text, tuple) else (text,) if text is not None else ()

        def matches(message: str) -> bool:
            if parse(message) is None:
                return False
            return text is None or any(matches_text(message, one) for one in wanted())

        return matches

    def said(self, phrases: Phrases) -> str:
        """Return the required message in words: ``“FOUND”``, ``2``, ``a number``; empty if it may be anything."""
        if isinstance(self.text, SaidDraw):
            return what_drawn(self.text.draw)
        if self.text is not None:
            wanted = self.text if isinstance(self.text, tuple) else (self.text,)
            return listed([number(one) if isinstance(one, int | float) else f"“{one}”" for one in wanted], "or")
        return {None: "", "number": "a number", "position": "a position (two numbers, x and y in m)"}[self.is_a]
