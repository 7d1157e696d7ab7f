"""Scenario files, analytic flights and their records for the tests of this folder."""

from collections.abc import Callable
from pathlib import Path

import numpy as np

from vfguide.results.record import Array, FlightRecord
from vfguide.scenario.load import LoadedScenario, load_scenario
from vfguide.scenario.resolved import Vehicle

MINIMAL = """\
name = "minimal"

[[vehicle]]
id = 1
position_m = [-500, 0, -100]

[[vehicle.goal]]
position_m = [0, 0, -100]
heading_deg = 0
"""

SECOND = """
[[vehicle]]
id = 2
position_m = [-500, 200, -100]

[[vehicle.goal]]
position_m = [0, 200, -100]
heading_deg = 0
"""

Path3 = Callable[[Array], Array]
"""Positions (n, 3) at times (n,)."""


def loaded_from(
    folder: Path, text: str = MINIMAL, overrides: tuple[str, ...] = ()
) -> LoadedScenario:
    file = folder / "x.toml"
    file.write_text(text)
    return load_scenario(file, overrides)


def spiral(time: Array) -> Array:
    """A climbing right-hand spiral of 90 m radius that ends in a straight line."""
    angle = 25.0 / 90.0 * time
    return np.column_stack(
        (90.0 * np.sin(angle), 90.0 * (1.0 - np.cos(angle)), -100.0 - 1.5 * time)
    )


def straight(time: Array) -> Array:
    """North at 25 m/s, through (0, 0, -100) after 20 s."""
    return np.column_stack((25.0 * (time - 20.0), 0.0 * time, 0.0 * time - 100.0))


def moved(path: Path3, by: tuple[float, float, float]) -> Path3:
    """The same path elsewhere."""
    return lambda time: path(time) + np.array(by)


def record_of(
    vehicle: Vehicle, path: Path3, seconds: float, rate: float = 50.0, height: float = 0.0
) -> FlightRecord:
    """The flight along `path`: velocities and attitude from its derivatives."""
    time = np.arange(round(seconds * rate) + 1) / rate
    step = 1e-4
    p_n = path(time)
    v_n = (path(time + step) - path(time - step)) / (2.0 * step)
    a_n = (path(time + step) - 2.0 * p_n + path(time - step)) / step**2
    yaw = np.arctan2(v_n[:, 1], v_n[:, 0])
    pitch = np.arctan2(-v_n[:, 2], np.hypot(v_n[:, 0], v_n[:, 1]))
    sideways = a_n[:, 1] * np.cos(yaw) - a_n[:, 0] * np.sin(yaw)
    roll = np.arctan2(sideways, 9.80665)
    turn = sideways / 25.0
    omega_b = np.column_stack((0.0 * time, turn * np.sin(roll), turn * np.cos(roll)))
    wanted = omega_b + 0.05 * np.sin(time)[:, None]
    wanted[:3] = np.nan
    return FlightRecord(
        vehicle=vehicle,
        time=time,
        p_n=p_n,
        v_n=v_n,
        euler=np.column_stack((roll, pitch, yaw)),
        omega_b=omega_b,
        omega_wanted_b=wanted,
        thrust=0.3 + 0.1 * np.sin(time),
        airspeed=25.0 + 0.4 * np.sin(0.7 * time),
        load_factor=1.0 / np.cos(roll),
        wind_n=np.zeros_like(p_n),
        altitude=488.0 - p_n[:, 2],
        height_above_ground=height - p_n[:, 2],
        setpoints=len(time),
    )
