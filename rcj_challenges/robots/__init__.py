"""The devices of all robots in one half: fitted, read, commanded, and connected by radio.

Belongs here: which devices each robot has (`fitting`), the manager that serves them tick by tick (`manager`), and radio
(`radio_hub`, `channels`). Does not belong here: what one kind of device measures or does (devices), how
readings reach a program's process (programs), when a program is due (match).
"""
