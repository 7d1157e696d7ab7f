"""A plan and a place that do not fit: refused before engaging, handed over in flight."""

import math

import pytest
from conversations import Conversation, flying, heartbeat, modes_asked, plan, setpoints, state
from hypothesis import given, settings
from hypothesis import strategies as st

from vfguide.autopilots.engagement import Phase
from vfguide.autopilots.px4 import Px4Mode
from vfguide.companion.place import LEAST_REACH, reach_of
from vfguide.earth.geodesy import ned_to_geodetic, tangent_plane
from vfguide.geometry.units import DEG, DEG_E7, MM
from vfguide.link.enums import GpsFixType, MavResult
from vfguide.link.messages import (
    CommandAck,
    CommandLong,
    GlobalPositionInt,
    GpsGlobalOrigin,
    GpsRawInt,
    LocalPositionNed,
    VfrHud,
)

pytestmark = pytest.mark.slow

LATITUDE, LONGITUDE, ALTITUDE = plan().origin
ANYWHERE = st.tuples(
    st.floats(-90.0, 90.0), st.floats(-180.0, 180.0), st.floats(-400.0, 9000.0)
).filter(lambda at: far_from_plan(at[0] * DEG, at[1] * DEG))


def far_from_plan(lat, lon):
    """Whether a place is more than the plan's reach away, by the haversine, in radians."""
    a = math.sin(0.5 * (lat - LATITUDE)) ** 2
    a += math.cos(lat) * math.cos(LATITUDE) * math.sin(0.5 * (lon - LONGITUDE)) ** 2
    return 2.0 * 6.35e6 * math.asin(math.sqrt(min(a, 1.0))) > 1.1 * LEAST_REACH


class Elsewhere(Conversation):
    """An autopilot whose origin, altitude or global position is another than the plan's."""

    def __init__(self, origin=None, hud=0.0, place=None, **options):
        super().__init__(**options)
        self.origin, self.hud_error, self.place_error = origin, hud, place

    def hear(self, *messages):
        return super().hear(*(told for m in messages for told in self.altered(m)))

    def altered(self, m):
        if isinstance(m, GpsGlobalOrigin) and self.origin is not None:
            lat, lon, alt = self.origin
            yield m._replace(
                latitude=round(lat * 1e7), longitude=round(lon * 1e7), altitude=round(alt * 1e3)
            )
            return
        if isinstance(m, VfrHud):
            if self.origin is not None:
                m = m._replace(alt=self.origin[2] + 120.0)
            m = m._replace(alt=m.alt + self.hud_error)
        yield m
        if isinstance(m, VfrHud) and self.place_error is not None:
            north, east = self.place_error
            p_n = (0.025 * self.boot_ms + north, -300.0 + east, -120.0)
            lat, lon, alt = ned_to_geodetic(tangent_plane(*plan().origin), p_n)
            at = (round(lat / DEG_E7), round(lon / DEG_E7), round(alt / MM))
            yield GlobalPositionInt(self.boot_ms, *at, 0, 0, 0, 0, 0)


@given(ANYWHERE)
@settings(max_examples=60)
def test_nothing_goes_out_far_from_the_plan_and_it_is_told_once(at):
    talk = Elsewhere(at)
    said = talk.fly(12.0)
    assert not setpoints(said)
    assert not modes_asked(said)
    notes = [note for note in talk.told if note.startswith("no setpoints")]
    assert len(notes) == 1
    assert "km from the nearest goal" in notes[0]


@given(ANYWHERE)
@settings(max_examples=40)
def test_in_flight_a_far_place_that_lasts_ends_in_hold_and_silence(at):
    talk = Elsewhere()
    talk.fly(1.0)
    talk.fly(1.0, Px4Mode.OFFBOARD)
    assert talk.companion.phase is Phase.FLYING
    talk.origin = at
    talk.fly(5.0, Px4Mode.OFFBOARD)
    assert talk.companion.phase is Phase.YIELDING
    assert modes_asked(talk.said)[-1] == Px4Mode.HOLD
    assert any("km from the nearest goal" in note for note in talk.told)
    assert not setpoints(talk.fly(30.0, Px4Mode.HOLD))


@given(ANYWHERE, st.floats(0.1, 3.0))
@settings(max_examples=40)
def test_a_glitch_of_any_distance_is_flown_through(at, lasts):
    talk = Elsewhere()
    talk.fly(1.0)
    talk.fly(1.0, Px4Mode.OFFBOARD)
    talk.origin = at
    glitch = setpoints(talk.fly(lasts, Px4Mode.OFFBOARD))
    talk.origin = None
    after = setpoints(talk.fly(3.0, Px4Mode.OFFBOARD))
    assert talk.companion.phase is Phase.FLYING
    assert len(glitch) + len(after) == pytest.approx(50 * (lasts + 3.0), abs=3)


