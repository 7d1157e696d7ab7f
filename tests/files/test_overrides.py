"""`--set key=value`."""

import pytest

from vfguide.files.errors import InputError
from vfguide.files.overrides import parse_override


@pytest.mark.parametrize(
    ("text", "location", "value"),
    [
        ("guidance.k_w=3", ("guidance", "k_w"), 3),
        ("vehicle.0.heading_deg=90.5", ("vehicle", 0, "heading_deg"), 90.5),
        ("vehicle[0].goal[1].heading_deg = 90", ("vehicle", 0, "goal", 1, "heading_deg"), 90),
        ("avoidance.between_vehicles=false", ("avoidance", "between_vehicles"), False),
        ("vehicle.0.position_m=[1, 2, -3]", ("vehicle", 0, "position_m"), [1, 2, -3]),
        ("wind.turbulence=light", ("wind", "turbulence"), "light"),
        ('wind.turbulence="light"', ("wind", "turbulence"), "light"),
        ("name=a=b", ("name",), "a=b"),
        ("name=1\nseed = 2", ("name",), "1\nseed = 2"),
    ],
)
def test_values_are_toml_and_bare_words_are_strings(
    text: str, location: tuple[int | str, ...], value: object
) -> None:
    override = parse_override(text)
    assert override.location == location
    assert override.value == value
    assert type(override.value) is type(value)


@pytest.mark.parametrize("text", ["seed", "=3", "a..b=3", "a.=3"])
def test_what_is_no_override(text: str) -> None:
    with pytest.raises(InputError) as error:
        parse_override(text)
    allowed = "allowed is key=value, such as vehicle.0.heading_deg=90"
    assert str(error.value) == f"--set {text}: {allowed}"
