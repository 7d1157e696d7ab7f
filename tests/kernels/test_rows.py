from typing import Annotated, NamedTuple

import numpy as np
import pytest
from numpy.typing import NDArray

from vfguide.kernels.compiled import compiled
from vfguide.kernels.rows import (
    OPEN,
    Shape,
    columns,
    flattener,
    getter,
    nester,
    part_reader,
    place,
    python_reader,
    reader,
    replacing,
    row_of,
    table_of,
    unnester,
    width,
    writer,
)

Vec3 = tuple[float, float, float]
Mat3 = tuple[Vec3, Vec3, Vec3]


class Wheel(NamedTuple):
    radius: float
    braked: bool


class Cart(NamedTuple):
    p_n: Vec3
    R_nb: Mat3
    wheels: tuple[Wheel, Wheel]
    load: Annotated[NDArray[np.float64], Shape(2, 3)]
    seats: int


EYE = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
read_cart, write_cart = reader(Cart), writer(Cart)
with_seats = replacing(Cart, "seats", "p_n")


def a_cart(seats: int = 2) -> Cart:
    wheels = (Wheel(0.3, True), Wheel(0.4, False))
    return Cart((1.0, 2.0, 3.0), EYE, wheels, np.arange(6.0).reshape(2, 3), seats)


@compiled
def one_seat_more(row: NDArray[np.float64], after: NDArray[np.float64]) -> float:
    cart = read_cart(row)
    write_cart(with_seats(cart, cart.seats + 1, (7.0, 8.0, 9.0)), after)
    return cart.wheels[1].radius


def test_a_row_has_the_numbers_in_the_order_of_the_fields():
    row = row_of(a_cart())
    assert width(Cart) == len(row) == 23
    assert list(row) == [1, 2, 3, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0.3, 1, 0.4, 0, 0, 1, 2, 3, 4, 5, 2]


def test_compiled_code_reads_replaces_and_writes_by_name():
    before, after = row_of(a_cart()), np.full(width(Cart), np.nan)
    assert one_seat_more(before, after) == 0.4
    assert list(before) == list(row_of(a_cart()))
    assert list(after) == list(row_of(a_cart(3)._replace(p_n=(7.0, 8.0, 9.0))))


def test_a_row_read_in_python_is_the_record():
    cart = read_cart(row_of(a_cart()))
    assert cart._replace(load=None) == a_cart()._replace(load=None)
    assert np.array_equal(cart.load, a_cart().load)


def test_the_numbers_of_a_row_make_the_record_in_python_too():
    wheel = Wheel(0.3, True)
    assert python_reader(Wheel)(row_of(wheel).tolist()) == wheel
    assert python_reader(tuple[Wheel, Vec3])([0.4, 0.0, 1.0, 2.0, 3.0]) == (
        Wheel(0.4, False),
        (1.0, 2.0, 3.0),
    )


def test_columns_of_a_table_have_the_shapes_of_the_fields():
    table = table_of(Cart, [a_cart(1), a_cart(5), a_cart(7)])
    found = columns(Cart, table)
    assert found.p_n.shape == (3, 3)
    assert found.R_nb.shape == (3, 3, 3)
    assert found.load.shape == (3, 2, 3)
    assert list(found.wheels.shape) == [3, 2, 2]
    assert list(found.seats) == [1, 5, 7]


def test_no_records_make_an_empty_table():
    assert table_of(Cart, []).shape == (0, width(Cart))
    assert columns(Cart, table_of(Cart, [])).R_nb.shape == (0, 3, 3)


@pytest.mark.parametrize(
    ("name", "there"),
    [
        ("p_n", slice(0, 3)),
        ("R_nb.1", slice(6, 9)),
        ("wheels.1.braked", slice(15, 16)),
        ("load", slice(16, 22)),
        ("seats", slice(22, 23)),
    ],
)
def test_place_of_a_name(name: str, there: slice):
    assert place(Cart, name) == there


class Train(NamedTuple):
    speed: float
    wagons: Annotated[NDArray[np.float64], OPEN]


read_train, write_train = reader(Train), writer(Train)


@compiled
def one_more(row: NDArray[np.float64]) -> NDArray[np.float64]:
    after = np.empty(len(row))
    train = read_train(row)
    write_train(Train(train.speed, train.wagons + 1.0), after)
    return after


def test_the_last_array_may_take_the_rest_of_the_row():
    row = row_of(Train(3.0, np.array([1.0, 2.0, 4.0])))
    assert width(Train) == 1
    assert list(one_more(row)) == [3.0, 2.0, 3.0, 5.0]
    assert list(getter(Train, "wagons")(row)) == [1.0, 2.0, 4.0]


@pytest.mark.parametrize(
    ("name", "value"),
    [("p_n", (1.0, 2.0, 3.0)), ("p_n.1", 2.0), ("wheels.1", Wheel(0.4, False)), ("seats", 2)],
)
def test_one_field_of_a_row(name: str, value: object):
    assert getter(Cart, name)(row_of(a_cart())) == value


def test_unknown_names_are_refused():
    with pytest.raises(KeyError, match="doors"):
        place(Cart, "doors")
    with pytest.raises(KeyError, match="doors"):
        replacing(Cart, "doors")


def test_what_is_no_number_is_refused():
    class Named(NamedTuple):
        name: str

    with pytest.raises(TypeError, match="name"):
        flattener(Named)


class Wagon(NamedTuple):
    radius: float
    braked: bool


def test_functions_of_different_types_never_share_a_name():
    """Cached machine code of several processes is told apart by it."""
    makers = (reader, writer, lambda kind: replacing(kind, "radius"))
    functions = [make(kind) for make in makers for kind in (Wheel, Wagon, Cart) if kind is not Cart]
    names = [function.py_func.__name__ for function in functions]
    assert len(set(names)) == len(names)


class Convoy(NamedTuple):
    first: Wheel
    cargo: NDArray[np.float64]
    speed: float


unnested_convoy, nested_convoy = unnester(Convoy), nester(Convoy)


@compiled
def cargo_and_radius(values: tuple[float, bool, NDArray[np.float64], float]) -> float:
    convoy = nested_convoy(values)
    return convoy.cargo[1] + convoy.first.radius if convoy.first.braked else convoy.speed


def test_records_of_records_cross_as_one_tuple():
    convoy = Convoy(Wheel(0.3, True), np.array((1.0, 2.0)), 7.0)
    values = unnested_convoy(convoy)
    assert values == (0.3, True, convoy.cargo, 7.0)
    assert values[2] is convoy.cargo
    assert cargo_and_radius(values) == 2.3


read_wheels, read_seats = part_reader(Cart, "wheels"), part_reader(Cart, "seats")


def test_a_part_is_read_from_its_place():
    row = row_of(a_cart(seats=7))
    assert read_wheels(row) == a_cart().wheels
    assert read_seats(row) == 7
    with pytest.raises(KeyError):
        part_reader(Cart, "doors")
