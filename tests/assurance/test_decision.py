import math

import numpy as np
import pytest
from assurance_samples import FLOWN, LEVEL, SMALL, decide, random_field
from flight_states import motion
from hazard_samples import ball, hazards
from hypothesis import given
from hypothesis import strategies as st

from vfguide.aircraft.point_mass import PointMass, advance
from vfguide.airspace.fence import Zone
from vfguide.airspace.hazards import Hazards, Intruder
from vfguide.assurance.backup_manoeuvre import Manoeuvre, fly_for, remainder
from vfguide.assurance.decision import BackupManoeuvre, Reason
from vfguide.field.obstacle import Obstacle, obstacle_distance

CLEAR, ESCAPE, BEST_EFFORT = Reason
BANKS, CLIMBS = st.floats(-2.0, 2.0), st.floats(-1.0, 1.0)
STILL = (0.0, 0.0, 0.0)


def within_limits(decision, of=FLOWN):
    limits = of.limits
    return (
        abs(decision.bank) <= limits.bank_max
        and -limits.descent_max <= decision.gamma <= limits.climb_max
    )


def known_field(seed, count=8):
    return hazards(random_field(np.random.default_rng(seed), count))


@given(BANKS, CLIMBS, st.floats(-0.8, 0.8))
def test_in_a_clear_world_it_never_acts(bank, gamma, now):
    decision, backup = decide(motion(bank=now), hazards([ball((2e3, 0, 0))]), (bank, gamma))
    assert decision.reason == CLEAR
    assert backup.acting == 0.0
    assert decision.bank == max(-FLOWN.limits.bank_max, min(FLOWN.limits.bank_max, bank))
    assert decision.gamma == max(-FLOWN.limits.descent_max, min(FLOWN.limits.climb_max, gamma))


def test_without_any_hazard():
    decision, _ = decide(motion(), hazards())
    assert decision == (0.0, 0.0, CLEAR, pytest.approx(FLOWN.margin), math.inf, -1)


@pytest.mark.parametrize("seed", range(60))
def test_what_it_flies_is_within_the_limits_and_always_the_same(seed):
    rng = np.random.default_rng(seed)
    known = known_field(seed)
    at = motion(bank=rng.uniform(-0.8, 0.8), gamma=rng.uniform(-0.1, 0.1))
    wish, gust = (rng.uniform(-0.8, 0.8), rng.uniform(-0.1, 0.1)), rng.uniform(0.0, 3.0)
    first, second = (decide(at, known, wish, gust=gust) for _ in range(2))
    assert first == second
    assert within_limits(first[0])


def test_a_stored_plan_stays_clear_by_the_exact_distance():
    stored_plans = 0
    for seed in range(60):
        known, at, wish = known_field(seed), motion(bank=0.2), (0.3, 0.0)
        decision, backup = decide(at, known, wish)
        if decision.reason == BEST_EFFORT:
            continue
        stored_plans += 1
        plan, t, dt = Manoeuvre(*backup[:3]), 0.0, 0.1
        if decision.reason == CLEAR:
            at, t = advance(at, *wish, STILL, FLOWN.limits, dt), dt
        while t < 15.0:
            for i in range(len(known.obstacles)):
                distance = obstacle_distance(known.obstacles, i, at.p_n, t)
                assert distance >= FLOWN.margin - 1.0
            at, plan, t = fly_for(at, plan, STILL, FLOWN.limits, dt), remainder(plan, dt), t + dt
    assert stored_plans >= 50


@pytest.mark.parametrize("seed", range(40))
@pytest.mark.parametrize("angle", [math.pi / 2.0, math.pi, -2.0])
def test_turning_the_world_turns_the_decision(seed, angle):
    c, s = math.cos(angle), math.sin(angle)

    def turned(a):
        return (c * a[0] - s * a[1], s * a[0] + c * a[1], a[2])

    field, wind_n = list(random_field(np.random.default_rng(seed))), (3.0, 4.0, 0.0)
    other = [Obstacle(o.shape, turned(o.p_n), o.heading + angle, turned(o.v_n)) for o in field]
    at = motion(bank=0.3)
    here, backup = decide(at, hazards(field), (0.5, 0.0), wind_n)
    there, other_stored = decide(
        PointMass(turned(at.p_n), angle, 0.3, 0.0, 25.0), hazards(other), (0.5, 0.0), turned(wind_n)
    )
    assert there[:3] == here[:3]
    assert other_stored == backup


