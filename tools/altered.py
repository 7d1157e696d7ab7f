"""Flights in which messages from the autopilot to its companion are altered on the link."""

from collections.abc import Callable, Sequence
from contextlib import ExitStack
from dataclasses import dataclass

import numpy as np

from vfguide.autopilots.engagement import SENDING
from vfguide.companion.session import Session
from vfguide.link.codec import Encoder, Parser, decode
from vfguide.preflight.load import load_scenario
from vfguide.results.judge import judge
from vfguide.results.record import FlightRecord
from vfguide.results.result import Result
from vfguide.runs.aeroplanes import Aeroplanes
from vfguide.runs.lockstep import Lockstep
from vfguide.runs.logs import Logs

Alter = Callable[[float, object], Sequence[object]]
"""The messages that arrive in place of one that was sent, `time` [s] after the start."""


class Alteration:
    """What an autopilot sends, decoded, altered and encoded again."""

    def __init__(self, alter: Alter):
        self.alter, self.parser, self.began = alter, Parser(), None
        self.encoders = {}

    def altered(self, now, data) -> bytes:
        """The bytes that arrive at `now` [us] in place of `data`."""
        self.began = now if self.began is None else self.began
        altered = b""
        for frame in self.parser.feed(data):
            message = decode(frame)
            if message is None:
                altered += frame.raw
                continue
            who = (frame.sysid, frame.compid)
            encoder = self.encoders.setdefault(who, Encoder(*who))
            told = self.alter((now - self.began) * 1e-6, message)
            altered += b"".join(encoder.encode(each) for each in told)
        return altered


class Altered:
    """A session whose input is altered between the autopilot and the companion."""

    def __init__(self, session: Session, alter: Alter):
        self.session, self.alteration = session, Alteration(alter)
        self.unpermitted = 0
        """Number of setpoints that went out in a phase in which none may."""

    def receive(self, now, data):
        """What the companion answers at `now` [us] to the altered `data`."""
        altered = self.alteration.altered(now, data)
        companion = self.session.companion
        before, was_sending = companion.setpoints, companion.phase in SENDING
        answers = self.session.receive(now, altered) if altered else self.session.poll(now)
        if not was_sending and companion.phase not in SENDING:
            self.unpermitted += companion.setpoints - before
        return answers

    def __getattr__(self, name):
        return getattr(self.session, name)


@dataclass(frozen=True)
class AlteredFlight:
    """The truth of an altered flight, its result, and the notes to the operator."""

    record: FlightRecord
    result: Result
    told: tuple[tuple[float, str], ...]
    unpermitted: int
    """Number of setpoints that went out in a phase in which none may."""

    @property
    def bank(self):
        """Greatest bank [deg]."""
        return self.result.vehicles[0].max_bank_deg

    @property
    def load(self):
        """Least and greatest load factor."""
        return self.result.vehicles[0].load_factor

    @property
    def lost(self):
        """Height lost below the lower one of start and goal [m]."""
        down = self.record.p_n[:, 2]
        return float(down.max() - max(down[0], -120.0))

    def notes(self, words):
        """The notes that contain some words."""
        return [note for _, note in self.told if words in note]


def fly_altered(folder, alter: Alter, *changes, scenario="first-flight") -> AlteredFlight:
    """Fly a scenario with every message to the companion altered."""
    loaded, told = load_scenario(scenario, changes), []
    with ExitStack() as stack:
        fleet = Aeroplanes(loaded, Logs(folder, stack))
        member = fleet.members[0]
        member._session = altered = Altered(member._session, alter)
        lockstep = Lockstep(fleet, loaded.scenario.duration_s)
        while lockstep.ending is None:
            lockstep.advance()
            told += [(lockstep.sim_s, note) for note in member.companion.news()]
        records = fleet.records()
    result = judge(loaded.scenario, records, lockstep.sim_s, 1.0)
    return AlteredFlight(records[0], result, tuple(told), altered.unpermitted)


def turned_about_vertical(q, angle):
    """A quaternion w, x, y, z turned by an angle about the down axis of NED [rad]."""
    c, s = np.cos(0.5 * angle), np.sin(0.5 * angle)
    w, x, y, z = q
    return c * w - s * z, c * x - s * y, c * y + s * x, c * z + s * w
