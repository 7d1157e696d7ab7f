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
"""Time between two evaluations of the law [s], as in a run."""
ARRIVED = 0.05
"""Distance from its goal at which a robot has arrived [m], as in a run."""
GAINS = PaperGains(0.25, 3.5, DT)


@dataclass(frozen=True)
class Flight:
    """The flight of N robots, from their starts until all are at rest or the time is over."""

    p_n: Vectors
    """(T, N, 3) positions, NED [m]."""
    R_nb: Matrices
    """(T, N, 3, 3) attitudes, body FRD to NED."""
    standing: np.ndarray
    """(N,) whether each is at rest at its goal."""

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
    """Fly law `paper` on the kinematic plant, exactly as a run does.

    `goals` are N rows of `goal_rows`; the order of the robots is that of their priority. A robot
    nearer to its goal than `arrived` [m] stays at rest.
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
