"""`--until`: what is a condition, which flights count, and when it is decided."""

import math

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from vfguide.campaign.condition import Comparison, Condition, check_column, parse_condition
from vfguide.campaign.intervals import sequential_rate
from vfguide.files.errors import InputError

MISS = "rate(miss_m > 2) < 0.01 @ 0.95"
ORDERS = [each for each in Comparison if each not in (Comparison.EQUAL, Comparison.UNEQUAL)]
WORDS = st.text(st.characters(exclude_characters='"', exclude_categories=["Cs"])) | st.text(
    st.characters(exclude_characters="'", exclude_categories=["Cs"])
)
NUMBERS = st.floats(allow_nan=False, allow_infinity=False)
CONDITIONS = st.builds(
    lambda compared, *others: Condition(others[0], *compared, *others[1:]),
    st.tuples(st.sampled_from(list(Comparison)), NUMBERS)
    | st.tuples(st.sampled_from([Comparison.EQUAL, Comparison.UNEQUAL]), WORDS | st.booleans()),
    WORDS.filter(bool),
    st.sampled_from([Comparison.LESS, Comparison.MORE]),
    st.floats(0.0, 1.0, exclude_min=True, exclude_max=True),
    st.floats(0.5, 1.0, exclude_max=True),
)
PIECES = [
    *MISS.split(),
    *Comparison,
    *"()@=!'\"",
    "rate(",
    "miss_m",
    "-1e-3",
    "0.5",
    "true",
    "\x00",
]


@pytest.mark.parametrize(
    ("text", "condition"),
    [
        (MISS, Condition("miss_m", Comparison.MORE, 2.0, Comparison.LESS, 0.01, 0.95)),
        (
            "  rate (miss_m>=-2.5e-1)>.5@0.5\n",
            Condition("miss_m", Comparison.AT_LEAST, -0.25, Comparison.MORE, 0.5, 0.5),
        ),
        (
            "rate(verdict == good) > 0.99 @ 0.99",
            Condition("verdict", Comparison.EQUAL, "good", Comparison.MORE, 0.99, 0.99),
        ),
        (
            "rate('wind speed'!=\"not good\")<1e-3@.9",
            Condition("wind speed", Comparison.UNEQUAL, "not good", Comparison.LESS, 0.001, 0.9),
        ),
        (
            "rate(vehicle[0].goal-1.reached == true) > 0.9 @ 0.95",
            Condition(
                "vehicle[0].goal-1.reached", Comparison.EQUAL, True, Comparison.MORE, 0.9, 0.95
            ),
        ),
        (
            'rate(id == "2") < 0.1 @ 0.95',
            Condition("id", Comparison.EQUAL, "2", Comparison.LESS, 0.1, 0.95),
        ),
    ],
)
def test_what_is_read(text, condition):
    found = parse_condition(text)
    assert found == condition
    assert type(found.threshold) is type(condition.threshold)


def test_it_is_written_as_one_types_it():
    assert str(parse_condition(" rate( miss_m>2.0)<1e-2@.95 ")) == MISS
    quoted = 'rate("wind speed" == "2") < 0.01 @ 0.95'
    assert str(parse_condition(quoted.replace(" < ", "<"))) == quoted
    assert str(parse_condition('rate(a != "b\'c") < 0.5 @ 0.5')) == 'rate(a != "b\'c") < 0.5 @ 0.5'


@given(CONDITIONS)
@example(Condition("true", Comparison.EQUAL, "true", Comparison.LESS, 0.1, 0.5))
@example(Condition("2", Comparison.EQUAL, "-1e5", Comparison.LESS, 0.1, 0.5))
@example(Condition("a", Comparison.EQUAL, "", Comparison.LESS, 5e-324, 0.5))
@example(Condition("a", Comparison.LESS, 1e22, Comparison.MORE, 0.1, 0.9999999999999999))
def test_what_is_written_is_read_again(condition):
    found = parse_condition(str(condition))
    assert found == condition
    assert type(found.threshold) is type(condition.threshold)


