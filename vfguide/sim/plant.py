"""The simulated aeroplane: one JSBSim instance, seen in SI units."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from vfguide.geometry.so3 import from_euler
from vfguide.geometry.units import FT, G0, LBF, SLUG_FT2, SLUG_FT3
from vfguide.geometry.vector import Mat3, Vec3, add, matvec, sub, transpose
from vfguide.kernels.written_functions import maker
from vfguide.sim.condition import Model, Start, Weather
from vfguide.sim.fdm import JsbsimError, PropertyNode, load, model_error, never_free
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
_truth = maker(Truth)
Getter = Callable[[], float]


class Accelerations(NamedTuple):
    """How the motion of an aeroplane changes, body FRD."""

    v_dot_b: Vec3
    """Derivatives of u, v, w [m/s^2]."""
    omega_dot_b: Vec3
    """Derivatives of p, q, r [rad/s^2]."""


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
        self._bind_inner()
        self._bind_truth()
        self._bind_bench()
        self._weather = weather
        self._gusts = gusty_air(weather)
        self._air_changes = weather.varies or self._gusts is not None
        self.place(start, self._first_wind(start.altitude - ground_altitude))
        if not np.isfinite(self.accelerations()).all():
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
            self._set_wind(self._next_wind(FT * self._height()))
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

    def inner(self) -> InnerTuple:
        """`Inner` without its names, for the inner loop at every time step."""
        p, q, r, alpha, beta, airspeed, density = self._inner
        return p(), q(), r(), alpha(), beta(), FT * airspeed(), SLUG_FT3 * density()

    def truth(self) -> Truth:
        """The whole state."""
        load_x, load_y, load_up = self._load_factors()
        latitude, longitude, altitude, roll, pitch, yaw, height = self._place
        p, q, r, alpha, beta, airspeed, density = self.inner()
        return _truth(
            (
                self.steps * self._dt,
                latitude(),
                longitude(),
                FT * altitude(),
                self._v_n(),
                roll(),
                pitch(),
                yaw(),
                (p, q, r),
                airspeed,
                alpha,
                beta,
                self._wind_n(),
                (G0 * load_x, G0 * load_y, -G0 * load_up),
                density,
                FT * height(),
            )
        )

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

    def accelerations(self) -> Accelerations:
        """The accelerations at this instant."""
        return Accelerations(self._v_dot_b(), self._omega_dot_b())

    def thrust(self) -> float:
        """Force along body x other than the aerodynamic force [N]."""
        return LBF * (self._force_x() - self._aero_force_x())

    def inertia(self) -> Mat3:
        """Inertia tensor about the centre of gravity, body FRD [kg m^2]."""
        ixx, iyy, izz, ixy, ixz, iyz = (SLUG_FT2 * moment() for moment in self._moments)
        # JSBSim's properties are elements of the tensor, two of them with the sign changed.
        return ((ixx, -ixy, ixz), (-ixy, iyy, -iyz), (ixz, -iyz, izz))

    def mass(self) -> float:
        """Mass [kg]."""
        return LBF / G0 * self._weight()

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
        return add(wind_n, self._gusts.fly(sub(self._v_n(), wind_n), height, self._dt))

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
        self._set_controls = [self._node(name).set_double_value for name in surfaces + throttles]

    def _bind_inner(self) -> None:
        self._inner = (
            self._getter("velocities/p-rad_sec"),
            self._getter("velocities/q-rad_sec"),
            self._getter("velocities/r-rad_sec"),
            self._getter("aero/alpha-rad"),
            self._getter("aero/beta-rad"),
            self._getter("velocities/vt-fps"),
            self._getter("atmosphere/rho-slugs_ft3"),
        )

    def _bind_truth(self) -> None:
        self._height = self._getter("position/h-agl-ft")
        self._place = (
            self._getter("position/lat-geod-rad"),
            self._getter("position/long-gc-rad"),
            self._getter("position/geod-alt-ft"),
            self._getter("attitude/phi-rad"),
            self._getter("attitude/theta-rad"),
            self._getter("attitude/psi-rad"),
            self._height,
        )
        directions = ("north", "east", "down")
        self._v_n = self._vector_getter([f"velocities/v-{d}-fps" for d in directions], FT)
        self._wind_n = self._vector_getter(
            [f"atmosphere/total-wind-{d}-fps" for d in directions], FT
        )
        self._load_factors = self._vector_getter([f"accelerations/N{axis}" for axis in "xyz"], 1.0)

    def _bind_bench(self) -> None:
        self._v_dot_b = self._vector_getter([f"accelerations/{x}dot-ft_sec2" for x in "uvw"], FT)
        self._omega_dot_b = self._vector_getter(
            [f"accelerations/{x}dot-rad_sec2" for x in "pqr"], 1.0
        )
        self._force_x = self._getter("forces/fbx-total-lbs")
        self._aero_force_x = self._getter("forces/fbx-aero-lbs")
        self._weight = self._getter("inertia/weight-lbs")
        pairs = ("xx", "yy", "zz", "xy", "xz", "yz")
        self._moments = [self._getter(f"inertia/i{pair}-slugs_ft2") for pair in pairs]

    def _getter(self, name: str) -> Getter:
        return self._node(name).get_double_value

    def _node(self, name: str) -> PropertyNode:
        node = self._fdm.get_property_manager().get_node(name)
        if node is None:
            raise model_error(self._model, f"has no property {name}")
        return node

    def _vector_getter(self, names: list[str], unit: float) -> Callable[[], Vec3]:
        x, y, z = map(self._getter, names)
        return lambda: (unit * x(), unit * y(), unit * z())


def gusty_air(weather: Weather) -> GustyAir | None:
    """The gusts of a weather, if it has any."""
    if weather.turbulence is Turbulence.NONE:
        return None
    return GustyAir(weather.turbulence, weather.seed)
