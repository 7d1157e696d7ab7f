"""Scenario and aircraft files, runs, results and reports."""
