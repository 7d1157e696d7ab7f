"""What autopilots are to the companion: one module each, chosen by the make in their heartbeat."""
