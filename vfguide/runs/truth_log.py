"""The truth in the log: HIL_STATE_QUATERNION, which no companion sees."""

from collections.abc import Sequence

from vfguide.earth.atmosphere import calibrated_airspeed
from vfguide.geometry.so3 import quaternion_from_euler
from vfguide.geometry.units import CM_S, DEG_E7, MILLI_G, MM
from vfguide.geometry.vector import Vec3
from vfguide.kernels.compiled import compiled
from vfguide.link.messages import HilStateQuaternion
from vfguide.sim.kinematic import Sighting
from vfguide.sim.truth import Truth

TRUTH_COMPONENT = 25
"""Number of the component that sends the truth, MAV_COMP_ID_USER1, which no other component of the
vehicle has."""
MAX_INT16 = 2**15 - 1
"""Largest value of a signed field of 16 bits."""
MAX_INT32 = 2**31 - 1
"""Largest value of a signed field of 32 bits."""


def truth_message(now: int, truth: Truth) -> HilStateQuaternion:
    """The truth at the date `now` [us since 1970]; the altitude is above mean sea level."""
    place = (truth.latitude, truth.longitude, truth.altitude)
    air = (truth.airspeed, truth.density)
    q_nb = quaternion_from_euler(truth.roll, truth.pitch, truth.yaw)
    return HilStateQuaternion(
        now, q_nb, *truth.omega_b, *on_the_wire(place, truth.v_n, air, truth.force_b)
    )


@compiled
def on_the_wire(
    place: Vec3, v_n: Vec3, air: tuple[float, float], force_b: Vec3
) -> tuple[int, int, int, int, int, int, int, int, int, int, int]:
    """The integers of the message: one call of compiled code makes all eleven.

    Args:
        place: latitude, longitude [rad] and altitude [m].
        v_n: velocity over ground [m/s].
        air: true airspeed [m/s] and density [kg/m^3].
        force_b: specific force [m/s^2].
    """
    latitude, longitude, altitude = place
    airspeed, density = air
    return (
        round(latitude / DEG_E7),
        round(longitude / DEG_E7),
        round(altitude / MM),
        short(v_n[0] / CM_S),
        short(v_n[1] / CM_S),
        short(v_n[2] / CM_S),
        round(calibrated_airspeed(airspeed, density) / CM_S),
        round(airspeed / CM_S),
        short(force_b[0] / MILLI_G),
        short(force_b[1] / MILLI_G),
        short(force_b[2] / MILLI_G),
    )


def body_message(now: int, seen: Sighting, omega_b: Sequence[float]) -> HilStateQuaternion:
    """The truth of a kinematic body, without air or weight: their fields are zero.

    Args:
        now: the date [us since 1970].
        seen: the body on the earth.
        omega_b: body rates [rad/s].
    """
    north, east, down = seen.v_l
    w, x, y, z = seen.q_lb
    p, q, r = omega_b
    return HilStateQuaternion(
        now,
        (w, x, y, z),
        p,
        q,
        r,
        round(seen.latitude / DEG_E7),
        round(seen.longitude / DEG_E7),
        fitting(seen.altitude / MM, MAX_INT32),
        short(north / CM_S),
        short(east / CM_S),
        short(down / CM_S),
        ind_airspeed=0,
        true_airspeed=0,
        xacc=0,
        yacc=0,
        zacc=0,
    )


@compiled
def short(value: float) -> int:
    """As a 16-bit integer, the nearest one that fits."""
    return fitting(value, MAX_INT16)


@compiled
def fitting(value: float, most: int) -> int:
    """The nearest integer from -`most` to `most`."""
    return round(value) if -most < value < most else (most if value > 0.0 else -most)
