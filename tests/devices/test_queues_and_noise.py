"""What waits for a program is bounded; numbers of noise come block by block, and no block comes twice."""

from __future__ import annotations

import pytest

from rcj_challenges.core.traffic import Packet
from rcj_challenges.devices.noise import Noise
from rcj_challenges.devices.receivers import QUEUE_BYTES, QUEUE_PACKETS, Queue
from tests.devices.device_bench import half


def waiting(*sizes: int) -> list[int]:
    """Return what of packets of these sizes still waits after the oldest have been dropped: their places, from 0."""
    queue = Queue()
    for place, size in enumerate(sizes):
        queue.put(Packet(place, bytes(size), 1.0, (1.0, 0.0, 0.0)))
    queue.trim()
    return [packet.device for packet in queue.take()]


def test_of_too_many_packets_the_oldest_are_dropped() -> None:
    assert waiting(*[1] * QUEUE_PACKETS) == list(range(QUEUE_PACKETS))
    assert waiting(*[1] * (QUEUE_PACKETS + 3)) == list(range(3, QUEUE_PACKETS + 3))


HALF = QUEUE_BYTES // 2


@pytest.mark.parametrize(
    ("sizes", "left"),
    [
        ((HALF, HALF), [0, 1]),
        ((HALF, HALF, 1), [1, 2]),
        ((1, HALF, HALF), [1, 2]),
        ((1, 1, QUEUE_BYTES), [2]),
        ((1, QUEUE_BYTES + 1), [1]),
        ((QUEUE_BYTES + 1,), [0]),
    ],
)
def test_of_too_many_bytes_the_oldest_are_dropped_and_the_newest_stays(sizes: tuple[int, ...], left: list[int]) -> None:
    assert waiting(*sizes) == left


def test_numbers_and_rows_of_noise_are_the_same_and_never_come_again() -> None:
    rows, numbers, both = (Noise(half(), [("Y1", "gps")], 3, 0.5) for _ in range(3))
    reported = [tuple(numbers.numbers(tick)) for tick in range(6000)]
    assert reported == [tuple(rows.row(tick).tolist()) for tick in range(6000)]
    assert all(both.row(tick).tolist() == both.numbers(tick) for tick in range(6000))
    assert len(set(reported)) == len(reported)
