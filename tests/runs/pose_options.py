"""What the tool for tables of poses is asked for."""

from argparse import Namespace


def options(**changes):
    """The options of tools/measure_poses.py with these changes."""
    usual = {
        "aircraft": "aerosonde",
        "scenario": "first-flight",
        "seed": 1,
        "nearest": 100.0,
        "farthest": 1000.0,
        "height": 30.0,
        "wind": 0.0,
        "turbulence": "none",
        "delay_ms": 0.0,
        "sensors": False,
        "no_wind_message": False,
        "no_airspeed": False,
        "set": [],
    }
    return Namespace(**(usual | changes))
