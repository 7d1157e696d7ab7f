"""The comparison of flights with those of a reference commit, and the tool that makes it."""

import json
import shutil
from pathlib import Path

import golden
import pytest
from flight_difference import flight_difference, frames_in, value_difference

from vfguide.link.codec import Encoder
from vfguide.link.messages import Attitude, Heartbeat
from vfguide.link.tlog_writer import tlog_record

START = 1_577_836_800_000_000
RESULT = {
    "verdict": "good",
    "wall_s": 1.5,
    "realtime_factor": 30.0,
    "vehicles": [{"id": 7, "goals": [{"miss_m": 0.02, "reached": True}, {"miss_m": 1.0}]}],
}


def records(count=40, roll=0.25):
    """A log in pieces: attitudes 20 ms apart, a heartbeat every ten of them."""
    encoder = Encoder(7, 1)
    for number in range(count):
        message = Attitude(20 * number, roll, 0.5, -1.0, 0.0, 0.0, 0.0)
        if number % 10 == 9:
            message = Heartbeat(1, 12, 0, 0, 4)
        yield tlog_record(START + 20_000 * number, encoder.encode(message))


def write_flight(folder, result=RESULT):
    folder.mkdir(parents=True)
    for name in ("flight.tlog", "vehicle-7.tlog"):
        (folder / name).write_bytes(b"".join(records()))
    (folder / "result.json").write_text(json.dumps(result))


@pytest.fixture
def flights(tmp_path):
    """Two folders of the same flight."""
    write_flight(tmp_path / "old")
    shutil.copytree(tmp_path / "old", tmp_path / "new")
    return tmp_path / "old", tmp_path / "new"


def changed_log(new: Path, change):
    """The records of the log of the vehicle, changed."""
    pieces = list(records())
    change(pieces)
    (new / "vehicle-7.tlog").write_bytes(b"".join(pieces))


def changed_result(new: Path, change):
    result = json.loads((new / "result.json").read_text())
    change(result)
    (new / "result.json").write_text(json.dumps(result))


def test_equal_flights(flights):
    assert flight_difference(*flights) is None
    assert frames_in(flights[0]) == 80


def test_the_clock_may_tell_something_else(flights):
    changed_result(flights[1], lambda its: its.update(wall_s=9.0, realtime_factor=2.0))
    assert flight_difference(*flights) is None


def test_a_changed_field_of_one_frame(flights):
    def change(pieces):
        pieces[23] = list(records(roll=0.5))[23]

    changed_log(flights[1], change)
    assert flight_difference(*flights) == (
        "vehicle-7.tlog: frame 23 at 0.460000 s, ATTITUDE of 7/1: roll 0.25, now 0.5"
    )


def test_the_last_bit_of_a_field_and_the_sign_of_zero(flights):
    def change(pieces):
        encoder = Encoder(7, 1)
        encoder.seq = 1
        message = Attitude(20, 0.25, 0.5, -1.0, 0.0, -0.0, 0.0)
        pieces[1] = tlog_record(START + 20_000, encoder.encode(message))

    changed_log(flights[1], change)
    found = flight_difference(*flights)
    assert found.endswith("frame 1 at 0.020000 s, ATTITUDE of 7/1: pitchspeed 0.0, now -0.0")


def test_a_changed_time(flights):
    def change(pieces):
        pieces[5] = tlog_record(START + 100_001, pieces[5][8:])

    changed_log(flights[1], change)
    found = flight_difference(*flights)
    assert found.startswith("vehicle-7.tlog: frame 5 at 0.100000 s, ATTITUDE of 7/1: time [us] ")
    assert found.endswith(f"{START + 100_000}, now {START + 100_001}")


def test_a_frame_missing_within(flights):
    changed_log(flights[1], lambda pieces: pieces.pop(9))
    found = flight_difference(*flights)
    assert found.startswith("vehicle-7.tlog: frame 9 at 0.180000 s, HEARTBEAT of 7/1: time [us] ")


def test_a_message_in_place_of_another(flights):
    def change(pieces):
        pieces[9] = tlog_record(START + 180_000, pieces[8][8:])

    changed_log(flights[1], change)
    found = flight_difference(*flights)
    assert found.endswith(
        "frame 9 at 0.180000 s, HEARTBEAT of 7/1: message HEARTBEAT, now ATTITUDE"
    )


@pytest.mark.parametrize(("shorter", "longer"), [(1, "reference"), (0, "tree")])
def test_a_frame_missing_at_the_end(flights, shorter, longer):
    changed_log(flights[shorter], lambda pieces: pieces.pop())
    assert flight_difference(*flights) == (
        f"vehicle-7.tlog: the {longer} has more frames, "
        "the first is frame 39 at 0.780000 s, HEARTBEAT of 7/1"
    )


