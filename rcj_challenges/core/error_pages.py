"""The pages of codes that several packages report: missing resources, and files that cannot be read or written."""

from __future__ import annotations

PAGES: dict[str, str] = {
    "cannot-open": (
        "A file or folder that was given cannot be opened.\n\nThe message says why. Check the path and its permissions."
    ),
    "cannot-write": (
        "A file or folder cannot be written.\n\n"
        "The message says why: a folder that is missing or read-only, a full disk, a program that has the file open."
    ),
    "file-exists": (
        "The file or folder to be written already exists; nothing was written.\n\n"
        "Choose another name, or move the old one away. Files of yours are never overwritten."
    ),
    "disk-full": "The disk is full.\n\nFree some space and run the command again; what was finished is saved.",
    "host-error": (
        "This computer cannot do what is needed: too little memory, too many open files, a broken disk.\n\n"
        "No team is to blame, and nothing counts as a fault of a program. Remove the cause and run the command again."
    ),
    "missing-extra": (
        "The command needs an optional package that is not installed.\n\nInstall it as the help of the error says."
    ),
    "no-memory": (
        "There is not enough memory on this computer.\n\nClose other programs, or do less at a time (--jobs, --at-once)."
    ),
    "no-physics": (
        "MuJoCo or numpy, which compute the physics, cannot be loaded.\n\n"
        "On Windows the Visual C++ runtime is often missing; elsewhere reinstall both packages."
    ),
    "unusable-picture": (
        "A picture cannot be used as a logo: it is damaged, too large, or of an unknown kind.\n\nSave it as a PNG of at "
        "most 1024 x 1024 pixels and 1 MB."
    ),
}
