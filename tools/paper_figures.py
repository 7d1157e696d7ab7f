#!/usr/bin/env python3
"""The figures of the paper, from this program's field and its flights of the examples.

python tools/paper_figures.py --out DIR

Those in `docs/images` come from here.
"""

import argparse
from collections.abc import Callable, Iterator
from functools import cache
from io import BytesIO
from pathlib import Path

import paper_examples as examples
import paper_field as field
from matplotlib.figure import Figure
from PIL import Image, ImageOps

from vfguide.report.drawing import Flights, to_png

MARGIN = 16
"""Width of the white margin around a picture [pixels]; chosen."""
FIELD: dict[str, Callable[[Figure], None]] = {
    "coordinates": field.draw_coordinates,
    "field-plane": field.draw_plane,
    "field-curves": field.draw_curves,
    "obstacle-surface": field.draw_surface,
    "four-robots": field.draw_robots,
}
EXAMPLES: dict[str, tuple[str, Callable[[Figure, Flights], None]]] = {
    "example-1-paths": ("paper/example-1", examples.draw_paths),
    "example-1-histories": ("paper/example-1", examples.draw_histories),
    "example-2": ("paper/example-2", examples.draw_projections),
    "example-3": ("paper/example-3", examples.draw_projections),
    "example-3-distances": ("paper/example-3", examples.draw_distances),
}


def pictures() -> Iterator[tuple[str, bytes]]:
    """The name and the PNG of every figure."""
    fly = cache(examples.fly)
    for name, draw in FIELD.items():
        yield name, to_png(lambda figure, _, draw=draw: draw(figure), None)
    for name, (scenario, draw) in EXAMPLES.items():
        yield name, to_png(draw, fly(scenario))


def smaller(png: bytes) -> bytes:
    """The picture without wide margins, in 128 colours: a third of the bytes."""
    picture = Image.open(BytesIO(png)).convert("RGB")
    shown = picture.crop(ImageOps.invert(picture).getbbox())
    packed = BytesIO()
    ImageOps.expand(shown, MARGIN, "white").quantize(128).save(packed, "png", optimize=True)
    return packed.getvalue()


def main() -> None:
    """Draw all figures and write them."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=Path, required=True)
    out = parser.parse_args().out
    out.mkdir(parents=True, exist_ok=True)
    for name, png in pictures():
        (out / f"paper-{name}.png").write_bytes(smaller(png))


if __name__ == "__main__":
    main()
