"""The command `vfguide sim`, which simulates autopilots over UDP."""

from collections.abc import Callable
from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from vfguide.terminal.exit_status import BAD, GOOD

if TYPE_CHECKING:
    from socket import socket

    from vfguide.scenario.loaded import LoadedScenario
    from vfguide.scenario.resolved import Scenario, Vehicle
    from vfguide.sim.real_time_pacing import RealTimePacing
    from vfguide.sim.realtime import Station
    from vfguide.sim.vehicle import Vehicle as SimVehicle

MAX_SPEED = 1000.0
"""Largest ratio of simulated to real time, dimensionless; chosen."""
MIN_SPEED = 0.01
"""Least ratio of simulated to real time, dimensionless; chosen."""


def sim(
    scenario: Annotated[str, typer.Argument(help="Path of a scenario file, or a shipped name.")],
    speed: Annotated[
        float, typer.Option(help="Seconds of simulation in a second.", min=MIN_SPEED, max=MAX_SPEED)
    ] = 1.0,
    log: Annotated[
        Path | None, typer.Option(help="Folder for truth.tlog, which no companion sees.")
    ] = None,
) -> None:
    """Simulate the autopilots of a scenario alone, over UDP, in real time, until Ctrl-C.

    All are airborne, armed and in hold. Example: vfguide sim first-flight
    """
    from vfguide.files.errors import InputError
    from vfguide.link.tlog import TlogError
    from vfguide.preflight.load import load_scenario
    from vfguide.runs.models import require_models
    from vfguide.runs.truth_log import truth_message
    from vfguide.runs.vehicle_setup import simulate
    from vfguide.sim.realtime import RealtimeFlight, warm_up
    from vfguide.sim.vehicle import steps_between_updates
    from vfguide.terminal.compiling import COMPILING
    from vfguide.terminal.console import complain, out
    from vfguide.terminal.signals import REQUESTS, CommandEnd

    COMPILING.stage("the checks of the plan")
    loaded = load_scenario(scenario)
    loaded.require_mavlink()
    require_models(loaded)
    with ExitStack() as stack:
        sockets = open_sockets(loaded.scenario, stack)
        observe = truth_writer(log, stack)
        COMPILING.stage("the simulator")
        stations = [
            station_of(loaded, vehicle, *each)
            for vehicle, each in zip(loaded.scenario.vehicles, sockets, strict=True)
        ]
        scratch = simulate(loaded, loaded.scenario.vehicles[0])
        warm_up(scratch)
        truth_message(scratch.now, scratch.truth)
        for station in stations:
            out.print(describe(station))
        out.print(f"flying at {speed:g} x real time; Ctrl-C ends it")
        steps = steps_between_updates(loaded.scenario.guidance.rate_hz)
        flight = RealtimeFlight(stations, speed, steps, observe, complain)
        stack.enter_context(REQUESTS)
        try:
            flight.run(REQUESTS.wanted)
        except TlogError as error:
            raise InputError(str(error)) from error
        out.print(f"ended after {flight.sim_s:.1f} s, {lateness(flight.pace)}")
        status = GOOD if flight.flying else BAD
        REQUESTS.ending = CommandEnd(status, "ended")
    raise typer.Exit(status)


def open_sockets(scenario: "Scenario", stack: ExitStack) -> "list[tuple[socket, socket]]":
    """The two sockets of every vehicle: to its companion, and to the ground station.

    Raises:
        InputError: a port is in use.
    """
    from vfguide.files.errors import InputError
    from vfguide.sim.udp import PortTakenError, bound_socket, ground_numbers, offboard_numbers

    opened: list[tuple[socket, socket]] = []
    for vehicle in scenario.vehicles:
        try:
            offboard = stack.enter_context(bound_socket(offboard_numbers(vehicle.id).own))
            ground = stack.enter_context(bound_socket(ground_numbers(vehicle.id).own))
        except PortTakenError as error:
            raise InputError(f"vehicle {vehicle.id}: {error}") from error
        opened.append((offboard, ground))
    return opened


def station_of(
    loaded: "LoadedScenario", vehicle: "Vehicle", offboard: "socket", ground: "socket"
) -> "Station":
    """A simulated vehicle at its start, with its channels over the two sockets.

    Raises:
        InputError: its model cannot be flown.
    """
    from vfguide.runs.vehicle_setup import simulate
    from vfguide.sim.autopilot.mavlink_channel import GROUND, ONBOARD
    from vfguide.sim.realtime import Station
    from vfguide.sim.udp import Channel, ground_numbers, offboard_numbers

    flown = simulate(loaded, vehicle)
    channels = (
        Channel(flown, ONBOARD, offboard, offboard_numbers(vehicle.id)),
        Channel(flown, GROUND, ground, ground_numbers(vehicle.id)),
    )
    return Station(flown, channels)


def describe(station: "Station") -> str:
    """The ports on which a vehicle listens and to which it sends, in words."""
    offboard, ground = (channel.numbers for channel in station.channels)
    return (
        f"vehicle {station.vehicle.sysid}: companion {offboard.own} -> {offboard.peer}, "
        f"ground station {ground.own} -> {ground.peer} (UDP, 127.0.0.1)"
    )


def lateness(pace: "RealTimePacing") -> str:
    """How well the machine kept up with the clock, in words: the largest delay, the time lost."""
    from vfguide.geometry.units import MS

    lost = f", {pace.lost:.1f} s given up" if pace.lost else ""
    return f"at most {pace.worst / MS:.0f} ms late{lost}"


def truth_writer(folder: Path | None, stack: ExitStack) -> "Callable[[SimVehicle], None]":
    """A function that records the truth of a vehicle in `folder`/truth.tlog.

    Without a folder it does nothing.

    Raises:
        InputError: the log cannot be written, or is there already.
    """
    from vfguide.cli.logs import new_log
    from vfguide.link.codec import Encoder
    from vfguide.runs.truth_log import TRUTH_COMPONENT, truth_message

    if folder is None:
        return lambda _: None
    log = stack.enter_context(new_log(folder / "truth.tlog"))
    encoders: dict[int, Encoder] = {}

    def write(vehicle: "SimVehicle") -> None:
        encoder = encoders.setdefault(vehicle.sysid, Encoder(vehicle.sysid, TRUTH_COMPONENT))
        log.write(vehicle.now, encoder.encode(truth_message(vehicle.now, vehicle.truth)))

    return write


def add_to(app: typer.Typer) -> None:
    """Add `vfguide sim` to the commands of `app`."""
    app.command()(sim)
