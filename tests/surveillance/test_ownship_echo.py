"""The ownship's own transponder among the reports: recognised, and no other aircraft taken for it.

Before, a report was an echo while it lay within 15 m and 3 m/s of the ownship: one that is late was
fled from for as long as it was heard, and an aircraft that came within 15 m was not avoided.
"""

import math

import numpy as np
import pytest
from own_flights import (
    OTHER,
    OWN,
    STEP,
    echoes,
    fly,
    listen,
    noisy,
    others,
    random_phases,
)
from reported import ORIGIN, moving

from vfguide.geometry.units import DEG
from vfguide.surveillance.own_track import TRACK_TIME, OwnTrack, extended, match, own_at
from vfguide.surveillance.picture import OWN_FOUND, OWN_LOST, Picture
from vfguide.surveillance.recognition import LEAST_TURN
from vfguide.surveillance.report import SMALL_AIRCRAFT, Ownship

pytestmark = pytest.mark.slow

RECOGNISED_WITHIN = 15.0
"""Time after the ownship has turned by LEAST_TURN [s] by which its echo must be recognised: one
report that noise puts off the track begins the count anew."""
FOUND = OWN_FOUND.format(icao=OWN)
SEEDS = range(20)


def flight(rng):
    wind = tuple(rng.uniform(-6.0, 6.0, 2))
    return fly(rng.uniform(15.0, 40.0), random_phases(rng), wind)


def turned_at(flown):
    """Time by which the ownship has turned by LEAST_TURN since its track reaches back [s]."""
    begin = round(TRACK_TIME / STEP)
    course = flown.course[begin:]
    swing = np.maximum.accumulate(course) - np.minimum.accumulate(course)
    return STEP * (begin + int(np.argmax(swing >= LEAST_TURN)))


def constant(rng):
    late = rng.uniform(0.0, 2.8)
    return lambda: late


def jittering(rng):
    return lambda: float(rng.uniform(0.0, 3.0))


def drifting(rng):
    late = rng.uniform(0.5, 2.5)
    return lambda: float(np.clip(late + rng.normal(0.0, 0.2), 0.0, 3.0))


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("lateness", [constant, jittering, drifting])
@pytest.mark.parametrize("told", [None, int])
def test_an_echo_is_not_avoided_after_a_turn(seed, lateness, told):
    rng = np.random.default_rng(seed)
    flown = flight(rng)
    seen, notes = listen(flown, echoes(flown, rng, lateness(rng), told))
    assert [note for _, note in notes] == [FOUND]
    assert max(seen.get(OWN, [0.0])) <= turned_at(flown) + RECOGNISED_WITHIN


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("turns", [False, True])
def test_an_echo_that_is_not_late_is_never_avoided(seed, turns):
    rng = np.random.default_rng(seed)
    flown = flight(rng) if turns else fly(25.0, [(40.0, 0.0, 0.0)])
    seen, notes = listen(flown, echoes(flown, rng, lambda: 0.04, sd=2.0))
    assert OWN not in seen
    assert notes[0][0] < 5.0


def abreast(flown, rng):
    """In formation, at the same place in the frame of the earth."""
    bearing = rng.uniform(0.0, math.tau)
    offset = 25.0 * np.array([math.cos(bearing), math.sin(bearing), 0.0])
    return lambda i: (flown.p_n[i] + offset, flown.v_n[i])


def in_formation(flown, rng):
    """In formation, at the same bearing from the nose, not right behind."""
    bearing = rng.uniform(-0.75 * math.pi, 0.75 * math.pi)

    def at(i):
        course = flown.course[i] + bearing
        return flown.p_n[i] + 25.0 * np.array([math.cos(course), math.sin(course), 0.0])

    def place(i):
        before, after = max(i - 1, 0), min(i + 1, len(flown.p_n) - 1)
        return at(i), (at(after) - at(before)) / ((after - before) * STEP)

    return place


