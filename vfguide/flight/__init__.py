"""From a field to a flyable aeroplane: approach, wind, attitude reference, energy."""
