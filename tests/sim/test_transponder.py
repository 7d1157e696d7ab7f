"""Other aircraft of the simulation: their paths, and what the receiver hears of them."""

import math

import numpy as np
import pytest

from vfguide.earth.geodesy import ned_to_geodetic, tangent_plane
from vfguide.geometry.units import DEG
from vfguide.link.codec import Encoder, Parser, decode
from vfguide.sim.traffic import Receiver, Transponder, Turn, flight_of, motion_at
from vfguide.surveillance.report import SMALL_AIRCRAFT, report_of

ORIGIN = (47.4 * DEG, 8.5 * DEG, 488.0)
TURNS = [Turn(10.0, 4.0, (0.0, 30.0, -3.0)), Turn(14.0, 2.0, (-20.0, 0.0, 0.0))]
STRAIGHT = flight_of((1000.0, 0.0, -150.0), (0.0, 40.0, 0.0), [])


class Place:
    """What a receiver looks at of the truth."""

    def __init__(self, time, p_n=(0.0, 0.0, -150.0)):
        self.time = time
        place = ned_to_geodetic(tangent_plane(*ORIGIN), p_n)
        self.latitude, self.longitude, self.altitude = place


def heard(receiver, times):
    return [(t, message) for t in times for message in receiver.hear(Place(t))]


def transponder(**changes):
    return Transponder(0x4B1A2C, "CROSS", STRAIGHT, 1.0, 0.0, 0.0, 1)._replace(**changes)


def test_a_path_is_the_integral_of_its_velocity():
    flight = flight_of((1.0, 2.0, -3.0), (25.0, 0.0, 0.0), TURNS)
    t = np.linspace(0.0, 30.0, 30001)
    p_n, v_n = motion_at(flight, t)
    summed = np.cumsum(0.5 * (v_n[1:] + v_n[:-1]) * np.diff(t)[:, None], axis=0)
    assert p_n[0] == pytest.approx([1.0, 2.0, -3.0])
    assert np.abs(p_n[1:] - p_n[0] - summed).max() < 1e-6
    assert v_n[0] == pytest.approx([25.0, 0.0, 0.0])
    assert v_n[12_000] == pytest.approx([12.5, 15.0, -1.5])
    assert v_n[14_000] == pytest.approx([0.0, 30.0, -3.0])
    assert v_n[-1] == pytest.approx([-20.0, 0.0, 0.0])


def test_what_is_sent_puts_it_where_it_is():
    (_, message), *_ = heard(Receiver([transponder()], ORIGIN, 2e4), [0.0])
    (frame,) = Parser().feed(Encoder(1, 1).encode(message))
    report = report_of(decode(frame), 0, ORIGIN, SMALL_AIRCRAFT)
    assert report.name == "CROSS"
    assert math.dist(report.intruder.p_n, (1000.0, 0.0, -150.0)) < 0.02
    assert report.intruder.v_n == pytest.approx((0.0, 40.0, 0.0), abs=0.01)


def test_each_report_is_heard_once_and_late():
    receiver = Receiver([transponder(interval=0.5, delay=1.2)], ORIGIN, 2e4)
    times = [0.02 * k for k in range(200)]
    arrived = heard(receiver, times)
    assert [t for t, _ in arrived] == pytest.approx([1.2, 1.7, 2.2, 2.7, 3.2, 3.7])
    assert {message.tslc for _, message in arrived} == {1}


def test_nothing_is_heard_from_beyond_the_range():
    times = [float(t) for t in range(60)]
    arrived = heard(Receiver([transponder()], ORIGIN, 1414.0), times)
    assert [t for t, _ in arrived] == times[:25]  # at 25 s it is 1000 m north and 1000 m east
    assert not heard(Receiver([transponder()], ORIGIN, 0.0), times)


def test_errors_have_the_size_asked_for_and_are_the_same_every_time():
    noisy = transponder(error=20.0, interval=0.1)
    one, other = (heard(Receiver([noisy], ORIGIN, 1e6), [300.0]) for _ in range(2))
    assert one == other
    east = [report_of(m, 0, ORIGIN, SMALL_AIRCRAFT).intruder.p_n[0] - 1000.0 for _, m in one]
    assert len(east) == 3001
    assert 19.0 < np.std(east) < 21.0
