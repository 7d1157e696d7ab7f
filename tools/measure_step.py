#!/usr/bin/env python3
"""What one step of the guidance takes among 15 obstacles, searches and assurance included.

    python tools/measure_step.py --runs 10

Flies random fields of 15 obstacles and times every call of the step, processor time; the companion
waits for each of them, so that the largest counts too.
"""

import argparse
import tempfile
import time
from pathlib import Path

import numpy as np
import tomli_w
from flown_worlds import scenario_of

from vfguide.loop.rows import step_measured
from vfguide.preflight.load import load_scenario
from vfguide.runs.lockstep import fly_scenario
from vfguide.runs.steps import Steps

OBSTACLES = 15


def main() -> None:
    """Time the steps of some flights."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--runs", type=int, default=10)
    parser.add_argument("--seed", type=int, default=1)
    args = parser.parse_args()
    took: list[float] = []

    def timed(*arguments):
        begun = time.process_time()
        after = step_measured(*arguments)
        took.append(time.process_time() - begun)
        return after

    number, flown = 0, 0
    while flown < args.runs:
        world, number = scenario_of("field", args.seed, number), number + 1
        if len(world["obstacle"]) != OBSTACLES:
            continue
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "world.toml"
            path.write_text(tomli_w.dumps(world))
            loaded = load_scenario(path)
            if not flown:
                fly_scenario(loaded, Path(folder))
            fly_scenario(loaded, Path(folder), steps=Steps(measured=timed))
        flown += 1
    median, high, most = np.quantile(np.array(took) * 1e6, (0.5, 0.99, 1.0))
    print(f"seed {args.seed}, {flown} flights among {OBSTACLES} obstacles, {len(took)} steps [us]:")
    print(f"median {median:.1f}, 99 % {high:.1f}, most {most:.0f}")


if __name__ == "__main__":
    main()
