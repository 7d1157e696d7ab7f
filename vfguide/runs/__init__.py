"""Scenarios flown: aeroplanes in lockstep, rigid bodies, logs."""
