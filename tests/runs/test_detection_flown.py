"""A fast Cessna among obstacles: at 300 m they are seen too late, at the range of the plan in time.

Worlds of `tools/measure_detection.py`, in which it hit something at 300 m or came near it.
"""

import pytest
from measure_detection import BEFORE, fly, world

pytestmark = pytest.mark.slow


@pytest.mark.parametrize(("seed", "hits"), [(21, True)])
def test_what_was_hit_at_the_old_range_is_kept_clear_of(seed: int, hits: bool) -> None:
    table = world(seed)
    before, after = fly({**table, "avoidance": {"detection_range_m": BEFORE}}), fly(table)
    assert before is not None
    assert after is not None
    assert (before.clearance <= 0.0) is hits
    assert before.clearance < 6.0
    assert after.clearance > 12.0
    assert after.reached == after.goals == 1
