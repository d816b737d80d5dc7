from controller import Robot

TIME_STEP = 32


class Player:
    def __init__(self):
        self.robot = Robot()
        self.gps = self.robot.getDevice("gps")
        self.gps.enable(TIME_STEP)
        self.trace = []

    def wait(self, ticks):
        for _ in range(ticks):
            if self.robot.step(TIME_STEP) == -1:
                return False
        return True

    def turn_until(self, x):
        while self.gps.getValues()[0] < x:
            if not self.wait(1):
                return False
        return True

    def run(self):
        while self.robot.step(TIME_STEP) != -1:
            self.wait(3)
            self.trace.append(self.gps.getValues()[0])
            self.turn_until(8)
            self.trace.append(self.gps.getValues()[0])
        print(self.trace)


Player().run()
