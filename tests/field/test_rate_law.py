import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from vfguide.field.rate_law import rate_law
from vfguide.geometry.so3 import IDENTITY, exp, log
from vfguide.geometry.vector import Vec3, matmul, matvec, norm, scale, sub, transpose, unit

K_W = 2.0
DURATION = 2.0
STEPS = 800
STILL: Vec3 = (0.0, 0.0, 0.0)
TURNING: Vec3 = (0.4, -0.3, 0.2)
AXIS = unit((1.0, 2.0, -2.0))

components = st.floats(-1.0, 1.0)
rates = st.tuples(components, components, components)
rotations = rates.map(lambda w: exp(scale(3.0, w)))


def error_angle(R_na, R_nb):
    return norm(log(matmul(transpose(R_na), R_nb)))


def follow(R_nb, Omega_a):
    """Integrate R' = R Omega^ (midpoint on SO(3)) behind a reference that turns steadily.

    Returns the error angles, (STEPS + 1,).
    """
    dt = DURATION / STEPS
    R_na, half = IDENTITY, exp(scale(0.5 * dt, Omega_a))
    errors = [error_angle(R_na, R_nb)]
    for _ in range(STEPS):
        middle = matmul(R_nb, exp(scale(0.5 * dt, rate_law(R_nb, R_na, Omega_a, K_W))))
        R_na = matmul(R_na, half)
        R_nb = matmul(R_nb, exp(scale(dt, rate_law(middle, R_na, Omega_a, K_W))))
        R_na = matmul(R_na, half)
        errors.append(error_angle(R_na, R_nb))
    return np.array(errors)


@pytest.mark.parametrize("Omega_a", [STILL, TURNING])
@pytest.mark.parametrize(
    "angle", [0.1, 1.5, 3.0, math.pi - 1e-3, math.pi - 1e-9, math.pi - 1e-15, math.pi]
)
def test_the_error_decays_as_lemma_4_says(angle, Omega_a):
    errors = follow(exp(scale(angle, AXIS)), Omega_a)
    times = np.linspace(0.0, DURATION, STEPS + 1)
    np.testing.assert_allclose(errors, angle * np.exp(-K_W * times), rtol=1e-4)


@given(rotations, rates)
def test_without_an_error_the_body_turns_as_the_reference_does(R, Omega_a):
    assert rate_law(R, R, Omega_a, K_W) == pytest.approx(Omega_a, abs=1e-14)


@given(rotations, rotations, rates)
def test_feed_forward_and_feedback(R_nb, R_na, Omega_a):
    R_ab = matmul(transpose(R_na), R_nb)
    feed_forward = matvec(transpose(R_ab), Omega_a)
    feedback = sub(rate_law(R_nb, R_na, Omega_a, K_W), feed_forward)
    assert feedback == pytest.approx(scale(-K_W, log(R_ab)), abs=1e-13)


@given(rotations, rotations, rotations, rates)
def test_body_rates_do_not_depend_on_the_frame_of_the_world(turn, R_nb, R_na, Omega_a):
    here = rate_law(R_nb, R_na, Omega_a, K_W)
    there = rate_law(matmul(turn, R_nb), matmul(turn, R_na), Omega_a, K_W)
    if error_angle(R_na, R_nb) < math.pi - 1e-6:
        assert there == pytest.approx(here, abs=1e-8)


def test_rates_stay_bounded_at_a_half_turn():
    assert norm(rate_law(exp(scale(math.pi, AXIS)), IDENTITY, STILL, K_W)) == pytest.approx(
        K_W * math.pi, rel=1e-14
    )
