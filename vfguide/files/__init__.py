"""Scenario and aircraft files: their keys, the values allowed for each, where they are found."""
