"""Codes about the site."""

from rcj_challenges.core.code import Code

# fmt: off
SITE_EXTRA = Code("site-extra", page="""
The commands `site` need Django and other libraries, which are not installed with a plain `pip install`.
Install them with `pip install "rcj-challenges[web]"`.""")
NO_FILE = Code("no-file", page="""
No archive came with the request.
Choose a ZIP, or send it as the body.""")
NO_SEASON = Code("no-season", page="""
No season is open, so nothing can be handed in.
Wait until the organizers announce one.""")
NO_TEAM = Code("no-team", page="""
The team has been deleted, so it can hand in nothing.
Ask its mentor.""")
NOT_FOR_TWO = Code("not-for-two", page="""
A ladder is played by two teams against each other, `blue` and `yellow`. The season has another scenario.
Choose a scenario such as `match` for it.""")
NOT_OPEN = Code("not-open", page="""
The season does not take uploads yet.
The message says when it does.""")
NOT_STORED = Code("not-stored", page="""
The archive may not have been stored, because the disk or the database of the site failed.
Look at the list of your submissions, and hand it in again if it is not there.""")
TOO_MUCH = Code("too-much", page="""
The team has handed in as many bytes as a day allows.
Hand in again tomorrow.""")
TOO_OFTEN = Code("too-often", page="""
The team has handed in as often as an hour or a day allows.
Hand in again later.""")
SITE_EXISTS = Code("site-exists", page="""
`site init` makes a new folder, and never changes one that holds a site.
Choose another name, or start the site that is there with `rcj-challenge site serve FOLDER`.""")
NOT_A_SITE = Code("not-a-site", page="""
The folder has no `site.yaml`, so it is not the folder of a site.
Give the folder that `rcj-challenge site init` made.""")
BAD_SITE_FILE = Code("bad-site-file", page="""
`site.yaml` has a key that is unknown, or a value that cannot be used. The message names the key.
Correct it; `docs/site.md` lists the keys.""")
SITE_DATABASE = Code("site-database", page="""
The database cannot be opened, or is not up to date.
Check `database` in `site.yaml`, and run `rcj-challenge site migrate FOLDER`.""")
SITE_ISOLATION = Code("site-isolation", page="""
A site runs programs of strangers, so its dispatcher starts only where they can be isolated strictly.
Run it on Linux with Landlock and seccomp (`docs/isolation.md`).
If you know all teams, `site serve FOLDER --trust-all-teams` starts it without.""")
BAD_RESULTS = Code("bad-results", page="""
`site rate` reads the results of a season as a site publishes them, at `/api/v1/seasons/N/results`.
Give that address, or a file with what it answers.""")
TABLE_DIFFERS = Code("table-differs", page="""
The published table is not the one that follows from the published matches: one of the two was changed.
Ask the organizers. `site rate` without `--check` prints the table that follows.""")
SEEDS_DIFFER = Code("seeds-differ", page="""
The seeds of a season follow from its secret, whose hash was published at its start. Those published do not.
Ask the organizers.""")
NO_LADDER = Code("no-ladder", page="""
The season does not exist, or its ladder has not begun.
Take the number from the page of the ladder.""")
BACKUP_DATABASE = Code("backup-database", page="""
`site backup` copies the SQLite database of a site. The database of this site is a server of PostgreSQL.
Make its backup with `pg_dump`, and copy the folder of the site after it.""")
EVENT_CHANGED = Code("event-changed", page="""
The hashes of what plays in an event were published. An archive in its folder `frozen` is another one now.
Copy it from a backup.""")
SITE_PROBLEMS = Code("site-problems", page="""
`site doctor` has found archives or scenarios that are missing or damaged, or jobs that are stuck.
Copy what is missing from a backup. Jobs can be tried again on the desk.""")
