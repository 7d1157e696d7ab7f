"""The way along the plan: when a step is due, what it remembers of the one before."""

import math

from vfguide.companion.knowledge import STALE, Knowledge, elapsed, heard, obstacle_time
from vfguide.companion.lookout import Lookout
from vfguide.companion.notes import (
    BROKEN_OFF,
    NO_ROOM,
    TESTING,
    air_notes,
    identified_notes,
    passage_note,
    progress_notes,
    route_note,
)
from vfguide.companion.place import Heard, place_state
from vfguide.companion.plan import Plan
from vfguide.companion.route_memory import (
    JUMPS,
    Noted,
    air_in,
    begin_leg,
    begin_route,
    decision_in,
    forget_learned,
    fresh_route,
    goal_in,
    has_news,
    leave_goal,
    noted_in,
    packed_memory,
    take_over,
    trusts_sensor_in,
    unpacked_memory,
)
from vfguide.companion.step import step_on
from vfguide.companion.surveillance import Surveillance
from vfguide.companion.traffic import Own, Picture
from vfguide.companion.trial import Trial
from vfguide.companion.tries import no_tries
from vfguide.flight.air_state import AirReport
from vfguide.flight.identification import Identified
from vfguide.flight.state import RateSetpoint
from vfguide.link.messages import AdsbVehicle
from vfguide.safety.assurance import Reason
from vfguide.safety.guard import in_sight
from vfguide.safety.hazards import Hazards

HELD = 1.0
"""A setpoint is made for the state so many of its periods after it begins to act: half of one for
its own middle, half because the reference's turning is known for the period before."""


class Route:
    """One vehicle's flight along its plan."""

    def __init__(self, plan: Plan) -> None:
        self.plan = plan
        """What is flown now."""
        self.identified: Identified | None = None
        """The aircraft as a test flight has shown it."""
        self._trial = Trial(plan) if plan.identify else None
        obstacles = 0 if plan.hazards is None else len(plan.hazards.obstacles)
        self._memory = packed_memory(fresh_route(obstacles))
        self.notes: list[str] = []
        """What the operator should read; the caller takes it away."""
        self._lookout = Lookout(plan)
        self._surveillance = Surveillance(Picture(plan.origin, plan.volume, plan.own_icao))
        self._stepped: int | None = None
        self._began = 0
        self._follows = False
        self._jumped = False

    @property
    def is_testing(self) -> bool:
        """Whether a test flight goes before the first goal now."""
        return self._trial is not None

    @property
    def air(self) -> AirReport:
        """What is believed of the air."""
        return air_in(self._memory)

    @property
    def noted(self) -> Noted:
        """What records keep of the last step."""
        return Noted(*noted_in(self._memory))

    def guide(self, known: Knowledge, follows: bool, delay: float) -> RateSetpoint | None:
        """The setpoint for the newest attitude; None: not due, or something is not known.

        It acts `delay` [s] after that attitude, and is held until the next one does.

        Steps leave a memory only while the autopilot `follows`; when it begins to, the leg to
        the present goal begins anew.
        """
        if known.attitude is None or not self._due(known.attitude.time_boot_ms):
            return None
        state = heard(known, delay + HELD / self.plan.rate)
        if state is None:
            return None
        t = obstacle_time(known, self.plan.epoch, self._began)
        now_ms = known.attitude.time_boot_ms
        if self._surveillance.is_due(now_ms):
            own = place_state(state, self.plan.origin)
            self.notes += self._surveillance.look(Own(now_ms, own.p_n, own.v_n))
        hazards = self.plan.hazards
        if hazards is not None:
            hazards = self._surveillance.among(hazards, now_ms, t)
        if follows and not self._follows:
            self._begin_leg(state, hazards, t)
        self._follows = follows
        plan, before = self.plan, self._memory
        omega_b, thrust, q_nb, after, miss = step_on(
            state,
            plan.origin,
            plan.legs,
            plan.law if self._trial is None else self._trial.law(goal_in(before)),
            before,
            hazards,
            plan.fence,
            t,
        )
        if follows:
            self._memory = after
            if has_news(before, after):
                self.notes += air_notes(before, after, plan)
                self._jumped |= bool(after[JUMPS] != before[JUMPS])
            self.notes += self._lookout.notes(after, t)
        setpoint = RateSetpoint(omega_b, thrust, q_nb)
        if follows and self._trial is not None:
            self._trial.take(state, setpoint, delay, trusts_sensor_in(after))
            self._test(self._trial)
        elif follows:
            self.notes += progress_notes(before, after)
            if math.isfinite(miss):
                self.notes.append(passage_note(before, after, miss, plan))
        return setpoint

    def hear_traffic(self, said: AdsbVehicle, known: Knowledge) -> None:
        """Take a report of another aircraft; without an attitude nobody knows its time."""
        if known.attitude is not None:
            self._surveillance.hear(said, known.attitude.time_boot_ms)

    def take_jump(self) -> bool:
        """Whether the position that is told has jumped; told once."""
        jumped, self._jumped = self._jumped, False
        return jumped

    def pause(self) -> None:
        """The autopilot does not follow now, or nobody knows."""
        self._follows = False

    def _begin_leg(self, state: Heard, hazards: Hazards | None, t: float) -> None:
        """The autopilot begins to follow: a test flight begins anew, a leg where it was."""
        memory = unpacked_memory(self._memory)
        if self._trial is None:
            self._memory = packed_memory(take_over(memory))
            self.notes.append(route_note(goal_in(self._memory), self.plan))
            return
        self._memory = packed_memory(begin_route(memory))
        if hazards is not None:
            p_n = place_state(state, self.plan.origin).p_n
            hazards = in_sight(hazards, memory.guard.copy(), p_n, t)
        if name := self._trial.begin(state, hazards, t):
            self.notes.append(TESTING.format(what=name))
            self.plan = self._trial.plan
        else:
            self._end_test(self._trial, NO_ROOM)

    def _test(self, trial: Trial) -> None:
        """Go on with the test flight; after it the goals are flown to with what it has shown."""
        if decision_in(self._memory)[0] != Reason.CLEAR.value:
            self._end_test(trial, BROKEN_OFF)
            return
        if trial.is_stuck(goal_in(self._memory)):
            self._memory = packed_memory(leave_goal(unpacked_memory(self._memory)))
        if name := trial.enters(goal_in(self._memory)):
            self.notes.append(TESTING.format(what=name))
        if trial.is_over(goal_in(self._memory)):
            self.identified = trial.identify()
            self._end_test(trial, *identified_notes(self.identified))

    def _end_test(self, trial: Trial, *notes: str) -> None:
        """Fly to the goals, with what the test flight has shown if it has."""
        before, after = self.plan.aircraft, trial.plan_after(self.identified)
        self._trial, self.plan, self._lookout = None, after, Lookout(after)
        memory = unpacked_memory(self._memory)
        memory = forget_learned(memory, before, after.aircraft)
        self._memory = packed_memory(begin_leg(0, no_tries(), memory))
        self.notes += (*notes, route_note(0, after))

    def _due(self, time_boot_ms: int) -> bool:
        """Whether the next step is due at the autopilot's time; one far back starts anew."""
        if self._stepped is None:
            self._began = time_boot_ms
        else:
            since = elapsed(self._stepped, time_boot_ms)
            if -STALE < since < 0.9 / self.plan.rate:
                return False
        self._stepped = time_boot_ms
        return True
