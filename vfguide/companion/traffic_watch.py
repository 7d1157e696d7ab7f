"""The watch of other aircraft from one vehicle: what they report, held against where it is."""

from vfguide.airspace.hazards import Hazards
from vfguide.companion.plan import Plan
from vfguide.estimation.local_frame import Measurement, place_state
from vfguide.link.messages import AdsbVehicle
from vfguide.surveillance.picture import Picture
from vfguide.surveillance.report import Ownship
from vfguide.surveillance.surveillance import Surveillance
from vfguide.telemetry.knowledge import Knowledge, measurement


class TrafficWatch:
    """The other aircraft that one vehicle hears."""

    def __init__(self, plan: Plan) -> None:
        """The watch before the first report."""
        self._origin = plan.origin
        self._surveillance = Surveillance(Picture(plan.origin, plan.volume, plan.own_icao))

    def hear(self, said: AdsbVehicle, known: Knowledge) -> list[str]:
        """Take a report, whose time is unknown without an attitude; returns notes."""
        if known.attitude is None:
            return []
        state, now_ms = measurement(known), known.time_ms
        ownship = None if state is None else self._ownship(state, now_ms)
        return self._surveillance.hear(said, now_ms, ownship, known.datum)

    def look(self, state: Measurement, now_ms: int) -> list[str]:
        """Look at the others from the state of the time `now_ms` [ms], if it is time; the notes.

        The state is predicted: to where the setpoint acts.
        """
        if not self._surveillance.is_listening:
            return []
        self._surveillance.follow(self._ownship(state, now_ms))
        if not self._surveillance.is_due(now_ms):
            return []
        predicted = place_state(state, self._origin)
        return self._surveillance.look(Ownship(now_ms, predicted.p_n, predicted.v_n))

    def among(self, hazards: Hazards, now_ms: int, t: float) -> Hazards:
        """The hazards with the aircraft in reach among them, as `Surveillance.among`."""
        return self._surveillance.among(hazards, now_ms, t)

    def _ownship(self, state: Measurement, now_ms: int) -> Ownship:
        """The ownship at the time `now_ms` of the attitude [ms], in the frame of the plan."""
        ownship = place_state(state._replace(lead=0.0), self._origin)
        return Ownship(now_ms, ownship.p_n, ownship.v_n)
