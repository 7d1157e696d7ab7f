"""The simulated aeroplane: one JSBSim instance, seen in SI units."""

from collections.abc import Callable

import numpy as np

from vfguide.geometry.so3 import from_euler
from vfguide.geometry.units import FT
from vfguide.geometry.vector import Vec3, add, matvec, sub, transpose
from vfguide.sim.condition import Model, Start, Weather
from vfguide.sim.fdm import JsbsimError, load, model_error, never_free
from vfguide.sim.readings import Readings, node
from vfguide.sim.signals import ControlTuple, InnerTuple
from vfguide.sim.truth import Truth
from vfguide.sim.turbulence import GustyAir, Turbulence

STEP = 1.0 / 200.0
"""Default time step of the simulation [s]; chosen, 200 Hz."""

_SETTLING_RUNS = 3
"""Runs with the clock stopped: by the third, every function has seen what the others give."""
_EVERY_ENGINE = -1
_RETRACTED = 0.0
_RICH = 1.15
"""Mixture of a leaned piston engine over the ratio of the air pressure to that at sea level, a
number; chosen, so that it is full rich up to 1150 m, as a pilot leaves it."""
_SEA_LEVEL_PRESSURE = 2116.22
"""Air pressure at sea level in the standard atmosphere [lbf/ft^2] (ISO 2533)."""


