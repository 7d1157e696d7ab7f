"""Which path leads to the goal, clear of what is known: the stage that seeks routes."""
