from controller import Robot

robot = Robot()
lidar = robot.getDevice("lidar")
lidar.enable(32)
lidar.enablePointCloud()
lidar.setFrequency(20)
robot.step(32)
print([round(reading, 2) for reading in lidar.getRangeImage()], len(lidar.getRangeImageArray()), lidar.getLayerRangeImage(0) == lidar.getRangeImage())
point = lidar.getPointCloud()[2]
print(round(point.x, 3), round(point.y, 3), point.z, point.layer_id, point.time, lidar.getNumberOfPoints(), lidar.getHorizontalResolution())
print(lidar.getFov() > 6.28, lidar.getMinRange(), lidar.getMaxRange(), lidar.getNumberOfLayers(), lidar.getFrequency())
robot.step(32)
