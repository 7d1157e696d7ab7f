"""Where scenarios and aircraft are found: the user's own files first, then the shipped ones."""

import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from difflib import SequenceMatcher, get_close_matches
from heapq import nlargest
from pathlib import Path

from vfguide.files.errors import InputError
from vfguide.files.looked_for import is_file

PACKAGE = Path(__file__).parent.parent
"""Folder of the package `vfguide`."""

ALIKE = 0.6
"""Least likeness of two names of which one may be meant for the other, the ratio of difflib,
dimensionless; chosen as the default of difflib."""


@dataclass(frozen=True)
class AircraftFiles:
    """The files of one aircraft."""

    name: str
    root: Path
    """The `aircraft` folder that contains the files: the aircraft path of JSBSim."""
    performance: Path
    """The aircraft file, which the companion reads: `NAME.toml` or `NAME/NAME.toml`."""
    model: Path | None
    """The JSBSim model, `NAME/NAME.xml` in that folder; None where there is none."""


def data_folder() -> Path:
    """The folder of the shipped `aircraft` and `scenarios`, in the wheel or in a checkout."""
    inside = PACKAGE / "_data"
    return inside if inside.is_dir() else PACKAGE.parent


def shipped_scenarios() -> list[str]:
    """Names of the shipped scenarios, such as `first-flight` and `paper/example-1`."""
    folder = data_folder() / "scenarios"
    names = (path.relative_to(folder).with_suffix("") for path in folder.rglob("*.toml"))
    return sorted(name.as_posix() for name in names if "aircraft" not in name.parts)


def find_scenario(name_or_path: str | Path) -> Path:
    """The scenario file at a path or of a shipped name.

    Raises:
        InputError: there is neither, and the message lists the shipped names; or the path cannot
            be looked up.
    """
    path = Path(name_or_path)
    if is_file(path):
        return path
    names = shipped_scenarios()
    name = path.as_posix().removesuffix(".toml")
    if name in names:
        return data_folder() / "scenarios" / f"{name}.toml"
    raise InputError(
        f"{name_or_path}: no such file and no shipped scenario{close_matches(name, names)}; "
        f"shipped: {', '.join(names)}"
    )


def find_aircraft(name: str, beside: Path | None = None) -> AircraftFiles:
    """The files of an aircraft: from `aircraft/` beside the scenario file, else shipped.

    Args:
        name: name of the aircraft.
        beside: the scenario file.

    Raises:
        InputError: there is no aircraft of that name, and the message lists all names; or it
            cannot be looked up.
    """
    own = [beside.parent / "aircraft"] if beside else []
    roots = [*own, data_folder() / "aircraft"]
    if re.fullmatch(r"[\w.-]+", name):
        for root in roots:
            if files := _files(root, name):
                return files
    names = sorted({found for root in roots for found in _names(root)})
    raise InputError(f"no such aircraft{close_match(name, names)}; allowed: {', '.join(names)}")


def close_match(wrong: str, right: Iterable[str]) -> str:
    """A hint to put after the name `wrong`, `, did you mean X?`; empty if nothing is similar."""
    matches = get_close_matches(wrong, list(right), n=1)
    return f", did you mean {matches[0]}?" if matches else ""


def close_matches(wrong: str, right: Sequence[str]) -> str:
    """A hint as of `close_match`, of up to three names, the most similar first.

    Names are compared with and without their folders, in lower case.
    """
    likeness = {
        name: max(
            SequenceMatcher(None, wrong.lower(), part).ratio()
            for part in (name, name.split("/")[-1])
        )
        for name in right
    }
    near = nlargest(3, (name for name in right if likeness[name] >= ALIKE), likeness.__getitem__)
    return f", did you mean {' or '.join(near)}?" if near else ""


def _files(root: Path, name: str) -> AircraftFiles | None:
    for performance in (root / f"{name}.toml", root / name / f"{name}.toml"):
        if is_file(performance):
            model = root / name / f"{name}.xml"
            return AircraftFiles(name, root, performance, model if is_file(model) else None)
    return None


def _names(root: Path) -> list[str]:
    candidates = {path.stem for pattern in ("*.toml", "*/*.toml") for path in root.glob(pattern)}
    return [name for name in candidates if _files(root, name)]
