"""Paths of bounded curvature, and the leg along one to a goal."""
