"""A row of the loop in which every number tells where it stands."""

import numpy as np

from vfguide.kernels.rows import Row, leaves, place, width
from vfguide.loop.state import LoopState, state_of_row

OBSTACLES = 3


def numbered() -> Row:
    """A row whose numbers all differ, but for truth values; none is that of a fresh state."""
    row = np.arange(2.0, 2.0 + width(LoopState) + OBSTACLES)
    for leaf in leaves(LoopState):
        if leaf.kind is bool:
            row[place(LoopState, leaf.name)] = 1.0
    return row


def flown() -> LoopState:
    return state_of_row(numbered())
