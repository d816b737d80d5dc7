"""What words keep from tick to tick: trackers, contacts, bindings of rules to triggers, and state as plain data."""
