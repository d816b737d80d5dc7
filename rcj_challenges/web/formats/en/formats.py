"""Times as on all other pages, with their zone."""

DATETIME_FORMAT = "Y-m-d H:i:s T"
