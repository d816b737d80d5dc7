"""RCJ Challenges."""
