"""The software autopilot: PX4's identity and behaviour on MAVLink, as far as a flight needs it.

No socket, clock or thread: the caller brings the time, the truth and the bytes.
"""

import math

from vfguide.aircraft.performance import Performance
from vfguide.earth.atmosphere import isa_density, true_airspeed
from vfguide.geometry.units import MS, SECOND
from vfguide.geometry.vector import Vec3
from vfguide.kernels.written_functions import maker
from vfguide.link.enums import MavSeverity
from vfguide.link.messages import (
    AdsbVehicle,
    CurrentMode,
    ScaledPressure,
    SetAttitudeTarget,
    Statustext,
    WindCov,
)
from vfguide.sim.autopilot.attitude_control import ATTITUDE_IGNORE, demand_of
from vfguide.sim.autopilot.estimate import Estimate, Estimator
from vfguide.sim.autopilot.flight_mode import (
    FAILSAFE_MODES,
    INTENDED,
    NEXT_MODE,
    REPORTED,
    Event,
    Mode,
)
from vfguide.sim.autopilot.instruments import Instruments
from vfguide.sim.autopilot.loiter import Loiter
from vfguide.sim.autopilot.mavlink_channel import MavlinkChannel
from vfguide.sim.autopilot.motor import SOUND, Motor
from vfguide.sim.autopilot.noise import RateNoise
from vfguide.sim.autopilot.parameters import HOLD_ACTION, Parameters
from vfguide.sim.autopilot.telemetry import MAKERS, Report
from vfguide.sim.inner_loop.airframe_model import Airframe
from vfguide.sim.inner_loop.inner_loop import inner_loop
from vfguide.sim.signals import Controls, ControlTuple, Inner, InnerTuple, without_names
from vfguide.sim.truth import Truth

_report = maker(Report)


