"""Before the flight: scenarios are loaded, and checked for what cannot be flown."""
