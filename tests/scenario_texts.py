"""Texts of scenario files for the tests."""

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
BOX = '\n[[obstacle]]\nname = "{name}"\nshape = "box"\nposition_m = {at}\nsize_m = {size}\n'
SQUARE = "polygon_m = [[-900, -900], [-900, 900], [900, 900], [900, -900]]"
"""Of a zone of a fence."""


def box(at: list[float], size: list[float], more: str = "") -> str:
    return BOX.format(name="shed", at=at, size=size) + more
