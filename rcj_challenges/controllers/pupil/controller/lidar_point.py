"""``controller.lidar_point`` of R2023a."""

from .lidar import LidarPoint

__all__ = ["LidarPoint"]
