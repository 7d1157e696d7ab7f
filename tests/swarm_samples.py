"""Swarms and their goals."""

import numpy as np
from scipy.spatial.transform import Rotation

from vfguide.field.goal_frame import goal_frame
from vfguide.field.swarm import goal_rows
from vfguide.field.swarm_control import PaperGains, Swarm

GOAL = goal_frame((10.0, -20.0, 5.0), 0.7, 0.3)
GAINS = PaperGains(0.5, 3.5, 0.02)


def swarm_of(p_n, R_nb=None, moving=None):
    p_n = np.array(p_n, float)
    count = len(p_n)
    R_nb = np.tile(np.eye(3), (count, 1, 1)) if R_nb is None else np.ascontiguousarray(R_nb)
    return Swarm(p_n, R_nb, np.ones(count, bool) if moving is None else np.array(moving))


def goals_of(*goals):
    return goal_rows(goals)


def random_attitudes(rng, count):
    return Rotation.from_quat(rng.normal(size=(count, 4))).as_matrix()


def random_swarm(rng, count, reach=150.0):
    return swarm_of(rng.uniform(-reach, reach, (count, 3)), random_attitudes(rng, count))


def angle_between(R, S):
    return Rotation.from_matrix(np.array(R).T @ np.array(S)).magnitude()
