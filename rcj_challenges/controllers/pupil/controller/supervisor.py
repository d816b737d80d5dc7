"""What only referees may do: accepted without effect, as in the original for a robot that is no supervisor."""

from __future__ import annotations

from ._connection import complain
from .robot import Robot

TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable

_CALLS = frozenset(
    (
        *("animationStartRecording", "animationStopRecording", "exportImage", "getFromDef", "getFromDevice"),
        *("getFromId", "getMovieStatus", "getRoot", "getSelected", "getSelf", "loadWorld", "movieFailed"),
        *("movieIsReady", "movieStartRecording", "movieStopRecording", "reloadWorld", "saveWorld", "setLabel"),
        *("setSimulationMode", "simulationGetMode", "simulationPhysicsReset", "simulationQuit", "simulationReset"),
        *("simulationResetPhysics", "simulationRevert", "simulationSetMode", "startAnimation", "startMovie"),
        *("stopAnimation", "stopMovie", "virtualRealityHeadsetGetOrientation"),
        *("virtualRealityHeadsetGetPosition", "virtualRealityHeadsetIsUsed", "worldLoad", "worldReload", "worldSave"),
    )
)


class Supervisor(Robot):
    """A robot like any other. The calls that only supervisors have do nothing and return None, after a message."""

    SIMULATION_MODE_PAUSE, SIMULATION_MODE_REAL_TIME, SIMULATION_MODE_FAST = range(3)

    def __getattr__(self, attribute: str) -> Callable[..., None]:
        if attribute not in _CALLS:
            text = f"{type(self).__name__!r} object has no attribute {attribute!r}"
            raise AttributeError(text, name=attribute, obj=self)

        def ignore(*_: object, **__: object) -> None:
            if attribute not in self._rcj_told_of:
                self._rcj_told_of.add(attribute)
                complain(
                    f"Warning: {attribute} is ignored and gives None: it is the referee's, this is a player's robot."
                )

        return ignore