def test_the_same_message_with_another_number_of_its_frame(flights):
    def change(pieces):
        encoder = Encoder(7, 1)
        encoder.seq = 77
        message = Attitude(0, 0.25, 0.5, -1.0, 0.0, 0.0, 0.0)
        pieces[0] = tlog_record(START, encoder.encode(message))

    changed_log(flights[1], change)
    assert flight_difference(*flights).endswith("ATTITUDE of 7/1: seq 0, now 77")


def test_every_byte_counts(flights):
    old, new = flights
    log = (old / "vehicle-7.tlog").read_bytes()
    for place in range(len(log)):
        (new / "vehicle-7.tlog").write_bytes(
            log[:place] + bytes([log[place] ^ 1]) + log[place + 1 :]
        )
        assert flight_difference(old, new) is not None


def test_a_log_that_one_of_them_lacks(flights):
    old, new = flights
    (new / "vehicle-7.tlog").unlink()
    assert flight_difference(old, new) == "vehicle-7.tlog: only the reference has it"
    assert flight_difference(new, old) == "vehicle-7.tlog: only the tree has it"


def test_a_changed_key_of_the_result(flights):
    def change(result):
        result["vehicles"][0]["goals"][1]["miss_m"] = 1.5

    changed_result(flights[1], change)
    assert flight_difference(*flights) == "result.json.vehicles[0].goals[1].miss_m: 1.0, now 1.5"


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ({"a": 1}, {}, "x.a: 1, now absent"),
        ({}, {"a": 1}, "x.a: absent, now 1"),
        ([1, 2], [1], "x[1]: 2, now absent"),
        ([], [{}], "x[0]: absent, now {}"),
        (1, 1.0, "x: 1, now 1.0"),
        (1, True, "x: 1, now True"),
        ({}, [], "x: {}, now []"),
        ({"a": None}, {"a": {}}, "x.a: None, now {}"),
        (0.0, -0.0, "x: 0.0, now -0.0"),
    ],
)
def test_values(old, new, told):
    assert value_difference("x", old, new) == told
    assert value_difference("x", old, old) is None


def test_no_number_is_no_number():
    assert value_difference("x", float("nan"), float("nan")) is None


def test_names_of_scenarios():
    files = ["towers.toml", "paper/example-1.toml", "aircraft/mine.toml", "towers.md"]
    assert golden.names_of(files) == ["paper/example-1", "towers"]


@pytest.fixture
def two_sides(monkeypatch, tmp_path):
    """Sides that write flights instead of flying; returns their results, by side and name."""
    flown = {("before", "a"): RESULT, ("before", "b"): RESULT}
    flown |= {("here", "a"): RESULT, ("here", "b"): RESULT}

    def fly(side, name, folder):
        place = "here" if side.tree == golden.ROOT else "before"
        if flown[place, name] is None:
            raise golden.NoFlightError("vfguide: no wings")
        asked.append((place, name))
        write_flight(folder, flown[place, name])

    def names(place):
        return sorted(name for side, name in flown if side == place)

    asked = []
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    monkeypatch.setattr(golden.Checkout, "fly", fly)
    monkeypatch.setattr(golden, "names_at", lambda _: names("before"))
    monkeypatch.setattr(golden, "names_here", lambda: names("here"))
    monkeypatch.setattr(golden, "commit_of", lambda _: "c0ffee")
    monkeypatch.setattr(golden, "git", lambda *_, **__: "")
    return flown, asked


def said_by(capsys):
    return capsys.readouterr().out.splitlines()[1:-1]


def test_all_is_identical_and_the_reference_flies_once(two_sides, capsys):
    _, asked = two_sides
    for expected in (4, 2):
        asked.clear()
        assert golden.main([]) == 0
        assert len(asked) == expected
        assert said_by(capsys) == ["a: identical, 80 frames", "b: identical, 80 frames"]


def test_one_is_different(two_sides, capsys):
    flown, _ = two_sides
    flown["here", "a"] = {**RESULT, "verdict": "bad"}
    assert golden.main([]) == 1
    assert said_by(capsys) == [
        "a: result.json.verdict: 'good', now 'bad'",
        "b: identical, 80 frames",
    ]


def test_one_does_not_fly(two_sides, capsys):
    flown, _ = two_sides
    flown["here", "b"] = None
    assert golden.main([]) == 1
    assert said_by(capsys)[1] == "b: does not fly: vfguide: no wings"


