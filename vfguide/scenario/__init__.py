"""Scenarios: what files say of them made whole, checked before the flight, and made into plans."""
