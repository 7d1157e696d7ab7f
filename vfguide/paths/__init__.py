"""Dubins paths, the leg to a goal along one, and path stretching for changes of height."""