def test_a_reference_that_does_not_fly_keeps_no_flight(two_sides, capsys, tmp_path):
    flown, _ = two_sides
    flown["before", "b"] = None
    assert golden.main([]) == 2
    expected = "golden.py: the reference does not fly b: vfguide: no wings\n"
    assert capsys.readouterr().err == expected
    assert [path.parent.name for path in tmp_path.rglob("result.json")] == ["a"]


def test_a_new_scenario_is_told_and_a_lost_one_fails(two_sides, capsys):
    flown, _ = two_sides
    flown["here", "new"] = RESULT
    assert golden.main([]) == 0
    assert "new: the reference lacks it" in said_by(capsys)
    del flown["here", "a"]
    assert golden.main([]) == 1
    assert "a: the tree lacks it" in said_by(capsys)


def test_only_what_is_asked_for(two_sides, capsys):
    assert golden.main(["--scenario", "b"]) == 0
    assert said_by(capsys) == ["b: identical, 80 frames"]
    assert golden.main(["--scenario", "c"]) == 2
    assert capsys.readouterr().err == "golden.py: c: no shipped scenario; shipped: a, b\n"


def test_flights_are_kept_for_each_kind_of_machine(two_sides, monkeypatch):
    _, asked = two_sides
    golden.main([])
    monkeypatch.setattr(golden, "machine", lambda: "another one")
    asked.clear()
    golden.main([])
    assert ("before", "a") in asked


@pytest.mark.parametrize(
    ("status", "last"), [(130, "vfguide: interrupted"), (1, "Traceback ...\nKeyError: 3")]
)
def test_a_flight_that_ends_too_soon_leaves_nothing(tmp_path, monkeypatch, status, last):
    def run(_, *words):
        write_flight(Path(words[words.index("--out") + 1]))
        return golden.subprocess.CompletedProcess([], status, "", f"{last}\n")

    monkeypatch.setattr(golden.Checkout, "vfguide", run)
    with pytest.raises(golden.NoFlightError) as raised:
        golden.Checkout(tmp_path, {}).fly("a", tmp_path / "flights" / "a")
    assert str(raised.value) == last.splitlines()[-1]
    assert list((tmp_path / "flights").iterdir()) == []


def test_recordings(two_sides, capsys, monkeypatch, tmp_path):
    for name in ("good", "other", "lost"):
        write_flight(tmp_path / "recorded" / name)
        (tmp_path / "recorded" / name / "scenario.toml").write_text(name)
    write_flight(tmp_path / "recorded" / "without-its-scenario")
    replayed = []

    def replay(side, log, folder):
        is_tree, name = side.tree == golden.ROOT, log.parent.name
        replayed.append((is_tree, name))
        if is_tree and name == "lost":
            raise golden.NoFlightError("vfguide: no such key")
        write_flight(folder)
        if is_tree and name == "other":
            changed_log(folder, list.pop)

    monkeypatch.setattr(golden.Checkout, "replay", replay)
    expected = [
        "recording good/vehicle-7.tlog: identical, 80 frames",
        "recording lost/vehicle-7.tlog: is not replayed: vfguide: no such key",
        "recording other/vehicle-7.tlog: the reference has more frames, the first is ",
    ]
    for replays in (6, 3):  # the reference replays once
        replayed.clear()
        assert golden.main(["--recordings", str(tmp_path / "recorded")]) == 1
        said = capsys.readouterr().out.splitlines()[3:]
        assert said[:2] == expected[:2]
        assert said[2].startswith(expected[2])
        assert len(replayed) == replays
    assert golden.main(["--recordings", str(tmp_path / "nowhere")]) == 0
    assert capsys.readouterr().out.splitlines()[3:] == [f"recordings: none in {tmp_path}/nowhere"]


def test_a_recording_that_the_reference_does_not_replay(two_sides, capsys, monkeypatch, tmp_path):
    write_flight(tmp_path / "recorded" / "bad")
    (tmp_path / "recorded" / "bad" / "scenario.toml").write_text("")

    def refuse(*_):
        raise golden.NoFlightError("vfguide: no such key")

    monkeypatch.setattr(golden.Checkout, "replay", refuse)
    assert golden.main(["--recordings", str(tmp_path / "recorded")]) == 2
    expected = "golden.py: the reference does not replay bad/vehicle-7.tlog: vfguide: no such key\n"
    assert capsys.readouterr().err == expected


def test_a_commit_that_is_none(capsys):
    assert golden.main(["no-such-commit"]) == 2
    said = capsys.readouterr().err
    assert said == f"golden.py: no-such-commit: no commit of the repository {golden.ROOT}\n"
