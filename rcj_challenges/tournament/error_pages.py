"""The pages of the codes about tournaments: files, submissions, data, rulings and the site."""

from __future__ import annotations

_TEXT = """
unknown-stage
There is no stage with this name.
Options such as --premiere take the names of stages in the file.

unknown-scenario
There is no scenario file at this path, and no shipped scenario with this name.
Paths are relative to the tournament file. `rcj-challenge validate NAME` checks whether a name is one of them.

wrong-scenario
A scenario that the tournament plays has mistakes, or a setting in 'set' does not fit it.
`rcj-challenge validate SCENARIO` shows all mistakes of a scenario.

wrong-seats
A scenario does not have the number of seats that this stage needs.
Stages of matches need scenarios for two, challenges scenarios for one. Super teams need sides with the same
number of robots.

teams-folder
The folder of the submissions cannot be used as it is.
It cannot be read, most of it has nothing to do with teams, or it has pipes, devices or links that lead out of it.
Create it next to the tournament file, and put one ZIP for each team into it.

same-team-id
Two teams have ids that are the same, or differ only in upper and lower case.
A team's id is the name of its ZIP without accents and special characters. Rename one of the files, or give it
another id under 'teams' with path.

same-name
Two stages, or two challenges of a stage, have names that differ only in upper and lower case.
Their pages would be one file on Windows and macOS. Give one of them another name; 'title' sets what is shown.

no-submission
The file names a team that has no submission.
Give path or sample, or put a ZIP with the team's id as its name into teams_folder.

two-sources
A team has both a path and a sample.
Keep one of them.

unknown-sample
There is no sample team with this name.
`rcj-challenge teams` lists them.

unknown-team
No team of this tournament has this id, or the team does not play in this match.
`rcj-challenge tournament plan FILE` lists the matches with their teams.

too-few-teams
A stage gets fewer teams than it needs.
A stage of matches needs two teams, each group two, and a match for third place four. Take more places from
the stage before, or remove the stage.

listed-teams
The lists of groups or super teams do not fit the teams.
Each team must be in one group; a super team has one team for each robot of a side.

too-many-rounds
A Swiss stage has more rounds than a team has opponents.
Use fewer rounds than teams, or a round_robin, in which all teams meet.

rematch-possible
A Swiss stage has so many rounds that two teams may have to meet twice.
With at most half as many rounds as teams, rounded up, no rematch is needed.

useless-tie-break
A tie-break cannot decide anything.
List each tie-break once, and lot last.

unknown-time-zone
There is no such time zone.
Write it as Europe/Berlin or UTC.

wrong-time
A time does not exist, is not of the form 2021-06-22 18:00, or is before that of the previous round.
Times are those of time_zone; when the clock is put forward in spring, an hour is missing. Write them in the order of
the rounds.

ambiguous-time
A warning: the clock is put back in this night, and shows this time twice.
The first of the two is used. Take a time outside of that hour, or set time_zone: UTC and write all times in UTC.

wrong-release
The number of times does not fit the number of rounds.
Give one time for the whole stage, or one for each round.

no-source
A stage names places, but no stage to take them from.
Add from, or remove places.

unreachable-stage
A stage takes its teams from one that is not played before it, or does not rank teams.
Stages are played in the order of the file. A stage of super teams ranks super teams, so no other stage can take teams from it.

wrong-places
The first place comes after the last one.
Write them as 1-4.

legs-and-best-of
A knock-out has both legs, whose scores are added up, and best_of, which counts wins.
Keep one of them.

undecided-places
Teams may tie for a place that decides which of them advances.
Add lot at the end of tie_breaks, or set play_off: true in the stage before.

submission-unreadable
The submission of a team cannot be read: it is not a ZIP, damaged, too large, or missing.
Let the team replace it, or take the team out: tournament decide FILE --withdraw TEAM --reason TEXT.

submission-fails
A submission does not pass the check, so nothing is played.
The message names the report for the team, in checks/TEAM of the data folder. Let the team replace its submission, or play it as
it is with --accept TEAM.

submission-unchecked
A submission could not be checked; this is not the team's fault.
Run the command again.

submission-unusable
A submission has no programs for a match that its team has to play.
Let the team replace it, decide that match with tournament decide, or withdraw the team.

other-versions
Matches were played with other versions of this package, MuJoCo or numpy, or on another kind of machine.
Results of different versions cannot be compared. Install the earlier versions, or play the whole tournament
again into another folder with --data.

stage-closed
A changed submission, scenario or ruling would change a match that later matches were drawn from.
Undo the change; or give --cascade: then all that depends on it is played again.

drawn-before
Matches have been played, and since then the teams, their pots, groups, legs or the seed have changed.
Undo the change; or take late teams in with `tournament run FILE --add TEAM`; or draw again with
`tournament run FILE --redraw`, which keeps the matches of pairs that still exist.

added-too-late
All stages that a late team could play in have been drawn.
A team can be added to a round robin or challenges until they have finished, and to other stages until their first
match. Remove the team, or draw again with --redraw.

fewer-matches
The site that was published before shows more matches than the new one would.
`tournament status FILE` shows what counts now. If that is right, publish with --fewer.

cannot-go-on
This computer cannot continue: most often its disk is full.
Played matches are kept. Fix what the message says, and run the command again.

shared-without-cluster
--shared applies only to the workers of a cluster.
Give --cluster ADDRESS too.

cluster-missing
Dask is not installed.
Install it with pip install "rcj-challenges[cluster]".

cluster-unreachable
No Dask scheduler answers at this address.
Start one with `dask scheduler`, and give the address that it prints.

cluster-no-workers
The cluster has no workers.
Start one on each computer: dask worker ADDRESS --nthreads 2.

cluster-worker-unfit
A worker has other versions than this computer, or does not see the shared folder.
Install the same versions there, or end the worker; with --shared the folder must have the same path.

cluster-lost
The connection to the scheduler was lost.
Start the scheduler and its workers, and run the command again: it continues where it stopped.

store-in-use
Another command writes to the data of this tournament.
Wait until it has ended, or end it. status and results can be used meanwhile.

store-damaged
The file store.sqlite is damaged, or it is empty although there are records of matches.
Restore a copy of it, or move it away: run then plays all matches again, with the same results, but rulings are
lost.

store-unwritable
The data of the tournament cannot be written.
Free some space or allow writing, and run the command again.

store-version
The data was written by another version of this package.
Use that version, or give another folder with --data.

data-file-missing
A file of the tournament's data is missing or damaged.
Restore a copy, or delete it and run the tournament again.

no-trajectory
A record has no trajectory, so the referee cannot judge it again.
`rcj-challenge tournament rerun FILE` plays the matches again and keeps their trajectories; the results stay.

not-verifiable
A record is incomplete, or a program was debugged in the terminal during the match.
Verify another record.

programs-missing
The programs that played a match are not here.
Give their submission with --team PATH.

which-decision
A decision concerns one match, or a team that leaves.
Give MATCH with one of --forfeit TEAM, --replay, --score A:B and --undo; or --withdraw TEAM without MATCH, which
can have --undo too.

unknown-match
There is no match with this id, or its teams are not known yet.
`rcj-challenge tournament plan FILE` lists the matches.

not-played
This match has not been played yet.
`rcj-challenge tournament results FILE` lists the matches that have been played.

ruling-score
The score of a ruling does not fit the match.
Give a number for each side, such as 2:1, or one number for a match of a single team.

ruling-reason
A ruling needs a reason, which is published.
Give 1 to 500 characters with --reason.

ruling-annulled
A team of this match has left the tournament, so the match is decided or does not count.
If the team was withdrawn by mistake, take this back first: decide FILE --withdraw TEAM --undo --reason TEXT.

nothing-to-undo
No decision about this match or team holds: there was none, or it was taken back already.
`rcj-challenge tournament results FILE --json` lists all decisions.

withdrawn-twice
This team has left the tournament already.
There is nothing to do.

folder-in-the-way
A folder that would be replaced was not made by tournament publish.
Move it elsewhere, or give another data folder with --data.

site-unwritable
The site cannot be written.
Free some space or allow writing, and publish again. The previous site is still there.

no-release
A stage without a release time has no premiere.
Set release in the stage.
"""
"""By code: what it means, on one line, and then what to do about it."""


_BLOCKS = (block.split("\n", 2) for block in _TEXT.strip().split("\n\n"))
PAGES = {code: f"{meaning}\n\n{help_}" for code, meaning, help_ in _BLOCKS}
