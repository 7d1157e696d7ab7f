"""Plants, laws and obstacles in scenario files: what is taken, what is refused, in which words."""

from pathlib import Path

import numpy as np
import pytest
from scenario_samples import loaded_from, message_for

from vfguide.field.obstacle_arrays import levels
from vfguide.files.obstacle_entry import SIZES
from vfguide.geometry.shapes.shape import SHAPES
from vfguide.preflight.load import load_scenario
from vfguide.scenario.obstacles import rows_of

PAPER = """\
name = "paper"
plant = "kinematic"
law = "paper"

[[vehicle]]
id = 1
position_m = [-100, 0, 0]

[[vehicle.goal]]
position_m = [0, 0, 0]
heading_deg = 0

"""
FLIGHT = PAPER.replace('law = "paper"\n', "")
VALUES = {
    "radius_m": "radius_m = 4",
    "height_m": "height_m = 12",
    "semi_axes_m": "semi_axes_m = [4, 5, 6]",
    "exponents": "exponents = [1, 2, 3.5]",
    "size_m": "size_m = [8, 10, 12]",
}


def obstacle(*lines: str, shape: str = "sphere", at: str = "[-50, 0, 0]") -> str:
    return "\n".join(["[[obstacle]]", f'shape = "{shape}"', f"position_m = {at}", *lines, ""])


def sized(shape: str, *lines: str, at: str = "[-50, 0, 0]") -> str:
    return obstacle(*(VALUES[key] for key in SIZES[shape]), *lines, shape=shape, at=at)


def test_every_shape_of_the_field_can_be_written() -> None:
    assert set(SIZES) == set(SHAPES)


@pytest.mark.parametrize("shape", SIZES)
def test_every_shape_with_its_sizes_and_no_other(tmp_path: Path, shape: str) -> None:
    scenario = loaded_from(tmp_path, PAPER + sized(shape)).scenario
    assert levels(np.array((-50.0, 0.0, 0.0)), 0.0, rows_of(scenario.obstacles)) < 1.0
    article = "an" if shape == "ellipsoid" else "a"
    needs = " and ".join(SIZES[shape])
    for key in SIZES[shape]:
        text = PAPER + sized(shape).replace(VALUES[key] + "\n", "")
        assert message_for(tmp_path, text) == (
            f"obstacle[0].{key}: missing, {article} {shape} needs {needs}"
        )
    for key in set(VALUES) - set(SIZES[shape]):
        message = message_for(tmp_path, PAPER + sized(shape, VALUES[key]))
        assert message.startswith(f"obstacle[0].{key} = ")
        assert message.endswith(f": not a size of {article} {shape}, allowed {needs}")


@pytest.mark.parametrize(
    ("shape", "on_surface"),
    [
        ("sphere", (4.0, 0.0, 0.0)),
        ("ellipsoid", (0.0, 5.0, 0.0)),
        ("superquadric", (0.0, 0.0, 6.0)),
        ("box", (4.0, 0.0, 0.0)),
        ("cylinder", (0.0, 0.0, -6.0)),
        ("cone", (0.0, 0.0, 6.0)),
    ],
)
def test_sizes_are_those_of_the_surface(
    tmp_path: Path, shape: str, on_surface: tuple[float, float, float]
) -> None:
    text = PAPER + sized(shape, "heading_deg = 90", "velocity_mps = [1, 2, 3]")
    rows = rows_of(loaded_from(tmp_path, text).scenario.obstacles)
    north, east, down = on_surface
    p_n = np.array((-50.0 - east + 2.0, north + 4.0, down + 6.0))
    assert levels(p_n, 2.0, rows) == pytest.approx(1.0, abs=1e-9)


def test_defaults(tmp_path: Path) -> None:
    text = PAPER + sized("sphere") + sized("box", 'name = "b"', at="[-50, 40, 0]")
    changes = ("avoidance.detection_range_m=77",)
    first, second = loaded_from(tmp_path, text, changes).scenario.obstacles
    assert (first.name, second.name) == ("0", "b")
    assert (first.heading_deg, first.velocity_mps) == (0.0, (0.0, 0.0, 0.0))
    assert (first.reactive_level, first.visible_from_m) == (4.0, 77.0)