def overtaking(flown, rng):
    """From 30 m behind along the track of the ownship, 2 to 10 m/s faster."""
    speed = float(np.hypot(*flown.v_n[0, :2]))
    faster = rng.uniform(2.0, 10.0) / speed

    def place(i):
        j = round(i * (1.0 + faster) - 30.0 / speed / STEP)
        before = min(j, 0) * STEP
        j = min(max(j, 0), len(flown.p_n) - 1)
        return flown.p_n[j] + before * flown.v_n[0], flown.v_n[j] * (1.0 + faster)

    return place


def overtaking_straight(flown, rng):
    """From 30 m behind, straight on."""
    along = flown.v_n[0] / np.linalg.norm(flown.v_n[0])
    v_n = flown.v_n[0] + rng.uniform(1.0, 10.0) * along
    return lambda i: (flown.p_n[0] - 30.0 * along + i * STEP * v_n, v_n)


def converging(flown, rng):
    """From the side, slowly, with the course of the ownship: it hits."""
    rate, side, begin = rng.uniform(0.3, 3.0), rng.choice([-1.0, 1.0]), rng.uniform(25.0, 60.0)

    def place(i):
        c = flown.course[i]
        right = side * np.array([-math.sin(c), math.cos(c), 0.0])
        return flown.p_n[i] + right * (begin - rate * i * STEP), flown.v_n[i] - rate * right

    return place


def crossing(flown, rng):
    """Across the track of the ownship, to hit it."""
    j, course = round(rng.uniform(5.0, 30.0) / STEP), rng.uniform(0.0, math.tau)
    v_n = rng.uniform(15.0, 50.0) * np.array([math.cos(course), math.sin(course), 0.0])
    return lambda i: (flown.p_n[j] + (i - j) * STEP * v_n, v_n)


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize(
    "kind", [abreast, in_formation, overtaking, overtaking_straight, converging, crossing]
)
def test_no_other_aircraft_is_taken_for_an_echo(seed, kind):
    rng = np.random.default_rng(seed)
    flown = flight(rng)
    place = kind(flown, rng)
    reports = others(flown, rng, lambda t: place(round(t / STEP)), begin=0.1)
    seen, notes = listen(flown, reports)
    assert notes == []
    assert len(seen[OTHER]) == int(flown.duration / 0.1) - 1


@pytest.mark.parametrize("seed", SEEDS)
def test_one_right_behind_is_not_taken_for_an_echo_on_a_straight(seed):
    rng = np.random.default_rng(seed)
    flown = fly(rng.uniform(15.0, 40.0), [(90.0, 0.0, 0.0)], tuple(rng.uniform(-6.0, 6.0, 2)))
    lag = rng.uniform(25.0, 60.0) / np.linalg.norm(flown.v_n[0])

    def place(t):
        return flown.own(t).p_n - lag * flown.v_n[0], flown.v_n[0]

    seen, notes = listen(flown, others(flown, rng, place, begin=0.1))
    assert notes == []
    assert len(seen[OTHER]) == int(flown.duration / 0.1) - 1


@pytest.mark.parametrize("seed", SEEDS)
def test_one_that_has_joined_and_follows_is_not_taken_for_an_echo_within_a_minute(seed):
    """It is heard 200 m away before, and then flies where the ownship flew, through every turn."""
    rng = np.random.default_rng(seed)
    flown = flight(rng)
    lag, joins = rng.uniform(0.8, 2.5), 8.0

    def place(t):
        own = flown.own(STEP * round(max(t - lag, 0.0) / STEP))
        away = 200.0 * max(1.0 - t / joins, 0.0)
        return np.array(own.p_n) + np.array([0.0, away, 0.0]), own.v_n

    _, notes = listen(flown, others(flown, rng, place, begin=0.1))
    assert [t for t, _ in notes if t < joins + 60.0] == []


