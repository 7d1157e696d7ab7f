"""The truth in the log: HIL_STATE_QUATERNION, which no companion sees."""

from vfguide.geometry.atmosphere import calibrated_airspeed
from vfguide.geometry.so3 import quaternion_from_euler
from vfguide.geometry.units import CM_S, DEG_E7, MILLI_G, MM
from vfguide.link.messages import HilStateQuaternion
from vfguide.sim.truth import Truth

TRUTH_COMPONENT = 25
"""MAV_COMP_ID_USER1: a component of the vehicle's system that is nobody else's."""
MOST = 2**15 - 1


def truth_message(now: int, truth: Truth) -> HilStateQuaternion:
    """The truth at the date `now` [us since 1970]; the altitude is above the ellipsoid."""
    p, q, r = truth.omega_b
    north, east, down = truth.v_n
    x, y, z = truth.force_b
    return HilStateQuaternion(
        now,
        quaternion_from_euler(truth.roll, truth.pitch, truth.yaw),
        p,
        q,
        r,
        round(truth.latitude / DEG_E7),
        round(truth.longitude / DEG_E7),
        round(truth.altitude / MM),
        short(north / CM_S),
        short(east / CM_S),
        short(down / CM_S),
        round(calibrated_airspeed(truth.airspeed, truth.density) / CM_S),
        round(truth.airspeed / CM_S),
        short(x / MILLI_G),
        short(y / MILLI_G),
        short(z / MILLI_G),
    )


def short(value: float) -> int:
    """As a 16-bit integer, the nearest one that fits."""
    return round(value) if -MOST < value < MOST else (MOST if value > 0.0 else -MOST)
