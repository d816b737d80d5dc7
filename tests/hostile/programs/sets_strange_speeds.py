#: about = "module"
#: tries = "to set speeds of NaN, infinity and 1e308, and values that are not numbers"
#: holds = "NaN is refused, speeds are clamped, other values raise an error"
#: tick = 10
#: ends = "plays on"
#: said = ["setVelocity.NaN. is refused", "beyond the maximum", "refused: velocity None TypeError", "limited: True"]

import arena

arena.drive(10)
left, right = arena.motors
for strange in (float("nan"), float("inf"), -float("inf"), 1e308, 10**300, True):
    left.setVelocity(strange)
    right.setPosition(strange)
print("limited:", abs(left.getVelocity()) <= left.getMaxVelocity())
for strange in (None, "fast", [1], {}, object(), 1j, b"fast"):
    for name, deed in (
        ("velocity", left.setVelocity),
        ("position", left.setPosition),
        ("torque", left.setAvailableTorque),
    ):
        arena.refused(f"{name} {strange}", deed, strange)
for motor in arena.motors:
    motor.setVelocity(0)
    motor.setPosition(float("inf"))
arena.play_on()
