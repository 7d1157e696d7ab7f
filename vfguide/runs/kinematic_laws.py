"""The laws that steer the rigid bodies of plant `kinematic`: `paper` or `flight`."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Protocol

import numpy as np

from vfguide.annunciations.goal_announcement import announcement, is_passed
from vfguide.field.goal_frame import GoalFrame
from vfguide.field.robots import Spacing
from vfguide.field.swarm_control import PaperGains, Swarm
from vfguide.geometry.vector import Vectors
from vfguide.kernels.rows import row_of, width
from vfguide.loop.state import fresh_state, row_of_state
from vfguide.results.announced_legs import AnnouncedLegs
from vfguide.results.arrivals import Arrivals
from vfguide.runs.steps import STEPS, Steps
from vfguide.scenario.loaded import LoadedScenario
from vfguide.scenario.obstacles import rows_of
from vfguide.scenario.plans import frame_of, plan_of
from vfguide.scenario.resolved import Scenario, Vehicle
from vfguide.sim.kinematic import Bodies, Commands


class KinematicLaw(Protocol):
    """Steers all bodies, in the order of their ids."""

    def steer(self, time: float, bodies: Bodies) -> Commands:
        """What drives the bodies from `time` [s] until the next update."""
        ...

    def courses(self, bodies: Bodies) -> Vectors:
        """(N, 3) vectors that point along the courses: velocities, where the bodies never stop."""
        ...


class PaperKinematicLaw:
    """Law `paper`: one closed loop for the whole swarm, a smaller id has priority.

    The present goal of a robot is that of its legs, since its state is known exactly.
    """

    def __init__(self, scenario: Scenario, legs: Sequence[Arrivals], steps: Steps = STEPS) -> None:
        guidance, avoidance = scenario.guidance, scenario.avoidance
        self._legs = legs
        self._step = steps.paper
        self._obstacles = rows_of(scenario.obstacles)
        self._gains = PaperGains(guidance.k_v, guidance.k_w, 1.0 / guidance.rate_hz)
        self._spacing = None
        if avoidance.between_vehicles:
            self._spacing = Spacing(avoidance.safety_radius_m, avoidance.detection_range_m)
        self._flown_to = [-1] * len(legs)
        self._goals = np.zeros((len(legs), width(GoalFrame)))

    def courses(self, bodies: Bodies) -> Vectors:
        """The directions of the noses: a robot at rest has a course too."""
        return bodies.R_nb[:, :, 0]

    def steer(self, time: float, bodies: Bodies) -> Commands:
        """Eq. (2)'s inputs, by Theorem 1 and Lemma 4 on the composite field."""
        moving = np.array([not legs.standing for legs in self._legs])
        for row, legs in enumerate(self._legs):
            if moving[row] and self._flown_to[row] != legs.leg:
                self._flown_to[row] = legs.leg
                self._goals[row] = row_of(frame_of(legs.goals[legs.leg]))
        swarm = Swarm(bodies.p_n, bodies.R_nb, moving)
        return Commands(
            *self._step(self._goals, swarm, time, self._obstacles, self._spacing, self._gains)
        )


class FlightKinematicLaw:
    """Law `flight`: every body flies its own route at its airspeed.

    It announces no misses: a body knows where it is.
    """

    def __init__(
        self,
        loaded: LoadedScenario,
        vehicles: Sequence[Vehicle],
        legs: Sequence[AnnouncedLegs],
        steps: Steps = STEPS,
    ) -> None:
        self._step, self._legs = steps.body, legs
        plans = [plan_of(loaded, vehicle) for vehicle in vehicles]
        self._plans = [replace(plan, is_rigid_body=True) for plan in plans]
        self._states = [row_of_state(fresh_state()) for _ in vehicles]
        self._speed = np.array([plan.gains.airspeed for plan in self._plans])

    def courses(self, bodies: Bodies) -> Vectors:
        """The velocities."""
        return self._speed[:, None] * bodies.R_nb[:, :, 0]

    def steer(self, time: float, bodies: Bodies) -> Commands:
        """The wanted airspeeds, and body rates towards the wanted directions of flight."""
        omega_b = np.empty_like(bodies.p_n)
        for i, plan in enumerate(self._plans):
            before = self._states[i]
            omega_b[i], self._states[i], miss = self._step(
                time,
                bodies.p_n[i],
                bodies.R_nb[i],
                before,
                plan.legs,
                plan.law,
                plan.vehicle_row,
            )
            if is_passed(before, self._states[i]):
                self._legs[i].announce(announcement(before, self._states[i], miss))
        return Commands(self._speed, omega_b)
