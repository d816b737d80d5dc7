"""The pages of the codes about the command line."""

from __future__ import annotations

_SCENARIO_HAS = "The help of the error lists the names that the scenario has."

PAGES: dict[str, str] = {
    "bad-arguments": "The command has an option or an argument that it does not know.\n\n`--help` lists all of them.",
    "bad-fps": "A video cannot have this number of pictures per second.\n\nGive --fps from 1 to 240.",
    "bad-out": "The file to write has a wrong ending, or its folder does not exist.\n\nThe message says what fits.",
    "bad-speed": "A speed cannot be read, or is out of range.\n\nThe message says what is allowed.",
    "bad-option": "An option has a value that it cannot have.\n\nThe help of the error has an example.",
    "bad-duration": "A time cannot be read.\n\nWrite 90, 90s or 1:30.",
    "bad-name": "A name cannot be the name of a file on every computer.\n\nUse letters, digits and _.",
    "bad-seeds": "The seeds cannot be read.\n\nWrite 1..10, 3 or 1,4,7..9.",
    "bad-team-name": "The name of a team has no characters that can be shown.\n\nUse letters.",
    "cannot-write-output": "The output of the command cannot be written.\n\nFree some space, or print elsewhere.",
    "not-taken": "The site did not take the archive. The message says why.\n\nDo what it says, and hand it in again.",
    "site-unreachable": (
        "The site does not answer at this address.\n\nCompare the address with the card, and check your connection. "
        "What was handed in is what you have a receipt for."
    ),
    "wrong-card": "The code is not that of any card.\n\nCompare it with the card; a mentor can replace a lost one.",
    "bad-url": "The address of a site cannot be one.\n\nBegin it with https:// or http://.",
    "device-name": "A file has the name of a Windows device, such as CON or AUX.\n\nChoose another name.",
    "internal-error": (
        "Something went wrong in this program, not in your input.\n\n"
        "Please send the report that the message names to the people of this project."
    ),
    "missing-package": "A package that this program needs is not installed.\n\nInstall it as the README says.",
    "no-sample-team": "No team was given for a seat, and no sample team fits.\n\nGive one with --team SEAT=PATH.",
    "option-does-not-fit": "An option needs another one, or does not fit the others.\n\nThe help of the error says which.",
    "option-given-twice": "An option is given twice.\n\nLeave one out.",
    "options-contradict": "Two options contradict each other.\n\nGive one of them.",
    "set-on-tournament": "--set changes scenarios, and a tournament file was given.\n\nChange the file.",
    "unknown-code": "There is no page for a code.\n\n`rcj-challenge explain` lists all codes.",
    "unknown-entrant": f"An option names an entrant that the scenario does not have.\n\n{_SCENARIO_HAS}",
    "unknown-preset": "There is no such preset for a new challenge.\n\nThe help of the error lists them.",
    "unknown-robot": f"An option names a robot that the scenario does not have.\n\n{_SCENARIO_HAS}",
}
