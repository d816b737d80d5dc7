"""RCJ Challenges: robot-soccer matches and technical challenges for pupils, declared in YAML, played on MuJoCo."""

from rcj_challenges import windows_runtime

__version__ = "0.1.0"

windows_runtime.find()
