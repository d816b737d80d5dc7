"""Registers the site with Django."""

from django.apps import AppConfig


class WebConfig(AppConfig):
    """The site as a Django app."""

    name = "rcj_challenges.web"
    label = "web"
    verbose_name = "League"
