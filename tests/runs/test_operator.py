"""What the daemon says in a flight, read as its operator reads it: true, and said once.

`operator_notes` has the states that he thinks of, which note may be said in which, and what each
claims. Setpoints that went out between two notes are counted and held against what was claimed.
"""

import random
from contextlib import ExitStack

import pytest
from altered import Altered
from operator_notes import NOTES, Line, faults_in

from vfguide.autopilots.engagement import FINAL_PHASES
from vfguide.autopilots.px4 import Px4Mode, main_and_sub
from vfguide.companion.companion import Companion
from vfguide.companion.session import Session
from vfguide.geometry.units import US
from vfguide.link.codec import Encoder, Parser
from vfguide.link.enums import MavCmd, ModeFlag
from vfguide.link.messages import (
    AttitudeQuaternion,
    CommandLong,
    CurrentMode,
    GpsGlobalOrigin,
    Heartbeat,
    LocalPositionNed,
    Timesync,
    VfrHud,
    WindCov,
)
from vfguide.preflight.load import load_scenario
from vfguide.runs.aeroplanes import Aeroplanes
from vfguide.runs.lockstep import Lockstep
from vfguide.runs.logs import Logs

pytestmark = pytest.mark.slow

ALL = object
STATE = (AttitudeQuaternion, LocalPositionNed, VfrHud, WindCov)
STATION = Encoder(255, 190)


class Between:
    """What happens to some kinds of messages for a time; everything else passes."""

    def __init__(self, kinds, begin, end):
        self.kinds, self.begin, self.end = kinds, begin, end

    def __call__(self, time, messages):
        if not self.begin <= time < self.end:
            return self.outside(time, messages)
        struck = [each for each in messages if isinstance(each, self.kinds)]
        others = [each for each in messages if not isinstance(each, self.kinds)]
        return [*self.strike(time, struck), *others]

    def outside(self, time, messages):
        return messages

    def strike(self, time, messages):
        raise NotImplementedError


class Lost(Between):
    """They are lost, all of them or a share."""

    def __init__(self, kinds, begin, end, share=1.0):
        super().__init__(kinds, begin, end)
        self.share, self.rng = share, random.Random(1)

    def strike(self, time, messages):
        return [each for each in messages if self.rng.random() >= self.share]


class Late(Between):
    """They arrive later by a delay [s], which is another one each time."""

    def __init__(self, kinds, begin, end, delay, more=0.0):
        super().__init__(kinds, begin, end)
        self.delay, self.more, self.rng, self.waiting = delay, more, random.Random(1), []

    def strike(self, time, messages):
        for each in messages:
            self.waiting.append((time + self.delay + self.rng.uniform(0.0, self.more), each))
        return self.outside(time, [])

    def outside(self, time, messages):
        due = [each for when, each in self.waiting if when <= time]
        self.waiting = [(when, each) for when, each in self.waiting if when > time]
        return [*due, *messages]


class Restarted(Between):
    """The autopilot's counter begins anew."""

    def __init__(self, begin):
        super().__init__((AttitudeQuaternion, LocalPositionNed), begin, 1e9)

    def strike(self, time, messages):
        since = round(1000 * self.begin)
        return [m._replace(time_boot_ms=max(m.time_boot_ms - since, 0)) for m in messages]


class Elsewhere(Between):
    """The position is that of another place, by a distance [m]."""

    def __init__(self, begin, end, distance):
        super().__init__(LocalPositionNed, begin, end)
        self.distance = distance

    def strike(self, time, messages):
        return [m._replace(x=m.x + self.distance) for m in messages]


class Another(Between):
    """A second autopilot says the same with another counter, and that it holds."""

    def __init__(self, begin, end):
        super().__init__((AttitudeQuaternion, LocalPositionNed, Heartbeat), begin, end)

    def strike(self, time, messages):
        return [each for m in messages for each in (m, self.other(m))]

    def other(self, m):
        if isinstance(m, Heartbeat):
            return m._replace(custom_mode=int(HOLD))
        return m._replace(time_boot_ms=m.time_boot_ms + 5_000_000)


class WithoutSensor(Between):
    """The airspeed is not a number."""

    def __init__(self, begin, end):
        super().__init__(VfrHud, begin, end)

    def strike(self, time, messages):
        return [m._replace(airspeed=float("nan")) for m in messages]


