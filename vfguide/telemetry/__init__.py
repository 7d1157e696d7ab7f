"""Telemetry: what the autopilot tells, from when it is, and how long it takes to arrive."""
