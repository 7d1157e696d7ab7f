"""The aircraft: its state, what it can fly, how it moves, and how a flight shows that."""
