"""What each address answers, by who uses it."""
