"""A route flown: hop after hop, until the last one is a leg's own way to the goal.

The hops lie in the horizontal plane, NED. Each is a way that ends at its end pose, as `way` has
them.
"""

import math
from typing import Annotated, NamedTuple

import numpy as np
from numpy.typing import NDArray

from vfguide.aircraft.state import FlightState
from vfguide.geometry.angles import wrap
from vfguide.geometry.compiled import compiled
from vfguide.geometry.rows import Shape, replacing
from vfguide.paths.course_laws import Course, Planar
from vfguide.paths.dubins import length_of
from vfguide.paths.edge import HOP_COLUMNS, Hop, Hops, hop_in
from vfguide.paths.leg import WAY, Leg, in_phase
from vfguide.paths.path_progress import (
    FIRST_TURN,
    LAST_TURN,
    TURN_IN,
    Pose,
    Way,
    along,
    beside,
    way_course,
)
from vfguide.paths.path_progress import way_left as rest_of
from vfguide.planning.overflight import NO_LEVEL
from vfguide.planning.roadmap import MOST_HOPS
from vfguide.planning.route_search import Detour

LOST = 0.7
"""A hop is given up farther beside it than this, in radii."""


class RouteState(NamedTuple):
    """What is remembered of the route round hazards, and of the searches for one."""

    length: int
    """Number of hops of the route; zero while none is flown."""
    present: int
    """Number of the hop that is flown."""
    piece: int
    left: float
    """`Way.piece` and `Way.left` of it."""
    radius: float
    """Of the turns [m]."""
    end: Pose
    """Where the last hop ends, NED."""
    clearance: float
    """That the route was found with; negative: none was found [m]."""
    looked: float
    sought: float
    """When the way was looked along last, and when one was searched for, on the clock of the
    obstacles [s]."""
    shifted: bool
    """Whether the leg was changed since the last look."""
    level: float
    """At which things are passed over, down from the origin; infinite: none is kept [m]."""
    fall: float
    """How long before the goal its height is flown to again [m]."""
    hops: Annotated[NDArray[np.float64], Shape(MOST_HOPS, HOP_COLUMNS)]
    """The hops of the route, then rows that mean nothing."""


with_shift = replacing(RouteState, "shifted")
with_level = replacing(RouteState, "level")
with_look = replacing(RouteState, "looked", "shifted")
with_search = replacing(RouteState, "looked", "sought", "length", "clearance")
with_overflight = replacing(RouteState, "level", "fall", "clearance")
_with_hops = replacing(RouteState, "length", "radius", "end", "clearance", "hops")
_at_hop = replacing(RouteState, "present", "piece", "left")
_without_hops = replacing(RouteState, "length")


@compiled
def fresh_route_state() -> RouteState:
    """No route, and nothing looked at."""
    never, hops = -math.inf, np.zeros((MOST_HOPS, HOP_COLUMNS))
    nowhere = Pose(0.0, 0.0, 0.0)
    return RouteState(0, 0, 0, 0.0, 0.0, nowhere, 0.0, never, never, True, NO_LEVEL, 0.0, hops)


@compiled
def is_on_route(route: RouteState) -> bool:
    """Whether a route is flown."""
    return route.length > 0


@compiled
def begin_route(route: RouteState, found: Detour, end: Pose, radius: float) -> RouteState:
    """Fly the hops that were found to `end`."""
    count, hops = len(found.hops), route.hops.copy()
    for i in range(count):
        hops[i] = found.hops[i]
    return begin_hop(_with_hops(route, count, radius, end, found.clearance, hops), 0)


@compiled
def begin_hop(route: RouteState, i: int) -> RouteState:
    """Fly hop `i` from its beginning."""
    return _at_hop(route, i, FIRST_TURN, hop_at(route, i).word.arc)


@compiled
def hop_at(route: RouteState, i: int) -> Hop:
    """Hop `i`."""
    return hop_in(route.hops, i)


@compiled
def end_at(route: RouteState, i: int) -> Pose:
    """Where hop `i` ends."""
    return hop_at(route, i + 1).begin if i + 1 < route.length else route.end


@compiled
def way_to(route: RouteState, i: int) -> Way:
    """Hop `i` as a way that ends at the origin along x."""
    hop, end = hop_at(route, i), end_at(route, i)
    x, y, course = seen_from(end, hop.begin)
    return Way(x, y, course, hop.word, route.radius, route.piece, route.left)


@compiled
def seen_from(frame: Pose, pose: Pose) -> Pose:
    """A pose in the axes of another."""
    c, s = math.cos(frame.course), math.sin(frame.course)
    dx, dy = pose.x - frame.x, pose.y - frame.y
    return Pose(c * dx + s * dy, c * dy - s * dx, wrap(pose.course - frame.course))


@compiled
def vehicle_from(frame: Pose, state: FlightState) -> Planar:
    """The vehicle in the axes of a pose."""
    c, s = math.cos(frame.course), math.sin(frame.course)
    dx, dy = state.p_n[0] - frame.x, state.p_n[1] - frame.y
    vx, vy = state.v_n[0], state.v_n[1]
    return Planar(c * dx + s * dy, c * dy - s * dx, c * vx + s * vy, c * vy - s * vx)


@compiled
def follow_route(route: RouteState, state: FlightState, leg: Leg) -> tuple[RouteState, Leg]:
    """Go along the hops; the last one becomes the way of the leg, and the route ends."""
    last = route.length - 1
    while route.present < last:
        i = route.present
        at = vehicle_from(end_at(route, i), state)
        way = along(way_to(route, i), at)
        route = _at_hop(route, i, way.piece, way.left)
        if beside(way, at) > LOST * route.radius:
            route = with_shift(route, True)
        if rest_of(way) > lead_into(route, i, state):
            return route, leg
        route = begin_hop(route, i + 1)
    way = way_to(route, last)
    leg = in_phase(Leg(WAY, route.radius, leg.final, leg.away, leg.circles, way), WAY, way)
    return _without_hops(route, 0), leg


@compiled
def lead_into(route: RouteState, i: int, state: FlightState) -> float:
    """How far before its end hop `i` goes over into the next one, for the lag of the bank [m]."""
    word, following = hop_at(route, i).word, hop_at(route, i + 1).word
    now = word.last if route.piece == LAST_TURN and word.end > 0.0 else 0.0
    then = following.first if following.arc > 0.0 else 0.0
    speed = math.hypot(state.v_n[0], state.v_n[1])
    return TURN_IN * speed * abs(then - now)


@compiled
def route_course(route: RouteState, state: FlightState, leg: Leg, course: float) -> Course:
    """Course along the hop that is flown, relative to `course`, and the path length to the goal."""
    i = route.present
    end = end_at(route, i)
    onto = way_course(way_to(route, i), vehicle_from(end, state))
    remaining = onto.remaining + leg.final
    for k in range(i + 1, route.length):
        remaining += route.radius * length_of(hop_at(route, k).word)
    return Course(wrap(end.course + onto.chi - course), onto.chi_rate, remaining)


@compiled
def hops_of(route: RouteState) -> Hops:
    """All hops as rows."""
    return route.hops[: route.length]
