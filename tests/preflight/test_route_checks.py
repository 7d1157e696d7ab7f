"""Before the flight: starts without a way out, tight goals, goals that hazards shut in."""

from pathlib import Path

import pytest
from scenario_samples import loaded_from, message_for
from scenario_texts import BOX, MINIMAL, box

HEAD = "[[vehicle]]\nid = 1"
SHUT = "".join(
    BOX.format(name=f"wall {k}", at=at, size=size)
    for k, (at, size) in enumerate(
        (
            ([-250, 0, -100], [20, 600, 300]),
            ([350, 0, -100], [20, 600, 300]),
            ([50, -300, -100], [620, 20, 300]),
            ([50, 300, -100], [620, 20, 300]),
        )
    )
)


def warnings_of(folder: Path, text: str) -> list[str]:
    file = str(folder / "x.toml")
    told = loaded_from(folder, text).warnings
    assert all(warning.startswith(f"{file}: vehicle[0]") for warning in told)
    return [warning.removeprefix(f"{file}: ") for warning in told]


def test_with_room_there_is_nothing_to_say(tmp_path: Path) -> None:
    assert warnings_of(tmp_path, MINIMAL) == []
    assert warnings_of(tmp_path, MINIMAL + box([-250, 0, -100], [40, 40, 300])) == []


def test_a_start_straight_before_a_wall_is_message_for(tmp_path: Path) -> None:
    message = message_for(tmp_path, MINIMAL + box([-470, 0, -100], [20, 600, 400]))
    assert message == (
        "vehicle[0].position_m = [-500.0, 0.0, -100.0]: no escape from here, straight on leads "
        'into "shed"; allowed farther from it, or with another heading_deg'
    )


def test_a_start_beside_a_wall_is_a_warning(tmp_path: Path) -> None:
    (told,) = warnings_of(tmp_path, MINIMAL + box([-400, 15, -100], [200, 12, 400]))
    assert told.startswith("vehicle[0].position_m: begins with an escape from ")


@pytest.mark.parametrize(
    ("text", "told"),
    [
        (
            box([0, 15, -100], [20, 14, 300]),
            'vehicle[0].goal[0]: 8.0 m from "shed" on its straight approach, 0 m before it, '
            "where 12 m are kept; move it away, or turn its course",
        ),
        (
            "[fence]\nfloor_m = 95\n",
            'vehicle[0].goal[0]: 5.0 m from "fence.floor_m" on its straight approach, 0 m before '
            "it, where 12 m are kept; move it away, or turn its course",
        ),
    ],
)
def test_a_tight_goal_is_a_warning(tmp_path: Path, text: str, told: str) -> None:
    assert told in warnings_of(tmp_path, MINIMAL + text)


def test_only_the_last_straight_of_the_approach_counts(tmp_path: Path) -> None:
    assert warnings_of(tmp_path, MINIMAL + box([-120, 22, -100], [20, 14, 300])) == []
    (told,) = warnings_of(tmp_path, MINIMAL + box([-20, 15, -100], [20, 14, 300]))
    assert "8.0 m" in told


def test_a_goal_that_is_shut_in_is_message_for(tmp_path: Path) -> None:
    assert message_for(tmp_path, MINIMAL + SHUT) == (
        "vehicle[0].goal[0] = [0.0, 0.0, -100.0]: enclosed, no route leads there at these heights; "
        "move it, or open a gap"
    )


def test_a_gap_is_enough_to_fly(tmp_path: Path) -> None:
    opened = SHUT.replace("[350, 0, -100]", "[350, 100, -100]")
    assert not any("enclosed" in told for told in warnings_of(tmp_path, MINIMAL + opened))


def test_walls_that_fly_away_shut_nothing_in(tmp_path: Path) -> None:
    moving = SHUT.replace("size_m", "velocity_mps = [0, 0, -1]\nsize_m")
    assert warnings_of(tmp_path, MINIMAL + moving) == []


def test_walls_below_the_heights_that_are_flown_shut_nothing_in(tmp_path: Path) -> None:
    low = SHUT.replace("-100]", "-20]").replace("300]\n", "60]\n")
    assert warnings_of(tmp_path, MINIMAL + low) == []


FAR = "visible_from_m = 2000\n"
CORRIDOR = """
[fence]
floor_m = 20
ceiling_m = {ceiling}
[[fence.zone]]
kind = "include"
polygon_m = [[-1800, -200], [1400, -200], [1400, 200], [-1800, 200]]
"""


@pytest.mark.parametrize(
    ("ceiling", "seen", "told"),
    [(300, FAR, False), (175, FAR, True), (300, "", True)],
)
def test_a_dam_across_a_fence_is_no_hindrance_where_there_is_room_over_it(
    tmp_path: Path, ceiling: int, seen: str, told: bool
) -> None:
    """25 m are kept: 2 of them are missing under the lower ceiling. Seen late it is too near."""
    far = MINIMAL.replace("[-500, 0, -100]", "[-1500, 0, -100]").replace("[0, 0,", "[1000, 0,")
    dam = CORRIDOR.format(ceiling=ceiling) + box([-400, 0, -63.5], [60, 420, 127], seen)
    found = [its for its in warnings_of(tmp_path, far + dam) if "no route there was found" in its]
    assert bool(found) == told


def test_a_dam_that_is_passed_over_is_told_of_where_other_aircraft_forbid_the_climb(
    tmp_path: Path,
) -> None:
    far = MINIMAL.replace("[-500, 0, -100]", "[-1500, 0, -100]").replace("[0, 0,", "[1000, 0,")
    dam = CORRIDOR.format(ceiling=300) + box([-400, 0, -63.5], [60, 420, 127], FAR)
    heard = dam + "[avoidance]\ntraffic = true\n"
    assert not any("leads over" in told for told in warnings_of(tmp_path, far + dam))
    assert any("leads over" in told for told in warnings_of(tmp_path, far + heard))


def test_without_hazards_nothing_is_looked_at(tmp_path: Path) -> None:
    kinematic = MINIMAL.replace(HEAD, f'plant = "kinematic"\n\n{HEAD}')
    assert warnings_of(tmp_path, kinematic) == []