@given(st.floats(0.0, 2.0 * math.pi), st.floats(0.0, 0.85))
@settings(max_examples=40)
def test_a_start_within_the_reach_of_the_plan_is_flown(bearing, share):
    """The origin is that far from the plan's, and the vehicle within 400 m of the origin."""
    far = share * reach_of(plan())
    p_n = (far * math.cos(bearing), far * math.sin(bearing), 0.0)
    lat, lon, alt = ned_to_geodetic(tangent_plane(*plan().origin), p_n)
    talk = Elsewhere((lat / DEG, lon / DEG, alt))
    assert setpoints(talk.fly(1.0))
    assert talk.fly(1.0, Px4Mode.OFFBOARD)
    assert talk.companion.phase is Phase.FLYING


def test_it_goes_on_by_itself_once_the_autopilot_has_its_fix():
    """The first origin is 0/0/0, as before a fix; it is asked for again, and the next is right."""
    talk = Elsewhere((0.0, 0.0, 0.0))
    asked = []
    for _ in range(250):
        said = [m for m in talk.fly(0.02) if isinstance(m, CommandLong)]
        talk.hear(*(CommandAck(m.command, MavResult.ACCEPTED) for m in said))
        asked += [m for m in said if m.param1 == GpsGlobalOrigin.MSGID]
    assert len(asked) >= 3
    talk.origin = None
    assert setpoints(talk.fly(1.0))
    talk.fly(1.0, Px4Mode.OFFBOARD)
    assert talk.companion.phase is Phase.FLYING
    assert sum(note.startswith("setpoints go out, ") for note in talk.told) == 1
    assert not any("again" in note for note in talk.told)


@pytest.mark.parametrize("error", [-1500.0, -500.0, -150.0, 150.0, 500.0, 2000.0])
def test_two_altitudes_of_one_autopilot_are_not_flown_on(error):
    talk = Elsewhere(hud=error)
    assert not setpoints(talk.fly(5.0))
    assert any("from the one in VFR_HUD" in note for note in talk.told)


@given(st.floats(0.0, 2.0 * math.pi), st.floats(130.0, 9000.0))
@settings(max_examples=30)
def test_two_places_of_one_autopilot_are_not_flown_on(bearing, distance):
    talk = Elsewhere(place=(distance * math.cos(bearing), distance * math.sin(bearing)))
    assert not setpoints(talk.fly(5.0))
    assert any("from the one in GLOBAL_POSITION_INT" in note for note in talk.told)


@given(st.floats(0.0, 2.0 * math.pi), st.floats(0.0, 60.0))
@settings(max_examples=30)
def test_places_that_differ_by_noise_and_age_are(bearing, distance):
    talk = Elsewhere(place=(distance * math.cos(bearing), distance * math.sin(bearing)))
    assert len(setpoints(talk.fly(2.0))) == pytest.approx(100, abs=3)


@pytest.mark.parametrize("height", [-1400.0, -700.0, 700.0, 3000.0])
def test_a_plan_at_another_height_is_refused_before_the_flight(height):
    """The plan of one field, loaded at another that is as much higher or lower."""
    talk = Elsewhere((LATITUDE / DEG, LONGITUDE / DEG, ALTITUDE + height))
    assert not setpoints(talk.fly(5.0))
    assert any("can be climbed or sunk" in note for note in talk.told)


def test_the_follow_mode_is_not_asked_for_while_the_place_is_wrong():
    """The place goes wrong after a setpoint, before the 0.2 s of the offer are over."""
    talk = Elsewhere()
    talk.fly(0.1)
    assert setpoints(talk.said)
    talk.origin = (0.0, 0.0, 0.0)
    assert not modes_asked(talk.fly(10.0))


@pytest.mark.parametrize(
    ("altitude", "ellipsoid", "fix", "undulation"),
    [
        (535.4, 488.0, GpsFixType.GPS_FIX_TYPE_3D_FIX, -47.4),
        (10.0, 95.0, GpsFixType.GPS_FIX_TYPE_3D_FIX, 85.0),
        (535.4, 0.0, GpsFixType.GPS_FIX_TYPE_3D_FIX, None),
        (535.4, 488.0, GpsFixType.GPS_FIX_TYPE_2D_FIX, None),
        (535.4, -100.0, GpsFixType.GPS_FIX_TYPE_3D_FIX, None),
    ],
)
def test_the_undulation_is_what_a_receiver_with_a_fix_tells(altitude, ellipsoid, fix, undulation):
    talk = flying()
    told = GpsRawInt(0, fix, 0, 0, round(altitude * 1e3), 0, 0, 0, 0, 9, round(ellipsoid * 1e3))
    talk.hear(heartbeat(Px4Mode.OFFBOARD), told, *state(talk.boot_ms + 20))
    known = talk.companion._known.datum.undulation
    assert known == (None if undulation is None else pytest.approx(undulation))


