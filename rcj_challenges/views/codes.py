"""Codes about pictures, videos and the live view."""

from rcj_challenges.core.code import Code

# fmt: off
BAD_SIZE = Code("bad-size", page="""
The size of a picture is not WIDTHxHEIGHT in pixels, or it is too small, too large or odd.
Write 1280x720 or a name such as 720p; each side has 160 to 4096 pixels, an even number in a video.""")
BAD_TIME = Code("bad-time", page="""
A moment of a match is not written as a time.
Write seconds, 113.9, or minutes and seconds, 1:53.9.""")
EMPTY_CLIP = Code("empty-clip", page="""
The part of the match that was asked for has no length.
The time after --from must be earlier than the one after --to.""")
NO_HIGHLIGHTS = Code("no-highlights", page="""
The score does not change in the part of the match that was asked for, so it has no highlights.
Leave --highlights out, or choose another part.""")
NO_OPENGL = Code("no-opengl", page="""
MuJoCo found no OpenGL with which to draw on this computer.
On Debian and Ubuntu: apt install libegl1 libgl1-mesa-dri. The replay page needs none: rcj-challenge view.""")
NO_SUCH_HALF = Code("no-such-half", page="""
The record does not have the half that was asked for.
The message lists the halves it has.""")
PORT_TAKEN = Code("port-taken", page="""
The port of --live cannot be used, most often because another program listens on it.
Choose another port, or leave the number out: then a free port is used.""")
TIME_NOT_PLAYED = Code("time-not-played", page="""
The moment that was asked for is after the end of the recording.
Times count over all halves; with --half N they count from the beginning of that half.""")
UNKNOWN_CAMERA = Code("unknown-camera", page="""
There is no camera with this name in the match.
The cameras are field, top, side, follow-ball and behind:ROBOT, as in behind:Y1.""")
