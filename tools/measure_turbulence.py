#!/usr/bin/env python3
"""The gusts that aircraft meet in straight flight against those of MIL-F-8785C, as tables.

    python tools/measure_turbulence.py --runs 8 --seconds 300

Three aircraft fly north at four heights above a ground that is 488 m high, in three intensities,
each flight with a seed of its own. Printed are the standard deviations of the air's velocity u
along the path, v across it and w down [m/s], behind them those of the standard; and the spectra
of all flights of an aircraft at a height over Dryden's, the least and the largest of all octaves
that are known well enough: from --cycles independent cycles on, up to a 14th of the sampling rate.
Gusts along the path last for seconds to a minute: with the options above their standard deviations
are known to 5 to 8 %.
"""

import argparse
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from itertools import pairwise, product
from typing import NamedTuple

import numpy as np
from scipy.signal import welch

from vfguide.files.data import data_folder
from vfguide.geometry.angles import wrap
from vfguide.geometry.units import DEG, G0
from vfguide.geometry.vector import Series, Vec3, Vectors
from vfguide.sim.condition import Model, Start, Weather
from vfguide.sim.fdm import stock_root
from vfguide.sim.inner_loop.airframe_model import identify
from vfguide.sim.inner_loop.inner_loop import inner_loop
from vfguide.sim.plant import STEP, Plant
from vfguide.sim.truth import Truth
from vfguide.sim.turbulence import Turbulence, scales_at

GROUND = 488.0
"""Height of the ground above the sea, that of the default origin [m]."""
HEIGHTS = (50.0, 200.0, 450.0, 800.0)
"""Heights above the ground: two of the low-altitude forms, between, and above [m]."""
LEVELS = (Turbulence.LIGHT, Turbulence.MODERATE, Turbulence.SEVERE)
EVERY = 4
"""Number of steps of the plant from one sample to the next; chosen."""
RESOLUTION = 16
"""Number of lines of the spectrum below the lowest octave; chosen, so that leakage from them is
below 1 % there."""


class Aircraft(NamedTuple):
    """An aircraft and its airspeed."""

    model: Model
    airspeed: float
    """True airspeed [m/s]."""


class Case(NamedTuple):
    """An aircraft at one height in one intensity of turbulence."""

    aircraft: Aircraft
    height: float
    """Height above the ground [m]."""
    level: Turbulence


def all_aircraft() -> list[Aircraft]:
    """The three aircraft, at the airspeeds at which they are flown."""
    own = data_folder() / "aircraft"
    return [
        Aircraft(Model(own, "aerosonde"), 25.0),
        Aircraft(Model(own, "easystar"), 10.5),
        Aircraft(Model(stock_root(), "c172p"), 50.0),
    ]


def wanted_rates(truth: Truth, pitch: float, altitude: float, airspeed: float) -> Vec3:
    """Body rates [rad/s] that keep the aircraft level, northbound and at its height.

    Below its airspeed [m/s] the nose goes down, so that no gust stalls a slow aircraft.
    """
    climb = max(-1.0, min(1.0, 0.3 * (altitude - truth.altitude)))
    slow = max(0.0, 1.0 - truth.airspeed / airspeed)
    nose = pitch + (climb + truth.v_n[2]) / max(truth.airspeed, 0.5 * airspeed) - 1.5 * slow
    bank = max(-0.5, min(0.5, -0.7 * wrap(truth.yaw)))
    turn = G0 * np.tan(truth.roll) / truth.airspeed
    return (2.0 * (bank - truth.roll), 2.0 * (nose - truth.pitch), float(turn))


def air_met(case: Case, seconds: float, seed: int) -> Vectors | None:
    """(n, 3) velocity of the air on one flight, NED [m/s].

    None: it came farther from its height than half of it, into other air.
    """
    aircraft, altitude = case.aircraft, GROUND + case.height
    each = identify(aircraft.model, aircraft.airspeed, altitude)
    start = Start(47.4 * DEG, 8.5 * DEG, altitude, 0.0, each.cruise)
    plant = Plant(aircraft.model, start, Weather(turbulence=case.level, seed=seed), GROUND)
    memory, winds, truth = (0.0, 0.0, 0.0), [], plant.truth()
    for step in range(round(seconds / STEP)):
        if step % EVERY == 0:
            truth = plant.truth()
            winds.append(truth.wind_n)
        lower = altitude - truth.altitude
        if abs(lower) > 0.5 * case.height:
            return None
        thrust = each.cruise_thrust + 0.1 * (aircraft.airspeed - truth.airspeed) + 0.02 * lower
        rates = wanted_rates(truth, each.cruise.pitch, altitude, aircraft.airspeed)
        setpoint = (*rates, max(0.0, min(1.0, thrust)))
        controls, memory = inner_loop(each.tables, plant.inner(), setpoint, memory, STEP)
        plant.advance(controls)
    return np.array(winds)


