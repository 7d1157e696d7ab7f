"""What is truly there is traffic, whatever addresses, velocities and other senders say.

Before, an address was one aircraft: of two with one address, one was never seen; without an address
or beyond the 200th none was; one report between others at random places hid an aircraft for good;
and a velocity that was told was believed, whatever way the aircraft flew.
"""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from own_flights import DATUM, fly
from reported import ALL, ORIGIN, moving

from vfguide.link.enums import AdsbFlags
from vfguide.surveillance.heights import HeightDatum
from vfguide.surveillance.picture import (
    LONGEST_SILENCE,
    MAX_AIRCRAFT,
    OWN_REACH_REPORTS,
    Picture,
)
from vfguide.surveillance.report import SMALL_AIRCRAFT, Ownship, placed_at
from vfguide.surveillance.surveillance import MAX_INTRUDERS, Surveillance

SETTLED = 5.0
"""Time after which each aircraft has been heard often enough [s]."""
DURATION = 30.0


class Other:
    """An aircraft that flies in a circle, and the reports of it."""

    def __init__(self, place, speed, course, turn_rate):
        self.place, self.speed, self.course, self.turn_rate = place, speed, course, turn_rate

    def at(self, t):
        courses = self.course + self.turn_rate * np.linspace(0.0, t, 200)
        mean = np.array((np.cos(courses).mean(), np.sin(courses).mean(), 0.0))
        last = np.array((math.cos(courses[-1]), math.sin(courses[-1]), 0.0))
        p_n = np.array((*self.place, -150.0)) + t * self.speed * mean
        return tuple(p_n.tolist()), tuple((self.speed * last).tolist())


def others(rng, number):
    """Aircraft that begin a kilometre or more apart, and may meet."""
    return [
        Other(
            (2000.0 * (k - 1) + rng.uniform(-500.0, 500.0), rng.uniform(-3000.0, 3000.0)),
            rng.uniform(10.0, 60.0),
            rng.uniform(0.0, 6.28),
            rng.uniform(-0.1, 0.1),
        )
        for k in range(number)
    ]


def reports(each, rng, change, *, interval=1.0):
    """(arrival, message) of each report, with errors of 5 m."""
    begin = rng.uniform(0.0, 1.0)
    for k in range(int((DURATION - begin) / interval)):
        p_n, v_n = each.at(begin + k * interval)
        noisy = tuple((np.array(p_n) + rng.normal(0.0, 5.0, 3)).tolist())
        yield begin + k * interval, change(moving(noisy, v_n), k)


def excess(tracks, now_ms, p_n):
    """Distance of a place from the nearest volume [m], not positive inside."""
    least = math.inf
    for report in (track.report for track in tracks):
        there, age = placed_at(report, now_ms), (now_ms - report.time_ms) * 1e-3
        its = report.intruder
        beside = math.hypot(there[0] - p_n[0], there[1] - p_n[1])
        beside -= its.radius + age * its.uncertainty_rate
        above = abs(there[2] - p_n[2]) - its.half_height - age * its.uncertainty_rate_up
        least = min(least, max(beside, above))
    return least


def worst(flying, heard, datum=DATUM):
    """How far an aircraft ever is outside of all volumes, once heard for SETTLED [m]."""
    picture, flown = Picture(ORIGIN, SMALL_AIRCRAFT), fly(25.0, [(DURATION, 0.0, 0.0)])
    heard, most = sorted(heard, key=lambda each: each[0]), -math.inf
    for k in range(1, int(DURATION / 0.25)):
        own = flown.own(0.25 * k)
        while heard and heard[0][0] <= 0.25 * k:
            picture.hear(heard.pop(0)[1], own.time_ms, own, datum)
        picture.forget(own.time_ms)
        picture.follow(own)
        if 0.25 * k > SETTLED:
            seen = picture.others(own)
            most = max(most, *(excess(seen, own.time_ms, it.at(0.25 * k)[0]) for it in flying))
    return most


def spoofed(rng, one, icao):
    """Reports of the address of an aircraft from all over, half a kilometre and more from it."""
    for t in np.arange(0.0, DURATION, 0.7).tolist():
        place = (*rng.uniform(-9000.0, 9000.0, 2).tolist(), -150.0)
        if math.dist(place, one.at(t)[0]) > 500.0:
            yield t, moving(place, (20.0, 0.0, 0.0), icao=icao)


def one_address(message, k):
    return message._replace(ICAO_address=0x4B1A2C)


def no_address(message, k):
    return message._replace(ICAO_address=0)


def no_icao_address(message, k):
    return message._replace(ICAO_address=2**24 + 5)


def other_callsigns(message, k):
    return message._replace(callsign=f"\x1b[{k}J")


def either_height(message, k):
    return message._replace(altitude_type=k % 2)


def height_now_and_then(message, k):
    return message if k % 3 else message._replace(flags=ALL & ~int(AdsbFlags.VALID_ALTITUDE))


def back(message, k):
    return message._replace(heading=(message.heading + 18_000) % 36_000)


def to_the_right(message, k):
    return message._replace(heading=(message.heading + 9_000) % 36_000)


def north(message, k):
    return message._replace(heading=0)


def standing(message, k):
    return message._replace(hor_velocity=0)


