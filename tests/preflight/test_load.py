"""Scenarios as they are flown: defaults, and the first of those that are shipped."""

import math
from datetime import UTC, datetime
from pathlib import Path

import pytest
from scenario_samples import loaded_from

from vfguide.preflight.load import load_scenario


def test_defaults_are_those_of_the_documentation(tmp_path: Path) -> None:
    scenario = loaded_from(tmp_path).scenario
    assert scenario.model_dump() == {
        "name": "minimal",
        "plant": "jsbsim",
        "law": "flight",
        "duration_s": 300.0,
        "seed": 1,
        "start_time": datetime(2026, 1, 1, tzinfo=UTC),
        "origin": {
            "latitude_deg": 47.397742,
            "longitude_deg": 8.545594,
            "altitude_m": 488.0,
            "undulation_m": 0.0,
        },
        "wind": {
            "speed_mps": 0.0,
            "from_deg": 0.0,
            "turbulence": "none",
            "shear_mps_per_100m": 0.0,
            "shear_height_m": 100.0,
            "change": [],
        },
        "weather": {"qnh_hpa": 1013.25},
        "sensors": None,
        "autopilot": {
            "airspeed_fails_at_s": None,
            "airspeed_fault": "missing",
            "thrust_scale": 1.0,
            "thrust_sag_per_min": 0.0,
            "thrust_floor": 0.5,
            "wind_message": True,
            "pressure_message": True,
            "reset": [],
        },
        "link": {"delay_ms": 0.0, "delay_back_ms": 0.0},
        "guidance": {
            "rate_hz": 50.0,
            "airspeed_mps": None,
            "bank_max_deg": None,
            "k_w": 3.5,
            "k_v": 1.0,
            "k_lateral": 1.2,
            "k_elevation": 0.5,
            "loiter": "right",
            "loiter_radius_m": None,
            "remedies": None,
        },
        "avoidance": {
            "safety_radius_m": 10.0,
            "detection_range_m": 300.0,
            "between_vehicles": True,
            "traffic": False,
            "traffic_radius_m": 50.0,
            "traffic_half_height_m": 30.0,
            "traffic_growth_mps": 3.0,
            "traffic_growth_up_mps": 1.5,
        },
        "fence": {"floor_m": None, "ceiling_m": None, "zone": []},
        "traffic_receiver": {"range_m": 20_000.0},
        "vehicles": (
            {
                "id": 1,
                "position_m": (-500.0, 0.0, -100.0),
                "heading_deg": 0.0,
                "attitude_deg": None,
                "airspeed_mps": pytest.approx(25.0 * (1.225 / 1.15733) ** 0.5, rel=1e-5),
                "aircraft": "aerosonde",
                "icao": None,
                "identify": False,
                "goals": (
                    {
                        "position_m": (0.0, 0.0, -100.0),
                        "heading_deg": 0.0,
                        "climb_deg": 0.0,
                        "tolerance_m": 5.0,
                        "tolerance_deg": 10.0,
                        "attempts": 0,
                    },
                ),
            },
        ),
        "obstacles": (),
        "traffic": (),
    }


def test_first_flight_needs_a_turn() -> None:
    scenario = load_scenario("first-flight").scenario
    (vehicle,) = scenario.vehicles
    (goal,) = vehicle.goals
    assert 500.0 < math.dist(vehicle.position_m, goal.position_m) < 900.0
    assert abs(goal.heading_deg - vehicle.heading_deg) >= 45.0
    assert scenario.wind.speed_mps == 3.0
