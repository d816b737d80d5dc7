"""Whether a submission will play: the tournament's own steps, told in words that a pupil understands."""