class Watched(Altered):
    """A session whose notes are read after every frame; for some times it does not run.

    What arrives then waits for it.
    """

    def __init__(self, session, events, stalls):
        super().__init__(session, self.alter)
        self.events, self.stalls, self.waiting, self.lines = events, stalls, b"", []

    def alter(self, time, message):
        messages = [message]
        for event in self.events:
            messages = event(time, messages)
        return messages

    def receive(self, now, data):
        self.waiting += data
        if self.is_stalled(now):
            return []
        data, self.waiting, out = self.waiting, b"", []
        for frame in Parser().feed(self.alteration.altered(now, data)):
            out += self.session.receive(now, frame.raw)
            self.look(now)
        return out or self.session.poll(now)

    def poll(self, now):
        return [] if self.is_stalled(now) else self.session.poll(now)

    def look(self, now):
        """Read what is new."""
        time, companion = (now - (self.alteration.began or now)) * US, self.session.companion
        self.lines += [Line(time, companion.setpoints, note) for note in companion.news()]

    def is_stalled(self, now):
        began = self.alteration.began
        time = 0.0 if began is None else (now - began) * US
        return any(begin <= time < begin + length for begin, length in self.stalls)


def choose(mode):
    """The operator chooses a mode at his ground station."""

    def act(member):
        main, sub = main_and_sub(mode)
        ask = CommandLong(
            member.vehicle.id, 1, MavCmd.DO_SET_MODE, 0, ModeFlag.CUSTOM_MODE_ENABLED, main, sub,
            0, 0, 0, 0,
        )  # fmt: skip
        member.sim.receive(member.sim.connect({}), STATION.encode(ask))

    return act


def stop(member):
    """The operator ends the companion."""
    now = member.sim.now
    member._up.send(now, member._session.stop(now))


def flown(folder, events=(), acts=(), *changes, stalls=(), engage=True, scenario="first-flight"):
    """The notes of a flight, and the line of its end.

    `acts` are what the operator does, each with its time [s].
    """
    loaded = load_scenario(scenario, ("duration_s=30.0", *changes))
    acts = sorted(acts, key=lambda act: act[0])
    with ExitStack() as stack:
        fleet = Aeroplanes(loaded, Logs(folder, stack))
        (member,) = fleet.members
        plan = member.companion.flight.plan
        member.companion = Companion(member.vehicle.id, plan, engage=engage)
        session = Session(member.companion, lambda *_: None)
        member._session = watched = Watched(session, list(events), stalls)
        lockstep = Lockstep(fleet, loaded.scenario.duration_s)
        while lockstep.sim_s < loaded.scenario.duration_s and lockstep.ending is None:
            lockstep.advance()
            while acts and acts[0][0] <= lockstep.sim_s:
                acts.pop(0)[1](member)
            watched.look(member.sim.now)
            if member.companion.phase in FINAL_PHASES:
                break
    return watched.lines, Line(lockstep.sim_s, member.companion.setpoints, "the end")


