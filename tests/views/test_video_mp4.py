"""MP4s: length and size, and that a file is complete or not there."""

from fractions import Fraction

import av
import numpy as np
import pytest
from PIL import Image

from rcj_challenges.core.errors import RcjError
from rcj_challenges.views.video.mp4 import opened_mp4

SIZE, FPS = (320, 180), Fraction(25)


def write(path, frames, *, fail=None):
    """Write frames that get brighter, then raise an error."""
    with opened_mp4(path, SIZE, FPS, "A match") as add:
        for frame in range(frames):
            add(Image.new("RGB", SIZE, (frame * 255 // frames,) * 3))
        if fail is not None:
            raise fail


def test_frames_rate_and_size_are_as_requested(tmp_path):
    write(tmp_path / "v.mp4", 50)
    with av.open(str(tmp_path / "v.mp4")) as container:
        stream = container.streams.video[0]
        pictures = [frame.to_ndarray(format="rgb24").astype(int) for frame in container.decode(stream)]
        assert float(stream.duration * stream.time_base) == pytest.approx(2.0)
        assert stream.average_rate == FPS
    assert len(pictures) == 50
    assert pictures[0].shape == (180, 320, 3)
    assert np.abs(pictures[-1] - pictures[0]).min() > 200


@pytest.mark.parametrize("error", [RuntimeError, KeyboardInterrupt])
@pytest.mark.parametrize("frames", [0, 3])
def test_failed_video_leaves_nothing_and_keeps_the_old_one(tmp_path, error, frames):
    (tmp_path / "v.mp4").write_bytes(b"the old one")
    with pytest.raises(error):
        write(tmp_path / "v.mp4", frames, fail=error("failed"))
    assert [path.name for path in tmp_path.iterdir()] == ["v.mp4"]
    assert (tmp_path / "v.mp4").read_bytes() == b"the old one"


def test_video_in_a_missing_folder_is_refused(tmp_path):
    with pytest.raises(RcjError) as error:
        write(tmp_path / "nowhere" / "v.mp4", 1)
    assert error.value.code == "cannot-write"
