"""What is written over the picture: names, score, clock, half, and what the referee says."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

from PIL import Image, ImageDraw

from rcj_challenges.facts.measures import number_words
from rcj_challenges.views.sentences import clock, plain
from rcj_challenges.views.video.colours import BOARD, CALL, EDGE, FAINT, FAULT, WHITE, Rgb, mixed, rgb, text_on
from rcj_challenges.views.video.footage import Footage
from rcj_challenges.views.video.lettering import Lettering, line_height
from rcj_challenges.views.video.timeline import Moment

CAPTION_S = 3.0
"""How long a caption stands, in s of the video: as long as it takes to read one line."""
MOST_CAPTIONS = 3


def board_height(size: tuple[int, int]) -> int:
    """Return how much of the top of a picture the board takes."""
    return max(24, round(min(size[1] * 0.085, size[0] * 0.075)))


class Board:
    """Writes over pictures of one size. What stays the same from frame to frame is drawn once."""

    def __init__(self, footage: Footage, size: tuple[int, int], lettering: Lettering) -> None:
        self._footage, self._size, self._lettering = footage, size, lettering
        self.height = board_height(size)
        self._text_px = round(self.height * 0.46)
        self._small_px = max(8, round(self.height * 0.34))
        self._caption_px = max(9, round(self.height * 0.40))
        self._gap = round(self.height * 0.3)
        self._strip = lru_cache(maxsize=8)(self._draw_strip)
        self._captions: dict[int, Image.Image] = {}

    def write(self, frame: Image.Image, moment: Moment) -> None:
        """Write over the picture of a moment."""
        half, t_s = moment.half, moment.t_s
        scores = self._footage.scores(half, t_s)
        frame.paste(self._strip(half.info.half, tuple(scores.items()), moment.speed), (0, 0))
        time = self._lettering.mask(clock(t_s), self._text_px, bold=True)
        frame.paste(WHITE, (self._gap, self._line_top(self._text_px)), time)
        self._write_captions(frame, moment)
        top = self.height + self._gap
        for line in filter(None, (moment.title, *self._footage.counted(half, t_s))):
            top = self._write_line(frame, line, top)

    def _line_top(self, size: int) -> int:
        # Capitals are about 0.72 of the size tall: they are centred in the strip.
        return round(self.height / 2 - size * 0.64)

    def _draw_strip(self, half: int, scores: tuple[tuple[str, float], ...], speed: float) -> Image.Image:
        strip = Image.new("RGB", (self._size[0], self.height), BOARD)
        write, small = self._lettering, self._small_px
        info = self._footage.half(half).info
        told = [f"half {half} of {info.halves}"] if info.halves > 1 else []
        told += [f"{speed:g} x"] if speed != 1 else []
        side = write.width("00:00.0", self._text_px, bold=True) + 2 * self._gap
        if told:
            mask = write.mask("  ".join(told), small)
            side = max(side, mask.width + 2 * self._gap)
            strip.paste(FAINT, (strip.width - mask.width - self._gap, self._line_top(small)), mask)
        room = strip.width - 2 * side
        if len(scores) == 2:
            self._draw_pair(strip, half, scores, room)
        else:
            self._draw_list(strip, half, scores, room)
        return strip

    def _draw_pair(self, strip: Image.Image, half: int, scores: tuple[tuple[str, float], ...], room: int) -> None:
        (left, left_score), (right, right_score) = scores
        middle = strip.width // 2
        between = f"{number_words(left_score)} : {number_words(right_score)}" if self._footage.shows_score else ":"
        points = self._lettering.mask(between, self._text_px, bold=True)
        strip.paste(WHITE, (middle - points.width // 2, self._line_top(self._text_px)), points)
        chip, inner = round(self.height * 0.36), middle - points.width // 2 - self._gap
        widest = room // 2 - (middle - inner) - chip - self._gap
        for team, way in ((left, -1), (right, 1)):
            name = self._name(team, widest)
            near = inner if way < 0 else strip.width - inner
            strip.paste(WHITE, (near - name.width if way < 0 else near, self._line_top(self._text_px)), name)
            far = near + way * (name.width + self._gap // 2)
            self._chip(strip, far - chip if way < 0 else far, chip, half, team)

    def _draw_list(self, strip: Image.Image, half: int, scores: tuple[tuple[str, float], ...], room: int) -> None:
        """Draw one team, or three and more, side by side."""
        chip = round(self.height * 0.36)
        each = room // max(len(scores), 1)
        pieces = []
        for team, score in scores:
            points = self._lettering.mask(
                number_words(score) if self._footage.shows_score else "", self._text_px, bold=True
            )
            name = self._name(team, each - chip - points.width - 3 * self._gap)
            pieces.append((team, name, points, chip + name.width + points.width + 2 * self._gap))
        x = (strip.width - sum(width for *_, width in pieces)) // 2
        for team, name, points, width in pieces:
            self._chip(strip, x, chip, half, team)
            at = x + chip + self._gap // 2
            strip.paste(WHITE, (at, self._line_top(self._text_px)), name)
            strip.paste(WHITE, (at + name.width + self._gap // 2, self._line_top(self._text_px)), points)
            x += width

    def _name(self, team: str, widest: int) -> Image.Image:
        text = self._lettering.fitted(self._footage.titles[team], self._text_px, max(widest, 0))
        return self._lettering.mask(text, self._text_px)

    def _chip(self, strip: Image.Image, x: int, edge: int, half: int, team: str) -> None:
        colour = rgb(self._footage.colour_of(self._footage.half(half), team))
        y = (self.height - edge) // 2
        ImageDraw.Draw(strip).rounded_rectangle((x, y, x + edge, y + edge), edge // 4, fill=colour)
        letter = self._lettering.mask(self._footage.letter_of(self._footage.half(half), team), edge * 3 // 4, bold=True)
        strip.paste(text_on(colour), (x + (edge - letter.width + 1) // 2, y + (edge - letter.height + 1) // 2), letter)

    def _write_captions(self, frame: Image.Image, moment: Moment) -> None:
        recent = self._footage.recent_events(moment.half, moment.t_s, CAPTION_S * moment.speed, MOST_CAPTIONS)
        bottom = frame.height - self._gap
        for event in reversed(recent):
            caption = self._caption(event)
            bottom -= caption.height
            if bottom < self.height:
                break
            frame.paste(caption, ((frame.width - caption.width) // 2, bottom), caption)
            bottom -= self._gap // 3

    def _caption(self, event: dict[str, Any]) -> Image.Image:
        """Return an event as a box of text; a change of the score is larger and in the team's colour.

        Points that are lost are in that colour at the edge only.
        """
        key = id(event)
        if key not in self._captions:
            if len(self._captions) > 64:
                self._captions.clear()
            self._captions[key] = self._draw_caption(event)
        return self._captions[key]

    def _draw_caption(self, event: dict[str, Any]) -> Image.Image:
        gained, scored = event["kind"] == "goal", event["kind"] in ("goal", "loss")
        colour: Rgb = FAULT if event["kind"] == "fault" else CALL
        if scored:
            colour = rgb(str(event["colour"] or "#f59f00"))
        size = round(self._caption_px * (1.2 if scored else 1.0))
        head = str(event["name"]).replace("_", " ") + (f"   {event['standing']}" if event["standing"] else "")
        text = " · ".join(filter(None, (str(event["about"]), str(event["told"]))))
        return self._box(head, text, colour if gained else BOARD, colour, size)

    def _box(self, head: str, text: str, ground: Rgb, mark: Rgb, size: int) -> Image.Image:
        """Return a box with a heading and a text: beside it if there is room, else below it."""
        write = self._lettering
        pad, widest = round(size * 0.6), self._size[0] - 2 * self._gap
        first = write.mask(write.fitted(head, size, widest - 3 * pad, bold=True), size, bold=True)
        room = widest - 4 * pad - first.width
        below = bool(text) and write.width(plain(text), size) > room
        rest = write.fitted(text, size, widest - 3 * pad if below else room)
        second = write.mask(rest, size) if rest else None
        width, height = first.width + 3 * pad, round(size * 1.75)
        if second is not None:
            width = max(width, second.width + 3 * pad) if below else width + second.width + pad
        box = Image.new("RGBA", (width, round(size * 3.1) if below else height), (*ground, 0))
        pen = ImageDraw.Draw(box)
        pen.rounded_rectangle((0, 0, width - 1, box.height - 1), size // 4, fill=(*ground, 232))
        pen.rounded_rectangle((0, 0, pad // 2, box.height - 1), size // 4, fill=(*mark, 255))
        ink = text_on(ground)
        left, top = round(1.5 * pad), round(height / 2 - size * 0.64)
        box.paste((*ink, 255), (left, top), first)
        if second is not None:
            place = (left, round(top + size * 1.35)) if below else (left + first.width + pad, top)
            box.paste((*mixed(ink, ground, 0.15), 255), place, second)
        return box

    def _write_line(self, frame: Image.Image, line: str, top: int) -> int:
        """Write a line on the left, under the board; returns where the next one begins."""
        size = self._small_px
        pad = round(size * 0.5)
        text = self._lettering.fitted(line, size, round(frame.width * 0.6))
        mask = self._lettering.mask(text, size, bold=True)
        box = Image.new("RGBA", (mask.width + 2 * pad, line_height(size) + pad), (*EDGE, 200))
        frame.paste(box, (self._gap, top), box)
        frame.paste(WHITE, (self._gap + pad, top + pad // 2 + round(size * 0.05)), mask)
        return top + box.height + self._gap // 4
