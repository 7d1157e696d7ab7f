"""Annunciations: what the operator reads, in plain words."""
