#!/usr/bin/env python3
"""Every shipped scenario flown by a reference commit and by the working tree: the same bytes?

    python tools/golden.py
    python tools/golden.py HEAD~3 --scenario towers --scenario traffic
    python tools/golden.py --recordings DIR

For changes that must not change any flight. Every `*.tlog` is compared frame by frame, time and
bytes, and `result.json` key by key but for what the clock says; of each scenario the first
difference is named. Frames count from 0, seconds from the first frame of the log. Scenarios that
the reference lacks are named, one that the tree lacks is a difference.

The reference flies in a work tree of its own. Its flights are kept below `~/.cache/vfguide-golden`
(or XDG_CACHE_HOME), by commit and by kind of machine, so that the next time only the tree flies.

A recording is a `vehicle-ID.tlog` beside the `scenario.toml` that was flown, of a real link or not.
Both checkouts replay it, and have to receive and send the same.

The exit status is 0 if all is identical, 1 if not, 2 for bad input, 130 when interrupted.
"""

import argparse
import hashlib
import os
import platform
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from functools import partial
from importlib.metadata import version
from pathlib import Path, PurePath
from typing import NamedTuple, TypeVar

import llvmlite.binding
from flight_difference import flight_difference, frames_in, log_difference

ROOT = Path(__file__).resolve().parent.parent
REFERENCE = "1dcd7e3"
"""The latest commit that changed flights on purpose."""
SAME, DIFFERENT, BAD_INPUT, INTERRUPTED = 0, 1, 2, 130
RUN = "from vfguide.cli.main import main; main()"
PACKAGES = ("jsbsim", "llvmlite", "numba", "numpy", "scipy")
"""Packages beside this one on which the bits of a flight depend."""
WIDE = "10000"
"""Number of columns of a terminal that breaks no line, as text."""

Job = TypeVar("Job")
Done = TypeVar("Done")


class BadInputError(Exception):
    """The comparison that was asked for cannot be made; the message says why."""


class NoFlightError(Exception):
    """A scenario was not flown to its end; the message is the last line of the program."""


class Verdict(NamedTuple):
    """The result of a comparison."""

    name: str
    """Name of the scenario or the recording."""
    same: bool
    told: str


class Checkout(NamedTuple):
    """A checkout that flies: the reference, or the working tree."""

    tree: Path
    """The checkout whose package and scenarios are used."""
    environment: dict[str, str]
    """Environment variables of its programs, added to those of this one."""

    def vfguide(self, *words: str | Path) -> subprocess.CompletedProcess[str]:
        """Run a command of the checkout's `vfguide`, in a process of its own."""
        paths = {"PYTHONPATH": str(self.tree), "COLUMNS": WIDE}
        return subprocess.run(
            [sys.executable, "-c", RUN, *map(str, words)],
            cwd=self.tree,
            env={**os.environ, **paths, **self.environment},
            capture_output=True,
            text=True,
            check=False,
        )

    def fly(self, name: str, folder: Path) -> None:
        """Fly a shipped scenario; a flight that is judged bad is one too.

        Raises:
            NoFlightError: there is no result.
        """
        self._leave(folder, "result.json", "run", name, "--no-report")

    def replay(self, log: Path, folder: Path) -> None:
        """Replay a recording.

        Raises:
            NoFlightError: it does not come to its end.
        """
        self._leave(folder, log.name, "replay", log)

    def _leave(self, folder: Path, last: str, *words: str | Path) -> None:
        """Run a command that leaves a folder, in which the file `last` is written.

        The folder is there only once the command is over. Where another process was faster, its
        folder stays.
        """
        folder.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=folder.parent) as scratch:
            out = Path(scratch) / "flight"
            done = self.vfguide(*words, "--out", out)
            if not is_over(done, out / last):
                raise NoFlightError(last_line(done))
            if not folder.exists():
                out.rename(folder)


def is_over(done: subprocess.CompletedProcess[str], last: Path) -> bool:
    """Whether a command came to its end; a traceback has the exit status of a bad flight."""
    judged = done.returncode in (0, 1) and last.exists()
    return judged and "Traceback" not in done.stderr


def lines_of(done: subprocess.CompletedProcess[str]) -> list[str]:
    """The lines that a program printed, on standard error if there are any."""
    return (done.stderr.strip() or done.stdout.strip()).splitlines()


def last_line(done: subprocess.CompletedProcess[str]) -> str:
    """The last line that a program printed."""
    return (lines_of(done) or [f"exit status {done.returncode}"])[-1]


def git(*words: str | Path, at: Path = ROOT) -> str:
    """What git says.

    Raises:
        BadInputError: it refuses.
    """
    done = subprocess.run(
        ["git", "-C", str(at), *map(str, words)], capture_output=True, text=True, check=False
    )
    if done.returncode:
        raise BadInputError(f"git {words[0]}: {last_line(done)}")
    return done.stdout.strip()


