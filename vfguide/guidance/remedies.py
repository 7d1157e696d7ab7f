"""The remedies of law `field` for what the paper's field lacks on an aeroplane, each a switch."""

from typing import NamedTuple


class Remedies(NamedTuple):
    """What law `field` does beyond the print, each on or off."""

    relative_velocity: bool = True
    """Hazards are passed by the velocity relative to them; else by their place alone."""
    reactive_range: bool = True
    """Hazards act from where a turn away still suffices; else within the reactive level of the
    scenario, and fences do not."""
    lead: bool = True
    """The turn rate of the field is fed forward, and half the roll response looked ahead."""
    unit_sum: bool = True
    """All terms of the sum have the airspeed; else tangents are as long as they are."""
    side: bool = True
    """What is dead ahead is passed on the side of the step before."""
    bounded_circles: bool = True
    """Ahead of the goal a point behind it is led to; else the circles of the print."""
    approach: bool = True
    """The last turn radii are flown as by law `flight`; else the field leads to the goal."""
    search: bool = True
    """Where the field is blocked ahead or comes no nearer, a route around the hazards is flown."""


ALL_REMEDIES = Remedies()
"""All remedies, as law `field` flies by default."""
