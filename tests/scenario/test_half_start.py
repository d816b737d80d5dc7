"""What rules do as a half starts: one that leaves the phase keeps those after it from firing, and from what they set."""

from __future__ import annotations

START = "{trigger: half_started}"
INTRO = "phases: {intro: {lasts_s: 1, next: play}}"
ENTER = "{action: set_phase, phase: intro}"
