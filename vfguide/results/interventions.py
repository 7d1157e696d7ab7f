"""Interventions of the run-time assurance: when it acted, why, and against which hazard."""

import math
from collections import Counter
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from vfguide.assurance.decision import Reason
from vfguide.results.record import Decisions, FlightRecord
from vfguide.scenario.resolved import Scenario

APART = 1.0
"""Longest time for which guidance is followed within one intervention [s]; chosen: after a longer
time another intervention begins."""


@dataclass(frozen=True)
class Intervention:
    """A time in which the command of guidance was not followed, as result.json has it."""

    from_s: float
    """Time of its first sample since the start of the run."""
    to_s: float
    """Time of the first sample after it."""
    reason: Literal["escape", "least bad"]
    """Whether something was clear in all its samples ("escape"), or nothing was in some."""
    hazard: str | None
    """The hazard that the command would have met in most of its samples; None: none is known."""


@dataclass(frozen=True)
class AssuranceResult:
    """What the assurance did in a flight, counted in samples, as result.json has it."""

    decided: int
    """Number of samples in which it decided."""
    escape: int
    """Number of samples in which it flew an escape that was clear."""
    least_bad: int
    """Number of samples in which nothing was clear."""
    acting_share: float | None
    """Share of the samples in which it did not follow guidance; None: it never decided."""
    min_margin_m: float | None
    """Least clearance along the escapes that it found, at most its margin; None: none is known."""
    episodes: tuple[Intervention, ...]


def assurance_of(scenario: Scenario, record: FlightRecord) -> AssuranceResult | None:
    """What the assurance did in a flight; None where there was nothing to keep clear of."""
    if record.decisions is None:
        return None
    reason, margin, conflict, _ = record.decisions
    decided = (reason > 0.0) | ~(conflict == 0.0)  # all zero before the first decision
    count, acting = int(decided.sum()), int((reason > 0.0).sum())
    least = float(np.fmin.reduce(margin[decided], initial=math.inf))
    return AssuranceResult(
        decided=count,
        escape=int((reason == Reason.RECOVERY).sum()),
        least_bad=int((reason == Reason.BEST_EFFORT).sum()),
        acting_share=round(acting / count, 6) if count else None,
        min_margin_m=round(least, 6) if math.isfinite(least) else None,
        episodes=interventions_of(scenario, record),
    )


def interventions_of(scenario: Scenario, record: FlightRecord) -> tuple[Intervention, ...]:
    """The interventions of a flight; those no more than `APART` from each other count as one."""
    decisions = record.decisions
    if decisions is None:
        return ()
    acting = np.flatnonzero(decisions.reason > 0.0)
    new = np.flatnonzero(np.diff(record.time[acting]) > APART) + 1
    each = [each for each in np.split(acting, new) if each.size]
    return tuple(_intervention(scenario, record, decisions, each) for each in each)


def _intervention(
    scenario: Scenario, record: FlightRecord, decisions: Decisions, samples: NDArray[np.intp]
) -> Intervention:
    step = float(record.time[1] - record.time[0]) if len(record.time) > 1 else 0.0
    first, last = samples[0], samples[-1]
    names = [
        hazard_name(scenario, int(hazard), float(-record.p_n[sample, 2]))
        for sample, hazard in zip(samples, decisions.hazard[samples], strict=True)
    ]
    known = Counter(name for name in names if name is not None).most_common(1)
    bad = (decisions.reason[samples] == Reason.BEST_EFFORT).any()
    return Intervention(
        from_s=round(float(record.time[first]), 6),
        to_s=round(float(record.time[last]) + step, 6),
        reason="least bad" if bad else "escape",
        hazard=next((name for name, _ in known), None),
    )


def hazard_name(scenario: Scenario, number: int, height: float) -> str | None:
    """The name of a hazard by its number; None where it is negative, for no hazard.

    Floor and ceiling have one number: the one nearer to `height`, above the origin [m], is named.
    """
    obstacles, fence = scenario.obstacles, scenario.fence
    if number < 0:
        return None
    if number < len(obstacles):
        return obstacles[number].name
    number -= len(obstacles)
    if number < len(fence.zone):
        return f"fence.zone[{number}]"
    if number > len(fence.zone):
        return "traffic"
    to_floor = math.inf if fence.floor_m is None else height - fence.floor_m
    to_ceiling = math.inf if fence.ceiling_m is None else fence.ceiling_m - height
    return "fence.floor_m" if to_floor <= to_ceiling else "fence.ceiling_m"
