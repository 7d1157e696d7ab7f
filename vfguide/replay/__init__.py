"""Recorded inputs through the same companion."""