@given(st.text() | st.lists(st.sampled_from(PIECES), max_size=14).map(" ".join))
@example("rate(miss_m > 1e999) < 0.01 @ 0.95")
@example("rate(miss_m > 2) < 1_0 @ \u0660.\u0669")
def test_anything_is_read_or_refused_with_one_message(text):
    refusal = ""
    try:
        text = str(parse_condition(text))
    except InputError as error:
        refusal = str(error)
    else:
        assert str(parse_condition(text)) == text
    assert refusal.startswith(f"--until {text}: ") or not refusal


EXPECTED = "; allowed is rate(COLUMN > VALUE) < LIMIT @ LEVEL, such as " + MISS


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "the end: expected rate" + EXPECTED),
        ("share(miss_m > 2)", "share(miss_m > 2): expected rate" + EXPECTED),
        ("rate miss_m > 2", "miss_m > 2: expected ( and a comparison" + EXPECTED),
        ("rate(> 2)", "> 2): expected the name of a column" + EXPECTED),
        (
            "rate(miss_m = 2) < 0.1 @ 0.9",
            "= 2) < 0.1 @ 0.9: expected < or <= or > or >= or == or !=" + EXPECTED,
        ),
        ("rate(miss_m >)", "): expected a number or a word" + EXPECTED),
        ("rate(miss_m > 2 < 0.01 @ 0.95", "< 0.01 @ 0.95: expected )" + EXPECTED),
        ("rate(miss_m > 2) <= 0.1 @ 0.9", "<= 0.1 @ 0.9: expected < or > and a limit" + EXPECTED),
        ("rate(miss_m > 2) <", "the end: expected a limit between 0 and 1" + EXPECTED),
        ("rate(miss_m > 2) < 0.01", "the end: expected @ and a confidence level" + EXPECTED),
        (
            "rate(miss_m > 2) < 0.01 @",
            "the end: expected a confidence level of at least 0.5, below 1" + EXPECTED,
        ),
        (MISS + " or 3", "or 3: expected nothing more" + EXPECTED),
        ("rate('' > 2) < 0.01 @ 0.95", "'': allowed is the name of a column"),
        (
            "rate(verdict < good) < 0.1 @ 0.9",
            "good: after < allowed is a number; a word after == and !=",
        ),
        (
            "rate(reached > true) < 0.1 @ 0.9",
            "true: after > allowed is a number; a word after == and !=",
        ),
        (
            "rate(miss_m > nan) < 0.1 @ 0.9",
            "nan: after > allowed is a number; a word after == and !=",
        ),
        ("rate(miss_m > 1e999) < 0.1 @ 0.9", "1e999: allowed is a finite number"),
        ("rate(miss_m > 2) < 1 @ 0.9", "1: allowed is a limit between 0 and 1"),
        ("rate(miss_m > 2) < 0 @ 0.9", "0: allowed is a limit between 0 and 1"),
        ("rate(miss_m > 2) < 1% @ 0.9", "1%: allowed is a limit between 0 and 1"),
        (
            "rate(miss_m > 2) < 0.1 @ 95",
            "95: allowed is a confidence level of at least 0.5, below 1",
        ),
        (
            "rate(miss_m > 2) < 0.1 @ .49",
            ".49: allowed is a confidence level of at least 0.5, below 1",
        ),
        (
            "rate(miss_m > 2) < 0.1 @ high",
            "high: allowed is a confidence level of at least 0.5, below 1",
        ),
    ],
)
def test_what_is_refused_is_told(text, message):
    with pytest.raises(InputError) as error:
        parse_condition(text)
    assert str(error.value) == f"--until {text}: {message}"


def test_a_long_part_is_shortened():
    with pytest.raises(InputError, match=r": x{37}\.\.\.: expected rate"):
        parse_condition("x" * 1000)


def test_an_unknown_column_is_told_with_those_that_are_near():
    condition = parse_condition("rate(mis_m > 2) < 0.01 @ 0.95")
    check_column(condition, {"mis_m"})
    with pytest.raises(InputError) as error:
        check_column(condition, {"verdict", "miss_m"})
    hint = "mis_m: no such column, did you mean miss_m?; allowed: miss_m, verdict"
    assert str(error.value) == f"--until {condition}: {hint}"


