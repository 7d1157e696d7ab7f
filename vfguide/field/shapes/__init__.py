"""The shapes of obstacles, one family a module: level function, distance bound and sections."""
