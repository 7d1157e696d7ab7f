"""Estimates of the numbers of an aircraft file, with their standard errors."""

import math
from typing import NamedTuple


class ParameterEstimate(NamedTuple):
    """An estimate of one number of an aircraft file."""

    table: str
    """The table of the file that has it."""
    key: str
    """Its key in that table."""
    value: float
    """The estimate in the unit of the file; not a number where there is none."""
    sigma: float
    """Its standard error in the unit of the file; not a number where there is none."""
    used: bool
    """Whether it is used; else what was known before is kept."""

    def __str__(self) -> str:
        """Key, value and standard error, as in "trim 0.296 +- 0.001"."""
        if not (math.isfinite(self.sigma) and self.sigma > 0.0):
            return f"{self.key} {self.value:.4g}"
        digits = max(0, -math.floor(math.log10(self.sigma)))
        return f"{self.key} {self.value:.{digits}f} +- {self.sigma:.{digits}f}"


class LiftEstimates(NamedTuple):
    """Estimates of the lift."""

    alpha_zero: ParameterEstimate
    """Angle of attack of zero lift [deg]."""
    alpha_load: ParameterEstimate
    """Its slope over n / V^2 [deg m^2/s^2]."""


class ThrustEstimates(NamedTuple):
    """Estimates of the thrust."""

    trim: ParameterEstimate
    """Setpoint of level flight at cruise, 0 to 1."""
    per_climb: ParameterEstimate
    """Its slope over f."""
    per_load: ParameterEstimate
    """Its slope over n^2."""
    response_time: ParameterEstimate
    """Time to 63 % of a step of the thrust [s]."""


def found(table: str, key: str, value: float, sigma: float, used: bool) -> ParameterEstimate:
    """An estimate, rounded as an aircraft file writes it, so that both are the same."""
    return ParameterEstimate(table, key, written(value), sigma, used)


def unseen(table: str, key: str) -> ParameterEstimate:
    """An estimate that the flight does not allow."""
    return ParameterEstimate(table, key, math.nan, math.nan, False)


def written(value: float) -> float:
    """A number rounded to four significant digits."""
    return float(f"{value:.4g}")
