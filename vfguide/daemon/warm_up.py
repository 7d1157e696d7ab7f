"""A warm-up flight without an autopilot, so that all code is compiled before a real one."""

import math

from vfguide.annunciations.hazard_notes import route_summary
from vfguide.autopilots.makes import ASSUMED
from vfguide.companion.companion import Companion
from vfguide.companion.plan import Plan
from vfguide.earth.geodesy import ned_to_geodetic, tangent_plane
from vfguide.estimation.position_resets import settled
from vfguide.geometry.so3 import quaternion_from_euler
from vfguide.geometry.units import DEG_E7, MM
from vfguide.link.enums import AdsbFlags, MavState, MavType
from vfguide.link.messages import (
    AdsbVehicle,
    AttitudeQuaternion,
    GlobalPositionInt,
    GpsGlobalOrigin,
    Heartbeat,
    LocalPositionNed,
    Timesync,
    VfrHud,
    WindCov,
)
from vfguide.loop.loop_report import route_of_row
from vfguide.loop.state import fresh_state, row_of_state, state_of_row

STATE_INTERVAL = 100
"""Time between two states of the warm-up flight [ms]; chosen."""
SILENCE = 400_000
"""Time without attitudes after which it coasts [us]; chosen above the 0.2 s for which it waits, and
below the 0.5 s from which on it would have stood still."""
REPORT_AGES = (3, 0)
"""Ages of two reports of one aircraft [s]; chosen far enough apart that velocity and positions are
compared."""
NEARBY_TRAFFIC = (
    AdsbFlags.VALID_COORDS
    | AdsbFlags.VALID_ALTITUDE
    | AdsbFlags.VALID_VELOCITY
    | AdsbFlags.VALID_HEADING
)
"""ADSB_FLAGS of MAVLink in the report of an aircraft near the goal."""


def warm_up(plan: Plan) -> None:
    """Fly a companion that is then thrown away past the first goal of `plan`; nothing is sent.

    Where it has flown past, its attitudes stay away, so that it coasts.
    """
    companion = Companion(1, plan, engage=False)
    goal = plan.goals[0]
    latitude, longitude, altitude = ned_to_geodetic(tangent_plane(*plan.origin), goal.p_n)
    origin = (round(latitude / DEG_E7), round(longitude / DEG_E7), round(altitude / MM))
    for mode in (ASSUMED.hold_mode, ASSUMED.follow_mode):
        beat = Heartbeat(MavType.FIXED_WING, ASSUMED.make, 0, mode, MavState.ACTIVE)
        companion.receive(0, beat)
    companion.receive(0, Timesync(1, 0))  # the answer to what it asked at the time 0
    speed = plan.gains.airspeed
    companion.receive(0, GpsGlobalOrigin(*origin))
    companion.receive(0, WindCov(0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0))
    c, s = math.cos(goal.course), math.sin(goal.course)
    q_nb = quaternion_from_euler(0.0, 0.0, goal.course)
    for step, along in enumerate((-1.0, 1.0, 2.0)):
        time = step * STATE_INTERVAL
        place, velocity = (along * c, along * s, 0.0), (speed * c, speed * s, 0.0)
        companion.receive(0, LocalPositionNed(time, *place, *velocity))
        companion.receive(0, GlobalPositionInt(time, *origin, 0, 0, 0, 0, 0))
        companion.receive(0, VfrHud(speed, speed, 0, 0, altitude, 0.0))
        companion.receive(0, AttitudeQuaternion(time, *q_nb, 0.0, 0.0, 0.0))
        for age in REPORT_AGES:
            companion.receive(
                0,
                AdsbVehicle(1, *origin[:2], 0, origin[2], 0, 100, 0, "", 0, age, NEARBY_TRAFFIC, 0),
            )
    companion.poll(SILENCE)
    warm_up_notes()


def warm_up_notes() -> None:
    """Make what notes say of a route and of a position reset, which a short flight has not."""
    row = row_of_state(fresh_state())
    route_summary(route_of_row(row))
    settled(state_of_row(row).estimation.resets)
