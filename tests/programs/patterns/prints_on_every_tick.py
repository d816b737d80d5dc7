# -*- coding: utf-8 -*-
from controller import Robot

robot = Robot()
größe = 7.5
while robot.step(32) != -1:
    print("Höhe", größe, "ボール", "⚽", "\udc80")
