"""The planned route: the leg to the goal, and the edges around hazards before it."""

from typing import NamedTuple

from vfguide.kernels.compiled import compiled
from vfguide.paths.leg import FIELD, Leg, in_phase, new_leg
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


@compiled
def route_on_field() -> Route:
    """No route: a field is followed. Its leg is in phase FIELD and has no radius."""
    return Route(in_phase(new_leg(), FIELD, new_leg().progress), fresh_following())


@compiled
def is_on_field(route: Route) -> bool:
    """Whether it is that of `route_on_field`."""
    return route.leg.phase == FIELD and route.leg.radius == 0.0
