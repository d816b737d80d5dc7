"""Warnings about valid scenarios that are probably mistakes: a class per check, `registry` runs them.

Belongs here: the warnings of `rcj-challenge validate`. Does not belong here: errors (`checks`), and what only playing
the scenario's tests can show (`rcj-challenge test` lists the rules that no test fires).
"""
