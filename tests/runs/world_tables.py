"""Scenarios that tests write as tables."""

import tomli_w

from vfguide.preflight.load import load_scenario


def northward(name, **hazards):
    """One aircraft on its way 900 m to the north, and what it meets there."""
    vehicle = {
        "id": 1,
        "position_m": [0.0, 0.0, -150.0],
        "goal": [{"position_m": [900.0, 0.0, -150.0], "heading_deg": 0.0}],
    }
    return {"name": name, "vehicle": [vehicle], **hazards}


def world_file(table, folder):
    path = folder / "world.toml"
    path.write_text(tomli_w.dumps(table))
    return path


def loaded_from(table, folder):
    return load_scenario(world_file(table, folder))
