"""The drawing of a scenario: field, walls, zones, gates, spots, start poses and placement areas as SVG.

Belongs here: shapes on paper, made of the same numbers that the referee tests. Does not belong here: anything that
moves, and anything that needs a display.
"""

from rcj_challenges.views.drawing.field import draw_scenario

__all__ = ["draw_scenario"]
