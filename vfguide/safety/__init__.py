"""What may leave the companion: limits on every setpoint."""
