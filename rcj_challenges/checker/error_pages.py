"""The pages of the findings of ``rcj-challenge check``."""

from __future__ import annotations

_FIX = "`rcj-challenge check FILE --fix NEW.zip` repairs this."
_OURS = "This says nothing about the team: please send the submission to the people of this project."
_LOGO = f"Save the logo as a PNG called logo.png, next to the folders of the programs. {_FIX}"

_IMPORTS = {
    "missing_module": "A program imports a module that does not exist.\n\nPut the file next to the program, or do without it. "
    "Available are Python's library, numpy, scipy and controller.",
    "wrong_case": "A module and its import differ in upper and lower case.\n\nWrite both in the same way.",
    "elsewhere": "A module is not in a folder in which Python looks for it.\n\nMove it next to the program.",
    "missing_part": "A part of a module or package that is imported does not exist.\n\nAdd the file, or correct the import.",
    "relative_import": "A file that is not in a package has a relative import.\n\nWrite it without the dots.",
    "not_on_this_computer": "A module exists on some operating systems only.\n\nDo without it.",
}
_FAULTS = {
    "crash": "A program ended with an error.\n\nThe last line of the report says what is wrong, the lines above it where.",
    "exit": "A program ended while the match goes on.\n\nCall robot.step(32) in a loop until it returns -1.",
    "start_timeout": "A program took too long to reach its first step.\n\nCall robot.step(32) sooner; prepare less before it.",
    "step_timeout": "A program took too long between two steps.\n\nLook for a loop that never calls robot.step(32).",
    "half_timeout": "A program used too much time in a half.\n\nDo less in each step.",
    "memory": "A program used too much memory.\n\nKeep less: is there a list that grows in every step?",
    "output_flood": "A program printed or wrote too much.\n\nPrint only what changes, or in every 30th step.",
    "protocol": "A program wrote into the channel to the match.\n\nLeave that to the module controller.",
    "start": "A program could not be started.\n\nIf the files are in order, this computer may be the reason.",
    "no_device": "A program asks for a device that its robot does not have.\n\nCorrect the name; the finding lists the devices.",
    "impossible": "This stage is not possible with this scenario.\n\nCheck whether the scenario can be played here.",
    "stumbled": f"The check itself failed at this stage.\n\n{_OURS}",
}

