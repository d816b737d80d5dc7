"""Writes over a picture: names, score, clock, half, and captions of the referee's events."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

from PIL import Image, ImageDraw

from rcj_challenges.core.amounts import number_words
from rcj_challenges.views.palette import PALETTE, Rgb, rgb, text_on
from rcj_challenges.views.sentences import clock
from rcj_challenges.views.standing import shows_score
from rcj_challenges.views.video.clips import Moment
from rcj_challenges.views.video.footage import Footage
from rcj_challenges.views.video.text import line_height_px, text_mask, text_width_px

CAPTION_S = 3.0
"""How long a caption is shown, in s of the video: time to read one line."""
BAR: Rgb = (17, 24, 39)
MUTED: Rgb = (156, 168, 186)
FAULT: Rgb = (220, 38, 38)
WHITE, WALL, DARK = (rgb(PALETTE[name]) for name in ("mark", "wall", "dark"))


def bar_height_px(size: tuple[int, int]) -> int:
    """Return the height of the scoreboard at the top of a picture."""
    return max(24, round(min(size[1] * 0.085, size[0] * 0.075)))


class Overlay:
    """Writes over pictures of one size. What many frames share is drawn once."""

    def __init__(self, footage: Footage, size: tuple[int, int]) -> None:
        self._footage, self._size = footage, size
        self.height = bar_height_px(size)
        self._text_px, self._small_px = round(self.height * 0.46), max(8, round(self.height * 0.34))
        self._gap = round(self.height * 0.3)
        self._bar = lru_cache(maxsize=8)(self._draw_bar)
        self._shown: tuple[Any, Image.Image] = (None, Image.new("RGBA", (1, 1)))

    def write(self, frame: Image.Image, moment: Moment) -> None:
        """Write over the picture of a moment."""
        half, t_s = moment.half, moment.t_s
        scores = self._footage.scores(half, t_s)
        frame.paste(self._bar(half.info.half, tuple(scores.items()), moment.speed), (0, 0))
        self._paste(frame, text_mask(clock(t_s), self._text_px, bold=True), self._gap, WHITE)
        if (event := self._footage.recent_event(half, t_s, CAPTION_S * moment.speed)) is not None:
            if self._shown[0] is not event:
                self._shown = event, self._draw_caption(event)
            box = self._shown[1]
            frame.paste(box, ((frame.width - box.width) // 2, frame.height - self._gap - box.height), box)
        top = self.height + self._gap
        for line in self._footage.counted(half, t_s):
            label = _box([(line, True)], self._small_px, DARK, DARK, 0.6 * frame.width)
            frame.paste(label, (self._gap, top), label)
            top += label.height + self._gap // 4

    def add_pictures(self, frame: Image.Image, moment: Moment, robot: str) -> None:
        """Show what the cameras of a robot took last, one below the other at the right edge."""
        top, width = self.height + self._gap, frame.width // 5
        for picture in self._footage.pictures(moment.half, robot, moment.t_s):
            shown = picture.resize((width, width * picture.height // picture.width), Image.Resampling.NEAREST)
            frame.paste(
                DARK,
                (frame.width - width - self._gap - 2, top - 2, frame.width - self._gap + 2, top + shown.height + 2),
            )
            frame.paste(shown, (frame.width - width - self._gap, top))
            top += shown.height + self._gap

    def _draw_bar(self, half: int, scores: tuple[tuple[str, float], ...], speed: float) -> Image.Image:
        bar = Image.new("RGB", (self._size[0], self.height), BAR)
        info = self._footage.half(half).info
        facts = [f"{self._footage.scenario.match.period} {half} of {info.halves}"] if info.halves > 1 else []
        facts += [f"{speed:g} x"] if speed != 1 else []
        side = text_mask("  ".join(facts), self._small_px)
        self._paste(bar, side, bar.width - side.width - self._gap, MUTED)
        edge = max(text_width_px("00:00.0", self._text_px, bold=True), side.width) + 2 * self._gap
        room = (bar.width - 2 * edge) / max(len(scores), 1)
        pieces: list[tuple[Image.Image, Rgb | None]] = []
        for place, (team, points) in enumerate(scores):
            number = number_words(points) if shows_score(self._footage.scenario) else ""
            own = [(text_mask(number, self._text_px, bold=True), WHITE)] if number else []
            chip = self._chip(half, team)
            name_px = room - chip.width - sum(mask.width for mask, _ in own) - 3 * self._gap
            name = text_mask(self._footage.titles[team], self._text_px, max_width_px=max(name_px, 0))
            row: list[tuple[Image.Image, Rgb | None]] = [(chip, None), (name, WHITE), *own]
            if len(scores) == 2 and place == 1:  # the second of two is mirrored: A 0 : 1 B
                pieces.append((text_mask(":", self._text_px, bold=True), WHITE))
                row.reverse()
            pieces += row
        gap = self._gap // 2
        left = (bar.width - sum(mask.width + gap for mask, _ in pieces) + gap) // 2
        for mask, colour in pieces:
            self._paste(bar, mask, left, colour)
            left += mask.width + gap
        return bar

    def _paste(self, image: Image.Image, mask: Image.Image, left: int, colour: Rgb | None) -> None:
        """Paste a picture, or a mask in a colour, vertically centred on the scoreboard."""
        top = (self.height - mask.height) // 2
        if colour is None:
            image.paste(mask, (left, top), mask)
        else:
            image.paste(colour, (left, top), mask)

    def _chip(self, half: int, team: str) -> Image.Image:
        seat = self._footage.seat_of(self._footage.half(half), team)
        edge, colour = round(self.height * 0.4), rgb(str(seat["colour"]))
        chip = Image.new("RGBA", (edge, edge))
        ImageDraw.Draw(chip).rounded_rectangle((0, 0, edge - 1, edge - 1), edge // 4, fill=colour)
        letter = text_mask(str(seat["letter"]), round(edge * 0.75), bold=True)
        chip.paste((*text_on(colour), 255), ((edge - letter.width) // 2, (edge - letter.height) // 2), letter)
        return chip

    def _draw_caption(self, event: dict[str, Any]) -> Image.Image:
        """Return an event as a box; points gained fill it with the team's colour, others mark its edge."""
        scored = event["kind"] in ("goal", "loss")
        colour = rgb(str(event["colour"] or "#f59f00")) if scored else FAULT if event["kind"] == "fault" else WALL
        head = "  ".join(
            filter(None, (event["name"].replace("_", " "), self._footage.titles.get(event["team"]), event["standing"]))
        )
        text = " · ".join(filter(None, (str(event["about"]), str(event["payload_text"]))))
        size_px = max(9, round(self.height * (0.46 if scored else 0.4)))
        ground = colour if event["kind"] == "goal" else BAR
        return _box([(head, True), (text, False)], size_px, ground, colour, self._size[0] - 2 * self._gap)


