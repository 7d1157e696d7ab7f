#!/usr/bin/env python3
"""An aircraft file for a JSBSim model: flight tests on the model, printed as TOML.

    python tools/measure_aircraft.py aircraft/easystar --cruise 11
    python tools/measure_aircraft.py J3Cub --cruise 30

The first word is the folder of a model, FOLDER/NAME/NAME.xml, or an aircraft that the jsbsim
package ships. docs/aircraft.md tells how each number is measured, on a real aircraft as well.
"""

import argparse
import math
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

import numpy as np

from vfguide.aircraft.gain_scheduling import airspeed_gains
from vfguide.geometry.units import DEG, G0
from vfguide.geometry.vector import Series, Vec3, Vectors
from vfguide.sim.bench import Bench
from vfguide.sim.condition import FlightCondition, Model, Start
from vfguide.sim.fdm import stock_root
from vfguide.sim.inner_loop.airframe_model import identify
from vfguide.sim.inner_loop.inner_loop import inner_loop
from vfguide.sim.plant import STEP, Plant
from vfguide.sim.signals import Controls, Inner
from vfguide.sim.trim import TrimError, trim

CLEAR_OF_GROUND = 1000.0
"""Height of the tests above the ground [m]; chosen."""
STEADY = (0.0, 0.0, 0.0)
RATES_DPS = (100.0, 80.0, 60.0, 45.0, 30.0, 20.0, 12.0, 8.0, 5.0)
"""Body rates that are tried, of which the fastest that is followed is taken [deg/s]; chosen."""


class Answers(NamedTuple):
    """The response of a model to a step, n samples."""

    omega_b: Vectors
    """(n, 3) body rates, FRD [rad/s]."""
    thrust: Series
    """(n,) thrust [N]."""


def answer_of(plant: Plant) -> tuple[Vec3, float]:
    """Body rates, FRD [rad/s], and thrust [N] at this instant."""
    now = Inner(*plant.inner())
    return (now.p, now.q, now.r), plant.readings.thrust()


@dataclass(frozen=True)
class FlightTest:
    """Flight tests of one model, at one altitude [m] and true airspeed of cruise [m/s]."""

    model: Model
    cruise: float
    altitude: float

    def trims(self, airspeed: float, climb: float = 0.0) -> bool:
        """Whether the model flies steadily at a true airspeed [m/s] and a path angle [rad]."""
        try:
            trim(Bench(self.model, self.altitude), airspeed, climb)
        except TrimError:
            return False
        return True

    def responses(self, omega_b: tuple[float, ...], thrust: float, seconds: float) -> Answers:
        """The response of the model to a step of setpoints at cruise, for `seconds`."""
        each = identify(self.model, self.cruise, self.altitude)
        start = Start(0.8, 0.1, self.altitude, 0.0, each.cruise)
        plant = Plant(self.model, start, ground_altitude=self.altitude - CLEAR_OF_GROUND)
        wanted, memory = (*omega_b, each.cruise_thrust + thrust), STEADY
        answers = [answer_of(plant)]
        for _ in range(round(seconds / STEP)):
            controls, memory = inner_loop(each.tables, plant.inner(), wanted, memory, STEP)
            plant.advance(controls)
            answers.append(answer_of(plant))
        omega_b, thrusts = zip(*answers, strict=True)
        return Answers(np.array(omega_b), np.array(thrusts))

    def share(self, axis: int, rate: float) -> Series:
        """Body rate after a step of `rate` [rad/s] about one axis, as a share of `rate`, (n,)."""
        omega_b = tuple(rate if axis == i else 0.0 for i in range(3))
        return self.responses(omega_b, 0.0, 0.6).omega_b[:, axis] / rate


def last_that(holds: Callable[[float], bool], good: float, bad: float, close: float) -> float:
    """The value farthest from `good` towards `bad` at which `holds` is true, to within `close`."""
    while abs(bad - good) > close:
        middle = 0.5 * (good + bad)
        good, bad = (middle, bad) if holds(middle) else (good, middle)
    return good


def is_followed(test: FlightTest, axis: int, rate: float) -> bool:
    """Whether steps to both sides are followed within 0.2 s, to within 20 %."""
    shares = [test.share(axis, rate), test.share(axis, -rate)]
    return all(time_to_63(s) < 0.2 and (abs(s[60:] - 1.0) < 0.2).all() for s in shares)


def time_to_63(share: Series) -> float:
    """Time to 63 % of a step [s]; infinite if that is not reached."""
    late = share > 1.0 - math.exp(-1.0)
    return STEP * float(np.argmax(late)) if late.any() else math.inf


def fastest_rate(test: FlightTest, axis: int) -> float:
    """The fastest of RATES_DPS that is followed [deg/s]."""
    return next((r for r in RATES_DPS if is_followed(test, axis, r * DEG)), RATES_DPS[-1])


