"""What all receivers share, and the queue of what they have delivered since their program last looked."""

from collections.abc import Callable

from rcj_challenges.core.traffic import Packet
from rcj_challenges.devices.base import Device

ANY_CHANNEL = -1
"""The channel of a receiver of all channels of its kind (Webots: -1): those of its team and the referee's, or
the balls', but not those of another team. No emitter may send on all of them: among them is the referee's."""

QUEUE_PACKETS = 16_384
"""Packets that wait for a program that does not look: with five a tick, those of 105 s."""

QUEUE_BYTES = 4_194_304
"""Payload that waits for it. Together with `QUEUE_PACKETS` about 8 MB a robot at the very worst."""

TRIM_EVERY_TICKS = 32
"""How often the bounds are enforced: counting at every packet costs more than a second of packets too many."""


class ReceiverDevice(Device):
    """A device that receives packets."""

    CLASS = "receiver"
    ACCEPTS = frozenset({"sampling", "channels"})


class Queue:
    """First in, first out; when memory runs out the oldest packets are dropped. `put` appends a packet."""

    __slots__ = ("_packets", "put")

    def __init__(self) -> None:
        self._packets: list[Packet] = []
        self.put = self._packets.append

    def trim(self) -> None:
        """Drop the oldest packets that are too many; the newest always stays. Cheap enough for every few ticks."""
        packets = self._packets
        size = sum(len(packet.data) for packet in packets)  # integers
        dropped = 0
        while len(packets) - dropped > 1 and (len(packets) - dropped > QUEUE_PACKETS or size > QUEUE_BYTES):
            size -= len(packets[dropped].data)
            dropped += 1
        del packets[:dropped]

    def take(self) -> list[Packet]:
        """Return all packets in order, and be empty."""
        packets = self._packets.copy()
        self._packets.clear()
        return packets


def _ignore(_: Packet) -> None:
    pass


class Receiver:
    """One receiver of one robot. Deaf until enabled; delivers at its sampling period.

    Attributes:
        robot: index of the robot.
        device: index of the receiver among its robot's devices.
        period_ticks: 0 while disabled.
        receive: takes a packet that arrived at this tick. Another function after `set_period`: look it up again then.
    """

    __slots__ = ("_held", "_next", "_queue", "channel", "device", "period_ticks", "range_m", "receive", "robot")

    def __init__(self, robot: int, device: int, channel: int, range_m: float, queue: Queue) -> None:
        self.robot = robot
        self.device = device
        self.channel = channel
        self.range_m = range_m
        self.period_ticks = 0
        self._next = 0
        self._queue = queue
        self._held = Queue()
        self.receive: Callable[[Packet], None] = _ignore

    def set_period(self, period_ticks: int, now: int) -> None:
        """Set the sampling period; 0 makes it deaf and drops what it has not delivered."""
        if period_ticks == self.period_ticks:
            return
        self.period_ticks = period_ticks
        self._next = now + period_ticks
        if not period_ticks:
            self._held.take()
            self.receive = _ignore
        elif period_ticks == 1:  # from now on nothing is held back: what is goes before all that comes
            self._hand_over()
            self.receive = self._queue.put
        else:
            self.receive = self._held.put

    @property
    def slow(self) -> bool:
        """Whether it holds packets back until a sampling tick."""
        return self.period_ticks > 1

    def deliver(self, tick: int) -> None:
        """At a sampling tick, hand over what arrived since the last. To be called each tick, after all `receive`."""
        if self.period_ticks and tick >= self._next:
            self._next = tick + self.period_ticks
            self._hand_over()

    def _hand_over(self) -> None:
        for packet in self._held.take():
            self._queue.put(packet)

    def trim(self) -> None:
        """Drop the oldest of what it has not delivered, if that is too much."""
        self._held.trim()
