"""Formats of the lists of organizers, by language."""
