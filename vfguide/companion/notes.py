"""What the operator should read, in plain words."""

from vfguide.companion.engagement import Phase
from vfguide.companion.plan import Plan
from vfguide.link.px4 import Px4Mode

SILENT_UNTIL_CHANGE = (
    "the autopilot already follows somebody's setpoints: silent until it flies another mode"
)
CHOICE_LEFT = "waiting for the operator to choose OFFBOARD"
LINK_LOST = "link lost, no heartbeat for 3 s: no setpoints until the autopilot is heard again"

ON_ENTERING = {
    Phase.SEARCHING: LINK_LOST,
    Phase.ASKING: "asking the autopilot for OFFBOARD",
    Phase.FLYING: "the autopilot follows",
    Phase.INTERRUPTED: LINK_LOST,
    Phase.RETURNING: "handing over: asking the autopilot for HOLD",
    Phase.RELEASED: "released: the mode was changed to {mode}, no more setpoints",
    Phase.ENDED: "ended: the autopilot flies {mode}",
    Phase.UNCONFIRMED: "ended without a link: what the autopilot flies is up to its failsafe",
}


def mode_name(custom_mode: int | None) -> str:
    """The autopilot's mode, in PX4's words."""
    if custom_mode is None:
        return "nothing known"
    known = custom_mode in set(Px4Mode)
    return Px4Mode(custom_mode).name if known else f"mode {custom_mode}"


def phase_note(before: Phase, after: Phase, custom_mode: int | None, engage: bool) -> str:
    """What a change of phase means.

    Args:
        before: the phase that is over.
        after: the one that begins.
        custom_mode: what the autopilot flies; None: unknown.
        engage: whether the companion asks for OFFBOARD by itself.
    """
    mode = mode_name(custom_mode)
    if after is not Phase.OFFERING:
        return ON_ENTERING[after].format(mode=mode)
    if before is Phase.ASKING:
        return CHOICE_LEFT
    plan = "OFFBOARD will be asked for" if engage else CHOICE_LEFT
    return f"the autopilot is found, it flies {mode}; setpoints go out, {plan}"


def route_note(goal: int, plan: Plan) -> str:
    """What is flown to."""
    goals = len(plan.goals)
    return f"flying to goal {goal + 1} of {goals}" if goal < goals else "loitering"


def passage_note(before: int, after: int, miss: float, plan: Plan) -> str:
    """A goal was passed with a `miss` [m]; the index of the goal flown to before and after."""
    if after == before:
        return f"goal {before + 1} missed by {miss:.1f} m or by its course: going round"
    return f"goal {before + 1} reached, {miss:.1f} m off; {route_note(after, plan)}"
