"""Campaigns: many flights of one scenario, drawn at random."""
