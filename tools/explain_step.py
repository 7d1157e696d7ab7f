#!/usr/bin/env python3
"""What the companion knew and decided at one step of a flight, from its log.

    python tools/explain_step.py results/vehicle-1.tlog --at 12

Replays the log up to a time, from its first frame, and prints what the operator could read until
then and what the step left: every branch of `LoopState` by its names, in SI units and radians. The
command was replaced by an escape where `assurance.decision.reason` is not NOMINAL; `hazard` and
`conflict` say what it would have come to, and after how many seconds. Scenario times begin a
moment after the first frame of the log: what `result.json` says of 12 s may be found at 12.3. The
first run compiles for a minute or two.
"""

import argparse
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from vfguide.assurance.decision import Decision, Reason
from vfguide.cli.replay import only_vehicle, open_log
from vfguide.companion.plan import Plan
from vfguide.estimation.local_frame import Measurement
from vfguide.loop.rows import step_measured
from vfguide.loop.state import state_of_row
from vfguide.preflight.load import load_scenario
from vfguide.replay.compare import Replay
from vfguide.scenario.plans import plan_of, vehicle_of


def main() -> None:
    """Print what the companion knew and decided at one step."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("log", type=Path, help="vehicle-ID.tlog")
    parser.add_argument("--at", type=float, required=True, help="time since the first frame [s]")
    parser.add_argument("--scenario", help="what was flown [default: scenario.toml beside the log]")
    parser.add_argument("--vehicle", type=int, help="[default: the only one in the log]")
    args = parser.parse_args()
    reader = open_log(args.log)
    loaded = load_scenario(args.scenario or str(args.log.parent / "scenario.toml"), [])
    sysid = args.vehicle if args.vehicle is not None else only_vehicle(args.log, reader)
    plan = plan_of(loaded, vehicle_of(loaded.scenario, sysid))
    for line in explained(reader, sysid, plan, args.at):
        print(line)


def explained(log: Any, sysid: int, plan: Plan, at: float) -> Iterator[str]:
    """The notes until a time [s] since the first frame, then the last step until then."""
    steps: list[tuple[Any, Any]] = []

    def noted(measured: Any, *known: Any) -> Any:
        after = step_measured(measured, *known)
        steps.append((measured, after))
        return after

    replay = Replay(sysid, plan, lambda _, __: None, noted)
    first = None
    for time, frame in log:
        first = time if first is None else first
        if (since := (time - first) / 1e6) > at:
            break
        replay.compare([(time, frame)])
        for note in replay.companion.news():
            yield f"{since:8.2f} s  {note}"
    if not steps:
        yield f"no step until {at} s"
        return
    measured, (omega_b, thrust, _, row, _) = steps[-1]
    yield from tree("measured", Measurement(*measured))
    yield f"setpoint: omega_b {shown(omega_b)}, thrust {shown(thrust)}"
    state = state_of_row(row)
    yield f"decision: {decided(state.assurance.decision, plan)}"
    yield from tree("state", state)


def decided(decision: Decision, plan: Plan) -> str:
    """A decision of the assurance in words."""
    reason = Reason(int(decision.reason))
    if reason is Reason.NOMINAL:
        return "NOMINAL, the command is flown"
    hazard, names = int(decision.hazard), plan.hazard_names
    what = "nothing" if hazard < 0 else names[hazard] if hazard < len(names) else "traffic"
    return f"{reason.name}, the command would come to {what} in {decision.conflict:.1f} s"


def tree(name: str, value: Any, depth: int = 0) -> Iterator[str]:
    """The lines of a record and of the records in it, one field each."""
    if not hasattr(value, "_fields"):
        yield f"{'  ' * depth}{name}: {shown(value)}"
        return
    yield f"{'  ' * depth}{name}:"
    for field, part in zip(value._fields, value, strict=True):
        yield from tree(field, part, depth + 1)


def shown(value: Any) -> str:
    """A number, an array or a tuple with six digits."""
    if isinstance(value, (tuple, np.ndarray)):
        return f"({', '.join(shown(part) for part in value)})"
    return f"{value:.6g}"


if __name__ == "__main__":
    main()
