"""What was noted of a flight, and how it is judged."""
