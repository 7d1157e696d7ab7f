"""How near other aircraft came."""

import numpy as np
import pytest

from vfguide.results.traffic_results import finely


def test_nothing_fast_is_overlooked():
    time, p_n = finely(np.arange(3) * 0.2, np.arange(9.0).reshape(3, 3))
    assert np.diff(time) == pytest.approx(np.full(20, 0.02))
    assert p_n[10] == pytest.approx([3.0, 4.0, 5.0])