def flights(case: Case, pool: ProcessPoolExecutor, runs: int, seconds: float) -> list[Vectors]:
    """The air of the flights that stayed at their height; no two cases have seeds in common."""
    first = 1000 * (1 + LEVELS.index(case.level)) + 10_000 * round(case.height)
    seeds = range(first, first + runs)
    flown = pool.map(partial(air_met, case, seconds), seeds)
    return [air for air in flown if air is not None]


def deviations(records: list[Vectors]) -> Series:
    """(3,) standard deviations about a mean that is known to be zero [m/s]."""
    return np.sqrt(np.mean(np.concatenate(records) ** 2, axis=0))


def spectrum(lw: Series, is_along: bool) -> Series:
    """Dryden's spectra over s^2 L, one-sided, at W radians a metre (MIL-F-8785C, 3.7.1.2)."""
    if is_along:
        return 2.0 / np.pi / (1.0 + lw**2)
    return (1.0 + 3.0 * lw**2) / (1.0 + lw**2) ** 2 / np.pi


def octaves(case: Case, records: list[Vectors], cycles: int) -> Iterator[float]:
    """Spectra of u, v and w over Dryden's, octave by octave."""
    s, dt, count = scales_at(case.level, case.height), EVERY * STEP, len(records[0])
    along, across, down = (s.sigma, s.length), (s.sigma, s.length), (s.sigma_w, s.length_w)
    first, last = cycles / (count * len(records) * dt), 0.072 / dt
    edges = last / 2.0 ** np.arange(int(np.log2(last / first)), -1, -1)
    size = min(count, round(RESOLUTION / (first * dt)))
    for k, (sigma, length) in enumerate((along, across, down)):
        spectra = [welch(r[:, k], 1.0 / dt, nperseg=size) for r in records]
        frequency, found = np.mean(spectra, axis=0)
        rate = 2.0 * np.pi / case.aircraft.airspeed
        expected = sigma**2 * length * rate * spectrum(length * rate * frequency, k == 0)
        for low, high in pairwise(edges):
            band = (frequency >= low) & (frequency < high)
            yield float(found[band].sum() / expected[band].sum())


def show(
    aircraft: Aircraft, height: float, pool: ProcessPoolExecutor, args: argparse.Namespace
) -> None:
    """Print a row of the table."""
    columns, ratios = [], []
    for level in LEVELS:
        case = Case(aircraft, height, level)
        records, s = flights(case, pool, args.runs, args.seconds), scales_at(level, height)
        stayed = "" if len(records) == args.runs else f", {len(records)} of {args.runs} flights"
        if not records:
            columns.append(f"- ({s.sigma:.2f} {s.sigma_w:.2f}){stayed}")
            continue
        u, v, w = deviations(records)
        columns.append(f"{u:.2f} {v:.2f} {w:.2f} ({s.sigma:.2f} {s.sigma_w:.2f}){stayed}")
        ratios += octaves(case, records, args.cycles)
    spectra = f"{min(ratios):.2f} to {max(ratios):.2f}" if ratios else "-"
    cells = (aircraft.model.name, f"{aircraft.airspeed:g}", f"{height:g}", *columns, spectra)
    print("| " + " | ".join(cells) + " |", flush=True)


def main() -> None:
    """Parse the command line and print the table."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--runs", type=int, default=8, help="flights of each case")
    parser.add_argument("--seconds", type=float, default=300.0, help="of each flight")
    parser.add_argument("--cycles", type=int, default=900, help="least in an octave")
    parser.add_argument("--workers", type=int, default=2)
    args = parser.parse_args()
    print("| aircraft | m/s | height | light: u v w (u, v; w) | moderate | severe | spectra |")
    print("| --- | --- | --- | --- | --- | --- | --- |")
    with ProcessPoolExecutor(args.workers) as pool:
        for aircraft, height in product(all_aircraft(), HEIGHTS):
            show(aircraft, height, pool, args)


if __name__ == "__main__":
    main()
