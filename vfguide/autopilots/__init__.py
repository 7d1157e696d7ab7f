"""Autopilots as the companion knows them: a record of each make, chosen by the first HEARTBEAT."""
