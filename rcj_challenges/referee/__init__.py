"""The referee: compiles the rules of a scenario and judges snapshots by them.

Belongs here: what words need to be compiled (`binding`, `compiling`), the order of a tick (`engine`), placements
(`placement`) and the ranking. Does not belong here: the words themselves (`rules`), tests in scenario files (`expect`),
files, clocks, global random numbers, physics. The same snapshots give the same outputs on every machine.
"""
