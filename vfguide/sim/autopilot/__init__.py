"""The software autopilot: PX4's identity and behaviour on MAVLink."""
