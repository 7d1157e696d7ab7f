import math

import numpy as np
import pytest
from assurance_samples import FLOWN, SMALL, random_field
from flight_states import motion
from hazard_samples import ball, hazards

from vfguide.airspace.fence import Zone
from vfguide.airspace.hazards import (
    Intruder,
    hazard_count,
    hazard_distance,
    hazard_uncertainty_rate,
    traffic_distance,
    traffic_rows,
)
from vfguide.assurance.backup_manoeuvre import (
    MANOEUVRE_KINDS,
    fly_for,
    fly_out,
    manoeuvre,
    remainder,
)
from vfguide.assurance.trajectory_clearance import MAX_UNCERTAINTY, clearance_along
from vfguide.kernels.rows import width

pytestmark = pytest.mark.slow

STEP, WIND = 0.2, (4.0, -3.0, 0.0)


def flown_out(kind, of=FLOWN, at=None, wind_n=WIND):
    track = np.empty((77, 3))
    at = at or motion(bank=-0.3, gamma=0.05)
    fly_out(at, manoeuvre(kind, of.scale), wind_n, of.limits, STEP, track)
    return track


def at_every_point(known, track, uncertainty_rate):
    """Clearances (N, hazards)."""
    return np.array(
        [
            [
                hazard_distance(known, i, tuple(map(float, p)), k * STEP)
                - min(
                    k * STEP * (uncertainty_rate + hazard_uncertainty_rate(known, i)),
                    MAX_UNCERTAINTY,
                )
                for i in range(hazard_count(known))
            ]
            for k, p in enumerate(track)
        ]
    )


def crowded(seed):
    rng = np.random.default_rng(seed)
    intruder = Intruder((300.0, 50.0, -140.0), (-20.0, -3.0, 0.0), -3.0, 50.0, 20.0, 1.0, 0.3)
    zone = Zone(True, ((-300.0, -300.0), (500.0, -250.0), (450.0, 350.0), (-300.0, 200.0)))
    return hazards(random_field(rng), [intruder], [zone], 90.0, 220.0)


@pytest.mark.parametrize("seed", range(10))
@pytest.mark.parametrize("uncertainty_rate", [0.0, 0.5])
def test_nothing_is_missed_between_the_points_looked_at(seed, uncertainty_rate):
    known = crowded(seed)
    for kind in range(MANOEUVRE_KINDS):
        track = flown_out(kind)
        every = at_every_point(known, track, uncertainty_rate)
        seen = clearance_along(known, track, 0.0, STEP, 30.0, uncertainty_rate, 12.0, 1.0, seed)
        lost = np.flatnonzero(every.min(axis=1) < 1.0)
        assert seen.lost == (pytest.approx(lost[0] * STEP) if len(lost) else math.inf)
        if not len(lost):
            assert seen.least == pytest.approx(min(12.0, every.min()))
            assert (seen.hazard >= 0) == (every.min() < 12.0)
        first = clearance_along(known, track, 0.0, STEP, 30.0, uncertainty_rate, 12.0, 12.0, seed)
        assert (first.hazard >= 0) == (every.min() < 12.0)


def test_no_obstacle_no_traffic_no_fence_no_floor():
    seen = clearance_along(hazards(), flown_out(3), 0.0, STEP, 30.0, 0.0, 12.0, 1.0, 0)
    assert seen == (12.0, math.inf, -1)


def test_a_hazard_without_a_number_is_not_clear():
    known = hazards([ball((math.nan, 0.0, 0.0))])
    assert clearance_along(known, flown_out(0), 0.0, STEP, 30.0, 0.0, 12.0, 1.0, 0).lost == 0.0


@pytest.mark.parametrize("of", [FLOWN, SMALL], ids=["aerosonde", "easystar"])
@pytest.mark.parametrize("kind", range(MANOEUVRE_KINDS))
def test_a_track_is_its_steps_one_by_one(kind, of):
    at, plan = motion(bank=-0.3, gamma=0.05), manoeuvre(kind, of.scale)
    for p_n in flown_out(kind, of):
        assert tuple(p_n) == pytest.approx(at.p_n, abs=0.3)
        at, plan = fly_for(at, plan, WIND, of.limits, STEP), remainder(plan, STEP)


def test_manoeuvres_are_all_different():
    assert len({manoeuvre(kind, 1.0) for kind in range(MANOEUVRE_KINDS)}) == MANOEUVRE_KINDS


def test_traffic_grows_with_its_age():
    rows = traffic_rows(
        [Intruder((100.0, 0.0, -100.0), (10.0, 0.0, -1.0), 5.0, 30.0, 10.0, 2.0, 0.5)]
    )
    assert traffic_distance(rows, 0, (0.0, 0.0, -100.0), 5.0) == pytest.approx(70.0)
    assert traffic_distance(rows, 0, (0.0, 0.0, -104.0), 9.0) == pytest.approx(140.0 - 38.0)
    assert traffic_distance(rows, 0, (140.0, 0.0, -154.0), 9.0) == pytest.approx(50.0 - 12.0)
    assert traffic_rows([]).shape == (0, width(Intruder))
