"""Before the flight: scenarios loaded and checked, so that what is flown can be flown."""
