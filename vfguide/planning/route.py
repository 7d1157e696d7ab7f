"""The planned route: the leg to the goal, and the edges around hazards before it."""

from typing import NamedTuple

from vfguide.kernels.compiled import compiled
from vfguide.paths.leg import Leg, new_leg
from vfguide.planning.route_following import RouteFollowing, fresh_following


class Route(NamedTuple):
    """The planned route, which is also the state that planning keeps."""

    leg: Leg
    following: RouteFollowing
    """The edges around hazards before the leg, and the state of the searches."""


@compiled
def fresh_route() -> Route:
    """The route before anything is planned."""
    return Route(new_leg(), fresh_following())
