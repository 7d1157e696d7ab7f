"""The traffic picture: which reports are believed, where they put an aircraft, and for how long."""

import math

import numpy as np
import pytest
from reported import ALL, ORIGIN, said

from vfguide.airspace.fence import fences
from vfguide.airspace.hazards import Hazards, Intruder, traffic_rows
from vfguide.field.obstacle import obstacle_rows
from vfguide.kernels.rows import columns, width
from vfguide.link.boot_time import ROLLOVER
from vfguide.link.enums import AdsbFlags
from vfguide.surveillance.heights import ANY_HEIGHT, HeightDatum
from vfguide.surveillance.picture import LONGEST_SILENCE, MAX_AIRCRAFT, Picture
from vfguide.surveillance.report import (
    ASSUMED_CLIMB,
    ASSUMED_SPEED,
    SMALL_AIRCRAFT,
    Ownship,
    report_of,
)
from vfguide.surveillance.surveillance import MAX_INTRUDERS, Surveillance, rows_of

FAR_AWAY = Ownship(0, (-9000.0, 0.0, -100.0), (25.0, 0.0, 0.0))


def report(message, now_ms=5000):
    return report_of(message, now_ms, ORIGIN, SMALL_AIRCRAFT, HeightDatum(undulation=0.0))


def test_place_and_velocity_in_the_frame_of_the_plan():
    its = report(said())
    assert its.name == "D-EABC"
    assert its.time_ms == 5000
    assert math.dist(its.intruder.p_n, (1000.0, 500.0, -150.0)) < 0.02
    assert its.intruder.v_n == pytest.approx((0.0, 30.0, -2.0), abs=0.01)
    assert its.intruder[2:] == (0.0, *SMALL_AIRCRAFT)


def test_the_age_that_a_report_tells_is_heeded():
    assert report(said(tslc=3)).time_ms == 2000


@pytest.mark.parametrize(
    ("lacking", "radius", "half_height", "uncertainty_rate", "uncertainty_rate_up"),
    [
        (AdsbFlags.VALID_ALTITUDE, 50.0, 30.0 + ANY_HEIGHT, 3.0, 1.5),
        (AdsbFlags.VALID_VELOCITY, 50.0, 30.0, 3.0 + ASSUMED_SPEED, 1.5),
        (AdsbFlags.VALID_HEADING, 50.0, 30.0, 33.0, 1.5),
        (AdsbFlags.VERTICAL_VELOCITY_VALID, 50.0, 30.0, 3.0, 1.5 + ASSUMED_CLIMB),
    ],
)
def test_what_is_not_told_makes_the_volume_larger_or_grow(
    lacking, radius, half_height, uncertainty_rate, uncertainty_rate_up
):
    its = report(said(flags=ALL & ~lacking)).intruder
    assert its[3:] == pytest.approx((radius, half_height, uncertainty_rate, uncertainty_rate_up))


def test_a_velocity_without_a_course_is_none():
    assert report(said(flags=ALL & ~AdsbFlags.VALID_HEADING)).intruder.v_n[:2] == pytest.approx(
        (0.0, 0.0), abs=0.01
    )


def test_without_a_callsign_the_address_is_the_name():
    assert report(said(flags=ALL & ~AdsbFlags.VALID_CALLSIGN)).name == "ABC123"


@pytest.mark.parametrize(
    "changes",
    [
        {"lat": 900_000_001},
        {"lon": -1_800_000_001},
        {"altitude": 31_000_000},
        {"hor_velocity": 50_000},
        {"ver_velocity": -10_001},
        {"heading": 36_001},
        {"flags": ALL & ~AdsbFlags.VALID_COORDS},
    ],
)
def test_what_cannot_be_true_is_refused(changes):
    picture = Picture(ORIGIN, SMALL_AIRCRAFT)
    picture.hear(said(**changes), 5000)
    assert (len(picture), picture.refused) == (0, 1)


def test_a_field_that_is_not_called_valid_may_hold_anything():
    flags = ALL & ~AdsbFlags.VALID_VELOCITY & ~AdsbFlags.VALID_HEADING
    assert report(said(flags=flags, hor_velocity=65_535, heading=65_535)) is not None


def test_the_newest_report_counts():
    picture = Picture(ORIGIN, SMALL_AIRCRAFT)
    picture.hear(said(), 5000)
    picture.hear(said((1000.0, 530.0, -152.0)), 6000)
    picture.hear(said((1000.0, 515.0, -151.0), tslc=5), 6500)
    assert len(picture) == 1
    assert picture.newest(1).time_ms == 6000


