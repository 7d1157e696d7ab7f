"""Scenarios: files with every default filled in, and made into the plans of companions."""
