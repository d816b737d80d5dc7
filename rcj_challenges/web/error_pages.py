"""The pages of the codes of the site."""

from __future__ import annotations

PAGES: dict[str, str] = {
    "site-extra": (
        "The commands `site` need Django and other libraries, which are not installed with a plain `pip install`.\n\n"
        'Install them with `pip install "rcj-challenges[web]"`.'
    ),
    "no-file": "No archive came with the request.\n\nChoose a ZIP, or send it as the body.",
    "no-season": "No season is open, so nothing can be handed in.\n\nWait until the organizers announce one.",
    "no-team": "The team has been deleted, so it can hand in nothing.\n\nAsk its mentor.",
    "bad-results": (
        "`site rate` reads the results of a season as a site publishes them, at `/api/v1/seasons/N/results`.\n\n"
        "Give that address, or a file with what it answers."
    ),
    "table-differs": (
        "The table that was published is not the one that follows from the published matches: one of the two was "
        "changed.\n\nAsk the organizers. `site rate` without `--check` prints the table that follows."
    ),
    "seeds-differ": (
        "The seeds of a season follow from its secret, whose hash was published at its begin. Those that were published "
        "do not.\n\nAsk the organizers."
    ),
    "no-ladder": "The season does not exist, or its ladder has not begun.\n\nTake the number from the page of the ladder.",
    "not-for-two": (
        "A ladder is played by two teams against each other, `blue` and `yellow`. The season has another scenario.\n\n"
        "Choose a scenario such as `match` for it."
    ),
    "not-open": "The season does not take uploads yet.\n\nThe message says when it does.",
    "not-stored": (
        "The archive may not have been stored, because the disk or the database of the site failed.\n\nLook at the "
        "list of your submissions, and hand it in again if it is not there."
    ),
    "too-much": "The team has handed in as many bytes as a day allows.\n\nHand in again tomorrow.",
    "too-often": "The team has handed in as often as an hour or a day allows.\n\nHand in again later.",
    "site-exists": (
        "`site init` makes a new folder, and never changes one that holds a site.\n\n"
        "Choose another name, or start the site that is there with `rcj-challenge site serve FOLDER`."
    ),
    "not-a-site": (
        "The folder has no `site.yaml`, so it is not the folder of a site.\n\n"
        "Give the folder that `rcj-challenge site init` made."
    ),
    "bad-site-file": (
        "`site.yaml` has a key that is unknown, or a value that cannot be used. The message names the key.\n\n"
        "Correct it; `docs/site.md` lists the keys."
    ),
    "site-database": (
        "The database cannot be opened, or is not up to date.\n\n"
        "Check `database` in `site.yaml`, and run `rcj-challenge site migrate FOLDER`."
    ),
    "site-isolation": (
        "A site runs programs of strangers, so its dispatcher starts only where programs can be isolated strictly "
        "(`docs/isolation.md`): on Linux with Landlock and seccomp.\n\n"
        "Run it there. If you know all teams, `site serve FOLDER --trust-all-teams` starts it without."
    ),
}
