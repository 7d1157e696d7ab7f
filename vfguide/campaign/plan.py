"""What a campaign flies: a scenario, what varies in it, and the seed of it all."""

import hashlib
import json
import shlex
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from vfguide import __version__
from vfguide.campaign.condition import Condition, check_column, parse_condition
from vfguide.campaign.draws import SEEDS, Draw, draw
from vfguide.campaign.flight import Job
from vfguide.campaign.schema import schema_of, simple_columns
from vfguide.files.data import find_scenario
from vfguide.files.errors import InputError
from vfguide.files.overrides import Override, drawn_override, parse_override
from vfguide.files.scenario_file import ScenarioFile
from vfguide.files.source import Source
from vfguide.files.vary import Distribution, Normal, Uniform
from vfguide.preflight.load import load_scenario
from vfguide.runs.models import require_models
from vfguide.scenario.loaded import LoadedScenario


@dataclass(frozen=True)
class CampaignPlan:
    """A campaign; every flight of it follows from this and its number."""

    scenario: str
    """As the user named it."""
    source: str
    """The same for workers wherever they are: an absolute path, or a shipped name."""
    overrides: tuple[str, ...]
    """What `--set` replaces in all flights."""
    seed: int
    vary: Mapping[str, Distribution]
    """The distributions by the dotted key that each is for."""
    loaded: LoadedScenario
    """The scenario with its written values."""

    @property
    def name(self) -> str:
        """Name of the scenario."""
        return self.loaded.scenario.name

    @property
    def identity(self) -> str:
        """What a folder of results has to be of to go on in it, as JSON."""
        text = find_scenario(self.source).read_bytes()
        told = {
            "version": __version__,
            "scenario": self.scenario,
            "sha256": hashlib.sha256(text).hexdigest(),
            "set": list(self.overrides),
            "seed": self.seed,
        }
        return json.dumps(told, indent=2) + "\n"

    def command(self, draw: Draw) -> str:
        """The command line that flies a flight alone."""
        changes = (*self.overrides, *(override.text for override in draw.overrides))
        return shlex.join(["vfguide", "run", self.scenario, *(f"--set={each}" for each in changes)])

    def job(self, index: int) -> Job:
        """The flight with a number."""
        return Job(self.source, self.overrides, draw(self.seed, index, self.vary))


def campaign_plan(scenario: str, overrides: Sequence[str], seed: int | None) -> CampaignPlan:
    """The campaign of a scenario, checked at the written values and at the ends of what varies.

    Args:
        scenario: path of a scenario file, or a shipped name.
        overrides: what `--set` replaces in all flights.
        seed: of the campaign; None: that of the scenario.

    Raises:
        InputError: it cannot be flown.
    """
    if scenario.endswith(".py"):
        raise InputError(
            f"{scenario}: worlds that a function draws are not supported yet, "
            "allowed is a scenario file or a shipped name"
        )
    if seed is not None and not 0 <= seed < SEEDS:
        raise InputError(f"--seed {seed}: allowed 0 to {SEEDS - 1}")
    path = find_scenario(scenario)
    entry = Source(path, tuple(map(parse_override, overrides))).parse(ScenarioFile)
    loaded = load_scenario(path, overrides)
    require_models(loaded)
    for override in extremes(entry.vary):
        load_scenario(path, overrides, [override])
    source = str(path.resolve()) if Path(scenario).is_file() else scenario
    seed = loaded.scenario.seed if seed is None else seed
    return CampaignPlan(scenario, source, tuple(overrides), seed, entry.vary, loaded)


def extremes(vary: Mapping[str, Distribution]) -> Iterator[Override]:
    """The values at the ends of each distribution, one at a time; the mean of a normal one."""
    for key, distribution in vary.items():
        match distribution:
            case Uniform(low, high):
                yield drawn_override(key, low)
                yield drawn_override(key, high)
            case Normal(mean, _):
                yield drawn_override(key, mean)


def condition_on(text: str, plan: CampaignPlan) -> Condition:
    """The condition of `--until`, on a column of the table of a campaign.

    Raises:
        InputError: it is none, or there is no such column.
    """
    condition = parse_condition(text)
    check_column(condition, simple_columns(schema_of(plan.vary)))
    return condition
