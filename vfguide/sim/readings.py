"""What is read of one JSBSim instance, in SI units: its properties are bound by name once."""

from collections.abc import Callable
from typing import NamedTuple

from vfguide.geometry.units import FT, G0, LBF, SLUG_FT2, SLUG_FT3
from vfguide.geometry.vector import Mat3, Vec3
from vfguide.kernels.written_functions import maker
from vfguide.sim.condition import Model
from vfguide.sim.fdm import Fdm, PropertyNode, model_error
from vfguide.sim.signals import InnerTuple
from vfguide.sim.truth import Truth

_truth = maker(Truth)
Getter = Callable[[], float]


class Accelerations(NamedTuple):
    """How the motion of an aeroplane changes, body FRD."""

    v_dot_b: Vec3
    """Derivatives of u, v, w [m/s^2]."""
    omega_dot_b: Vec3
    """Derivatives of p, q, r [rad/s^2]."""


class Readings:
    """The state of one aeroplane, and the forces on it."""

    def __init__(self, fdm: Fdm, model: Model) -> None:
        """The readings of `fdm`, which has loaded `model`.

        Raises:
            ModelError: the model lacks a property.
        """
        self._fdm = fdm
        self._model = model
        self._bind_inner()
        self._bind_truth()
        self._bind_forces()

    def inner(self) -> InnerTuple:
        """`Inner` without its names, for the inner loop at every time step."""
        p, q, r, alpha, beta, airspeed, density = self._inner
        return p(), q(), r(), alpha(), beta(), FT * airspeed(), SLUG_FT3 * density()

    def height(self) -> float:
        """Height above the ground [m]."""
        return FT * self._height()

    def truth(self, time: float) -> Truth:
        """The whole state, at the simulated time `time` [s]."""
        load_x, load_y, load_up = self._load_factors()
        latitude, longitude, altitude, roll, pitch, yaw, height = self._place
        p, q, r, alpha, beta, airspeed, density = self.inner()
        return _truth(
            (
                time,
                latitude(),
                longitude(),
                FT * altitude(),
                self.v_n(),
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
        self.v_n = self._vector_getter([f"velocities/v-{d}-fps" for d in directions], FT)
        """Velocity over ground, NED [m/s]."""
        self._wind_n = self._vector_getter(
            [f"atmosphere/total-wind-{d}-fps" for d in directions], FT
        )
        self._load_factors = self._vector_getter([f"accelerations/N{axis}" for axis in "xyz"], 1.0)

    def _bind_forces(self) -> None:
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
        return node(self._fdm, self._model, name).get_double_value

    def _vector_getter(self, names: list[str], unit: float) -> Callable[[], Vec3]:
        x, y, z = map(self._getter, names)
        return lambda: (unit * x(), unit * y(), unit * z())


def node(fdm: Fdm, model: Model, name: str) -> PropertyNode:
    """A property of `fdm`, by its name.

    Raises:
        ModelError: `model`, which it has loaded, lacks it.
    """
    found = fdm.get_property_manager().get_node(name)
    if found is None:
        raise model_error(model, f"has no property {name}")
    return found