def test_obstacles_and_attitudes_survive_being_resolved(tmp_path: Path) -> None:
    text = PAPER.replace("id = 1", "id = 1\nattitude_deg = [10, -20.5, 359]")
    text += "".join(
        sized(shape, f'name = "the {shape}"', "visible_from_m = 12.5", at=f"[-50, {40 * i}, 30]")
        for i, shape in enumerate(SIZES)
    )
    scenario = loaded_from(tmp_path, text).scenario
    resolved = tmp_path / "resolved.toml"
    resolved.write_text(scenario.to_toml())
    assert load_scenario(resolved).scenario == scenario
    assert load_scenario(resolved).scenario.to_toml() == scenario.to_toml()
    assert scenario.vehicles[0].attitude_deg == (10.0, -20.5, 359.0)


def test_values_of_an_obstacle_can_be_set(tmp_path: Path) -> None:
    text = PAPER + sized("sphere")
    (its,) = loaded_from(
        tmp_path, text, ("obstacle.0.radius_m=7.5", "obstacle[0].velocity_mps=[0, 1, 0]")
    ).scenario.obstacles
    assert (its.radius_m, its.velocity_mps) == (7.5, (0.0, 1.0, 0.0))
    assert loaded_from(tmp_path, text, ("obstacle=[]",)).scenario.obstacles == ()
    file = tmp_path / "x.toml"
    assert message_for(tmp_path, text, "obstacle.0.size_m=[1, 2, 3]") == (
        f"{file}, --set obstacle.0.size_m=[1, 2, 3]: obstacle[0].size_m = [1.0, 2.0, 3.0]: "
        "not a size of a sphere, allowed radius_m"
    )
    assert message_for(tmp_path, text, "obstacle.1.radius_m=3") == (
        f"{file}, --set obstacle.1.radius_m=3: 1 is no index here, allowed 0 to 0"
    )


def test_what_moves_may_come_over_a_goal_and_start_over_it(tmp_path: Path) -> None:
    moving = sized("sphere", "velocity_mps = [0, 0, 1]", at="[1, 0, 0]")
    assert len(loaded_from(tmp_path, PAPER + moving).scenario.obstacles) == 1


