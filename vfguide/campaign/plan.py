"""What a campaign flies: a scenario, what varies in it, and the seed of it all."""

import json
import shlex
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from vfguide import __version__
from vfguide.campaign.condition import Condition, check_column, check_threshold, parse_condition
from vfguide.campaign.draws import SEEDS, Draw, draw
from vfguide.campaign.flight import Job
from vfguide.campaign.inputs import Inputs, inputs_of
from vfguide.campaign.schema import COLUMN_WORDS, schema_of, simple_columns, values_in
from vfguide.files.data import find_scenario
from vfguide.files.errors import InputError
from vfguide.files.overrides import Override, drawn_override, location_of, parse_override
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
    inputs: Inputs

    @property
    def name(self) -> str:
        """Name of the scenario."""
        return self.loaded.scenario.name

    @property
    def identity(self) -> str:
        """What a folder of results has to be of to go on in it, as JSON."""
        told = {
            "version": __version__,
            "scenario": self.scenario,
            "sha256": self.inputs.scenario,
            "aircraft_sha256": self.inputs.aircraft,
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
        drawn = draw(self.seed, index, self.vary)
        return Job(self.source, self.overrides, drawn, tuple(self.loaded.files), self.inputs)


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
    source = str(path.absolute()) if Path(scenario).is_file() else scenario
    for text in (source, *overrides):
        check_utf8(text)
    given = tuple(map(parse_override, overrides))
    entry = Source(path, given).parse(ScenarioFile)
    check_not_drawn(given, entry.vary)
    loaded = load_scenario(path, overrides)
    inputs = inputs_of(source, loaded.files)
    require_models(loaded)
    for override in extremes(entry.vary):
        load_scenario(path, overrides, [override])
    seed = loaded.scenario.seed if seed is None else seed
    return CampaignPlan(scenario, source, tuple(overrides), seed, entry.vary, loaded, inputs)


def check_utf8(text: str) -> None:
    """Refuse a text that no column of a table can hold.

    Raises:
        InputError: it is not valid UTF-8.
    """
    try:
        text.encode()
    except UnicodeEncodeError as error:
        raise InputError(f"{text}: not valid UTF-8, no table can hold it") from error


def check_not_drawn(given: Sequence[Override], vary: Mapping[str, Distribution]) -> None:
    """Refuse to set what is drawn: the drawn value would replace it in every flight.

    Raises:
        InputError: one is set.
    """
    for override in given:
        for key in vary:
            location = location_of(key)
            if override.location[: len(location)] == location:
                raise InputError(f"{override.origin}: drawn for each flight, as [vary] has {key}")


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
    schema = schema_of(plan.vary)
    check_column(condition, simple_columns(schema))
    check_threshold(condition, values_in(schema), COLUMN_WORDS)
    return condition
