import random

import numpy as np
from controller import Robot

robot = Robot()
robot.step(32)
draws = [random.random(), random.Random().random(), np.random.rand(), np.random.default_rng().random()]
draws.append(np.random.RandomState().rand())
random.seed()
np.random.seed()
draws += [random.random(), np.random.rand(), len({"a", "b", "c"})]
random.seed(7)
np.random.seed(7)
print(*draws, list({"blue", "yellow", "ball", "goal"}))
print("fixed", random.random(), np.random.rand())
robot.step(32)
