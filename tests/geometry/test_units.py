import math

import pytest
from scipy import constants

from vfguide.geometry import units

SCIPY = {
    "DEG": constants.degree,
    "NM": constants.nautical_mile,
    "FT": constants.foot,
    "KT": constants.knot,
    "LB": constants.lb,
    "LBF": constants.lbf,
    "SLUG": constants.slug,
    "G0": constants.g,
    "MINUTE": constants.minute,
    "HOUR": constants.hour,
    "SLUG_FT2": constants.slug * constants.foot**2,
    "SLUG_FT3": constants.slug / constants.foot**3,
    "KM": constants.kilo,
    "MM": constants.milli,
    "CM_S": constants.centi,
    "MS": constants.milli,
    "US": constants.micro,
    "HPA": constants.hecto,
    "PERCENT": constants.centi,
    "MILLI_G": constants.g * constants.milli,
    "CDEG": constants.degree / 100.0,
    "DEG_E7": constants.degree * 1e-7,
}


def test_every_factor_has_an_oracle():
    names = {name for name, value in vars(units).items() if isinstance(value, float)}
    assert names == set(SCIPY)


@pytest.mark.parametrize("name", SCIPY)
def test_factor_is_scipys(name):
    assert getattr(units, name) == pytest.approx(SCIPY[name], rel=1e-15)


def test_how_a_factor_is_used():
    half_turn, latitude = 180.0 * units.DEG, 473977420 * units.DEG_E7
    assert half_turn == pytest.approx(math.pi)
    assert latitude == pytest.approx(math.radians(47.397742), abs=1e-15)
    assert round(488.25 / units.MM) == 488250


def test_the_suffix_of_a_key_tells_its_unit():
    assert units.in_si("yaw_bias_deg", 180.0) == ("yaw_bias", math.pi)
    assert units.in_si("velocity_mps", 0.1) == ("velocity", 0.1)
    with pytest.raises(KeyError):
        units.in_si("height_ft", 1.0)
