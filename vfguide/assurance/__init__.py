"""Run-time assurance (ASTM F3269): after each command an escape remains."""
