"""One vehicle's flight along its plan: when a step is due, and the state between steps."""

import math
from collections.abc import Callable

from vfguide.aircraft.identification import Identified
from vfguide.aircraft.state import RateSetpoint
from vfguide.airspace.detection import Airspace, in_sight, unnested_airspace
from vfguide.airspace.hazards import Hazards
from vfguide.annunciations.flight_notes import progress_notes
from vfguide.annunciations.goal_announcement import GoalAnnouncement, announcement
from vfguide.annunciations.goal_notes import leg_note, passage_note
from vfguide.annunciations.identification_notes import (
    BROKEN_OFF,
    NO_ROOM,
    TESTING,
    identified_notes,
)
from vfguide.annunciations.step_notes import StepAnnunciator
from vfguide.assurance.decision import Reason
from vfguide.companion.identification_flight import IdentificationFlight
from vfguide.companion.obstacle_clock import ObstacleClock
from vfguide.companion.plan import Plan
from vfguide.companion.traffic_watch import TrafficWatch
from vfguide.estimation.air_state import AirReport
from vfguide.estimation.local_frame import Measurement, Quaternion, place_state, without_names
from vfguide.geometry.units import MS
from vfguide.geometry.vector import Vec3
from vfguide.guidance.laws import crossing
from vfguide.kernels.rows import Row
from vfguide.link.messages import AdsbVehicle
from vfguide.loop.attempts import no_attempts
from vfguide.loop.loop_report import (
    Noted,
    air_report,
    decision_of_row,
    goal_of_row,
    noted_numbers,
    number_of_resets,
    trusts_sensor_of_row,
)
from vfguide.loop.rows import step_measured
from vfguide.loop.state import (
    begin_leg,
    begin_mission,
    forget_learned,
    fresh_state,
    leave_goal,
    row_of_state,
    state_of_row,
    take_over,
    watching,
)
from vfguide.telemetry.knowledge import Knowledge, measurement

HELD_PERIODS = 1.0
"""Number of guidance periods by which the state is predicted beyond the delay: half of one because
a setpoint is held for one, half because the reference's rate is the mean of the one before."""
DUE_SHARE = 0.9
"""Share of the guidance period after which the next step is due; chosen below 1, since an attitude
may come a little early."""

Step = Callable[..., tuple[Vec3, float, Quaternion, Row, float]]
"""The type of `step_measured`."""
ASSUMED_GUST = 1.0
"""Standard deviation of gusts with which trajectories are predicted [m/s]; chosen, since it is not
measured."""


