"""What a team hands in: a folder, a ZIP or one program, read without trusting any of it.

Belongs here: archives, the paths in them, the team's name, which program drives which robot, and what is wrong with any
of these. Does not belong here: running a program (programs), what a check makes of the problems (checker).
"""
