"""Vectors, rotations, geodesy and units: pure mathematics, compiled."""
