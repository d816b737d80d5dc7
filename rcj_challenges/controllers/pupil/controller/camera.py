"""``controller.camera`` of R2023a."""

from ._absent import Camera, CameraRecognitionObject

__all__ = ["Camera", "CameraRecognitionObject"]