HOLD, OFFBOARD, RETURN = Px4Mode.HOLD, Px4Mode.OFFBOARD, Px4Mode.RETURN
POSITION, ATTITUDE = LocalPositionNed, AttitudeQuaternion
FLIGHTS = {
    "nothing happens": {},
    "nothing is heard": {"events": [Lost(ALL, -1, 99)], "acts": [(5, stop)]},
    "heartbeats alone": {"events": [Lost((*STATE, GpsGlobalOrigin), -1, 12)]},
    "stopped while offered": {"engage": False, "acts": [(5, stop)]},
    "stopped in flight": {"acts": [(8, stop)]},
    "stopped while lost": {"events": [Lost(ALL, 8, 99)], "acts": [(12, stop)]},
    "stopped while held": {"events": [Late(Timesync, 5, 20, 1.0)], "acts": [(9, stop)]},
    "stopped after release": {"acts": [(8, choose(HOLD)), (12, stop)]},
    "taken over": {"acts": [(8, choose(HOLD))]},
    "taken over in doubt": {"events": [Lost(POSITION, 7, 9)], "acts": [(8.2, choose(HOLD))]},
    "taken over, then lost": {
        "events": [Lost(ALL, 10, 30)], "acts": [(8, choose(RETURN)), (25, stop)]
    },
    "the operator chooses it": {"engage": False, "acts": [(5, choose(OFFBOARD))]},
    "the operator chooses another mode": {"acts": [(0.1, choose(RETURN)), (9, choose(OFFBOARD))]},
    "link lost": {"events": [Lost(ALL, 8, 13)], "acts": [(20, choose(OFFBOARD))]},
    "link lost while offered": {"events": [Lost(ALL, 8, 13)], "engage": False},
    "no attitude": {"events": [Lost(ATTITUDE, 8, 9.9)], "acts": [(20, choose(OFFBOARD))]},
    "no attitude while offered": {"events": [Lost(ATTITUDE, 8, 15)], "engage": False},
    "no position": {"events": [Lost(POSITION, 8, 13)], "acts": [(20, choose(OFFBOARD))]},
    "no position from the beginning": {"events": [Lost(POSITION, -1, 15)]},
    "late positions": {"events": [Late(POSITION, 5, 20, 0.3)]},
    "much too late positions": {"events": [Late(POSITION, 5, 20, 0.7)]},
    "everything late": {"events": [Late(ALL, 5, 20, 0.3)]},
    "everything late by anything": {"events": [Late(ALL, 5, 20, 0.0, 0.35)]},
    "answers late": {"events": [Late(Timesync, 5, 12, 0.4)]},
    "answers much too late": {
        "events": [Late(Timesync, 5, 12, 1.0)], "acts": [(20, choose(OFFBOARD))]
    },
    "answers stop": {"events": [Lost(Timesync, 8, 15)], "acts": [(20, choose(OFFBOARD))]},
    "answers never come": {"events": [Lost(Timesync, -1, 99)]},
    "answers stop, and the rest is late": {
        "events": [Lost(Timesync, 8, 99), Late(ALL, 9, 99, 1.0)]
    },
    "everything much too late": {"events": [Late(ALL, 8, 20, 1.5)]},
    "another speaks": {"events": [Another(8, 14)], "acts": [(26, choose(OFFBOARD))]},
    "another speaks from the beginning": {"events": [Another(-1, 99)]},
    "answers late by anything": {"events": [Late(Timesync, 5, 30, 0.0, 0.5)]},
    "answers too late from the beginning": {"events": [Late(Timesync, -1, 12, 0.8)]},
    "half of everything lost": {"events": [Lost(ALL, 3, 30, 0.5)]},
    "most of everything lost": {"events": [Lost(ALL, 3, 30, 0.9)]},
    "no airspeed sensor": {"events": [WithoutSensor(-1, 99)]},
    "airspeed for a while": {"events": [WithoutSensor(-1, 6), WithoutSensor(15, 20)]},
    "airspeed late at first": {"events": [Lost(VfrHud, 0.1, 4)], "engage": False,
                               "acts": [(2, choose(OFFBOARD))]},
    "no airspeed message": {"events": [Lost(VfrHud, 10, 16)]},
    "elsewhere from the beginning": {"events": [Elsewhere(-1, 12, 5e5)]},
    "elsewhere for a while": {"events": [Elsewhere(8, 10, 5e5)]},
    "elsewhere from now on": {"events": [Elsewhere(8, 20, 5e5)], "acts": [(24, choose(OFFBOARD))]},
    "the autopilot restarts": {"events": [Restarted(8)]},
    "stall of 0.7 s": {"stalls": [(8, 0.7)]},
    "stall of 2 s": {"stalls": [(8, 2.0)], "acts": [(14, choose(OFFBOARD))]},
    "stall of 5 s": {"stalls": [(8, 5.0)], "acts": [(20, choose(OFFBOARD)), (30, stop)]},
    "stalls while offered": {"stalls": [(5, 0.7), (8, 5.0)], "engage": False},
}  # fmt: skip


@pytest.mark.parametrize("name", FLIGHTS)
def test_a_flight_is_told_truly_and_once(tmp_path, name):
    flight = FLIGHTS[name]
    assert faults_in(*flown(tmp_path, **flight)) == []


