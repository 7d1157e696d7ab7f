"""Other aircraft: their paths, their transponders, and the receiver of their reports."""

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from vfguide.earth.geodesy import (
    R_level,
    TangentPlane,
    geodetic_to_ned,
    ned_to_geodetic,
    tangent_plane,
)
from vfguide.geometry.polyline import points_at
from vfguide.geometry.units import CDEG, CM_S, DEG_E7, MM
from vfguide.geometry.vector import Series, Vec3, Vector, Vectors, add, matvec, norm, sub, transpose
from vfguide.link.enums import AdsbAltitudeType, AdsbFlags
from vfguide.link.messages import AdsbVehicle
from vfguide.sim.truth import Truth

ALL_VALID = int(
    AdsbFlags.VALID_COORDS
    | AdsbFlags.VALID_ALTITUDE
    | AdsbFlags.VALID_HEADING
    | AdsbFlags.VALID_VELOCITY
    | AdsbFlags.VALID_CALLSIGN
    | AdsbFlags.VERTICAL_VELOCITY_VALID
    | AdsbFlags.SIMULATED
)
"""Flags of an ADSB_VEHICLE message all of whose fields are valid."""
LIGHT_EMITTER = 1
"""Value of ADSB_EMITTER_TYPE_LIGHT, light aircraft."""
TIME_TOLERANCE = 1e-9
"""Difference below which two times count as equal [s]; chosen above rounding."""
HEADINGS = 36_000
"""Number of headings in a full circle of ADSB_VEHICLE [0.01 deg]."""


class Turn(NamedTuple):
    """A velocity that the aircraft changes to, linearly."""

    time: float
    """Time at which the change begins [s]."""
    within: float
    """Duration of the change [s]."""
    v_n: Vec3
    """Velocity after it, NED [m/s]."""


class Flight(NamedTuple):
    """A path: instants between which the velocity changes linearly."""

    times: Series
    """(n,) [s]."""
    places: Vectors
    """(n, 3), NED [m]."""
    velocities: Vectors
    """(n, 3), NED [m/s]."""


def flight_of(p_n: Vec3, v_n: Vec3, turns: Sequence[Turn]) -> Flight:
    """The path from `p_n` [m] with `v_n` [m/s], NED; the turns are in their order."""
    times, velocities = [0.0], [v_n]
    for turn in turns:
        times += [turn.time, turn.time + turn.within]
        velocities += [velocities[-1], turn.v_n]
    v: Vectors = np.array(velocities, dtype=float)
    steps = 0.5 * np.diff(times)[:, None] * (v[:-1] + v[1:])
    return Flight(np.array(times), np.cumsum(np.vstack((p_n, steps)), axis=0), v)


def motion_at(flight: Flight, t: Series) -> tuple[Vectors, Vectors]:
    """Positions [m] and velocities [m/s], NED, (n, 3), at times (n,) [s]."""
    times, v = flight.times, flight.velocities
    i = np.searchsorted(times, t, "right") - 1
    now = points_at(t, times, v)
    return flight.places[i] + 0.5 * (t - times[i])[:, None] * (v[i] + now), now


class Transponder(NamedTuple):
    """The transponder of another aircraft."""

    icao: int
    callsign: str
    flight: Flight
    interval: float
    """Time between two reports [s]."""
    delay: float
    """Time from a position to the arrival of its report [s]."""
    error: float
    """Standard deviation of each axis of the reported position [m]."""
    seed: int
    """Seed of those errors."""
    altitude_type: AdsbAltitudeType = AdsbAltitudeType.GEOMETRIC
    """What the altitude that it reports is measured from."""
    altitude_offset: float = 0.0
    """Reported altitude less that above mean sea level [m]."""


class Sender:
    """A transponder with its random errors and the number of its reports."""

    def __init__(self, each: Transponder) -> None:
        """A transponder before its first report."""
        self.each = each
        self._rng = np.random.default_rng(each.seed)
        self._number = 0

    def take(self, time: float) -> list[tuple[Vec3, Vec3, Vec3]]:
        """The reports that have arrived by `time` [s]: position, error and velocity, NED."""
        taken: list[tuple[Vec3, Vec3, Vec3]] = []
        while self._number * self.each.interval + self.each.delay <= time + TIME_TOLERANCE:
            at = np.array([self._number * self.each.interval])
            p_n, v_n = motion_at(self.each.flight, at)
            error = self.each.error * self._rng.standard_normal(3)
            taken.append((vec3(p_n[0]), vec3(error), vec3(v_n[0])))
            self._number += 1
        return taken


class Receiver:
    """Hears the transponders in range, each report once."""

    def __init__(self, transponders: Sequence[Transponder], origin: Vec3, reach: float) -> None:
        """A receiver before its first report.

        Args:
            transponders: the transponders of all other aircraft.
            origin: latitude, longitude [rad], altitude [m] of the frame of their paths.
            reach: distance within which it hears [m].
        """
        self._plane = tangent_plane(*origin)
        self._reach = reach
        self._senders = [Sender(each) for each in transponders]

    def hear(self, truth: Truth) -> list[AdsbVehicle]:
        """The reports that have arrived since the last time."""
        if not self._senders:
            return []
        own = geodetic_to_ned(self._plane, truth.latitude, truth.longitude, truth.altitude)
        return [
            report(sender.each, add(p_n, error), v_n, self._plane)
            for sender in self._senders
            for p_n, error, v_n in sender.take(truth.time)
            if norm(sub(p_n, own)) <= self._reach
        ]


def vec3(row: Vector) -> Vec3:
    """A row of three as a tuple."""
    return (float(row[0]), float(row[1]), float(row[2]))


def report(each: Transponder, p_n: Vec3, v_n: Vec3, plane: TangentPlane) -> AdsbVehicle:
    """ADSB_VEHICLE of an aircraft at `p_n` [m] that moves with `v_n` [m/s], NED of the plane."""
    latitude, longitude, altitude = ned_to_geodetic(plane, p_n)
    north, east, down = matvec(transpose(R_level(plane, latitude, longitude)), v_n)
    return AdsbVehicle(
        each.icao,
        round(latitude / DEG_E7),
        round(longitude / DEG_E7),
        each.altitude_type,
        round((altitude + each.altitude_offset) / MM),
        round(math.atan2(east, north) / CDEG) % HEADINGS,
        round(math.hypot(north, east) / CM_S),
        round(-down / CM_S),
        each.callsign,
        LIGHT_EMITTER,
        int(each.delay),
        ALL_VALID,
        0,
    )