def commit_of(reference: str) -> str:
    """The whole hash of a commit.

    Raises:
        BadInputError: there is none of that name.
    """
    try:
        return git("rev-parse", "--verify", "--end-of-options", f"{reference}^{{commit}}")
    except BadInputError as error:
        raise BadInputError(f"{reference}: no commit of the repository {ROOT}") from error


def names_of(files: Iterable[str]) -> list[str]:
    """The names of the scenarios among paths below the folder of scenarios."""
    paths = map(PurePath, files)
    names = {each.with_suffix("") for each in paths if each.suffix == ".toml"}
    return sorted(name.as_posix() for name in names if "aircraft" not in name.parts)


def names_at(commit: str) -> list[str]:
    """The scenarios that a commit ships."""
    return names_of(git("ls-tree", "-r", "--name-only", f"{commit}:scenarios").splitlines())


def names_here() -> list[str]:
    """The scenarios that the working tree ships."""
    folder = ROOT / "scenarios"
    return names_of(str(path.relative_to(folder)) for path in folder.rglob("*.toml"))


def machine() -> str:
    """What the bits of a flight depend on besides the code, in words: processor and libraries."""
    processor = (platform.machine(), llvmlite.binding.get_host_cpu_name())
    features = llvmlite.binding.get_host_cpu_features().flatten()
    libraries = ("python", platform.python_version(), *platform.libc_ver())
    versions = (f"{package} {version(package)}" for package in PACKAGES)
    return "\n".join([" ".join(processor), " ".join(libraries), *versions, features, ""])


def kept_flights(commit: str) -> Path:
    """The folder for the flights of a commit on this kind of machine."""
    home = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache").absolute()
    kind = hashlib.sha256(machine().encode()).hexdigest()[:12]
    folder = home / "vfguide-golden" / commit / kind
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "machine.txt").write_text(machine())
    return folder


@contextmanager
def checkout(commit: str, folder: Path, *, keep: bool) -> Iterator[Checkout]:
    """The reference as a work tree in `folder`, with the machine code that belongs to it.

    Raises:
        BadInputError: something else is there already.
    """
    tree = folder / commit
    if not tree.exists():
        git("worktree", "add", "--detach", tree, commit)
    elif git("rev-parse", "HEAD", at=tree) != commit or git("status", "--porcelain", at=tree):
        raise BadInputError(f"{tree}: not a clean checkout of that commit")
    try:
        yield Checkout(tree, {"XDG_CACHE_HOME": str(folder / "cache")})
    finally:
        if not keep:
            git("worktree", "remove", "--force", tree)


def in_turn(work: Callable[[Job], Done], jobs: Sequence[Job], workers: int) -> Iterator[Done]:
    """The results of all jobs, in order; the first runs alone, since it compiles for the others."""
    yield from map(work, jobs[:1])
    with ThreadPoolExecutor(workers) as pool:
        yield from pool.map(work, jobs[1:])


def reference_flights(
    commit: str, names: Sequence[str], scratch: Path, args: argparse.Namespace
) -> Path:
    """The folder of the reference's flights; those of `names` that it lacks are flown.

    Raises:
        BadInputError: the reference does not fly one of them.
    """
    kept = kept_flights(commit)
    missing = [name for name in names if not (kept / name / "result.json").exists()]
    say(f"reference {commit[:12]}: {len(missing)} of {len(names)} to fly, kept in {kept}")
    if missing:
        with checkout(commit, scratch, keep=args.keep is not None) as reference:
            for _ in in_turn(partial(fly_reference, reference, kept), missing, args.workers):
                pass
    return kept


def fly_reference(reference: Checkout, kept: Path, name: str) -> None:
    """Fly one scenario as the reference does.

    Raises:
        BadInputError: it does not.
    """
    try:
        reference.fly(name, kept / name)
    except NoFlightError as error:
        raise BadInputError(f"the reference does not fly {name}: {error}") from error


def compare(tree: Checkout, kept: Path, flown: Path, name: str) -> Verdict:
    """Fly one scenario as the tree does, and compare it with the kept flight."""
    try:
        tree.fly(name, flown / name)
    except NoFlightError as error:
        return Verdict(name, same=False, told=f"does not fly: {error}")
    found = flight_difference(kept / name, flown / name)
    told = found or f"identical, {frames_in(flown / name):,} frames"
    return Verdict(name, same=found is None, told=told)


