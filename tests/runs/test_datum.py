"""One datum of altitudes, mean sea level, at places where the ellipsoid is somewhere else."""

import pytest
from altered import fly_altered

from vfguide.link.messages import GlobalPositionInt, GpsGlobalOrigin, GpsRawInt, VfrHud

GOAL_ALTITUDE = 618.0
SCENARIO = f"""
name = "datum"
duration_s = 60
[origin]
latitude_deg = 60.1
longitude_deg = -8.2
altitude_m = 480.0
[[vehicle]]
id = 1
position_m = [-400.0, -250.0, -110.0]
heading_deg = 20.0
[[vehicle.goal]]
latitude_deg = 60.1
longitude_deg = -8.2
altitude_m = {GOAL_ALTITUDE}
heading_deg = 70.0
"""


class Spy:
    """Tells everything on, and keeps what was told of altitudes."""

    def __init__(self):
        self.origin, self.hud, self.place, self.satellites = [], [], [], []

    def __call__(self, _, message):
        match message:
            case GpsGlobalOrigin():
                self.origin.append(message.altitude * 1e-3)
            case VfrHud():
                self.hud.append(message.alt)
            case GlobalPositionInt():
                self.place.append(message.alt * 1e-3)
            case GpsRawInt():
                self.satellites.append((message.alt * 1e-3, message.alt_ellipsoid * 1e-3))
        return [message]


@pytest.mark.parametrize("undulation", [-106.0, -0.5, 0.0, 47.4, 85.0])
def test_a_goal_above_sea_level_is_passed_there_whatever_the_undulation(tmp_path, undulation):
    scenario, spy = tmp_path / "datum.toml", Spy()
    scenario.write_text(SCENARIO)
    changes = (f"origin.undulation_m={undulation}",)
    flight = fly_altered(tmp_path, spy, *changes, scenario=scenario)
    goal = flight.result.vehicles[0].goals[0]
    assert goal.reached
    assert goal.miss_m < 1.0
    nearest = abs(flight.record.time - goal.time_s).argmin()
    assert flight.record.altitude[nearest] == pytest.approx(GOAL_ALTITUDE, abs=1.0)
    assert spy.origin[0] == pytest.approx(590.0, abs=0.1)
    for told in (spy.hud, spy.place, [above_sea for above_sea, _ in spy.satellites]):
        assert told[0] == pytest.approx(590.0, abs=0.5)
    apart = [ellipsoid - above_sea for above_sea, ellipsoid in spy.satellites]
    assert apart == pytest.approx([undulation] * len(apart), abs=2e-3)


@pytest.mark.parametrize("undulation", [-106.0, 47.4])
def test_only_the_altitude_above_the_ellipsoid_is_told_otherwise(tmp_path, undulation):
    paths = []
    for value in (0.0, undulation):
        folder = tmp_path / str(value)
        folder.mkdir()
        changes = (f"origin.undulation_m={value}", "duration_s=20")
        paths.append(fly_altered(folder, Spy(), *changes).record.p_n)
    assert (paths[0] == paths[1]).all()
