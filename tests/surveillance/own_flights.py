"""Flights of an ownship, and what a receiver aboard hears: its own transponder, and others."""

import bisect
from typing import NamedTuple

import numpy as np
from reported import ORIGIN, moving

from vfguide.surveillance.heights import HeightDatum
from vfguide.surveillance.picture import Picture
from vfguide.surveillance.report import SMALL_AIRCRAFT, Ownship

STEP = 0.02
DATUM = HeightDatum(0.0, 0.0)
OWN = 0xABCDEF
OTHER = 0x4B1234


class Flown(NamedTuple):
    """A flight, sampled every STEP."""

    p_n: np.ndarray
    v_n: np.ndarray
    course: np.ndarray

    def own(self, t):
        i = round(t / STEP)
        p_n, v_n = tuple(map(float, self.p_n[i])), tuple(map(float, self.v_n[i]))
        return Ownship(round(1000 * t) + 60_000, p_n, v_n)

    @property
    def duration(self):
        return STEP * (len(self.p_n) - 1)


def fly(speed, phases, wind=(0.0, 0.0)):
    """A flight of phases: duration [s], turn rate [rad/s], climb [m/s]."""
    turn = np.concatenate([np.full(round(d / STEP), w) for d, w, _ in phases])
    climb = np.concatenate([np.full(round(d / STEP), c) for d, _, c in phases])
    # a roll takes time: turn rates are reached within a second
    kernel = np.ones(50) / 50.0
    turn = np.convolve(np.concatenate((np.full(49, turn[0]), turn)), kernel, "valid")
    course = np.concatenate(([0.0], np.cumsum(turn) * STEP))
    climb = np.append(climb, climb[-1])
    v_n = np.column_stack(
        (speed * np.cos(course) + wind[0], speed * np.sin(course) + wind[1], -climb)
    )
    p_n = np.vstack((np.zeros(3), np.cumsum(0.5 * (v_n[1:] + v_n[:-1]) * STEP, axis=0)))
    return Flown(p_n + np.array([0.0, 0.0, -150.0]), v_n, course)


def listen(flown, reports, picture=None):
    """Times at which the addresses are flown on as traffic, and all notes.

    `reports` are (arrival time, message), at which the ownship looks at its picture too.
    """
    picture = Picture(ORIGIN, SMALL_AIRCRAFT) if picture is None else picture
    reports = sorted(reports, key=lambda each: each[0])
    times = [t for t, _ in reports]
    seen, notes = {}, []
    for k in range(1, int(flown.duration / 0.1)):
        t = 0.1 * k
        own = flown.own(t)
        if not picture.is_empty:
            picture.follow(own)
        low, high = bisect.bisect_right(times, t - 0.1), bisect.bisect_right(times, t)
        for arrival, message in reports[low:high]:
            now = flown.own(STEP * round(arrival / STEP))
            notes += [(t, note) for note in picture.hear(message, now.time_ms, now, DATUM)]
        picture.forget(own.time_ms)
        for each in picture.others(own):
            seen.setdefault(each.report.icao, []).append(t)
    return seen, notes


def noisy(rng, p_n, v_n, sd=3.0, sd_v=0.3, **changes):
    """A report with errors of position and velocity."""
    p = np.asarray(p_n) + rng.normal(0.0, sd, 3)
    v = np.asarray(v_n) + rng.normal(0.0, sd_v, 3)
    return moving(tuple(map(float, p)), tuple(map(float, v)), **changes)


def echoes(flown, rng, lateness, told=None, interval=1.0, sd=3.0):
    """Reports of the own transponder; `lateness()` and `told()` are drawn for each."""
    out = []
    for k in range(int(flown.duration / interval)):
        then, late = k * interval, lateness()
        if then + late > flown.duration - 0.2:
            continue
        own = flown.own(STEP * round(then / STEP))
        tslc = 0 if told is None else told(late)
        out.append((then + late, noisy(rng, own.p_n, own.v_n, sd, icao=OWN, tslc=tslc)))
    return out


def others(flown, rng, place, interval=1.0, sd=3.0, begin=0.0):
    """Reports of another aircraft; `place(t)` gives its position and velocity."""
    out = []
    t = begin
    while t < flown.duration - 0.2:
        p_n, v_n = place(t)
        out.append((t, noisy(rng, p_n, v_n, sd, icao=OTHER)))
        t += interval
    return out


def random_phases(rng, n=6):
    """Straights, turns and climbs; at least one turn of more than a right angle."""
    phases = []
    for _ in range(n):
        duration = rng.uniform(4.0, 15.0)
        turn = rng.choice([0.0, 1.0, -1.0]) * rng.uniform(0.1, 0.45)
        phases.append((duration, turn, rng.choice([0.0, rng.uniform(-3.0, 3.0)])))
    phases.insert(rng.integers(0, n), (10.0, rng.choice([-1.0, 1.0]) * rng.uniform(0.2, 0.45), 0.0))
    return phases
