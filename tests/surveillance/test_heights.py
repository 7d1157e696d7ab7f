"""Heights that others report: the true one is among those that are kept clear of."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from reported import ALL, ORIGIN, said

from vfguide.earth.pressure_altitude import isa_pressure, pressure_altitude
from vfguide.geometry.units import HPA, MM
from vfguide.link.enums import AdsbAltitudeType, AdsbFlags
from vfguide.surveillance.height_difference import FOLLOWING_SPEED, difference_after
from vfguide.surveillance.height_notes import ANSWER_TIME
from vfguide.surveillance.heights import (
    PRESSURE_ERROR,
    HeightDatum,
    height_of,
    offsets,
    pressure_offset,
    weather,
)
from vfguide.surveillance.picture import Picture
from vfguide.surveillance.report import SMALL_AIRCRAFT, report_of

PRESSURE = {"altitude_type": AdsbAltitudeType.PRESSURE_QNH}
altitudes = st.floats(0.0, 3000.0)
qnhs = st.floats(950.0, 1050.0)


def told(altitude, kind=AdsbAltitudeType.GEOMETRIC):
    return said(altitude_type=kind, altitude=round(altitude / MM))


def holds(height, altitude):
    return abs(height.altitude - altitude) <= height.doubt + 0.01


@given(altitudes, altitudes, qnhs, st.booleans(), st.booleans())
def test_a_pressure_altitude_of_either_kind_holds_the_true_one(own, other, qnh, is_qne, is_told):
    """Before, only 20 m up and down were kept clear of: 170 m off is what 20 hPa make."""
    shift = pressure_altitude(qnh * HPA)
    own_offset = pressure_offset(isa_pressure(own + shift), own) if is_told else None
    report = told(other + (shift if is_qne else 0.0), AdsbAltitudeType.PRESSURE_QNH)
    height = height_of(report, HeightDatum(own_offset, 0.0), ORIGIN[2])
    assert holds(height, other)
    if is_told:
        assert height.doubt == pytest.approx(PRESSURE_ERROR + 0.5 * abs(shift), abs=0.01)


@given(altitudes, st.floats(-107.0, 86.0), st.booleans())
def test_a_geometric_height_holds_the_true_one(other, undulation, is_told):
    datum = HeightDatum(None, undulation if is_told else None)
    height = height_of(told(other + undulation), datum, ORIGIN[2])
    assert holds(height, other)
    assert (height.doubt == 0.0) is is_told


@given(altitudes)
def test_weather_makes_less_of_it_than_is_allowed_for(altitude):
    """A column of air 25 K off the standard one at any pressure of the day."""
    least, greatest = weather(altitude)
    for qnh in (950.0, 1013.25, 1050.0):
        for share in (-25.0 / 288.0, 25.0 / 288.0):
            assert least <= pressure_altitude(qnh * HPA) + share * altitude <= greatest


@pytest.mark.parametrize("pressure", [0.0, -5.0, math.nan, math.inf, 300.0 * HPA, 1200.0 * HPA])
def test_a_pressure_that_no_weather_makes_is_none(pressure):
    assert pressure_offset(pressure, 500.0) is None


def test_a_pressure_of_the_day():
    """1033 hPa are 163 m: an altimeter set to 1013 hPa reads so much too little."""
    pressure = isa_pressure(638.0 + pressure_altitude(1033.0 * HPA))
    assert pressure_offset(pressure, 638.0) == pytest.approx(-163.1, abs=0.5)


def test_the_volume_contains_the_doubt():
    report = report_of(said(**PRESSURE), 5000, ORIGIN, SMALL_AIRCRAFT, HeightDatum(-164.0, 0.0))
    assert report.intruder.half_height == pytest.approx(30.0 + PRESSURE_ERROR + 82.0)
    geometric = report_of(said(), 5000, ORIGIN, SMALL_AIRCRAFT, HeightDatum(-164.0, 0.0))
    assert geometric.intruder.p_n[2] - report.intruder.p_n[2] == pytest.approx(82.0, abs=0.1)


def test_zero_is_always_among_the_offsets():
    for offset in (*np.linspace(-300.0, 500.0, 9), None):
        least, greatest = offsets(HeightDatum(offset, 0.0), 500.0)
        assert least <= 0.0 <= greatest


@given(
    st.lists(st.floats(-100.0, 100.0), min_size=1, max_size=40),
    st.integers(0, 39),
    st.floats(-50.0, 50.0),
)
def test_what_was_told_once_stays_among_what_may_be_for_a_minute(told, right, height):
    """Before, the newest of any messages was believed: traffic was put 100 m off by one."""
    known = None
    for k, other in enumerate([*told[:right], height, *told[right:]]):
        known = difference_after(known, other, 5000 + 1500 * k)
        assert known.least <= other <= known.greatest
        since = 1.5 * max(0, k - min(right, len(told)))
        if k >= right:
            off = FOLLOWING_SPEED * since + 1e-6
            assert known.least - off <= height <= known.greatest + off
    assert 0.25 * SMALL_AIRCRAFT.half_height > FOLLOWING_SPEED * 60.0


def test_a_change_that_lasts_is_followed():
    known = difference_after(None, 47.0, 5000)
    for k in range(1, 1000):
        known = difference_after(known, -53.0, 5000 + 1000 * k)
    assert (known.least, known.greatest) == (-53.0, pytest.approx(-52.9))


def heard(messages, datum, interval=1.0):
    picture = Picture(ORIGIN, SMALL_AIRCRAFT)
    return [
        (interval * k, note)
        for k, message in enumerate(messages)
        for note in picture.hear(message, 5000 + round(1000 * interval * k), None, datum)
    ]


@pytest.mark.parametrize(
    ("changes", "words"),
    [(PRESSURE, "tells no pressure"), ({}, "tells no height above the ellipsoid")],
)
def test_heights_that_cannot_be_compared_are_told_once(changes, words):
    notes = heard([said(**changes)] * 60, HeightDatum())
    assert [(t, words in note) for t, note in notes] == [(ANSWER_TIME, True)]
    assert heard([said(**changes)] * 60, HeightDatum(0.0, 0.0)) == []
    flags = ALL & ~AdsbFlags.VALID_ALTITUDE
    assert heard([said(flags=flags, **changes)] * 60, HeightDatum()) == []


def test_what_is_told_of_a_pressure_altitude():
    ((_, note),) = heard([told(600.0, AdsbAltitudeType.PRESSURE_QNH)] * 9, HeightDatum())
    assert note == (
        "the autopilot tells no pressure (SCALED_PRESSURE): traffic that reports a pressure "
        "altitude is kept clear of from 600 m below it to 362 m above"
    )


def test_refused_reports_are_told_once_for_each_reason():
    without_place = said(flags=ALL & ~AdsbFlags.VALID_COORDS)
    fast = said(hor_velocity=60_000)
    notes = heard([without_place, fast] * 5, HeightDatum(0.0, 0.0))
    assert [note for _, note in notes] == [
        "a report of traffic is not used: it has no position",
        "a report of traffic is not used: it cannot be true",
    ]