def test_an_address_that_leaves_the_own_track_is_traffic_again():
    """It has flown where the ownship did, through a turn; then it flies on straight."""
    rng = np.random.default_rng(1)
    flown = fly(25.0, [(10.0, 0.3, 0.0), (10.0, 0.0, 0.0), (10.0, -0.35, 0.0)])
    leaves = 18.0

    def place(t):
        own = flown.own(STEP * round(max(t - 1.5, 0.0) / STEP))
        straight = max(t - leaves, 0.0)
        held = flown.own(STEP * round((min(t, leaves) - 1.5) / STEP)) if straight else own
        return np.array(held.p_n) + straight * np.array(held.v_n), held.v_n

    seen, notes = listen(flown, others(flown, rng, place, begin=1.6, sd=1.0))
    assert [note for _, note in notes] == [
        OWN_FOUND.format(icao=OTHER),
        OWN_LOST.format(icao=OTHER),
    ]
    lost = notes[1][0]
    own, (p_n, _) = flown.own(lost), place(lost)
    assert math.dist(own.p_n, p_n) > 20.0
    assert seen[OTHER][-1] == pytest.approx(29.9, abs=0.11)


def test_an_echo_after_a_position_reset_is_found_again():
    rng = np.random.default_rng(3)
    flown = fly(25.0, [(60.0, 0.2, 0.0)])
    reports = echoes(flown, rng, lambda: 0.5, sd=1.0)
    jumped = flown._replace(p_n=flown.p_n.copy())
    jumped.p_n[round(20.0 / STEP) : round(23.0 / STEP)] += np.array([300.0, 0.0, 0.0])
    seen, _ = listen(jumped, reports)
    assert max(seen[OWN]) < 40.0


def test_a_known_address_is_never_traffic():
    flown = fly(25.0, [(20.0, 0.0, 0.0)])

    def place(_):
        return np.array([200.0, 0.0, -150.0]), np.zeros(3)

    reports = others(flown, np.random.default_rng(1), place)
    picture = Picture(ORIGIN, SMALL_AIRCRAFT, own_icao=OTHER)
    assert listen(flown, reports, picture) == ({}, [])


def test_a_late_report_matches_the_track_at_its_age():
    flown = fly(25.0, [(10.0, 0.3, 0.0)])
    track = OwnTrack()
    for k in range(81):
        track = extended(track, flown.own(0.1 * k))
    now, then = flown.own(8.0), flown.own(6.3)
    found = match(track, now, then.p_n, then.v_n)
    assert found.age == pytest.approx(1.7, abs=0.01)
    assert found.miss < 0.05
    assert math.dist(own_at(track, now, then.time_ms).p_n, then.p_n) < 0.1
    assert now.time_ms - track.samples[0].time_ms >= 1000 * TRACK_TIME


def test_a_track_begins_anew_after_a_jump_and_after_a_gap():
    first = Ownship(1000, (0.0, 0.0, -100.0), (25.0, 0.0, 0.0))
    on = Ownship(1100, (2.5, 0.0, -100.0), (25.0, 0.0, 0.0))
    track = extended(extended(OwnTrack(), first), on)
    assert track.samples == (first, on)
    jumped = Ownship(1200, (55.0, 0.0, -100.0), (25.0, 0.0, 0.0))
    assert extended(track, jumped).samples == (jumped,)
    later = Ownship(4000, (75.0, 0.0, -100.0), (25.0, 0.0, 0.0))
    assert extended(track, later).samples == (later,)


def test_the_turn_that_shows_an_echo_is_one_that_formation_does_not_survive():
    """Right behind at 25 m and fixed in the frame of the earth: off the track by then."""
    assert 25.0 * math.sin(LEAST_TURN) > 12.0
    assert pytest.approx(45.0 * DEG) == LEAST_TURN


def test_reports_without_a_velocity_are_never_an_echo():
    flown = fly(25.0, [(30.0, 0.3, 0.0)])
    reports = [
        (float(t), noisy(np.random.default_rng(t), *flown.own(float(t))[1:], icao=OWN, flags=3))
        for t in range(1, 29)
    ]
    seen, notes = listen(flown, reports)
    assert (len(seen[OWN]) > 250, notes) == (True, [])


def test_moving_is_what_the_wire_says():
    message = moving((0.0, 0.0, -150.0), (0.0, -25.0, -1.0))
    assert (message.heading, message.hor_velocity, message.ver_velocity) == (27_000, 2500, 100)
