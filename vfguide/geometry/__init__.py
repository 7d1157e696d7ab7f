"""Vectors, rotations, shapes and units: pure mathematics, compiled."""
