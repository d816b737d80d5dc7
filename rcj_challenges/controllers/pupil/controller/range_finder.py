"""``controller.range_finder`` of R2023a."""

from ._absent import RangeFinder

__all__ = ["RangeFinder"]