KINDS = [
    one_address,
    no_address,
    no_icao_address,
    other_callsigns,
    either_height,
    height_now_and_then,
    back,
    to_the_right,
    north,
    standing,
]


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("seed", range(12))
def test_every_aircraft_is_in_a_volume(kind, seed):
    rng = np.random.default_rng(seed)
    flying = others(rng, 3)
    heard = [each for one in flying for each in reports(one, rng, kind)]
    assert worst(flying, heard) <= 0.0


@pytest.mark.parametrize("seed", range(12))
def test_one_of_an_address_that_somebody_sends_from_everywhere_is_in_a_volume(seed):
    rng = np.random.default_rng(seed)
    (one,) = others(rng, 1)
    heard = [*reports(one, rng, one_address), *spoofed(rng, one, 0x4B1A2C)]
    assert worst([one], heard) <= 0.0


def test_the_nearest_of_too_many_are_remembered_and_it_is_told_once():
    picture, own = Picture(ORIGIN, SMALL_AIRCRAFT), fly(25.0, [(9.0, 0.0, 0.0)]).own(5.0)
    notes = []
    for icao in range(1, MAX_AIRCRAFT + 50):
        far = moving((9000.0 + 5.0 * icao, 0.0, -150.0), (0.0, 0.0, 0.0), icao=icao)
        notes += picture.hear(far, own.time_ms, own, DATUM)
    near = moving((900.0, 0.0, -150.0), (0.0, 0.0, 0.0), icao=0xABCDEF)
    notes += picture.hear(near, own.time_ms, own, DATUM)
    assert len(picture) == MAX_AIRCRAFT
    assert picture.others(own)[0].report.icao == 0xABCDEF
    assert notes == ["more than 200 aircraft are heard: only the nearest are kept clear of"]


def test_one_report_alone_is_not_flown_on_where_its_address_is_known():
    picture = Picture(ORIGIN, SMALL_AIRCRAFT)
    own = Ownship(6000, (0.0, 0.0, -150.0), (25.0, 0.0, 0.0))
    picture.hear(moving((1000.0, 0.0, -150.0), (0.0, 0.0, 0.0)), 5000)
    picture.hear(moving((9000.0, 0.0, -150.0), (0.0, 0.0, 0.0)), 6000)
    assert [each.number for each in picture.others(own)] == [1]
    picture.hear(moving((9000.0, 9.0, -150.0), (0.0, 0.0, 0.0)), 7000)
    assert [each.number for each in picture.others(own)] == [1, 2]
    picture.forget(5000 + round(1000 * LONGEST_SILENCE))
    assert [each.number for each in picture.others(own)] == [2]


def test_one_in_conflict_is_flown_on_before_nearer_ones_that_are_none():
    """Before, only distance counted: eight that stayed abreast hid one head-on until 5 s before."""
    seen = Surveillance(Picture(ORIGIN, SMALL_AIRCRAFT))
    own = Ownship(5000, (0.0, 0.0, -150.0), (25.0, 0.0, 0.0))
    for number in range(1, MAX_INTRUDERS + 3):
        abreast = (0.0, 300.0 + 20.0 * number, -150.0)
        seen.hear(moving(abreast, own.v_n, icao=number), 5000, own, DATUM)
    seen.hear(moving((1500.0, 0.0, -150.0), (-50.0, 0.0, 0.0), icao=0xABC), 5000, own, DATUM)
    seen.look(own)
    rows = seen.rows(5000, 0.0)
    assert len(rows) == MAX_INTRUDERS
    assert rows[0][:3] == pytest.approx((1500.0, 0.0, -150.0), abs=0.1)


@given(st.floats(0.0, 0.4), st.floats(10.0, 60.0), st.floats(0.0, 3.0), st.integers(0, 9999))
def test_a_right_velocity_is_never_replaced(turn_rate, speed, late, seed):
    """In turns, with reports that come up to 3 s late and positions 5 m off."""
    rng = np.random.default_rng(seed)
    each, picture = Other((500.0, 0.0), speed, 1.0, turn_rate), Picture(ORIGIN, SMALL_AIRCRAFT)
    for k in range(12):
        p_n, v_n = each.at(float(k))
        noisy = tuple((np.array(p_n) + rng.normal(0.0, 5.0, 3)).tolist())
        arrival = 5000 + 1000 * k + round(1000 * rng.uniform(0.0, late))
        picture.hear(moving(noisy, v_n), arrival, None, HeightDatum(0.0, 0.0))
        newest = picture.newest(1)
        assert newest is not None
        assert newest.intruder.uncertainty_rate == SMALL_AIRCRAFT.uncertainty_rate


def test_an_own_address_that_somebody_else_has_is_told_once():
    """Before, an aircraft with the address that the plan calls the own one was passed over."""
    picture = Picture(ORIGIN, SMALL_AIRCRAFT, own_icao=0xABC123)
    own, notes = Ownship(5000, (0.0, 0.0, -150.0), (25.0, 0.0, 0.0)), []
    for k in range(3 * OWN_REACH_REPORTS):
        place = (0.0, 2500.0, -150.0)
        notes += picture.hear(moving(place, (0.0, 0.0, 0.0)), 5000 + 1000 * k, own, DATUM)
    note = "another aircraft reports this aircraft's own address ABC123, 2.5 km away: "
    assert notes == [note + "it is not avoided"]
    assert len(picture) == 0
