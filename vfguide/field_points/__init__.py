"""The fields of a scenario at points of one's own, without a flight."""
