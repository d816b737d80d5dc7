"""``controller.connector`` of R2023a."""

from ._absent import Connector

__all__ = ["Connector"]
