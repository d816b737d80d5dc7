"""MP4s: length and size, and that a file is complete or not there."""

import errno
from fractions import Fraction
from pathlib import Path

import av
import numpy as np
import pytest
from PIL import Image

from rcj_challenges.views.video.errors import VideoError, VideoInterruptedError
from rcj_challenges.views.video.mp4 import Mp4Writer

SIZE, FPS = (320, 180), Fraction(25)


def write(path, frames, *, fail=None):
    """Write frames that get brighter, then raise an error."""
    with Mp4Writer(path, SIZE, FPS, "A match") as video:
        for frame in range(frames):
            video.add(Image.new("RGB", SIZE, (frame * 255 // frames,) * 3))
        if fail is not None:
            raise fail


def decoded(path):
    with av.open(str(path)) as container:
        stream = container.streams.video[0]
        pictures = [frame.to_ndarray(format="rgb24").astype(int) for frame in container.decode(stream)]
        return pictures, float(stream.duration * stream.time_base), stream.average_rate


def names(folder):
    return sorted(path.name for path in folder.iterdir())


def test_frames_rate_and_size_are_as_requested(tmp_path):
    write(tmp_path / "v.mp4", 75)
    pictures, length_s, rate = decoded(tmp_path / "v.mp4")
    assert len(pictures) == 75
    assert pictures[0].shape == (180, 320, 3)
    assert length_s == pytest.approx(3.0)
    assert rate == FPS
    assert np.abs(pictures[-1] - pictures[0]).min() > 200


def test_interrupted_video_is_kept_under_another_name(tmp_path):
    with pytest.raises(VideoInterruptedError) as caught:
        write(tmp_path / "v.mp4", 20, fail=KeyboardInterrupt())
    assert names(tmp_path) == ["v.part.mp4"]
    assert caught.value.frames == len(decoded(caught.value.kept)[0]) == 20


def test_video_interrupted_before_its_first_frame_leaves_nothing(tmp_path):
    with pytest.raises(KeyboardInterrupt):
        write(tmp_path / "v.mp4", 0, fail=KeyboardInterrupt())
    assert names(tmp_path) == []


def test_failed_video_leaves_nothing_and_keeps_the_old_one(tmp_path):
    (tmp_path / "v.mp4").write_bytes(b"the old one")
    with pytest.raises(RuntimeError):
        write(tmp_path / "v.mp4", 3, fail=RuntimeError("failed"))
    assert names(tmp_path) == ["v.mp4"]
    assert (tmp_path / "v.mp4").read_bytes() == b"the old one"


def test_video_that_cannot_replace_an_open_one_is_kept_beside_it(tmp_path, monkeypatch):
    """Windows does not rename over a file that a player has open."""
    replace = Path.replace

    def refuse(path, target):
        if Path(target).name == "v.mp4":
            refused = PermissionError(errno.EACCES, "Access is denied", str(path))
            refused.winerror = 5
            raise refused
        return replace(path, target)

    monkeypatch.setattr(Path, "replace", refuse)
    monkeypatch.setattr("rcj_challenges.records.folder._WAIT_FOR_OTHERS_S", 0.01)
    (tmp_path / "v.mp4").write_bytes(b"the old one")
    with pytest.raises(VideoError) as error:
        write(tmp_path / "v.mp4", 5)
    assert error.value.diagnostics[0].code == "cannot-write"
    assert names(tmp_path) == ["v.mp4", "v.part.mp4"]
    assert (tmp_path / "v.mp4").read_bytes() == b"the old one"
    assert len(decoded(tmp_path / "v.part.mp4")[0]) == 5


def test_video_in_a_missing_folder_is_refused(tmp_path):
    with pytest.raises(VideoError) as error:
        write(tmp_path / "nowhere" / "v.mp4", 1)
    assert error.value.diagnostics[0].code == "cannot-write"
