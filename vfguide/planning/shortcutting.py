"""Shortens a way: leaves out via poses, and slides those that are left."""

import math

import numpy as np

from vfguide.airspace.keep_out import Outlines, read_outline
from vfguide.airspace.planar_clearance import NOTHING
from vfguide.geometry.compiled import compiled
from vfguide.paths.edge import HOP_COLUMNS, Hop, Hops, hop_in, hop_row, next_word, way_length
from vfguide.paths.path_progress import Pose
from vfguide.planning.collision_check import Demand, Task, check_hop

SLIDES = 0.3, 0.1
"""How far via poses are slid [radii, and rad]."""
WORTH = 0.5
"""What is changed saves at least this [m]."""


@compiled
def shortened(hazards: Outlines, task: Task, demand: Demand, hops: Hops) -> Hops:
    """The way without the via poses that it needs not, and the others slid where it is shorter."""
    i = 1
    while i < len(hops):
        trial = without(task, hops, i)
        better = is_better(hazards, task, demand, trial, hops, i - 1, i)
        hops = trial if better else hops
        i += 0 if better else 1
    for size in SLIDES:
        for i in range(1, len(hops)):
            hops = slid(hazards, task, demand, hops, i, size)
    return hops


@compiled
def slid(hazards: Outlines, task: Task, demand: Demand, hops: Hops, i: int, size: float) -> Hops:
    """The way with the beginning of hop `i` slid to the sides, along the course and turned."""
    for side in (1.0, -1.0):
        for k in range(3):
            x, y, course = hop_in(hops, i).begin
            across = side * size * task.radius if k == 0 else 0.0
            along = side * size * task.radius if k == 1 else 0.0
            c, s = math.cos(course), math.sin(course)
            turned = course + (side * size if k == 2 else 0.0)
            there = Pose(x + along * c - across * s, y + along * s + across * c, turned)
            trial = through(task, hops, i, there)
            if is_better(hazards, task, demand, trial, hops, i - 1, i + 1):
                hops = trial
    return hops


@compiled
def is_better(
    hazards: Outlines, task: Task, demand: Demand, trial: Hops, hops: Hops, first: int, last: int
) -> bool:
    """Whether a way is shorter than another and clear; only hops `first` to `last` are new."""
    saved = way_length(hops, task.radius) - way_length(trial, task.radius)
    if not saved > WORTH:
        return False
    if moves(hazards):
        first, last = 0, len(trial)
    t = task.t
    for i in range(first, last):
        found = check_hop(hazards, task, demand, hop_in(trial, i), t)
        if found.blocker != NOTHING:
            return False
        t = found.t
    return True


@compiled
def moves(hazards: Outlines) -> bool:
    """Whether it matters when one is where."""
    for i in range(len(hazards.table)):
        outline = read_outline(hazards.table[i])
        if outline.speed > 0.0 or outline.since > -math.inf:
            return True
    return False


@compiled
def end_of(task: Task, hops: Hops, i: int) -> Pose:
    """Where hop `i` ends."""
    return hop_in(hops, i + 1).begin if i + 1 < len(hops) else task.goal


@compiled
def hop_between(begin: Pose, end: Pose, radius: float) -> Hop:
    """The shortest hop."""
    return Hop(begin, next_word(begin, end, radius, -1.0))


@compiled
def without(task: Task, hops: Hops, i: int) -> Hops:
    """The way straight from the beginning of the hop before `i` to the end of hop `i`."""
    trial = np.empty((len(hops) - 1, HOP_COLUMNS))
    trial[: i - 1], trial[i:] = hops[: i - 1], hops[i + 1 :]
    begin = hop_in(hops, i - 1).begin
    trial[i - 1] = hop_row(hop_between(begin, end_of(task, hops, i), task.radius))
    return trial


@compiled
def through(task: Task, hops: Hops, i: int, via: Pose) -> Hops:
    """The way with the beginning of hop `i` elsewhere."""
    trial = hops.copy()
    begin, end = hop_in(hops, i - 1).begin, end_of(task, hops, i)
    trial[i - 1] = hop_row(hop_between(begin, via, task.radius))
    trial[i] = hop_row(hop_between(via, end, task.radius))
    return trial