PAGES: dict[str, str] = {
    "check.broken": f"The check itself failed.\n\n{_OURS}",
    "archive.sound": "The archive can be read.",
    "archive.impossible": _FAULTS["impossible"],
    "archive.stumbled": _FAULTS["stumbled"],
    "sources.impossible": _FAULTS["impossible"],
    "sources.stumbled": _FAULTS["stumbled"],
    "layout.program": "A program is where the scenario asks for it.",
    "layout.same_program": "A program that is never started is the same as one that is.\n\nIt can be deleted.",
    "layout.single_program": f"A single file drives all robots.\n\nA tournament wants a ZIP. {_FIX}",
    "layout.no_folder": f"The programs are not in the folder that the scenario asks for.\n\n{_FIX}",
    "layout.folder_name": f"The folder of the programs does not have the name that the scenario asks for.\n\n{_FIX}",
    "layout.top_folder": f"Everything is in an extra folder.\n\nPack what is in it, not the folder itself. {_FIX}",
    "layout.misnamed": f"A program does not have the name that the scenario asks for.\n\nRename it. If names are clear, {_FIX}",
    "layout.empty_entry": "The file that would be started is empty.\n\nPut the program into it, or delete it.",
    "layout.empty_program": "A file that looks like a program is empty.\n\nDelete it.",
    "layout.never_started": (
        "A program is never started: the scenario starts another one, whatever the colour.\n\n"
        "Move its code into the program that is started, which can call robot.getName()."
    ),
    "identity.name": "The team has a name.",
    "identity.logo": "The logo can be shown.",
    "identity.logo_missing": "There is no logo.\n\nNone is needed.",
    "identity.logo_file": f"The logo has another name or place than logo.png.\n\n{_LOGO}",
    "identity.logo_no_picture": f"The logo is not a picture.\n\n{_LOGO}",
    "identity.logo_type": f"The logo is not a PNG.\n\n{_LOGO}",
    "identity.logo_size": f"The logo has too many pixels.\n\n{_LOGO}",
    "identity.logo_bytes": f"The logo has too many bytes.\n\n{_LOGO}",
    "identity.logo_damaged": f"The logo is damaged.\n\n{_LOGO}",
    "identity.logo_animated": f"The logo is animated; only its first picture is shown.\n\n{_LOGO}",
    "sources.ok": "All Python files in use can be read, and their imports exist.",
    "sources.more": "There are more findings of this kind.\n\nStart with those that are listed.",
    "sources.empty": "A program is empty.\n\nPut your program into this file.",
    "sources.syntax": "Python cannot read a file.\n\nCorrect this line, or the one before it.",
    "sources.encoding": (
        "A file has characters that Python cannot read: it is not saved as UTF-8.\n\nSave it as UTF-8 in your editor."
    ),
    "sources.odd_encoding": "A file names an unusual encoding.\n\nSave it as UTF-8, and remove the line that names it.",
    "sources.null_bytes": "A file has zero bytes in it, so it is not text.\n\nSave it as UTF-8 text in your editor.",
    "sources.too_deep": "Brackets or blocks are nested too deeply for Python.\n\nWrite it in several smaller steps.",
    "sources.too_slow": "Python takes far too long to read a file.\n\nSplit it, or put data into another file.",
    "sources.large": "A file is too large to be checked.\n\nPut large data into a file that is not a program.",
    "sources.too_many_imports": "The programs import too many modules to be checked.\n\nLeave out what is not needed.",
    "sources.unread": "A file was not checked, because the files before it reach the limit.\n\nLeave out what is not needed.",
    "sources.refused_module": (
        "A program imports a module for something that a match refuses: the network, other programs, windows.\n\n"
        "Play without it; an import that is not used does no harm."
    ),
    "sources.passed_over": (
        "A file has the name of a module that Python has loaded before any program, so it is never read.\n\n"
        "Give it another name, and import it under that name."
    ),
    "sources.shadows": "A file hides a module of Python, numpy or scipy.\n\nGive it another name, unless you want that.",
    **{f"sources.{code}": page for code, page in _IMPORTS.items()},
    **{f"sources.optional_{code}": f"{page}\n\nThe program catches the error." for code, page in _IMPORTS.items()},
    **{
        f"sources.conditional_{code}": f"{page}\n\nOnly running the program can show whether it reaches the import."
        for code, page in _IMPORTS.items()
    },
    **{f"{stage}.{kind}": page for stage in ("start", "play") for kind, page in _FAULTS.items()},
    "start.ok": "All robots start and answer.",
    "start.slow": "A program comes near the time limit of its start.\n\nPrepare less before the first step.",
    "play.played": "A short match was played.",
    "play.absent": (
        "A program called robot.step very rarely.\n\nDo not sleep or wait: call robot.step(32) in a loop instead."
    ),
    "play.stands": (
        'A robot did not move.\n\nIf it waits on purpose, this is fine; otherwise call setPosition(float("inf")) and '
        "setVelocity on both motors."
    ),
    "play.no_touch": "No robot touched the ball.\n\nWatch the replay (--replay DIR): do the robots find it?",
    "play.slow": "A program would use up most of its time in a whole half.\n\nDo less in each step.",
    "play.slow_step": "One step came near its time limit.\n\nSpread long work over many steps.",
    "play.prints_much": "A program prints so much that it may be stopped in a whole half.\n\nPrint less.",
    "play.thread": "A thread of a program ended with an error.\n\nCorrect the line in the report.",
    "play.complaint": "The module controller refused or ignored a call.\n\nCorrect this call.",
}