class Plant:
    """One aeroplane in its air, from its start onward.

    Each plant is a JSBSim instance of its own, made afresh: equal arguments and controls give
    bit-identical flights, whatever else has run in the process. The ground is level at
    `ground_altitude` [m] above mean sea level. `dt` is the time step [s].

    Raises:
        ModelError: the model is missing, unreadable or broken.
    """

    def __init__(
        self,
        model: Model,
        start: Start,
        weather: Weather | None = None,
        ground_altitude: float = 0.0,
        dt: float = STEP,
    ) -> None:
        weather = weather or Weather()
        self._model = model
        self._dt = dt
        self.steps = 0
        """Time steps since the start."""
        self._fdm = load(model, dt)
        self._fdm["ic/terrain-elevation-ft"] = ground_altitude / FT
        self._bind_controls()
        self.readings = Readings(self._fdm, model)
        """What is read of it."""
        self.inner: Callable[[], InnerTuple] = self.readings.inner
        """`Inner` without its names, for the inner loop at every time step."""
        self._weather = weather
        self._gusts = gusty_air(weather)
        self._air_changes = weather.varies or self._gusts is not None
        self.place(start, self._first_wind(start.altitude - ground_altitude))
        if not np.isfinite(self.readings.accelerations()).all():
            raise model_error(model, "accelerations are not finite at the start")

    @property
    def time(self) -> float:
        """Simulated time since the start [s]."""
        return self.steps * self._dt

    def advance(self, controls: ControlTuple) -> None:
        """Fly one time step with `controls` (aileron, elevator, rudder, throttle) held.

        Raises:
            ModelError: the model fails in flight.
        """
        self._command(controls)
        if self._air_changes:
            self._set_wind(self._next_wind(self.readings.height()))
        try:
            self._run()
        except JsbsimError as error:
            never_free(self._fdm)
            raise model_error(self._model, f"in flight: {error}") from error
        self.steps += 1

    def run_bare(self, steps: int) -> None:
        """JSBSim alone for a number of time steps, controls held: a reference of speed."""
        for _ in range(steps):
            self._run()
        self.steps += steps

    def truth(self) -> Truth:
        """The whole state."""
        return self.readings.truth(self.steps * self._dt)

    def place(self, start: Start, wind_n: Vec3 = (0.0, 0.0, 0.0)) -> None:
        """Put the aeroplane into `start`, servos and motor in steady state, time standing still.

        For trim and identification. A flight needs a fresh plant: what gusts and integrators
        remember is not wiped here.
        """
        self._place_at(start)
        self._move(start, wind_n)
        self._fdm.run_ic()
        # run_ic forgets the controls and takes its own wind.
        self._set_wind(wind_n)
        self._settle(start.condition.controls)

    def _place_at(self, start: Start) -> None:
        fdm = self._fdm
        fdm["ic/lat-geod-rad"] = start.latitude
        fdm["ic/long-gc-rad"] = start.longitude
        # JSBSim takes the height above its sea level along the radius: millimetres off.
        fdm["ic/h-sl-ft"] = start.altitude / FT
        fdm["ic/h-sl-ft"] += start.altitude / FT - fdm["ic/geod-alt-ft"]

    def _move(self, start: Start, wind_n: Vec3) -> None:
        """Set attitude, then the velocity over ground: any other order changes the first."""
        fdm, condition = self._fdm, start.condition
        fdm["ic/phi-rad"] = condition.bank
        fdm["ic/theta-rad"] = condition.pitch
        fdm["ic/psi-true-rad"] = start.yaw
        R_nb = from_euler(condition.bank, condition.pitch, start.yaw)
        v_b = add(condition.v_air_b, matvec(transpose(R_nb), wind_n))
        for name, speed in zip("uvw", v_b, strict=True):
            fdm[f"ic/{name}-fps"] = speed / FT
        for name, rate in zip("pqr", condition.omega_b, strict=True):
            fdm[f"ic/{name}-rad_sec"] = rate

    def _set_wind(self, wind_n: Vec3) -> None:
        for axis, speed in zip(("north", "east", "down"), wind_n, strict=True):
            self._fdm[f"atmosphere/wind-{axis}-fps"] = speed / FT

    def _first_wind(self, height: float) -> Vec3:
        """The wind at the start with its gusts: the aeroplane begins in equilibrium with both."""
        wind_n = self._weather.wind_at(0.0, height)
        return add(wind_n, self._gusts.gust_at(height)) if self._gusts else wind_n

    def _next_wind(self, height: float) -> Vec3:
        """The wind of this step with its gusts, in the air into which the aeroplane has flown."""
        wind_n = self._weather.wind_at(self.time, height)
        if self._gusts is None:
            return wind_n
        return add(wind_n, self._gusts.fly(sub(self.readings.v_n(), wind_n), height, self._dt))

    def _settle(self, controls: ControlTuple) -> None:
        """Bring servos, motor and engines to what `controls` command, the clock standing."""
        fdm, propulsion = self._fdm, self._fdm.get_propulsion()
        fdm["gear/gear-cmd-norm"] = _RETRACTED
        if self._engines:
            propulsion.init_running(_EVERY_ENGINE)
            self._lean()
        # Servos have no lag and no rate limit while JSBSim is being trimmed.
        fdm.set_trim_status(True)
        fdm.suspend_integration()
        for _ in range(_SETTLING_RUNS):
            self._command(controls)
            self._run()
            if self._engines:
                propulsion.get_steady_state()
        fdm.resume_integration()
        fdm.set_trim_status(False)

    def _lean(self) -> None:
        """Lean the mixture for the height, as a pilot does; init_running has made it full rich."""
        fdm, rich = self._fdm, _RICH * self._fdm["atmosphere/P-psf"] / _SEA_LEVEL_PRESSURE
        for engine in range(self._engines):
            fdm[f"fcs/mixture-cmd-norm[{engine}]"] = min(1.0, rich)

    def _command(self, controls: ControlTuple) -> None:
        aileron, elevator, rudder, throttle = controls
        set_aileron, set_elevator, set_rudder, *set_throttles = self._set_controls
        set_aileron(aileron)
        set_elevator(elevator)
        set_rudder(rudder)
        for set_throttle in set_throttles:
            set_throttle(throttle)

    def _bind_controls(self) -> None:
        self._run = self._fdm.run
        self._engines = self._fdm.get_propulsion().get_num_engines()
        surfaces = [f"fcs/{name}-cmd-norm" for name in ("aileron", "elevator", "rudder")]
        throttles = [f"fcs/throttle-cmd-norm[{i}]" for i in range(max(1, self._engines))]
        self._set_controls = [
            node(self._fdm, self._model, name).set_double_value for name in surfaces + throttles
        ]


def gusty_air(weather: Weather) -> GustyAir | None:
    """The gusts of a weather, if it has any."""
    if weather.turbulence is Turbulence.NONE:
        return None
    return GustyAir(weather.turbulence, weather.seed)
