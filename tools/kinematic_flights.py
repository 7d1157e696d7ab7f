"""Flights of the paper's robots without files or logs: for tables of thousands of them."""

from dataclasses import dataclass

import numpy as np

from vfguide.field.goal_frame import GoalFrame
from vfguide.field.obstacle import Rows
from vfguide.field.robots import Spacing
from vfguide.field.swarm_control import PaperGains, Swarm, fly_paper_law
from vfguide.geometry.vector import Matrices, Series, Vectors
from vfguide.kernels.rows import columns
from vfguide.sim.kinematic import Bodies, Commands, advance

DT = 0.02
"""Between two evaluations of the law [s], as in a run."""
ARRIVED = 0.05
"""[m], as in a run."""
GAINS = PaperGains(0.25, 3.5, DT)


@dataclass(frozen=True)
class Flight:
    """N robots, from their starts until all stand or the time is over."""

    p_n: Vectors
    """(T, N, 3) [m]."""
    R_nb: Matrices
    """(T, N, 3, 3)."""
    standing: np.ndarray
    """(N,) whether each is at its goal."""

    def headings(self, goals: Rows) -> Series:
        """Angles between body x and the goal's direction at the end, (N,) [rad]."""
        nose, wanted = self.R_nb[-1, :, :, 0], columns(GoalFrame, goals).R_ng[:, :, 0]
        cosine = np.sum(nose * wanted, axis=1)
        return np.arctan2(np.linalg.norm(np.cross(nose, wanted), axis=1), cosine)


def fly(
    goals: Rows,
    start: Bodies,
    obstacles: Rows,
    spacing: Spacing | None = None,
    seconds: float = 120.0,
    gains: PaperGains = GAINS,
    arrived: float = ARRIVED,
) -> Flight:
    """Law `paper` and the kinematic plant, exactly as a run flies them.

    `goals` are of `goal_rows`, N rows; the order of the robots is that of their priority. Nearer
    than `arrived` to its goal [m] a robot stands still.
    """
    ends = columns(GoalFrame, goals).p_n
    bodies, moving = start, np.ones(len(goals), bool)
    path = [bodies]
    for step in range(round(seconds / gains.dt)):
        swarm = Swarm(bodies.p_n, bodies.R_nb, moving)
        speed, omega = fly_paper_law(goals, swarm, step * gains.dt, obstacles, spacing, gains)
        bodies = advance(bodies, Commands(speed, omega), gains.dt)
        path.append(bodies)
        moving &= np.linalg.norm(bodies.p_n - ends, axis=1) > arrived
        if not moving.any():
            break
    p_n = np.array([at.p_n for at in path])
    return Flight(p_n, np.array([at.R_nb for at in path]), ~moving)
