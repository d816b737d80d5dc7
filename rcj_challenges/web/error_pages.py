"""The pages of the codes of the site."""

from __future__ import annotations

PAGES: dict[str, str] = {
    "site-extra": (
        "The commands `site` need Django and other libraries, which are not installed with a plain `pip install`.\n\n"
        'Install them with `pip install "rcj-challenges[web]"`.'
    ),
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
