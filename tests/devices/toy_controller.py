"""The class of the toy device, as the file ``controller/midline_sensor.py`` of a program's process."""

from .device import ReadOnly, Sensor


class MidlineSensor(Sensor):
    """How far the robot is from the midline."""

    def getValue(self):
        """Return the distance in m."""
        return self._rcj_numbers()[0]

    value = ReadOnly(getValue)