@pytest.mark.parametrize(
    ("text", "message"),
    [
        # Plant and law.
        (
            PAPER.replace("kinematic", "jsbsim").replace("id = 1", "id = 1\nidentify = true"),
            "vehicle[0].identify = true: "
            'only law = "flight" flies a test flight, allowed here false',
        ),
        (
            FLIGHT + sized("sphere"),
            'obstacle: law = "flight" avoids them on plant = "jsbsim" only, '
            'allowed with law = "paper"',
        ),
        (
            PAPER.replace('"kinematic"', '"kinematics"'),
            'plant = "kinematics": unknown, did you mean kinematic?; allowed "jsbsim", "kinematic"',
        ),
        (
            PAPER.replace('law = "paper"', "law = 3"),
            'law = 3: unknown; allowed "flight", "field", "paper"',
        ),
        # Attitudes.
        (
            FLIGHT.replace("kinematic", "jsbsim").replace(
                "id = 1", "id = 1\nattitude_deg = [0, 0, 9]"
            ),
            "vehicle[0].attitude_deg = [0.0, 0.0, 9.0]: "
            'only plant = "kinematic" starts in any attitude, allowed is heading_deg',
        ),
        (
            PAPER.replace("id = 1", "id = 1\nheading_deg = 0\nattitude_deg = [0, 0, 9]"),
            "vehicle[0].attitude_deg = [0.0, 0.0, 9.0]: "
            "not allowed beside heading_deg, its third number is the heading",
        ),
        (
            PAPER.replace("id = 1", "id = 1\nattitude_deg = [0, 9]"),
            "vehicle[0].attitude_deg = [0, 9]: 2 values, a list of three numbers is required",
        ),
        (
            PAPER.replace("id = 1", "id = 1\nattitude_deg = [0, 400, 9]"),
            "vehicle[0].attitude_deg[1] = 400: too large, allowed -360 to 360",
        ),
        # Wind.
        (
            PAPER.replace("[[vehicle]]", "[wind]\nspeed_mps = 3\n\n[[vehicle]]"),
            'wind.speed_mps = 3.0: plant = "kinematic" has no wind, allowed 0',
        ),
        (
            FLIGHT.replace("[[vehicle]]", '[wind]\nturbulence = "light"\n\n[[vehicle]]'),
            'wind.turbulence = "light": plant = "kinematic" has no wind, allowed "none"',
        ),
        # Obstacles.
        (PAPER + "[[obstacle]]\nradius_m = 3", "obstacle[0].shape: missing, but required"),
        (
            PAPER + obstacle("radius_m = 3").replace("position_m = [-50, 0, 0]\n", ""),
            "obstacle[0].position_m: missing, but required",
        ),
        (
            PAPER + sized("sphere").replace("sphere", "spere"),
            'obstacle[0].shape = "spere": unknown, did you mean sphere?; allowed "sphere", '
            '"ellipsoid", "superquadric", "cylinder", "box", "cone"',
        ),
        (
            PAPER + sized("sphere", "radius = 3"),
            "obstacle[0].radius: unknown key, did you mean radius_m?; allowed: name, shape, "
            "position_m, radius_m, height_m, semi_axes_m, exponents, size_m, heading_deg, "
            "velocity_mps, reactive_level, visible_from_m",
        ),
        (
            PAPER + obstacle("radius_m = 0"),
            "obstacle[0].radius_m = 0: too small, allowed above 0, up to 10000",
        ),
        (
            PAPER + obstacle("size_m = [1, -2, 3]", shape="box"),
            "obstacle[0].size_m = [1, -2, 3]: out of range, allowed above 0, up to 10000 each",
        ),
        (
            PAPER + sized("superquadric").replace("[1, 2, 3.5]", "[1, 0.99, 3.5]"),
            "obstacle[0].exponents = [1, 0.99, 3.5]: out of range, allowed 1 to 50 each",
        ),
        (
            PAPER + sized("sphere", "velocity_mps = [0, 0, 1001]"),
            "obstacle[0].velocity_mps = [0, 0, 1001]: out of range, allowed -1000 to 1000 each",
        ),
        (
            PAPER + sized("sphere", "reactive_level = 1.0"),
            "obstacle[0].reactive_level = 1.0: too small, allowed above 1, up to 1000000",
        ),
        (
            PAPER + sized("sphere", "visible_from_m = 0.0"),
            "obstacle[0].visible_from_m = 0.0: too small, allowed above 0, up to 100000",
        ),
        (
            PAPER + sized("sphere", 'name = ""'),
            'obstacle[0].name = "": allowed are 1 to 100 printable characters',
        ),
        (
            PAPER + sized("sphere", 'name = "a\\nb"'),
            'obstacle[0].name = "a\\nb": allowed are 1 to 100 printable characters',
        ),
        (
            PAPER + sized("sphere", 'name = "a"') + sized("box", 'name = "a"', at="[-50, 9, 0]"),
            'obstacle[1].name = "a": already the name of obstacle[0], each needs its own',
        ),
        (
            PAPER + sized("sphere", 'name = "1"') + sized("box", at="[-50, 9, 0]"),
            'obstacle[1].name = "1": already the name of obstacle[0], each needs its own',
        ),
        (
            PAPER + sized("sphere", 'name = "rock"', at="[-97, 0, 0]"),
            "vehicle[0].position_m = [-100.0, 0.0, 0.0]: "
            'inside obstacle "rock", allowed outside its surface',
        ),
        (
            PAPER + sized("sphere", "velocity_mps = [0, 9, 0]", at="[-100, 0, 4]"),
            "vehicle[0].position_m = [-100.0, 0.0, 0.0]: "
            'inside obstacle "0", allowed outside its surface',
        ),
        (
            PAPER + sized("sphere", "velocity_mps = [9, 0, 0]") + sized("box", at="[3, 0, 0]"),
            "vehicle[0].goal[0] = [0.0, 0.0, 0.0]: "
            'inside obstacle "1", allowed outside its surface',
        ),
    ],
)
def test_message(tmp_path: Path, text: str, message: str) -> None:
    assert message_for(tmp_path, text) == message


def test_law_paper_flies_on_either_plant(tmp_path: Path) -> None:
    text = PAPER.replace("[-100, 0, 0]", "[-100, 0, -100]").replace("[0, 0, 0]", "[0, 0, -100]")
    for plant in ("kinematic", "jsbsim"):
        loaded = loaded_from(tmp_path, text.replace("kinematic", plant))
        assert (loaded.scenario.law, loaded.scenario.plant) == ("paper", plant)


def test_the_kinematic_plant_has_no_ground_and_takes_no_notice_of_aircraft(tmp_path: Path) -> None:
    text = PAPER.replace("id = 1", 'id = 1\naircraft = "nobody"\nairspeed_mps = 3')
    vehicle = loaded_from(tmp_path, text.replace("[0, 0, 0]", "[0, 0, 50]")).scenario.vehicles[0]
    assert vehicle.goals[0].position_m == (0.0, 0.0, 50.0)
    assert vehicle.airspeed_mps == 3.0
    assert loaded_from(tmp_path, PAPER).scenario.vehicles[0].airspeed_mps == 25.0
