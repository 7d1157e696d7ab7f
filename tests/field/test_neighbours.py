import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from vfguide.field.neighbours import counting_sort, robots_in_range, robots_with_priority


def sets(neighbours):
    pairs = zip(neighbours.start[:-1], neighbours.start[1:], strict=True)
    return [neighbours.others[a:b].tolist() for a, b in pairs]


def test_the_papers_four_robots():
    """Figure fig_four_UAVs: all see each other but for 2 and 4, numbered from 1."""
    p = np.array([[0.0, 0.0, 0.0], [0.0, 80.0, 0.0], [10.0, 0.0, 5.0], [0.0, -80.0, 0.0]])
    numbered = [[j + 1 for j in robots] for robots in sets(robots_in_range(p, 100.0))]
    assert numbered == [[2, 3, 4], [1, 3], [1, 2, 4], [1, 3]]
    numbered = [[j + 1 for j in robots] for robots in sets(robots_with_priority(p, 100.0))]
    assert numbered == [[], [1], [1, 2], [1, 3]]


@given(st.integers(0, 40), st.floats(10.0, 200.0), st.integers(0, 100))
def test_sets_against_all_pairs(count, detection_range, seed):
    p = np.random.default_rng(seed).uniform(-100.0, 100.0, (count, 3))
    distance = np.linalg.norm(p[:, None] - p[None], axis=2)
    near = [
        [j for j in range(count) if j != i and distance[i, j] <= detection_range]
        for i in range(count)
    ]
    assert sets(robots_in_range(p, detection_range)) == near
    above = [[j for j in robots if j < i] for i, robots in enumerate(near)]
    assert sets(robots_with_priority(p, detection_range)) == above


@given(st.lists(st.integers(0, 9)))
def test_counting_sort_keeps_the_order_of_equal_keys(keys):
    start, order = counting_sort(np.array(keys, np.int64), 10)
    np.testing.assert_array_equal(order, np.argsort(keys, kind="stable"))
    np.testing.assert_array_equal(start, np.searchsorted(np.sort(keys), np.arange(11)))
