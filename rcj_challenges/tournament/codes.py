"""Codes about tournaments: files, submissions, data, rulings and the site."""

from rcj_challenges.core.code import Code

# fmt: off
UNKNOWN_STAGE = Code("unknown-stage", page="""
There is no stage with this name.
Options such as --premiere take the names of stages in the file.""")
UNKNOWN_SCENARIO = Code("unknown-scenario", page="""
There is no scenario file at this path, and no shipped scenario with this name.
Paths are relative to the tournament file. `rcj-challenge validate NAME` checks whether a name is one of them.""")
WRONG_SCENARIO = Code("wrong-scenario", page="""
A scenario that the tournament plays has mistakes, or a setting in 'set' does not fit it.
`rcj-challenge validate SCENARIO` shows all mistakes of a scenario.""")
WRONG_SEATS = Code("wrong-seats", page="""
A scenario does not have the number of seats that this stage needs.
Stages of matches need scenarios for two, challenges scenarios for one. Super teams need sides with the same number
of robots.""")
TEAMS_FOLDER = Code("teams-folder", page="""
The folder of the submissions cannot be used as it is.
It cannot be read, most of it has nothing to do with teams, or it has pipes, devices or links that lead out of it.
Create it next to the tournament file, and put one ZIP for each team into it.""")
SAME_TEAM_ID = Code("same-team-id", page="""
Two teams have ids that are the same, or differ only in upper and lower case.
A team's id is the name of its ZIP without accents and special characters. Rename one of the files, or give it
another id under 'teams' with path.""")
SAME_NAME = Code("same-name", page="""
Two stages, or two challenges of a stage, have names that differ only in upper and lower case.
Their pages would be one file on Windows and macOS. Give one of them another name; 'title' sets what is shown.""")
NO_SUBMISSION = Code("no-submission", page="""
The file names a team that has no submission.
Give path or sample, or put a ZIP with the team's id as its name into teams_folder.""")
TWO_SOURCES = Code("two-sources", page="""
A team has both a path and a sample.
Keep one of them.""")
UNKNOWN_SAMPLE = Code("unknown-sample", page="""
There is no sample team with this name.
`rcj-challenge teams` lists them.""")
UNKNOWN_TEAM = Code("unknown-team", page="""
No team of this tournament has this id, or the team does not play in this match.
`rcj-challenge tournament plan FILE` lists the matches with their teams.""")
TOO_FEW_TEAMS = Code("too-few-teams", page="""
A stage gets fewer teams than it needs.
A stage of matches needs two teams, each group two, and a match for third place four. Take more places from the
stage before, or remove the stage.""")
LISTED_TEAMS = Code("listed-teams", page="""
The lists of groups or super teams do not fit the teams.
Each team must be in one group; a super team has one team for each robot of a side.""")
TOO_MANY_ROUNDS = Code("too-many-rounds", page="""
A Swiss stage has more rounds than a team has opponents.
Use fewer rounds than teams, or a round_robin, in which all teams meet.""")
REMATCH_POSSIBLE = Code("rematch-possible", level="warning", page="""
A Swiss stage has so many rounds that two teams may have to meet twice.
With at most half as many rounds as teams, rounded up, no rematch is needed.""")
USELESS_TIE_BREAK = Code("useless-tie-break", page="""
A tie-break cannot decide anything.
List each tie-break once, and lot last.""")
UNKNOWN_TIME_ZONE = Code("unknown-time-zone", page="""
There is no such time zone.
Write it as Europe/Berlin or UTC.""")
WRONG_TIME = Code("wrong-time", page="""
A time does not exist, is not of the form 2021-06-22 18:00, or is before that of the previous round.
Times are those of time_zone; when the clock is put forward in spring, an hour is missing. Write them in the order
of the rounds.""")
AMBIGUOUS_TIME = Code("ambiguous-time", level="warning", page="""
A warning: the clock is put back in this night, and shows this time twice.
The first of the two is used. Take a time outside of that hour, or set time_zone: UTC and write all times in UTC.""")
WRONG_RELEASE = Code("wrong-release", page="""
The number of times does not fit the number of rounds.
Give one time for the whole stage, or one for each round.""")
NO_SOURCE = Code("no-source", page="""
A stage names places, but no stage to take them from.
Add from, or remove places.""")
UNREACHABLE_STAGE = Code("unreachable-stage", page="""
A stage takes its teams from one that is not played before it, or does not rank teams.
Stages are played in the order of the file. A stage of super teams ranks super teams, so no other stage can take
teams from it.""")
WRONG_PLACES = Code("wrong-places", page="""
The first place comes after the last one.
Write them as 1-4.""")
LEGS_AND_BEST_OF = Code("legs-and-best-of", page="""
A knock-out has both legs, whose scores are added up, and best_of, which counts wins.
Keep one of them.""")
UNDECIDED_PLACES = Code("undecided-places", page="""
Teams may tie for a place that decides which of them advances.
Add lot at the end of tie_breaks, or set play_off: true in the stage before.""")
SUBMISSION_UNREADABLE = Code("submission-unreadable", page="""
The submission of a team cannot be read: it is not a ZIP, damaged, too large, or missing.
Let the team replace it, or take the team out: tournament decide FILE --withdraw TEAM --reason TEXT.""")
SUBMISSION_FAILS = Code("submission-fails", page="""
A submission does not pass the check, so nothing is played.
The message names the report for the team, in checks/TEAM of the data folder. Let the team replace its submission,
or play it as it is with --accept TEAM.""")
SUBMISSION_UNCHECKED = Code("submission-unchecked", page="""
A submission could not be checked; this is not the team's fault.
Run the command again.""")
SUBMISSION_UNUSABLE = Code("submission-unusable", page="""
A submission has no programs for a match that its team has to play.
Let the team replace it, decide that match with tournament decide, or withdraw the team.""")
OTHER_VERSIONS = Code("other-versions", page="""
Matches were played with other versions of this package, MuJoCo or numpy, or on another kind of machine.
Results of different versions cannot be compared. Install the earlier versions, or play the whole tournament again
into another folder with --data.""")
STAGE_CLOSED = Code("stage-closed", page="""
A changed submission, scenario or ruling would change a match that later matches were drawn from.
Undo the change; or give --cascade: then all that depends on it is played again.""")
DRAWN_BEFORE = Code("drawn-before", page="""
Matches have been played, and since then the teams, their pots, groups, legs or the seed have changed.
Undo the change; or take late teams in with `tournament run FILE --add TEAM`; or draw again with `tournament run
FILE --redraw`, which keeps the matches of pairs that still exist.""")
ADDED_TOO_LATE = Code("added-too-late", page="""
All stages that a late team could play in have been drawn.
A team can be added to a round robin or challenges until they have finished, and to other stages until their first
match. Remove the team, or draw again with --redraw.""")
FEWER_MATCHES = Code("fewer-matches", page="""
The site that was published before shows more matches than the new one would.
`tournament status FILE` shows what counts now. If that is right, publish with --fewer.""")
CANNOT_GO_ON = Code("cannot-go-on", page="""
This computer cannot continue: most often its disk is full.
Played matches are kept. Fix what the message says, and run the command again.""")
SHARED_WITHOUT_CLUSTER = Code("shared-without-cluster", page="""
--shared applies only to the workers of a cluster.
Give --cluster ADDRESS too.""")
CLUSTER_MISSING = Code("cluster-missing", page="""
Dask is not installed.
Install it with pip install "rcj-challenges[cluster]".""")
CLUSTER_UNREACHABLE = Code("cluster-unreachable", page="""
No Dask scheduler answers at this address.
Start one with `dask scheduler`, and give the address that it prints.""")
CLUSTER_NO_WORKERS = Code("cluster-no-workers", page="""
The cluster has no workers.
Start one on each computer: dask worker ADDRESS --nthreads 2.""")
CLUSTER_WORKER_UNFIT = Code("cluster-worker-unfit", page="""
A worker has other versions than this computer, or does not see the shared folder.
Install the same versions there, or end the worker; with --shared the folder must have the same path.""")
CLUSTER_LOST = Code("cluster-lost", page="""
The connection to the scheduler was lost.
Start the scheduler and its workers, and run the command again: it continues where it stopped.""")
STORE_IN_USE = Code("store-in-use", page="""
Another command writes to the data of this tournament.
Wait until it has ended, or end it. status and results can be used meanwhile.""")
STORE_DAMAGED = Code("store-damaged", page="""
The file store.sqlite is damaged, or it is empty although there are records of matches.
Restore a copy of it, or move it away: run then plays all matches again, with the same results, but rulings are
lost.""")
STORE_UNWRITABLE = Code("store-unwritable", page="""
The data of the tournament cannot be written.
Free some space or allow writing, and run the command again.""")
STORE_VERSION = Code("store-version", page="""
The data was written by another version of this package.
Use that version, or give another folder with --data.""")
DATA_FILE_MISSING = Code("data-file-missing", page="""
A file of the tournament's data is missing or damaged.
Restore a copy, or delete it and run the tournament again.""")
NO_TRAJECTORY = Code("no-trajectory", page="""
A record has no trajectory, so the referee cannot judge it again.
`rcj-challenge tournament rerun FILE` plays the matches again and keeps their trajectories; the results stay.""")
NOT_VERIFIABLE = Code("not-verifiable", page="""
A record is incomplete, or a program was debugged in the terminal during the match.
Verify another record.""")
PROGRAMS_MISSING = Code("programs-missing", page="""
The programs that played a match are not here.
Give their submission with --team PATH.""")
WHICH_DECISION = Code("which-decision", page="""
A decision concerns one match, or a team that leaves.
Give MATCH with one of --forfeit TEAM, --replay, --score A:B and --undo; or --withdraw TEAM without MATCH, which can
have --undo too.""")
UNKNOWN_MATCH = Code("unknown-match", page="""
There is no match with this id, or its teams are not known yet.
`rcj-challenge tournament plan FILE` lists the matches.""")
NOT_PLAYED = Code("not-played", page="""
This match has not been played yet.
`rcj-challenge tournament results FILE` lists the matches that have been played.""")
RULING_SCORE = Code("ruling-score", page="""
The score of a ruling does not fit the match.
Give a number for each side, such as 2:1, or one number for a match of a single team.""")
RULING_REASON = Code("ruling-reason", page="""
A ruling needs a reason, which is published.
Give 1 to 500 characters with --reason.""")
RULING_ANNULLED = Code("ruling-annulled", page="""
A team of this match has left the tournament, so the match is decided or does not count.
If the team was withdrawn by mistake, take this back first: decide FILE --withdraw TEAM --undo --reason TEXT.""")
NOTHING_TO_UNDO = Code("nothing-to-undo", page="""
No decision about this match or team holds: there was none, or it was taken back already.
`rcj-challenge tournament results FILE --json` lists all decisions.""")
WITHDRAWN_TWICE = Code("withdrawn-twice", page="""
This team has left the tournament already.
There is nothing to do.""")
FOLDER_IN_THE_WAY = Code("folder-in-the-way", page="""
A folder that would be replaced was not made by tournament publish.
Move it elsewhere, or give another data folder with --data.""")
SITE_UNWRITABLE = Code("site-unwritable", page="""
The site cannot be written.
Free some space or allow writing, and publish again. The previous site is still there.""")
NO_RELEASE = Code("no-release", page="""
A stage without a release time has no premiere.
Set release in the stage.""")
