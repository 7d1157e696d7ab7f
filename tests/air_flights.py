"""An aeroplane in a wind, seen by what measures badly: what the estimator of the air is fed."""

import math

import numpy as np
from flight_states import AEROSONDE

from vfguide.aircraft.flight_model import modelled_flight
from vfguide.aircraft.state import FlightState
from vfguide.estimation.air_data import sense_air
from vfguide.estimation.air_state import fresh_air
from vfguide.geometry.so3 import from_euler
from vfguide.geometry.units import DEG, G0

DT = 0.02
TOLD = np.array((math.nan, math.nan, math.nan))
"""A wind that is not told."""


class Air:
    """Coordinated flight at a constant airspeed, banked by `bank`, with constant errors."""

    def __init__(self, wind, airspeed=25.0, yaw_error=0.0, sensor_error=0.0, rng=None):
        self.wind, self.airspeed = np.array((*wind, 0.0)), airspeed
        self.yaw_error, self.sensor_error, self.rng = yaw_error, sensor_error, rng
        self.acceleration = 0.0
        self.course, self.time, self.air = 0.0, 1.0, fresh_air()
        self.asked = 0.0  # thrust at the step before

    def fly(self, seconds, bank=0.0, sensor=True, told=TOLD, fault=None):
        """States that were flown on, and what was believed after each."""
        believed = []
        for _ in range(round(seconds / DT)):
            self.time += DT
            self.course += DT * G0 * math.tan(bank) / self.airspeed
            state = self.state(bank, sensor, told, fault)
            state, self.air = sense_air(state, self.air, self.asked, AEROSONDE, 25.0)
            self.asked = self.thrust(bank)
            believed.append((state, self.air))
        return believed

    def state(self, bank, sensor, told, fault):
        v_n = self.airspeed * np.array((math.cos(self.course), math.sin(self.course), 0.0))
        speed = math.nan
        if sensor:
            speed = self.airspeed + self.sensor_error if fault is None else fault
        R_nb = self.attitude(bank)
        noise = np.zeros(3) if self.rng is None else self.rng.normal(0.0, 0.1, 3)
        if self.rng is not None and fault is None:
            speed += self.rng.normal(0.0, 0.3)
        v_g = tuple((v_n + self.wind + noise).tolist())
        return FlightState(
            self.time, (0.0, 0.0, -150.0), v_g, R_nb, speed, tuple(np.array(told).tolist())
        )

    def attitude(self, bank):
        """Fuselage above the path by the angle of attack that carries the aircraft."""
        load = 1.0 / math.cos(bank)
        alpha = AEROSONDE.alpha_zero + AEROSONDE.alpha_load * load / self.airspeed**2
        level = from_euler(bank, 0.0, self.course + self.yaw_error)
        return tuple(map(tuple, np.array(level) @ np.array(from_euler(0.0, alpha, 0.0))))

    def thrust(self, bank):
        """What this acceleration takes in level flight, by the aircraft's own model."""
        idle = modelled_flight(self.attitude(bank), self.airspeed, 0.0, 0.0, AEROSONDE)
        return (self.acceleration - idle.acceleration) * AEROSONDE.thrust_per_climb / G0


BANK = 30.0 * DEG
