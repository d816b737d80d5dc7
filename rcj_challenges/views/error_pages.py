"""The pages of the codes about pictures, videos and the live view."""

from __future__ import annotations

PAGES: dict[str, str] = {
    "bad-size": (
        "The size of a picture is not WIDTHxHEIGHT in pixels, or it is too small, too large or odd.\n\n"
        "Write 1280x720 or a name such as 720p; each side has 160 to 4096 pixels, an even number in a video."
    ),
    "bad-time": (
        "A moment of a match is not written as a time.\n\nWrite seconds, 113.9, or minutes and seconds, 1:53.9."
    ),
    "empty-clip": (
        "The part of the match that was asked for has no length.\n\n"
        "The time after --from must be earlier than the one after --to."
    ),
    "no-highlights": (
        "The score does not change in the part of the match that was asked for, so it has no highlights.\n\n"
        "Leave --highlights out, or choose another part."
    ),
    "no-opengl": (
        "MuJoCo found no OpenGL with which to draw on this computer.\n\n"
        "On Debian and Ubuntu: apt install libegl1 libgl1-mesa-dri. The replay page needs none: rcj-challenge view."
    ),
    "no-such-half": ("The record does not have the half that was asked for.\n\nThe message lists the halves it has."),
    "port-taken": (
        "The port of --live cannot be used, most often because another program listens on it.\n\n"
        "Choose another port, or leave the number out: then a free port is used."
    ),
    "time-not-played": (
        "The moment that was asked for is after the end of the recording.\n\n"
        "Times count over all halves; with --half N they count from the beginning of that half."
    ),
    "unknown-camera": (
        "There is no camera with this name in the match.\n\n"
        "The cameras are field, top, side, follow-ball and behind:ROBOT, as in behind:Y1."
    ),
}