@pytest.mark.parametrize(
    ("counted", "value", "holds"),
    [
        ("a < 2", 2, False),
        ("a < 2", 1.9, True),
        ("a <= 2", 2, True),
        ("a > 2", np.float64(2.0), False),
        ("a > 2", math.inf, True),
        ("a >= 2", np.int32(2), True),
        ("a == 2", 2.0, True),
        ("a != 2", 2.0, False),
        ("a == good", "good", True),
        ("a != good", np.str_("good"), False),
        ("a != good", "bad", True),
        ("a == true", True, True),
        ("a == true", np.bool_(False), False),
        ("a == false", False, True),
        ("a < 1", False, True),
    ],
)
def test_which_flights_count(counted, value, holds):
    found = parse_condition(f"rate({counted}) < 0.1 @ 0.9").holds({"a": value, "b": 5})
    assert found is holds


@pytest.mark.parametrize("comparison", list(Comparison))
@pytest.mark.parametrize("row", [{}, {"a": None}, {"a": math.nan}, {"a": np.float64("nan")}])
def test_a_missing_value_counts_against_what_is_hoped_for(comparison, row):
    assert Condition("a", comparison, 2.0, Comparison.LESS, 0.1, 0.9).holds(row) is True
    assert Condition("a", comparison, 2.0, Comparison.MORE, 0.1, 0.9).holds(row) is False


@pytest.mark.parametrize(
    ("threshold", "value", "part"),
    [
        ("2", "good", "2: cannot be compared with good, which a holds"),
        ("good", 2.0, "good: cannot be compared with 2, which a holds"),
        ("good", True, "good: cannot be compared with true, which a holds"),
        ("2", [1, 2], "2: cannot be compared with [1, 2], which a holds"),
    ],
)
def test_words_and_numbers_are_not_compared(threshold, value, part):
    condition = parse_condition(f"rate(a == {threshold}) < 0.1 @ 0.9")
    with pytest.raises(InputError) as error:
        condition.holds({"a": value})
    assert str(error.value) == f"--until {condition}: {part}"


def test_it_is_decided_when_the_limit_is_outside_the_confidence_sequence():
    below, above = parse_condition(MISS), parse_condition(MISS.replace(" < ", " > "))
    for successes, trials in ((0, 0), (0, 679), (1, 2), (20, 1000), (0, 680), (3, 4), (50, 1000)):
        low, high = sequential_rate(successes, trials, 0.95).interval
        expected = True if high < 0.01 else False if low > 0.01 else None
        assert below.decided(successes, trials) is expected
        assert above.decided(successes, trials) is (None if expected is None else not expected)
    assert below.decided(0, 680) is True
    assert below.decided(50, 1000) is False
    assert below.decided(0, 0) is below.decided(20, 1000) is None


@given(st.integers(0, 500), st.integers(0, 500), st.floats(0.01, 0.99), st.floats(0.5, 0.99))
def test_more_that_count_never_turn_a_decision_towards_a_small_rate(more, other, limit, level):
    condition = Condition("a", Comparison.MORE, 2.0, Comparison.LESS, limit, level)
    order = [True, None, False]
    trials = more + other + 1
    fewer = condition.decided(more, trials)
    assert order.index(condition.decided(more + 1, trials)) >= order.index(fewer)


@pytest.mark.parametrize("rate", [0.05, 0.3])
def test_looking_after_every_flight_decides_wrongly_no_more_often_than_the_level_says(rate):
    condition = Condition("a", Comparison.MORE, 2.0, Comparison.LESS, rate, 0.8)
    flights = np.random.default_rng(18).random((200, 500)) < rate
    decided = 0
    for successes in flights.cumsum(axis=1).tolist():
        looks = (condition.decided(each, 1 + i) for i, each in enumerate(successes))
        decided += any(look is not None for look in looks)
    assert 0 < decided <= 0.2 * 200
