"""Surveillance of other aircraft: their reports, the traffic picture, alerts."""
