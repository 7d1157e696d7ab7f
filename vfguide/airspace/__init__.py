"""Obstacles, traffic and the geofence: detection, and distances from all of them."""
