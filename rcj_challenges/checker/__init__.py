"""Checks whether a submission will play, by the tournament's own steps, and reports it in words a pupil understands.

Belongs here: the stages of ``check`` (`archives`, `layout`, `identity`, `sources`, `starting`, `playing`), what to do
about programs that fail (`advice`), repairs (`repair`), and the report as text, HTML and data.
Does not belong here: opening a team's files (submissions), playing (match), options and exit codes (cli).
"""
