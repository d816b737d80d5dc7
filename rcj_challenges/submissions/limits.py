"""How large a submission may be: its ZIP archive, its files and its folders."""

MAX_PACKED_BYTES = 10_000_000
"""A submission is at most 10 MB (reference, section 7)."""
MAX_UNPACKED_BYTES = 50_000_000
"""Text is packed to a fifth; three programs of each team need a copy in their private folders."""
MAX_RATIO = 100
"""Times its own size that an archive may grow; programs grow to 3 to 10 times, long logs to 50 times."""
FREE_UNPACKED_BYTES = 10_000_000
"""Up to this size the ratio does not matter: a small picture of one colour is no bomb."""
MAX_FILES = 5_000
MAX_FOLDERS = 1_000
"""A large library has a hundred; every look at the files costs as much as there are folders above them."""
MAX_DEPTH = 12
"""Folders in one another; libraries have five."""
