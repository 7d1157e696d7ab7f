"""How the goal is flown to: the leg, and the route round hazards before it."""

from typing import NamedTuple

from vfguide.geometry.compiled import compiled
from vfguide.paths.leg import Leg, new_leg
from vfguide.planning.route_following import RouteFollowing, fresh_following


class Route(NamedTuple):
    """How the goal is flown to; also what one step leaves for the next."""

    leg: Leg
    following: RouteFollowing
    """Round hazards, before the leg; and what is remembered of searches for it."""


@compiled
def fresh_route() -> Route:
    """Nothing is planned yet."""
    return Route(new_leg(), fresh_following())
