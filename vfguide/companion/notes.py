"""What the operator should read, in plain words."""

from vfguide.companion.engagement import Phase
from vfguide.companion.plan import Plan
from vfguide.companion.step import GATE, RouteMemory, passing
from vfguide.flight.state import FlightState
from vfguide.geometry.vector import norm
from vfguide.link.px4 import Px4Mode

SILENT_UNTIL_CHANGE = (
    "the autopilot already follows somebody's setpoints: silent until it flies another mode"
)
CHOICE_LEFT = "waiting for the operator to choose OFFBOARD"


def mode_name(custom_mode: int) -> str:
    """The autopilot's mode, in PX4's words."""
    known = custom_mode in set(Px4Mode)
    return Px4Mode(custom_mode).name if known else f"mode {custom_mode}"


def phase_note(before: Phase, after: Phase, mode: str, engage: bool, route: str) -> str:
    """What a change of phase means.

    Args:
        before: the phase that is over.
        after: the one that begins.
        mode: what the autopilot flies.
        engage: whether the companion asks for OFFBOARD by itself.
        route: what is flown to, of `route_note`.
    """
    match after:
        case Phase.OFFERING if before is Phase.ASKING:
            return CHOICE_LEFT
        case Phase.OFFERING:
            plan = "OFFBOARD will be asked for" if engage else CHOICE_LEFT
            return f"the autopilot is found, it flies {mode}; setpoints go out, {plan}"
        case Phase.ASKING:
            return "asking the autopilot for OFFBOARD"
        case Phase.FLYING:
            return f"the autopilot follows: {route}"
        case Phase.SEARCHING | Phase.INTERRUPTED:
            return "link lost, no heartbeat for 3 s: no setpoints until the autopilot is heard again"
        case Phase.RETURNING:
            return "handing over: asking the autopilot for HOLD"
        case Phase.RELEASED:
            return f"released: the mode was changed to {mode}, no more setpoints"
        case Phase.ENDED if before is Phase.RETURNING:
            return f"handed over: the autopilot flies {mode}"
        case Phase.ENDED:
            return "ended: the autopilot was not under control"
        case Phase.UNCONFIRMED:
            return "ended without a link: what the autopilot flies now is up to its failsafe"


def route_note(goal: int, plan: Plan) -> str:
    """What is flown to."""
    goals = len(plan.goals)
    return f"flying to goal {goal + 1} of {goals}" if goal < goals else "loitering"


def pass_note(before: RouteMemory, after: RouteMemory, state: FlightState, plan: Plan) -> str:
    """What happened between two steps: a goal reached or missed; empty if neither."""
    if before.before is None or before.goal == len(plan.goals):
        return ""
    miss = passing(before.before, state, plan.goals[before.goal].p_n)
    if miss is None or norm(miss) > GATE:
        return ""
    goal = before.goal + 1
    if after.goal == before.goal:
        return f"goal {goal} missed by {norm(miss):.1f} m or by its course: going round"
    return f"goal {goal} reached, {norm(miss):.1f} m off; {route_note(after.goal, plan)}"
