from controller import GPS, Compass, DistanceSensor, Emitter, Lidar, Motor, PositionSensor, Receiver, Robot

robot = Robot()
motor: Motor = robot.getDevice("left wheel motor")
motor.target_position = float("inf")
motor.velocity = 2
gps: GPS = robot.getDevice("gps")
gps.enable(32)
sonar: DistanceSensor = robot.getDevice("distancesensor left")
sonar.enable(32)
receiver: Receiver = robot.getDevice("supervisor receiver")
receiver.enable(32)
emitter: Emitter = robot.getDevice("team emitter")
robot.step()
print(robot.name, robot.time, robot.basic_time_step, motor.velocity, motor.max_velocity, motor.name)
print(gps.values, gps.sampling_period, sonar.value, sonar.max_value)
print(receiver.queue_length, receiver.bytes, receiver.data_size, receiver.signal_strength, receiver.channel)
print(emitter.channel, emitter.range, robot.number_of_devices, [type(d) for d in (motor, gps, sonar)])
robot.step()
