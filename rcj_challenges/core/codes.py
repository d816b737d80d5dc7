"""Codes that several packages report: missing resources, and files that cannot be read or written."""

from rcj_challenges.core.code import Code

# fmt: off
CANNOT_OPEN = Code("cannot-open", page="""
A file or folder that was given cannot be opened.
The message says why. Check the path and its permissions.""")
CANNOT_WRITE = Code("cannot-write", page="""
A file or folder cannot be written.
The message says why: a folder that is missing or read-only, a full disk, a program that has the file open.""")
FILE_EXISTS = Code("file-exists", page="""
The file or folder to be written already exists; nothing was written.
Choose another name, or move the old one away. Files of yours are never overwritten.""")
DISK_FULL = Code("disk-full", page="""
The disk is full.
Free some space and run the command again; what was finished is saved.""")
HOST_ERROR = Code("host-error", page="""
This computer cannot do what is needed: too little memory, too many open files, a broken disk.
No team is to blame, and nothing counts as a fault of a program. Remove the cause and run the command again.""")
MISSING_EXTRA = Code("missing-extra", page="""
The command needs an optional package that is not installed.
Install it as the help of the error says.""")
NO_MEMORY = Code("no-memory", page="""
There is not enough memory on this computer.
Close other programs, or do less at a time (--jobs, --at-once).""")
NO_PHYSICS = Code("no-physics", page="""
MuJoCo or numpy, which compute the physics, cannot be loaded.
On Windows the Visual C++ runtime is often missing; elsewhere reinstall both packages.""")
UNUSABLE_PICTURE = Code("unusable-picture", page="""
A picture cannot be used as a logo: it is damaged, too large, or of an unknown kind.
Save it as a PNG of at most 1024 x 1024 pixels and 1 MB.""")
BAD_OPTION = Code("bad-option", page="""
An option has a value that it cannot have.
The help of the error has an example.""")
TEMPORARY_FOLDER = Code("temporary-folder", page="""
The folder for temporary files cannot be used, perhaps because its disk is full.
Free some space there, or set TMPDIR (TEMP on Windows) to another folder.""")
