"""Planning: routes around and over hazards, and the leg to the goal."""
