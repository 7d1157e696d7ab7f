"""The control loop: one step, written once, and what it remembers."""
