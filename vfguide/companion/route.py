"""The way along the plan: when a step is due, what it remembers of the one before."""

from vfguide.companion.knowledge import STALE, Knowledge, elapsed, flight_state
from vfguide.companion.notes import pass_note, route_note
from vfguide.companion.plan import Plan
from vfguide.companion.step import RouteMemory, fresh_route, step
from vfguide.flight.memory import Wish
from vfguide.flight.state import RateSetpoint


class Route:
    """One vehicle's flight along its plan."""

    def __init__(self, plan: Plan) -> None:
        self.plan = plan
        self.memory: RouteMemory = fresh_route()
        self.wish: Wish | None = None
        """What the law wanted at the last step."""
        self.notes: list[str] = []
        """What the operator should read; the caller takes it away."""
        self._stepped: int | None = None
        self._follows = False

    def guide(self, known: Knowledge, follows: bool) -> RateSetpoint | None:
        """The setpoint for the newest attitude; None: not due, or something is not known.

        Steps leave a memory only while the autopilot `follows`; when it begins to, the leg to
        the present goal begins anew.
        """
        if known.attitude is None or not self._due(known.attitude.time_boot_ms):
            return None
        state = flight_state(known, self.plan.frame)
        if state is None:
            return None
        if follows and not self._follows:
            self._begin_leg()
        self._follows = follows
        setpoint, memory, self.wish = step(state, self.plan, self.memory)
        if follows:
            if note := pass_note(self.memory, memory, state, self.plan):
                self.notes.append(note)
            self.memory = memory
        return setpoint

    def pause(self) -> None:
        """The autopilot does not follow now, or nobody knows."""
        self._follows = False

    def _begin_leg(self) -> None:
        self.memory = RouteMemory(self.memory.goal, None, fresh_route().flight)
        self.notes.append(route_note(self.memory.goal, self.plan))

    def _due(self, time_boot_ms: int) -> bool:
        """Whether the next step is due at the autopilot's time; one far back starts anew."""
        if self._stepped is not None:
            since = elapsed(self._stepped, time_boot_ms)
            if -STALE < since < 0.9 / self.plan.rate:
                return False
        self._stepped = time_boot_ms
        return True