@pytest.mark.parametrize("of", [FLOWN, SMALL], ids=["aerosonde", "easystar"])
@pytest.mark.parametrize("wish", [LEVEL, (0.5, 0.1)])
def test_it_acts_before_a_wall(of, wish):
    speed = 25.0 if of is FLOWN else 11.0
    size = speed * speed / 12.5
    for distance, reasons in ((16.0, {CLEAR}), (0.7, {ESCAPE, BEST_EFFORT})):
        wall = ball((distance * size + 20.0 * size, 0.0, -150.0), 20.0 * size)
        decision, _ = decide(motion(airspeed=speed), hazards([wall]), wish, of=of)
        assert decision.reason in reasons


def test_it_returns_only_with_more_than_the_margin():
    """A straight way that passes a ball at the margin and a metre more."""
    known = hazards([ball((150.0, 40.0 + FLOWN.margin + 1.0, -150.0))])
    tower = [ball((150.0, s * 1e3, -150.0), 1e3 - FLOWN.margin - 1.0) for s in (-1.0, 1.0)]
    for obstacles in (known, hazards(tower)):
        free, _ = decide(motion(), obstacles)
        assert free.reason == CLEAR
    acting, _ = decide(motion(), hazards(tower), backup=BackupManoeuvre(0.0, 0.0, 0.0, 1.0))
    assert acting.reason == ESCAPE


def test_inside_an_obstacle_it_says_so_and_flies_on():
    decision, backup = decide(motion(), hazards([ball((5.0, 10.0, -150.0))]), (0.2, 0.0))
    assert decision.reason == BEST_EFFORT
    assert decision.conflict == 0.0
    assert decision.hazard == 0
    assert decision.margin < 0.0
    assert within_limits(decision)
    assert backup.acting == 1.0


@pytest.mark.parametrize(
    ("at", "wish", "wind_n", "gust"),
    [
        (motion(), (math.nan, math.nan), STILL, 0.0),
        (motion(), LEVEL, (math.nan, math.nan, math.nan), math.nan),
        (motion(), (math.inf, -math.inf), (math.inf, 0.0, 0.0), math.inf),
        (motion(bank=math.nan), LEVEL, STILL, 0.0),
        (motion((math.nan, 0.0, 0.0)), (0.3, math.nan), STILL, 0.0),
        (motion(airspeed=math.nan), LEVEL, STILL, 0.0),
        (motion(airspeed=0.0), LEVEL, STILL, 0.0),
    ],
)
def test_always_finite(at, wish, wind_n, gust):
    known = known_field(3)
    decision, backup = decide(at, known, wish, wind_n, gust)
    assert within_limits(decision)
    assert all(map(math.isfinite, (*backup, decision.bank, decision.gamma, decision.margin)))


def test_a_state_without_a_number_is_said():
    assert decide(motion(bank=math.nan), hazards())[0].reason == BEST_EFFORT


def test_floor_and_ceiling():
    descent, climb = (0.0, -0.17), (0.0, 0.17)
    low, high = motion((0.0, 0.0, -112.3)), motion((0.0, 0.0, -187.7))
    known = hazards(floor=100.0, ceiling=200.0)
    for at, wish, other in ((low, descent, climb), (high, climb, descent)):
        assert decide(at, known, other)[0].reason == CLEAR
        diving = PointMass(at.p_n, 0.0, 0.0, wish[1], 25.0)
        decision, _ = decide(diving, known, wish)
        assert decision.reason != CLEAR
        assert decision.gamma * wish[1] <= 0.0


def test_out_of_the_corner_of_a_fence():
    fence = Zone(True, ((-500.0, -60.0), (80.0, -60.0), (80.0, 400.0), (-500.0, 400.0)))
    decision, _ = decide(motion(), hazards(zones=[fence]))
    assert decision.reason == ESCAPE
    assert decision.bank > 0.5


def test_head_on_traffic():
    intruder = Intruder((190.0, 0.0, -150.0), (-30.0, 0.0, 0.0), 0.0, 60.0, 30.0, 1.0, 0.5)
    decision, _ = decide(motion(), hazards(intruders=[intruder]))
    assert decision.reason != CLEAR
    away = intruder._replace(v_n=(40.0, 0.0, 0.0))
    assert decide(motion(), hazards(intruders=[away]))[0].reason == CLEAR


def test_a_moving_obstacle_is_where_its_clock_says():
    mover = ball((1120.0, 0.0, -150.0), v_n=(-20.0, 0.0, 0.0))
    assert decide(motion(), hazards([mover]), t=0.0)[0].reason == CLEAR
    assert decide(motion(), hazards([mover]), t=50.0)[0].reason != CLEAR


def test_hazards_of_no_length():
    empty = hazards()
    assert isinstance(empty, Hazards)
    assert [len(a) for a in (empty.obstacles, empty.traffic, empty.fences.zones)] == [0, 0, 0]
    assert decide(motion(), empty, of=SMALL)[0].reason == CLEAR