def test_a_leap_is_believed_only_when_the_next_report_agrees():
    picture = Picture(ORIGIN, SMALL_AIRCRAFT)
    picture.hear(said(), 5000)
    picture.hear(said((9000.0, 530.0, -152.0)), 6000)
    assert picture.newest(1).time_ms == 5000
    assert [each.number for each in picture.others(FAR_AWAY)] == [1]
    picture.hear(said((9000.0, 560.0, -154.0)), 7000)
    assert {each.number for each in picture.others(FAR_AWAY)} == {1, 2}
    assert picture.newest(2).time_ms == 7000


def test_it_is_forgotten_also_across_the_rollover():
    picture = Picture(ORIGIN, SMALL_AIRCRAFT)
    picture.hear(said(), ROLLOVER - 5000)
    picture.forget(round(1000 * LONGEST_SILENCE) - 5001)
    assert len(picture) == 1
    picture.forget(round(1000 * LONGEST_SILENCE) - 5000)
    assert len(picture) == 0


def test_no_more_than_so_many_are_remembered():
    picture = Picture(ORIGIN, SMALL_AIRCRAFT)
    for icao in range(1, MAX_AIRCRAFT + 50):
        picture.hear(said(icao=icao), 5000)
    assert len(picture) == MAX_AIRCRAFT


def test_the_own_transponder_is_no_traffic():
    picture = Picture(ORIGIN, SMALL_AIRCRAFT, own_icao=0xABC123)
    picture.hear(said(), 5000)
    assert len(picture) == 0


def test_rows_tell_the_time_of_the_report_on_the_clock_of_the_obstacles():
    rows = rows_of([report(said(tslc=2))], 6000, 100.0)
    assert rows.shape == (1, width(Intruder))
    assert columns(Intruder, rows).time == pytest.approx([97.0])


def test_only_the_nearest_in_reach_are_for_the_step():
    seen = Surveillance(Picture(ORIGIN, SMALL_AIRCRAFT))
    assert not seen.is_due(5000)
    for number in range(1, 13):
        seen.hear(said((200.0 * number, 0.0, -150.0), icao=number), 5000)
    own = Ownship(5000, (0.0, 0.0, -150.0), (25.0, 0.0, 0.0))
    assert seen.is_due(5000)
    assert seen.rows(5000, 0.0).shape == (0, width(Intruder))
    seen.look(own)
    assert not seen.is_due(5400)
    assert seen.is_due(5500)
    rows = seen.rows(5000, 0.0)
    assert rows.shape == (MAX_INTRUDERS, width(Intruder))
    nearest = [200.0 * number for number in range(1, MAX_INTRUDERS + 1)]
    norths = columns(Intruder, rows).p_n[:, 0]
    assert norths == pytest.approx(nearest, abs=0.02)  # the wire has 1e-7 deg
    seen.look(FAR_AWAY._replace(time_ms=6000))
    assert seen.rows(6000, 1.0).shape == (0, width(Intruder))


def test_hazards_get_the_others_in_reach_as_traffic_and_stay_themselves_without():
    seen = Surveillance(Picture(ORIGIN, SMALL_AIRCRAFT))
    hazards = Hazards(obstacle_rows([]), traffic_rows([]), fences([]), -math.inf, math.inf)
    assert seen.among(hazards, 5000, 0.0) is hazards
    seen.hear(said(), 5000)
    seen.look(Ownship(5000, (0.0, 0.0, -150.0), (25.0, 0.0, 0.0)))
    among = seen.among(hazards, 5000, 7.0)
    np.testing.assert_array_equal(among.traffic, seen.rows(5000, 7.0))
    assert among.traffic.shape == (1, width(Intruder))
    assert among[2:] == hazards[2:]
    seen.look(FAR_AWAY._replace(time_ms=6000))
    assert seen.among(hazards, 6000, 8.0) is hazards


def test_the_operator_is_told_once_and_again_when_it_is_over():
    seen, told = Surveillance(Picture(ORIGIN, SMALL_AIRCRAFT)), []
    for look in range(60):
        now, t = 500 * look, 0.5 * look
        place = (0.0, 500.0 - 25.0 * t, -150.0)
        seen.hear(said(place, heading=27_000, hor_velocity=2500, ver_velocity=0), now)
        told += seen.look(Ownship(now, (40.0, -500.0 + 25.0 * t, -150.0), (0.0, 25.0, 0.0)))
    assert told == ["traffic D-EABC in 19 s, 40 m", "traffic D-EABC is no conflict any more"]
