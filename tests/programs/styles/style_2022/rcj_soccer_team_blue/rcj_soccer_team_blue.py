# -*- coding: utf-8 -*-
# Team „Größenwahn 2022“ ⚽
import math  # noqa: F401
import random
import sys
import threading  # noqa: F401
import time
from pathlib import Path

sys.path.append(str(Path('.').absolute().parent))
# You can import the scripts that you need
import utils
from controller import Robot
from rcj_soccer_robot import RCJSoccerRobot, TIME_STEP

zähler = 0
letzter_kick = time.time()


class MyRobot1(RCJSoccerRobot):
    def run(self):
        global zähler, letzter_kick
        start = time.time()
        last_tick = time.time()
        while self.robot.step(TIME_STEP) != -1:
            now = time.time()
            fps = 1 / (now - last_tick)  # geteilt durch die Zeit seit dem letzten Schritt
            last_tick = now
            zähler += 1
            if self.is_new_data():
                data = self.get_new_data()  # noqa: F841
                while self.is_new_team_data():
                    team_data = self.get_new_team_data()  # noqa: F841

                if self.is_new_ball_data():
                    ball_data = self.get_new_ball_data()
                else:
                    # Kein Ball in Sicht: drehen
                    self.left_motor.setVelocity(4)
                    self.right_motor.setVelocity(-4)
                    print(self.name, 'kein Ball…')
                    continue

                heading = self.get_compass_heading()
                robot_pos = self.get_gps_coordinates()
                sonar_values = self.get_sonar_values()
                weit = utils.distance_from_z(ball_data["direction"])

                direction = utils.get_direction(ball_data["direction"])
                if direction == 0:
                    left_speed = 15   # zu schnell, wird begrenzt
                    right_speed = 15
                else:
                    left_speed = direction * 4
                    right_speed = direction * -4

                if now - letzter_kick > 5 + random.random():
                    letzter_kick = now
                    self.left_motor.setVelocity(-10)
                    self.right_motor.setVelocity(-10)
                    self.zurück()
                    continue

                self.left_motor.setVelocity(left_speed)
                self.right_motor.setVelocity(right_speed)

                self.send_data_to_team(self.player_id)
                print(self.name, zähler, round(now - start, 3), round(fps, 1), 'Höhe', round(weit, 3),
                      robot_pos, round(heading, 2), sonar_values['front'])

    def zurück(self):
        # eine eigene Schleife mit step, bis die Zeit um ist
        ende = time.time() + 0.3
        while time.time() < ende:
            if self.robot.step(TIME_STEP) == -1:
                return


robot = Robot()
name = robot.getName()
robot_number = int(name[1])

robot_controller = MyRobot1(robot)
robot_controller.run()
print('Ende für', name, '– tschüß')