class Autopilot:
    """One autopilot, airborne, armed and in hold from its first moment."""

    def __init__(
        self,
        sysid: int,
        airframe: Airframe,
        aircraft: Performance,
        airspeed: float,
        first: Truth,
        instruments: Instruments,
        motor: Motor = SOUND,
    ) -> None:
        """An autopilot that has just taken over.

        Args:
            sysid: its MAVLink system id.
            airframe: what the rate loop and the thrust map know of the aircraft.
            aircraft: what its hold knows of it, as at sea level.
            airspeed: true airspeed of its hold [m/s].
            first: the truth at its start; the local frame begins there.
            instruments: what it measures with.
            motor: what it gets of the thrust that it sets; it does not know.
        """
        self.sysid = sysid
        self.mode = Mode.HOLD
        self.parameters = Parameters()
        self.ports: list[MavlinkChannel] = []
        """The channels on which it is heard."""
        self.now = 0
        """Date of the latest update [us since 1970]."""
        self._airframe = airframe
        self._tables = airframe.tables
        self._estimator = Estimator(first, instruments)
        self._silent = silent_streams(instruments)
        errors = instruments.errors
        self._rates = None if errors is None else RateNoise(errors, instruments.rate_seed)
        self._cruise = aircraft.airspeed_cruise
        self._has_airspeed = self._estimator.has_airspeed(first.time)
        self.estimate: Estimate = self._estimator.update(first)
        self._hold = Loiter(aircraft, airspeed, self.estimate)
        self.setpoint: SetAttitudeTarget | None = None
        """The newest setpoint, whether or not it is flown."""
        self._setpoint_at = -SECOND * 3600
        self._wanted = (0.0, 0.0, 0.0, airframe.cruise_thrust)  # p, q, r [rad/s], thrust
        self._motor = motor
        self._thrust_share = motor.share(first.time)
        self._is_flyable = True  # else PX4 puts all surfaces to trim and stops the motor
        self._integral: Vec3 = (0.0, 0.0, 0.0)
        self._controls: ControlTuple = Controls()

    @property
    def origin(self) -> tuple[float, float, float]:
        """Latitude, longitude [rad] and altitude [m] of the origin of the local frame."""
        return self._estimator.origin

    def control(self, inner: InnerTuple, dt: float) -> ControlTuple:
        """Controls by the rate loop and the thrust map, at every step of the plant of `dt` [s].

        `inner` has the measurements of the loop, still without errors.
        """
        if not self._is_flyable:
            self._controls = self._airframe.cruise.controls._replace(throttle=0.0)
            return self._controls
        if self._rates is not None:
            inner = self._rates.measure(inner, self._estimator.error.airspeed)
        if not self._has_airspeed:
            # PX4 then scales with the trim airspeed, an equivalent one.
            cruise = true_airspeed(self._cruise, isa_density(self.estimate.altitude))
            inner = without_names(Inner(*inner)._replace(airspeed=cruise))
        p, q, r, thrust = self._wanted
        self._controls, self._integral = inner_loop(
            self._tables, inner, (p, q, r, thrust * self._thrust_share), self._integral, dt
        )
        return self._controls

    def update(self, now: int, truth: Truth) -> None:
        """The slower part: estimate, loss of the stream, attitude setpoints, hold.

        `now` is the date [us since 1970], `truth` the state of the plant then.
        """
        self.now = now
        rate_error = (0.0, 0.0, 0.0) if self._rates is None else self._rates.last
        self.estimate = self._estimator.update(truth, rate_error)
        self._has_airspeed = self._estimator.has_airspeed(truth.time)
        self._thrust_share = self._motor.share(truth.time)
        self._watch_stream()
        if self.mode is not Mode.OFFBOARD:
            omega_b, thrust = self._hold.step(self.estimate)
            self._wanted = (*omega_b, thrust)
            self._is_flyable = True
        elif self.setpoint is not None and not self.setpoint.type_mask & ATTITUDE_IGNORE:
            self._follow(self.setpoint)  # its body rates change with the attitude

    def streams(self, port: MavlinkChannel) -> list[bytes]:
        """The frames that are due on a port now."""
        report = self.report()
        messages, silent = port.take_queue(self.now), self._silent
        messages += [MAKERS[msgid](report) for msgid in port.due(self.now) if msgid not in silent]
        return [port.encode(message) for message in messages]

    def report(self) -> Report:
        """Everything that the streams tell."""
        _, _, _, throttle = self._controls
        return _report(
            (
                self.now,
                round(self.estimate.time / MS) % 2**32,
                self.estimate,
                self._estimator.origin,
                self._estimator.home,
                self.mode,
                True,
                self.setpoint if self.mode is Mode.OFFBOARD else None,
                throttle,
                self._estimator.pressure_altitude,
                self._estimator.undulation,
            )
        )

    def take_setpoint(self, setpoint: SetAttitudeTarget) -> None:
        """Take a setpoint; the stream goes on with it."""
        self.setpoint = setpoint
        self._setpoint_at = self.now
        if self.mode in FAILSAFE_MODES:
            self.happen(Event.STREAM_BACK)
        if self.mode is Mode.OFFBOARD:
            self._follow(setpoint)

    @property
    def has_stream(self) -> bool:
        """Whether setpoints arrive."""
        age = self.now - self._setpoint_at
        return age <= self.parameters["COM_OF_LOSS_T"] * SECOND

    def happen(self, event: Event) -> None:
        """Go on in the table of modes; tell the links."""
        after = NEXT_MODE[self.mode, event]
        if after is self.mode:
            return
        self.mode = after
        if after in (Mode.HOLD, Mode.LOST_TO_HOLD):
            self._hold.start_here(self.estimate)
        elif after is not Mode.OFFBOARD:
            self._hold.begin_about(self._estimator.home, self.estimate)
        elif self.setpoint is not None:
            self._follow(self.setpoint)
        self._announce(after)

    def pass_on(self, message: AdsbVehicle) -> None:
        """Send what the receiver has heard to every link."""
        for port in self.ports:
            port.queue(self.now, message)

    def _announce(self, mode: Mode) -> None:
        name = REPORTED[mode].name.lower()
        lost = mode in FAILSAFE_MODES
        text = f"Failsafe: no offboard setpoints, {name}" if lost else f"Flight mode {name}"
        severity = MavSeverity.CRITICAL if lost else MavSeverity.INFO
        for port in self.ports:
            port.queue(self.now, CurrentMode(0, REPORTED[mode], INTENDED[mode]))
            if port.has_ground_station:
                port.queue(self.now, Statustext(severity, text))

    def _watch_stream(self) -> None:
        if self.mode is Mode.OFFBOARD and not self.has_stream:
            hold = self.parameters["NAV_RCL_ACT"] == HOLD_ACTION
            self.happen(Event.STREAM_LOST_HOLD if hold else Event.STREAM_LOST_RETURN)

    def _follow(self, setpoint: SetAttitudeTarget) -> None:
        """Body rates and thrust of the setpoint; what it ignores is not made up for."""
        self._wanted = demand_of(setpoint, self.estimate.euler, self.estimate.true_airspeed)
        self._is_flyable = all(map(math.isfinite, self._wanted))


def silent_streams(instruments: Instruments) -> frozenset[int]:
    """Ids of the streams that an autopilot with these instruments never sends."""
    tells = {WindCov: instruments.tells_wind, ScaledPressure: instruments.tells_pressure}
    return frozenset(message.MSGID for message, told in tells.items() if not told)
