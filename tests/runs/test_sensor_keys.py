"""From the keys of a scenario to what an autopilot measures with."""

import pytest

from vfguide.files.simulation_entry import Sensors
from vfguide.geometry.units import DEG
from vfguide.runs.instruments import errors_from


def test_every_error_has_its_key_and_its_unit():
    errors = errors_from(Sensors(drift_s=50.0, attitude_deg=2.0, rate_bias_dps=3.0))
    assert (errors.drift, errors.position) == (50.0, 1.5)
    assert errors.attitude == pytest.approx(2.0 * DEG)
    assert errors.rate_bias == pytest.approx(3.0 * DEG)
    assert len(errors) == len(Sensors.model_fields)
