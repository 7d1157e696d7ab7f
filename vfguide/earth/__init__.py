"""The Earth: its ellipsoid, the local frames of autopilots, the standard atmosphere."""
