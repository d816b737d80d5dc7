"""``rcj-challenge tournament``: plan, play, follow and decide a tournament that is declared in YAML.

The commands, in the order in which ``--help`` lists them below each heading.
"""

# ruff: noqa: F401, I001 - each module adds its command to the group when it is imported, so their order counts
from rcj_challenges.cli.app import ORGANIZE, app
from rcj_challenges.cli.tournament import plan
from rcj_challenges.cli.tournament import run
from rcj_challenges.cli.tournament import status
from rcj_challenges.cli.tournament import results
from rcj_challenges.cli.tournament import publish
from rcj_challenges.cli.tournament import decide
from rcj_challenges.cli.tournament import verify
from rcj_challenges.cli.tournament import rerun
from rcj_challenges.cli.tournament import judge
from rcj_challenges.cli.tournament import play_job
from rcj_challenges.cli.tournament.group import tournament_app

app.add_typer(tournament_app, name="tournament", rich_help_panel=ORGANIZE)
