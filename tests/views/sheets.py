"""Rule sheets of small scenarios, and single sentences of them."""

from rcj_challenges.scenario.load import load_text
from rcj_challenges.views.sheet import sheet_markdown

HEAD = "schema_version: 2\nid: small\ntitle: Small\nextends: soccersim_v2\n"


def sheet(text: str, preset: str = "soccersim_v2") -> str:
    """Return the sheet of a scenario, without the marks that keep Markdown from reading names as something else."""
    loaded = load_text(HEAD.replace("soccersim_v2", preset) + text)
    return sheet_markdown(loaded.scenario, loaded.roster).replace("\\", "")


def section(text: str, title: str) -> str:
    """Return a section of a sheet."""
    return text.partition(f"# {title}\n")[2].partition("\n#")[0].strip()


def sentence(rule: str, more: str = "") -> str:
    """Return the sentence of a rule that is written in YAML on one line."""
    text = sheet(f"{more}\nrules:\n  it: {{{rule}}}\n")
    return next(line for line in text.splitlines() if line.startswith("1. [it] ")).removeprefix("1. [it] ")


def spoken(rule: str, more: str = "") -> str:
    """Return what a rule that is written in YAML on one line says to players."""
    return section(sheet(f"{more}\nrules:\n  it: {{{rule}}}\n"), "Rules").removeprefix("- ")
