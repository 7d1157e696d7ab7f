"""What the operator is told on a flight among obstacles."""

from pathlib import Path

import pytest

from vfguide.preflight.load import load_scenario
from vfguide.runs.jsbsim_vehicle import JsbsimVehicle
from vfguide.runs.lockstep import fly_scenario


def test_a_flight_among_towers_tells_of_its_way(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    members: list[JsbsimVehicle] = []
    begin = JsbsimVehicle.__init__

    def kept(self: JsbsimVehicle, *arguments: object) -> None:
        members.append(self)
        begin(self, *arguments)

    monkeypatch.setattr(JsbsimVehicle, "__init__", kept)
    fly_scenario(load_scenario("towers"), tmp_path)
    notes = members[-1].companion.news()  # the first warms up
    assert any(note.startswith("a way round: ") for note in notes)
    assert sum(note.startswith(("a way", "escape", "NOTHING")) for note in notes) < 20