def drag_of_lift(test: FlightTest) -> float:
    """Induced drag at cruise [N], from D = a V^2 + b / V^2 at two speeds of level flight."""
    bench, speeds = Bench(test.model, test.altitude), np.array([1.0, 1.15]) * test.cruise
    drags = [bench.thrust(trim(bench, float(v))) for v in speeds]
    (_, b) = np.linalg.solve(np.column_stack([speeds**2, speeds**-2]), drags)
    return max(0.0, float(b) / test.cruise**2)


def lift_fit(test: FlightTest) -> tuple[float, float]:
    """alpha_zero [deg] and alpha_load [deg m^2/s^2] by a fit to the trims around cruise."""
    bench, speeds = Bench(test.model, test.altitude), np.array([0.9, 1.0, 1.15]) * test.cruise
    alphas = [trim(bench, float(v)).alpha / DEG for v in speeds]
    load, zero = np.polyfit(speeds**-2, alphas, 1)
    return float(zero), float(load)


def full_at(test: FlightTest, airspeed: float) -> float:
    """Full thrust at an airspeed [m/s] over that at cruise."""
    bench, controls = Bench(test.model, test.altitude), Controls(throttle=1.0)
    alpha = trim(bench, test.cruise).alpha
    full, cruise = (
        bench.thrust(FlightCondition(speed, alpha=alpha, controls=controls))
        for speed in (airspeed, test.cruise)
    )
    return full / cruise


def measure(test: FlightTest, name: str, stock: str | None) -> str:
    """The values of the whole aircraft file."""
    each, bench = identify(test.model, test.cruise, test.altitude), Bench(test.model, test.altitude)
    stall = last_that(test.trims, test.cruise, 0.2 * test.cruise, 0.01 * test.cruise)
    fastest = last_that(test.trims, test.cruise, 2.0 * test.cruise, 0.01 * test.cruise)

    def climbs(angle: float) -> bool:
        return test.trims(test.cruise, angle)

    up, down = (last_that(climbs, 0.0, end * DEG, 0.2 * DEG) / DEG for end in (40.0, -40.0))
    rates = [fastest_rate(test, axis) for axis in range(3)]
    roll_s = time_to_63(test.share(0, rates[0] * DEG))
    thrusts = test.responses(STEADY, 0.1, 4.0).thrust
    thrust_s = time_to_63((thrusts - thrusts[0]) / (0.1 * each.thrust.full_thrust))
    per_climb = bench.mass * G0 / each.thrust.full_thrust
    per_airspeed, integral = airspeed_gains(per_climb, thrust_s)
    zero, load = lift_fit(test)
    fastest_shown = round(min(0.95 * fastest, 1.35 * test.cruise), 1)
    model = f'\n[model]\nstock = "{stock}"\n' if stock else ""
    return f"""\
name = "{name}"
source = "Measured on the JSBSim model, {test.altitude:g} m above the sea"

[airspeed]
# Level flight from {stall:.1f} m/s, taken as the 1-g stall, to {fastest:.1f} m/s.
min_mps = {1.04 * stall:.1f}
cruise_mps = {test.cruise:.1f}
max_mps = {fastest_shown}

[limits]
bank_max_deg = 45.0
load_factor_max = 1.7
load_factor_min = 0.3
# The steepest steady climb at cruise is {up:.1f} deg, the steepest descent {-down:.1f} deg.
climb_max_deg = {min(10.0, 0.6 * up):.1f}
descent_max_deg = {min(10.0, -0.7 * down):.1f}
roll_rate_max_dps = {rates[0]}
pitch_rate_max_dps = {rates[1]}
yaw_rate_max_dps = {rates[2]}

[lift]
alpha_zero_deg = {zero:.2f}
alpha_load_deg_m2ps2 = {load:.1f}

[thrust]
# Full thrust at cruise is {each.thrust.full_thrust:.4g} N.
trim = {each.cruise_thrust:.3f}
per_climb = {per_climb:.2f}
per_load = {drag_of_lift(test) / each.thrust.full_thrust:.3f}
per_airspeed = {per_airspeed:.3f}
integral = {integral:.3f}
# Full thrust at max_mps over that at cruise.
full_at_max = {full_at(test, fastest_shown):.2f}

[response]
roll_s = {roll_s:.3f}
thrust_s = {thrust_s:.2f}
{model}"""


def main() -> None:
    """Measure the model and print the file."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("model", help="folder of a model, or an aircraft of the jsbsim package")
    parser.add_argument("--cruise", type=float, required=True, help="[m/s]")
    parser.add_argument(
        "--altitude",
        type=float,
        default=0.0,
        help="above the sea [m]; an aircraft file holds there",
    )
    args = parser.parse_args()
    folder = Path(args.model)
    own = (folder / f"{folder.name}.xml").is_file()
    model = Model(folder.parent, folder.name) if own else Model(stock_root(), args.model)
    test = FlightTest(model, args.cruise, args.altitude)
    print(measure(test, model.name, None if own else args.model), end="")


if __name__ == "__main__":
    main()
