"""Autopilots as the companion knows them: a record of each make, and who of the two flies."""