class Shaken(Conversation):
    """The position goes to and fro by a distance."""

    distance = 0.0
    every = 10

    def hear(self, *messages):
        far = self.boot_ms // 20 // self.every % 2
        return super().hear(
            *(
                m._replace(x=m.x + far * self.distance) if isinstance(m, LocalPositionNed) else m
                for m in messages
            )
        )


def shaken(distance, every):
    talk = Shaken()
    talk.fly(1.0)
    talk.fly(1.0, Px4Mode.OFFBOARD)
    talk.distance, talk.every = distance, every
    return talk


@pytest.mark.parametrize("every", [1, 10, 25])
def test_a_place_that_goes_to_and_fro_is_told_once_and_ends_in_hold(every):
    talk = shaken(20_000.0, every)
    talk.fly(3.0, Px4Mode.OFFBOARD)
    assert talk.companion.phase is Phase.FLYING
    assert sum("not followed unless" in note for note in talk.told) == 1
    assert not any("right again" in note for note in talk.told)
    talk.fly(3.0, Px4Mode.OFFBOARD)
    assert talk.companion.phase is Phase.YIELDING


@pytest.mark.parametrize("every", [1, 10, 20])
def test_for_a_place_that_goes_to_and_fro_nothing_is_offered_and_it_is_told_once(every):
    talk = Shaken()
    talk.distance, talk.every = 20_000.0, every
    talk.fly(1.0)
    assert not setpoints(talk.fly(9.0))
    assert sum("no setpoints" in note for note in talk.told) == 1
    assert sum("go out again" in note for note in talk.told) <= 1


class TwoOrigins(Conversation):
    """The origin is told in each tick, now 1 m higher and now not."""

    def hear(self, *messages):
        higher = self.boot_ms // 20 % 2 * 1000
        return super().hear(
            *(
                m._replace(altitude=m.altitude + higher) if isinstance(m, GpsGlobalOrigin) else m
                for m in messages
            )
        )


def test_an_origin_that_moves_to_and_fro_is_told_now_and_then():
    talk = TwoOrigins()
    talk.fly(9.0)
    talk.fly(9.0, Px4Mode.OFFBOARD)
    assert 1 <= sum("moved the origin" in note for note in talk.told) <= 2


@pytest.mark.parametrize("every", [1, 10])
def test_a_position_that_goes_to_and_fro_is_told_now_and_then(every):
    talk = shaken(20.0, every)
    talk.fly(9.0, Px4Mode.OFFBOARD)
    assert 1 <= sum("has jumped" in note for note in talk.told) <= 2


def test_a_flight_that_begins_at_the_end_of_the_reach_may_lead_away_first():
    """The goal is at the origin of the plan; the vehicle flies north, 25 m each second."""
    far = reach_of(plan()) - 60.0
    lat, lon, alt = ned_to_geodetic(tangent_plane(*plan().origin), (far - 125.0, 0.0, 0.0))
    talk = Elsewhere((lat / DEG, lon / DEG, alt))
    talk.fly(1.0)
    talk.fly(9.0, Px4Mode.OFFBOARD)
    assert talk.companion.phase is Phase.FLYING
    assert not any("km from the nearest goal" in note for note in talk.told)


@pytest.mark.parametrize("height", [2500.0, 6000.0, 9000.0])
def test_another_height_in_flight_is_not_followed_and_ends_in_hold_if_it_lasts(height):
    """Origin and VFR_HUD agree on it, as after a wrong fix."""
    talk = Elsewhere()
    talk.fly(1.0)
    talk.fly(1.0, Px4Mode.OFFBOARD)
    talk.origin = (LATITUDE / DEG, LONGITUDE / DEG, ALTITUDE + height)
    talk.fly(2.0, Px4Mode.OFFBOARD)
    assert talk.companion.phase is Phase.FLYING
    assert any("can be climbed or sunk" in note for note in talk.told)
    assert not any("airspeed" in note for note in talk.told)  # of the density of another height
    talk.fly(3.0, Px4Mode.OFFBOARD)
    assert talk.companion.phase is Phase.YIELDING
