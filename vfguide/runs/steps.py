"""The compiled steps that a flight calls; a study may replace one, as by a timed one."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from vfguide.field.swarm_control import fly_paper_law
from vfguide.loop.rows import step_body, step_measured


@dataclass(frozen=True)
class Steps:
    """The functions that are called at each update."""

    measured: Callable[..., Any] = step_measured
    """The control loop on a measurement of an autopilot."""
    body: Callable[..., Any] = step_body
    """The control loop for a rigid body."""
    paper: Callable[..., Any] = fly_paper_law
    """The paper's own closed loop for a swarm of rigid bodies."""


STEPS = Steps()
"""The compiled steps of the product, unchanged."""
