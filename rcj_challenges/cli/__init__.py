"""The command rcj-challenge; imports lazily."""