def _box(parts: list[tuple[str, bool]], size_px: int, ground: Rgb, mark: Rgb, max_width_px: float) -> Image.Image:
    """Return texts (and whether they are bold) in a box: side by side if there is room, else below each other."""
    pad = round(size_px * 0.6)
    room = max_width_px - 3 * pad
    masks = [text_mask(text, size_px, bold=bold, max_width_px=room) for text, bold in parts if text]
    full_px = sum(text_width_px(text, size_px, bold=bold) + pad for text, bold in parts) - pad
    beside = full_px <= room
    width = sum(mask.width + pad for mask in masks) - pad if beside else max(mask.width for mask in masks)
    height = line_height_px(size_px) * (1 if beside else len(masks)) + pad // 2
    box = Image.new("RGBA", (round(width) + 3 * pad, height))
    pen = ImageDraw.Draw(box)
    pen.rounded_rectangle((0, 0, box.width - 1, height - 1), size_px // 4, fill=(*ground, 232))
    pen.rounded_rectangle((0, 0, pad // 2, height - 1), size_px // 4, fill=(*mark, 255))
    left, top = round(1.5 * pad), pad // 4
    for mask in masks:
        box.paste((*text_on(ground), 255), (left, top), mask)
        left, top = (left + mask.width + pad, top) if beside else (left, top + mask.height)
    return box
