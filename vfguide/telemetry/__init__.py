"""Telemetry: what the autopilot reports, of which time it is, and how long it takes to arrive."""
