"""The compiled steps that a flight calls; a study may put a stopwatch round one."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from vfguide.field.swarm_control import fly_paper_law
from vfguide.loop.rows import step_body, step_measured


@dataclass(frozen=True)
class Steps:
    """What flies a scenario at each update."""

    measured: Callable[..., Any] = step_measured
    """The loop for what an autopilot told."""
    body: Callable[..., Any] = step_body
    """The loop for a rigid body."""
    paper: Callable[..., Any] = fly_paper_law
    """The paper's own closed loop for a swarm of rigid bodies."""


STEPS = Steps()
"""The steps as they are."""
