"""Phases of a leg: a state machine that chooses between the laws of `course_laws`.

    NEW -> (OUTBOUND ->) ON_PATH -> FIELD

A leg starts as `leg_start.begin_leg` decides. From the last turn of its path the paper's field is
captured. A leg that cannot go on as it is becomes NEW and is planned again.
"""

from vfguide.aircraft.performance import Gains
from vfguide.kernels.compiled import compiled
from vfguide.paths.course_laws import Course, PlanarState, field_course
from vfguide.paths.field_capture import off_field, rolls_out, stays_in_field, takes_up_field
from vfguide.paths.leg import FIELD, NEW, ON_PATH, OUTBOUND, Leg, before_end, in_phase
from vfguide.paths.leg_start import Paths, begin_leg, start_here
from vfguide.paths.path_progress import (
    PathProgress,
    along,
    beside,
    leads_straight_on,
    path_course,
    path_left,
)

OFF_PATH = 0.5
"""Distance beside its path above which a leg is planned anew [turn radii]; chosen."""
BREAK_OFF = 0.9
"""Share of the path length that the change of height takes: a path with less of it left is planned
anew; chosen."""


@compiled
def fly_leg(leg: Leg, at: PlanarState, paths: Paths, gains: Gains) -> Leg:
    """The leg after one step, with the phase that is flown now.

    Args:
        leg: the leg at the step before.
        at: the vehicle in the plane of the goal frame.
        paths: lengths of path that the rest of the change of height takes.
        gains: gains of the guidance.
    """
    entry = before_end(leg, at)
    after = go_on(leg, entry)
    if after.phase == NEW:
        return begin_leg(after, at, paths, gains)
    if after.phase == OUTBOUND:
        return start_here(after, at, paths.needed, gains).leg
    left_to_fly = entry_course(after, entry, leg.radius).remaining
    if after.phase == FIELD:
        left_to_fly += leg.radius * off_field(entry)
    if BREAK_OFF * (paths.needed - leg.final_approach) > left_to_fly > 2.0 * leg.radius:
        return begin_leg(in_phase(leg, NEW, leg.progress), at, paths, gains)
    return after


@compiled
def leg_course(leg: Leg, at: PlanarState, core: float) -> Course:
    """Course of the present phase, relative to the goal's, and the path length to the goal.

    `core` is that of `field_course` [m].
    """
    toward = entry_course(leg, before_end(leg, at), core)
    return Course(toward.chi, toward.chi_rate, toward.remaining + leg.final_approach)


@compiled
def entry_course(leg: Leg, at: PlanarState, core: float) -> Course:
    """Course of the present phase, and the path length to the start of the final approach.

    That start is the origin here. In phase OUTBOUND the path counts as one radius long, so that
    height is changed as steeply as allowed.
    """
    if leg.phase == ON_PATH:
        return path_course(leg.progress, at)
    if leg.phase == OUTBOUND:
        return Course(leg.outbound, 0.0, leg.radius)
    return field_course(at, core)


@compiled
def go_on(leg: Leg, entry: PlanarState) -> Leg:
    """The leg in the phase that follows; NEW where it cannot go on as it is."""
    if leg.phase == FIELD:
        leads_on = stays_in_field(leg, entry) and entry.x < leg.final_approach
        return in_phase(leg, FIELD if leads_on else NEW, leg.progress)
    if leg.phase == ON_PATH:
        progress = along(leg.progress, entry)
        return in_phase(leg, phase_after(leg, progress, entry), progress)
    return leg


@compiled
def phase_after(leg: Leg, progress: PathProgress, entry: PlanarState) -> int:
    """The phase that follows on a path, with the progress along it."""
    left = path_left(progress)
    captures = leads_straight_on(progress) and takes_up_field(leg, entry)
    if captures or rolls_out(leg, entry, left):
        return FIELD
    strays = beside(progress, entry) >= OFF_PATH * leg.radius
    return NEW if left <= 0.0 or strays else ON_PATH