def compare_flights(scratch: Path, args: argparse.Namespace) -> Iterator[Verdict]:
    """Verdicts of all scenarios that were asked for."""
    commit = commit_of(args.reference)
    before, here = names_at(commit), names_here()
    if wrong := set(args.scenarios).difference(before, here):
        raise BadInputError(f"{min(wrong)}: no shipped scenario; shipped: {', '.join(here)}")
    wanted = args.scenarios or sorted({*before, *here})
    both = [name for name in wanted if name in before and name in here]
    kept = reference_flights(commit, both, scratch, args)
    for name in wanted:
        if name not in both:
            lacking = "reference" if name in here else "tree"
            yield Verdict(name, same=name in here, told=f"the {lacking} lacks it")
    flown = Path(tempfile.mkdtemp(prefix="tree-", dir=scratch))
    yield from in_turn(partial(compare, Checkout(ROOT, {}), kept, flown), both, args.workers)


def recordings_in(folder: Path) -> list[Path]:
    """The logs of companions that lie beside the scenario that was flown."""
    logs = sorted(folder.rglob("vehicle-*.tlog"))
    return [log for log in logs if (log.parent / "scenario.toml").exists()]


def name_of(log: Path) -> str:
    """The name of a recording, from its folder and its file."""
    return f"{log.parent.name}/{log.name}"


def compare_recordings(scratch: Path, args: argparse.Namespace) -> Iterator[Verdict]:
    """All recordings below a folder, replayed by both checkouts.

    Raises:
        BadInputError: the reference does not replay one of them.
    """
    folder = args.recordings
    logs = recordings_in(folder.absolute()) if folder else []
    if not logs:
        say(f"recordings: none in {folder}" if folder else "recordings: no folder given")
        return
    commit = commit_of(args.reference)
    kept = {log: kept_replay(commit, log) for log in logs}
    if missing := [log for log in logs if not kept[log].exists()]:
        with checkout(commit, scratch, keep=args.keep is not None) as reference:
            for log in missing:
                replay_reference(reference, log, kept[log])
    new = Path(tempfile.mkdtemp(prefix="replay-", dir=scratch))
    yield from in_turn(lambda log: compare_replay(log, kept[log], new), logs, args.workers)


def kept_replay(commit: str, log: Path) -> Path:
    """The folder for a commit's replay of a recording, named by the content of both files."""
    content = log.read_bytes() + (log.parent / "scenario.toml").read_bytes()
    return kept_flights(commit) / "recordings" / hashlib.sha256(content).hexdigest()[:16]


def replay_reference(reference: Checkout, log: Path, kept: Path) -> None:
    """Replay one recording as the reference does.

    Raises:
        BadInputError: it does not.
    """
    try:
        reference.replay(log, kept)
    except NoFlightError as error:
        raise BadInputError(f"the reference does not replay {name_of(log)}: {error}") from error


def compare_replay(log: Path, kept: Path, new: Path) -> Verdict:
    """Replay one recording as the tree does, and compare it with the kept replay."""
    name, folder = f"recording {name_of(log)}", new / log.parent.name / log.stem
    try:
        Checkout(ROOT, {}).replay(log, folder)
    except NoFlightError as error:
        return Verdict(name, same=False, told=f"is not replayed: {error}")
    found = log_difference(kept / log.name, folder / log.name)
    told = found or f"identical, {frames_in(folder):,} frames"
    return Verdict(name, same=found is None, told=told)


def say(line: str) -> None:
    """Print a line at once."""
    print(line, flush=True)


def whole(text: str) -> int:
    """The number of processes in an argument of the command line."""
    if (number := int(text)) < 1:
        raise argparse.ArgumentTypeError(f"{number}, allowed is 1 or more")
    return number


def parse(arguments: Sequence[str] | None = None) -> argparse.Namespace:
    """The options of the command line."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("reference", nargs="?", default=REFERENCE, help=f"commit, {REFERENCE}")
    parser.add_argument("--scenario", dest="scenarios", action="append", default=[], metavar="NAME")
    parser.add_argument("--recordings", type=Path, metavar="DIR", help="replayed by both")
    parser.add_argument(
        "--keep", type=Path, metavar="DIR", help="for checkout and flights of the tree, to look at"
    )
    parser.add_argument("--workers", type=whole, default=2, help="processes at a time")
    return parser.parse_args(arguments)


def verdicts(args: argparse.Namespace) -> Iterator[Verdict]:
    """The verdicts of everything that is compared."""
    if args.keep:
        args.keep.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as temporary:
        scratch = (args.keep or Path(temporary)).absolute()
        yield from compare_flights(scratch, args)
        yield from compare_recordings(scratch, args)


def main(arguments: Sequence[str] | None = None) -> int:
    """Compare, and print the verdicts; returns the exit status."""
    status = SAME
    try:
        for verdict in verdicts(parse(arguments)):
            say(f"{verdict.name}: {verdict.told}")
            status = status if verdict.same else DIFFERENT
    except (BadInputError, OSError) as error:
        print(f"golden.py: {error}", file=sys.stderr)
        return BAD_INPUT
    except KeyboardInterrupt:
        print("golden.py: interrupted", file=sys.stderr)
        return INTERRUPTED
    return status


if __name__ == "__main__":
    sys.exit(main())