@pytest.mark.parametrize(
    ("name", "told", "untrue"),
    [
        ("nothing is heard", "ended: no autopilot was found", "flies"),
        ("taken over, then lost", "ended: the autopilot is not heard any more", "nothing known"),
        ("heartbeats alone", "no setpoints: not heard yet: origin of ", "again"),
        ("no attitude while offered", "no setpoints: the attitude is too old", "position"),
        ("no position", "no setpoints: the position is too old", "attitude"),
        ("no airspeed message", "no airspeed is heard any more: ", "sensor is not believed"),
        ("airspeed late at first", "no setpoints: not heard yet: airspeed", "no airspeed sensor"),
        ("airspeed for a while", "the airspeed sensor is believed from now on", "not believed"),
        ("everything late by anything", "the autopilot follows", "jumped"),
        ("answers stop", "the autopilot does not answer TIMESYNC, so that the delay", "fallen"),
        ("answers never come", "no setpoints: the autopilot does not answer TIMESYNC", "again"),
        ("everything much too late", "no setpoints: the attitudes arrive 1.5 s late", "jumped"),
        ("another speaks", "more than one autopilot speaks as vehicle 1", "released"),
        ("answers late", "slow link: a setpoint acts 0.4 s after", "jumped"),
        ("stopped while held", "ended: the autopilot flies HOLD", "handing over"),
    ],
)  # fmt: skip
def test_the_reason_is_the_true_one(tmp_path, name, told, untrue):
    lines, _ = flown(tmp_path, **FLIGHTS[name])
    notes = [line.note for line in lines]
    times = 2 if name == "no position" else 1  # once more after the failsafe, as it is offered
    assert sum(note.startswith(told) for note in notes) == times, notes
    assert not [note for note in notes if untrue in note]


def drawn(seed):
    """A flight to which up to four things happen at any time."""
    rng = random.Random(seed)
    kinds = (
        ALL,
        ATTITUDE,
        POSITION,
        VfrHud,
        WindCov,
        Heartbeat,
        (Heartbeat, CurrentMode),
        Timesync,
    )
    events, acts, stalls = [], [], []
    for _ in range(rng.randint(1, 4)):
        begin, length, kind = rng.uniform(-1.0, 18.0), rng.uniform(0.3, 8.0), rng.choice(kinds)
        match rng.randrange(7):
            case 0:
                events.append(Lost(kind, begin, begin + length, rng.choice((0.5, 0.9, 1.0))))
            case 1:
                events.append(Late(kind, begin, begin + length, rng.uniform(0.0, 1.0)))
            case 2:
                events.append(Late(kind, begin, begin + length, 0.0, rng.uniform(0.0, 1.0)))
            case 3:
                events.append(WithoutSensor(begin, begin + length))
            case 4:
                stalls.append((begin, rng.uniform(0.1, 4.0)))
            case _:
                acts.append((max(begin, 0.0), choose(rng.choice((HOLD, OFFBOARD, RETURN)))))
    if rng.random() < 0.3:
        acts.append((rng.uniform(0.0, 28.0), stop))
    return {"events": events, "acts": acts, "stalls": stalls, "engage": rng.random() < 0.7}


@pytest.mark.parametrize("seed", range(25))
def test_any_flight_is_told_truly_and_once(tmp_path, seed):
    assert faults_in(*flown(tmp_path, **drawn(seed))) == []


def test_the_reader_finds_what_is_wrong():
    """What was said before it was mended, and what nobody ever said."""
    found = Line(0.02, 0, "the autopilot is found, it flies HOLD")
    sent = Line(0.04, 1, "setpoints go out, waiting for the operator to choose OFFBOARD")
    follows = Line(5.0, 249, "the autopilot follows")
    released = Line(8.0, 399, "released: the mode was changed to HOLD, no more setpoints")
    goal = Line(5.0, 249, "flying to goal 1 of 1")
    begin, later = [found, sent, follows], Line(9.0, 399, "setpoints go out again")
    end = Line(8.5, 420, "the end")
    assert faults_in([*begin, released], end._replace(setpoints=399)) == []
    wrong = {
        "cannot be said while TAKEN_OVER": ([*begin, released, later], later),
        "setpoints went out after: released": ([*begin, released], end),
        "none went out for": ([found, sent], Line(5.0, 1, "the end")),
        "is said twice": ([*begin, goal, goal], end),
        "nobody knows what it means": ([found, Line(1.0, 0, "hello")], end),
        "never began": ([*begin, Line(5.1, 250, "the airspeed sensor is believed again")], end),
        "none has gone out": ([found, sent._replace(setpoints=0)], end),
    }
    for fault, (lines, last) in wrong.items():
        assert any(fault in each for each in faults_in(lines, last)), fault
    assert all(each.states for each in NOTES)
