"""Scenario and aircraft files: their keys, what each may be, where they are found."""
