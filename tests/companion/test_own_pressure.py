"""The autopilot's own pressure: asked for when traffic needs it, and what follows from it."""

import math

import pytest
from conversations import Conversation, plan, state

from vfguide.earth.pressure_altitude import isa_pressure
from vfguide.geometry.units import DEG_E7, HPA, MM
from vfguide.link.enums import AdsbAltitudeType, MavCmd, MavResult
from vfguide.link.messages import AdsbVehicle, CommandAck, CommandLong, ScaledPressure
from vfguide.telemetry.knowledge import Knowledge, observe

ORIGIN = plan().origin
OWN_ALTITUDE = ORIGIN[2] + 120.0


def traffic(kind):
    place = (round(ORIGIN[0] / DEG_E7) + 90_000, round(ORIGIN[1] / DEG_E7), kind)
    return AdsbVehicle(0x4B1A2C, *place, round(OWN_ALTITUDE / MM), 0, 0, 0, "FAR", 1, 0, 0x9F, 0)


def pressure(offset):
    return ScaledPressure(5000, isa_pressure(OWN_ALTITUDE + offset) / HPA, 0.0, 1500)


def asked(messages):
    """The intervals in which the pressure is asked for [us]."""
    return [
        m.param2
        for m in messages
        if isinstance(m, CommandLong)
        and (m.command, m.param1) == (MavCmd.SET_MESSAGE_INTERVAL, ScaledPressure.MSGID)
    ]


class Answering(Conversation):
    """Whose autopilot acknowledges every stream."""

    def hear(self, *messages):
        out = super().hear(*messages)
        for each in out:
            if isinstance(each, CommandLong):
                super().hear(CommandAck(each.command, MavResult.ACCEPTED))
        return out


def test_it_is_asked_for_once_when_a_pressure_altitude_is_heard():
    talk = Answering(engage=False)
    talk.fly(2.0)
    talk.hear(traffic(AdsbAltitudeType.GEOMETRIC))
    talk.fly(2.0)
    assert asked(talk.said) == []
    for _ in range(5):
        talk.hear(traffic(AdsbAltitudeType.PRESSURE_QNH))
        talk.fly(1.0)
    assert asked(talk.said) == [1e6]


@pytest.mark.parametrize("offset", [-250.0, -40.0, 0.0, 164.0, 500.0])
def test_the_offset_is_the_pressure_altitude_less_the_altitude(offset):
    known = Knowledge()
    for message in (*state(5000), pressure(offset)):
        known = observe(known, message, 0)
    assert known.datum.pressure_offset == pytest.approx(offset, abs=0.01)


@pytest.mark.parametrize("press_abs", [0.0, -3.0, math.nan, math.inf, 400.0, 1300.0])
def test_a_sensor_that_is_wrong_is_as_good_as_none(press_abs):
    known = Knowledge()
    for message in (*state(5000), pressure(0.0), pressure(0.0)._replace(press_abs=press_abs)):
        known = observe(known, message, 0)
    assert known.datum.pressure_offset is None


def test_without_a_position_there_is_no_offset():
    assert observe(Knowledge(), pressure(10.0), 0).pressure_offset is None


@pytest.mark.parametrize("tells", [True, False])
def test_an_autopilot_without_pressure_is_told_of_once_before_it_is_engaged(tells):
    talk = Answering(engage=False)
    for _ in range(20):
        talk.fly(1.0)
        talk.hear(traffic(AdsbAltitudeType.PRESSURE_QNH))
        if tells:
            talk.hear(pressure(30.0))
    assert len([note for note in talk.told if "tells no pressure" in note]) == (not tells)
