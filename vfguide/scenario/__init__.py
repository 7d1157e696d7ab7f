"""Scenarios: what files say of them made whole, and made into the plans of companions."""
