"""The ownship's track: its positions and velocities of the last seconds.

A report of the ownship's own transponder is late by an unknown time: it agrees with this track at
one of its ages, in position and in velocity.
"""

import math
from itertools import pairwise
from typing import NamedTuple

from vfguide.geometry.vector import Vec3, add, norm, scale, sub
from vfguide.link.boot_time import elapsed
from vfguide.surveillance.report import Ownship

SAMPLE_INTERVAL = 0.1
"""Least time between two samples of the track [s]; chosen: the tightest turn bends by 0.1 m from
the chord of two samples."""
TRACK_TIME = 3.5
"""Time that the track reaches back [s]; chosen, since receivers pass reports on up to 3 s late."""
TRACK_BREAK_TIME = 1.5
"""Time without a sample after which the track begins anew [s]; chosen."""
TRACK_BREAK_DISTANCE = 10.0
"""Distance of a sample from where the one before leads beyond which the track begins anew [m];
chosen: the position that the autopilot reports was reset."""
POSITION_TOLERANCE = 12.0
"""Horizontal distance within which a report agrees with the track [m]; chosen for errors of 4 m in
each of two receivers, and below the distance of aircraft in close formation."""
VELOCITY_TOLERANCE = 4.0
"""Difference of velocities over ground within which a report agrees [m/s]; chosen: a velocity that
is 0.2 s older than its position differs by that in a steep turn."""

FASTEST_OWN = 150.0
"""Largest speed over ground of the ownship, which bounds how far from it a report of its track can
be [m/s]; chosen above any aircraft that is flown."""
NormalisedState = tuple[float, float, float, float]
"""Horizontal position and velocity, each in units of its tolerance."""


class OwnTrack(NamedTuple):
    """Samples of the ownship, the oldest first."""

    samples: tuple[Ownship, ...] = ()
    """At least SAMPLE_INTERVAL apart; they reach back by TRACK_TIME and one sample more."""


class Match(NamedTuple):
    """The point of the track that a report fits best."""

    age: float
    """Time from there to the newest point of the track [s]."""
    miss: float
    """Root of the sum of the squares of the horizontal differences of position and velocity, each
    in units of its tolerance: up to 1 where the report can come from there."""
    own: Ownship
    """The ownship there."""


def extended(track: OwnTrack, ownship: Ownship) -> OwnTrack:
    """The track with the ownship at a later time; begun anew where the two do not belong together.

    Unchanged if SAMPLE_INTERVAL has not passed.
    """
    if not track.samples:
        return OwnTrack((ownship,))
    last = track.samples[-1]
    step = elapsed(last.time_ms, ownship.time_ms)
    if 0.0 <= step < SAMPLE_INTERVAL:
        return track
    leads_to = add(last.p_n, scale(0.5 * step, add(last.v_n, ownship.v_n)))
    if (
        not 0.0 < step <= TRACK_BREAK_TIME
        or norm(sub(ownship.p_n, leads_to)) > TRACK_BREAK_DISTANCE
    ):
        return OwnTrack((ownship,))
    there = [
        one
        for one, after in pairwise((*track.samples, ownship))
        if elapsed(after.time_ms, ownship.time_ms) < TRACK_TIME
    ]
    return OwnTrack((*there, ownship))


def may_precede(track: OwnTrack, ownship: Ownship, p_n: Vec3) -> bool:
    """Whether the ownship may have been at `p_n` within TRACK_TIME, but before the track.

    Then it is behind the oldest sample, or ahead of it by no more than POSITION_TOLERANCE.
    """
    first = track.samples[0] if track.samples else ownship
    if elapsed(first.time_ms, ownship.time_ms) >= TRACK_TIME:
        return False
    x, v = sub(p_n, first.p_n), first.v_n
    ahead = x[0] * v[0] + x[1] * v[1]
    return ahead <= POSITION_TOLERANCE * math.hypot(v[0], v[1])


def own_at(track: OwnTrack, ownship: Ownship, time_ms: int) -> Ownship:
    """The ownship at a time_boot_ms [ms] up to now; before the track it flew straight."""
    samples = (*track.samples, ownship)
    for one, after in pairwise(samples):
        step, since = elapsed(one.time_ms, after.time_ms), elapsed(one.time_ms, time_ms)
        if 0.0 <= since <= step and step > 0.0:
            return between(one, after, since / step)
    first = samples[0]
    back = scale(elapsed(first.time_ms, time_ms), first.v_n)
    return Ownship(time_ms, add(first.p_n, back), first.v_n)


def match(track: OwnTrack, ownship: Ownship, p_n: Vec3, v_n: Vec3) -> Match:
    """The point of the track up to the ownship now that best fits a position and a velocity.

    Heights and vertical speeds do not count.

    Args:
        track: samples before now.
        ownship: the ownship now.
        p_n: the reported position, NED [m].
        v_n: the reported velocity, NED [m/s].
    """
    said = _normalised(p_n, v_n)
    best = Match(0.0, math.dist(said, _normalised(ownship.p_n, ownship.v_n)), ownship)
    if POSITION_TOLERANCE * best.miss > TRACK_TIME * FASTEST_OWN:
        return best
    parts = pairwise((*track.samples, ownship))
    return min((best, *(_on(one, after, said, ownship.time_ms) for one, after in parts)), key=miss)


def miss(found: Match) -> float:
    """The miss of a match."""
    return found.miss


def _on(one: Ownship, after: Ownship, said: NormalisedState, now_ms: int) -> Match:
    """The best point between two samples.

    There the difference is linear in the share s of the way, x + s dx, so that its square is least
    at s = -x.dx / dx.dx.
    """
    begin, end = _normalised(one.p_n, one.v_n), _normalised(after.p_n, after.v_n)
    dx = [b - a for a, b in zip(begin, end, strict=True)]
    along = sum((c - a) * d for a, c, d in zip(begin, said, dx, strict=True))
    square = sum(d * d for d in dx)
    share = min(max(along / square, 0.0), 1.0) if square > 0.0 else 0.0
    own = between(one, after, share)
    return Match(elapsed(own.time_ms, now_ms), math.dist(said, _normalised(own.p_n, own.v_n)), own)


def _normalised(p_n: Vec3, v_n: Vec3) -> NormalisedState:
    """Horizontal position and velocity, each in units of its tolerance."""
    return (
        p_n[0] / POSITION_TOLERANCE,
        p_n[1] / POSITION_TOLERANCE,
        v_n[0] / VELOCITY_TOLERANCE,
        v_n[1] / VELOCITY_TOLERANCE,
    )


def between(one: Ownship, after: Ownship, share: float) -> Ownship:
    """The ownship at a share of the time from one sample to the next."""
    return Ownship(
        one.time_ms + round(share * (after.time_ms - one.time_ms)),
        add(one.p_n, scale(share, sub(after.p_n, one.p_n))),
        add(one.v_n, scale(share, sub(after.v_n, one.v_n))),
    )
