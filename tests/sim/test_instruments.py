"""Errors of measurement have the size that is asked for; failures and resets come when they do."""

import math

import numpy as np
import pytest

from vfguide.earth.pressure_altitude import pressure_altitude
from vfguide.geometry.units import DEG
from vfguide.link.messages import ScaledPressure, WindCov
from vfguide.sim.autopilot.autopilot import silent_streams
from vfguide.sim.autopilot.estimate import Estimator
from vfguide.sim.autopilot.instruments import EXACT, AirspeedFault, Errors, Instruments, Reset
from vfguide.sim.autopilot.noise import Drift, RateNoise, StateNoise, normals
from vfguide.sim.condition import Weather
from vfguide.sim.truth import Truth

ERRORS = Errors(
    *(2.0, 1.0, 50.0, 0.1, 0.5 * DEG, 0.5 * DEG, 1.0 * DEG, 1.5 * DEG),
    *(0.3 * DEG, 0.1 * DEG, 0.3, 0.7, 0.5),
)
INNER = (0.1, 0.2, 0.3, 0.05, 0.01, 25.0, 1.2)


def truth(time, north=0.0):
    return Truth(
        time=time,
        latitude=47.4 * DEG + north / 6_371_000.0,
        longitude=8.5 * DEG,
        altitude=600.0,
        v_n=(20.0, 15.0, 0.0),
        roll=0.1,
        pitch=0.05,
        yaw=0.6,
        omega_b=(0.01, 0.02, 0.03),
        airspeed=25.0,
        alpha=0.05,
        beta=0.0,
        wind_n=(3.0, -4.0, 0.0),
        force_b=(0.0, 0.0, -9.8),
        density=1.15,
        height_above_ground=110.0,
    )


def estimates(instruments, times):
    estimator = Estimator(truth(0.0), instruments)
    return [estimator.update(truth(time)) for time in times]


@pytest.mark.parametrize("time", [0.5, 5.0])
def test_a_drift_keeps_its_size_and_forgets_at_its_time(time):
    drift = Drift(normals(3), 2.0, time)
    values = np.array([drift.step(0.02) for _ in range(200_000)])
    assert values.std() == pytest.approx(2.0, rel=0.1)
    steps = round(time / 0.02)
    kept = np.corrcoef(values[:-steps], values[steps:])[0, 1]
    assert kept == pytest.approx(math.exp(-1.0), abs=0.08)


def test_over_many_seeds_every_error_has_its_size():
    seen = []
    for seed in range(400):
        error = StateNoise(ERRORS, seed).step(0.02)
        seen.append((*error.p_n, *error.v_n, *error.euler, error.airspeed, *error.wind_n[:2]))
    tilt, yaw = math.hypot(0.5, 0.5) * DEG, math.hypot(1.0, 1.5) * DEG
    sizes = (2.0, 2.0, 1.0, 0.1, 0.1, 0.1, tilt, tilt, yaw, math.hypot(0.3, 0.7), 0.5, 0.5)
    assert np.std(seen, axis=0) == pytest.approx(sizes, rel=0.15)
    assert np.abs(np.mean(seen, axis=0) / sizes).max() < 0.2


def test_body_rates_and_airspeed_of_the_inner_loop_are_measured():
    noise = RateNoise(ERRORS, 5)
    rows = np.array([noise.measure(INNER, 0.4) for _ in range(20_000)])
    off = rows - INNER
    assert off[:, :3].std(axis=0) == pytest.approx((0.3 * DEG,) * 3, rel=0.05)
    assert np.abs(off[:, :3].mean(axis=0)).max() < 0.4 * DEG
    assert off[:, 5] == pytest.approx(0.4)
    assert not off[:, [3, 4, 6]].any()


def test_without_errors_the_estimate_is_the_truth():
    (found,) = estimates(EXACT, [0.02])
    assert (found.v_n, found.euler, found.omega_b) == (
        (20.0, 15.0, 0.0),
        (0.1, 0.05, 0.6),
        (0.01, 0.02, 0.03),
    )
    assert found.true_airspeed == 25.0
    assert found.p_l == (0.0, 0.0, 0.0)


@pytest.mark.parametrize(
    ("fault", "told"),
    [(AirspeedFault.MISSING, math.nan), (AirspeedFault.FROZEN, 1.0), (AirspeedFault.BLOCKED, 0.0)],
)
def test_an_airspeed_sensor_fails_at_its_time_and_the_autopilot_flies_on(fault, told):
    its = Instruments(airspeed_fails=1.0, airspeed_fault=fault)
    before, after = estimates(its, [0.98, 1.0])
    assert before.calibrated_airspeed > 20.0
    assert after.calibrated_airspeed == pytest.approx(
        told * before.calibrated_airspeed, nan_ok=True
    )
    assert after.true_airspeed == pytest.approx(math.hypot(17.0, 19.0))


def test_a_reset_of_the_position_is_one_of_the_estimate():
    its = Instruments(resets=(Reset(1.0, (30.0, -40.0, 5.0), (0.0, 0.0, 0.0)),))
    before, after = estimates(its, [0.98, 1.0])
    assert np.subtract(after.p_l, before.p_l) == pytest.approx((30.0, -40.0, 5.0), abs=1e-3)
    assert after.altitude == 595.0


def test_a_reset_of_the_origin_leaves_the_vehicle_where_it_is():
    its = Instruments(resets=(Reset(1.0, (0.0, 0.0, 0.0), (30.0, -40.0, 5.0)),))
    estimator = Estimator(truth(0.0), its)
    before = estimator.update(truth(0.98))
    after = estimator.update(truth(1.0))
    assert np.subtract(after.p_l, before.p_l) == pytest.approx((-30.0, 40.0, -5.0), abs=1e-3)
    assert after[1:4] == before[1:4]
    assert estimator.home.altitude == 600.0
    assert estimator.origin.altitude == 595.0


def test_the_wind_changes_linearly_with_time_and_height():
    weather = Weather(
        (10.0, 0.0, 0.0),
        changes=((10.0, (20.0, 0.0, 0.0)), (20.0, (20.0, -8.0, 0.0))),
        shear_n=(0.02, 0.0, 0.0),
        shear_height=100.0,
    )
    assert weather.varies
    assert not Weather((10.0, 0.0, 0.0)).varies
    expected = {0.0: (10.0, 0.0), 5.0: (15.0, 0.0), 10.0: (20.0, 0.0), 15.0: (20.0, -4.0)}
    for time, wind in {**expected, 20.0: (20.0, -8.0), 99.0: (20.0, -8.0)}.items():
        assert weather.wind_at(time, 100.0)[:2] == pytest.approx(wind)
        assert weather.wind_at(time, 150.0)[:2] == pytest.approx((wind[0] + 1.0, wind[1]))


@pytest.mark.parametrize("qnh", [95_000.0, 101_325.0, 104_300.0])
def test_the_pressure_follows_that_of_the_day(qnh):
    """By the definition of QNH an altimeter that is set to it shows the altitude."""
    estimator = Estimator(truth(0.0), Instruments(qnh=qnh))
    shown = estimator.pressure_altitude - pressure_altitude(qnh)
    assert shown == pytest.approx(truth(0.0).altitude)


def test_streams_that_an_autopilot_does_not_have():
    assert silent_streams(EXACT) == frozenset()
    assert silent_streams(EXACT._replace(tells_pressure=False)) == {ScaledPressure.MSGID}
    assert silent_streams(EXACT._replace(tells_wind=False)) == {WindCov.MSGID}
