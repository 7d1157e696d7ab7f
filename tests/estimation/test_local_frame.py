"""A state told ahead of its time."""

import math

import numpy as np
import pytest

from vfguide.estimation.local_frame import extrapolated
from vfguide.geometry.so3 import from_euler


@pytest.mark.parametrize("lead", [0.0, 0.02, 0.1, 0.2])
@pytest.mark.parametrize("bank", [0.0, -0.3, 0.8])
def test_a_steady_turn_is_predicted(lead, bank):
    speed, rate = 25.0, 9.80665 * math.tan(bank) / 25.0
    omega_b = (0.0, rate * math.sin(bank), rate * math.cos(bank))
    v_n, R_nb = extrapolated((speed, 0.0, 0.0), from_euler(bank, 0.0, 0.0), omega_b, lead)
    course = rate * lead
    assert v_n == pytest.approx((speed * math.cos(course), speed * math.sin(course), 0.0), abs=0.1)
    np.testing.assert_allclose(R_nb, from_euler(bank, 0.0, course), atol=1e-9)
