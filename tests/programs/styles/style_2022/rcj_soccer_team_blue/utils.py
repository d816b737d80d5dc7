import math


def get_direction(ball_vector: list) -> int:
    """-1 rechts, 0 geradeaus, 1 links"""
    if -0.13 <= ball_vector[1] <= 0.13:
        return 0
    return -1 if ball_vector[1] < 0 else 1


def distance_from_z(direction, tilt=0.0166):
    # Höhenunterschied Ball – Empfänger: die alte Art, die Entfernung zu messen
    return abs(tilt / direction[2])