class GuidedFlight:
    """One vehicle's flight along its plan."""

    def __init__(self, plan: Plan, step: Step = step_measured) -> None:
        """A flight that has not begun, of `plan` with the `step` of the control loop."""
        self.plan = plan
        """What is flown now."""
        self.identified: Identified | None = None
        """The aircraft as a test flight has shown it."""
        self._step = step
        self._identification = IdentificationFlight(plan) if plan.identify else None
        obstacles = 0 if plan.hazards is None else len(plan.hazards.obstacles)
        self._state = row_of_state(fresh_state(obstacles))
        self.notes: list[str] = []
        """What the operator should read; the caller takes it away."""
        self.announced: list[GoalAnnouncement] = []
        """The goals that were passed, as the companion saw it, in the order of time."""
        self.unfit: str | None = None
        """Why what the autopilot reports cannot be flown on; None where it can."""
        self._announcer = StepAnnunciator(plan.briefing)
        self._traffic = TrafficWatch(plan)
        self._obstacle_clock = ObstacleClock(plan)
        self._stepped: int | None = None
        self._follows = False
        self._jumped = False

    @property
    def is_testing(self) -> bool:
        """Whether the test flight that goes before the first goal is not over."""
        return self._identification is not None

    @property
    def air(self) -> AirReport:
        """The estimate of the air."""
        return air_report(self._state)

    @property
    def noted(self) -> Noted:
        """What records keep of the last step."""
        return Noted(*noted_numbers(self._state))

    def hear_traffic(self, said: AdsbVehicle, known: Knowledge) -> None:
        """Take a report of another aircraft."""
        self.notes += self._traffic.hear(said, known)

    def objection(self, known: Knowledge) -> str | None:
        """Why the autopilot must not begin to follow, None: it may."""
        return self._obstacle_clock.objection(known)

    def take_jump(self) -> bool:
        """Whether there was a position reset since the last call."""
        jumped, self._jumped = self._jumped, False
        return jumped

    def pause(self) -> None:
        """Record that the autopilot does not follow, or that it is unknown whether it does."""
        self._follows = False

    def guide(self, known: Knowledge, follows: bool, delay: float) -> RateSetpoint | None:
        """The setpoint for the newest attitude; None: not due, or something is not known.

        It acts `delay` [s] after that attitude, and is held until the next one does. Its body
        rates are FRD [rad/s].

        While the autopilot does not follow setpoints (`follows`), a step leaves nothing but its
        doubts. When it begins to, the leg to the present goal begins anew.
        """
        state, now_ms = self._due_state(known, delay), known.time_ms
        if state is None:
            return None
        if follows:
            self._obstacle_clock.settle(known)
        t = self._obstacle_clock.time(known)
        hazards = self._hazards(state, now_ms, t)
        if follows and not self._follows:
            self._begin(state, hazards, t)
        self._follows = follows
        before, (setpoint, after, miss) = self._state, self._fly(state, hazards, t)
        self._state = after if follows else watching(before, after)
        self.notes += self._announcer.doubts(before, after)
        self.unfit = self._announcer.unfit
        if follows:
            self.notes += self._announcer.events(before, after, now_ms, t, state.calibrated)
            if self._announcer.has_news:
                self._jumped |= number_of_resets(after) != number_of_resets(before)
        if follows and self._identification is not None:
            self._identification.take(state, setpoint, delay, trusts_sensor_of_row(after))
            self._test(self._identification)
        elif follows:
            self._progress(before, after, miss)
        return setpoint

    def _due_state(self, known: Knowledge, delay: float) -> Measurement | None:
        """The state at the newest attitude, if the next step is due and can be made."""
        now_ms, before_ms = known.time_ms, self._stepped
        if known.attitude is None:
            return None
        if before_ms is not None and (now_ms - before_ms) * MS < DUE_SHARE / self.plan.rate:
            return None
        self._stepped = now_ms
        self.notes += self._obstacle_clock.notes(known)
        if self._obstacle_clock.objection(known) is not None:
            return None
        return measurement(known, delay + HELD_PERIODS / self.plan.rate)

    def _hazards(self, state: Measurement, now_ms: int, t: float) -> Hazards | None:
        """The hazards of the plan and the traffic at the time `now_ms` [ms], `t` [s]."""
        self.notes += self._traffic.look(state, now_ms)
        hazards = self.plan.hazards
        return None if hazards is None else self._traffic.among(hazards, now_ms, t)

    def _fly(
        self, state: Measurement, hazards: Hazards | None, t: float
    ) -> tuple[RateSetpoint, Row, float]:
        """One step of the control loop: the setpoint, what the step leaves, and a goal's miss."""
        plan, test = self.plan, self._identification
        airspace = None
        if hazards is not None:
            airspace = unnested_airspace(Airspace(hazards, plan.fence, t, ASSUMED_GUST))
        omega_b, thrust, q_nb, after, miss = self._step(
            without_names(state),
            plan.origin,
            self._state,
            plan.legs,
            airspace,
            crossing(plan.law),
            plan.vehicle_row if test is None else test.vehicle_row(goal_of_row(self._state)),
        )
        return RateSetpoint(omega_b, thrust, q_nb), after, miss

    def _progress(self, before: Row, after: Row, miss: float) -> None:
        """Tell of a step on the way to a goal, and of one that was passed by `miss` [m]."""
        if self._announcer.has_news:
            self.notes += progress_notes(before, after)
        if math.isfinite(miss):
            self.announced.append(announcement(before, after, miss))
            self.notes.append(passage_note(self.announced[-1], len(self.plan.goals)))

    def _begin(self, state: Measurement, hazards: Hazards | None, t: float) -> None:
        """The autopilot begins to follow: a test flight begins anew, a leg where it was."""
        before = state_of_row(self._state)
        self._announcer.begin(self.plan.briefing)
        if self._identification is None:
            self._state = row_of_state(take_over(before))
            self.notes.append(leg_note(before.mission.goal, len(self.plan.goals)))
            return
        self._state = row_of_state(begin_mission(before))
        if hazards is not None:
            p_n = place_state(state, self.plan.origin).p_n
            hazards = in_sight(hazards, before.detection.known.copy(), p_n, t)
        if name := self._identification.begin(state, hazards, t):
            self.notes.append(TESTING.format(what=name))
            self.plan = self._identification.plan
            self._announcer.begin(self.plan.briefing)
        else:
            self._end_test(self._identification, NO_ROOM)

    def _test(self, identification: IdentificationFlight) -> None:
        """Go on with the test flight; after it the goals are flown to with what it has shown."""
        if decision_of_row(self._state).reason != Reason.NOMINAL:
            self._end_test(identification, BROKEN_OFF)
            return
        if identification.is_stuck(goal_of_row(self._state)):
            self._state = row_of_state(leave_goal(state_of_row(self._state)))
        leg = goal_of_row(self._state)
        if name := identification.enters(leg):
            self.notes.append(TESTING.format(what=name))
        if identification.is_over(leg):
            self.identified = identification.identify()
            self._end_test(identification, *identified_notes(self.identified))

    def _end_test(self, identification: IdentificationFlight, *notes: str) -> None:
        """Go on to the goals, with what the test flight has shown, if anything."""
        before, after = self.plan.aircraft, identification.plan_after(self.identified)
        self._identification, self.plan = None, after
        self._announcer.begin(after.briefing)
        s = forget_learned(state_of_row(self._state), before, after.aircraft)
        self._state = row_of_state(begin_leg(s, 0, no_attempts()))
        self.notes += (*notes, leg_note(0, len(after.goals)))
