"""Which JSBSim model an aircraft is simulated with."""

from pathlib import Path

import pytest
from scenario_samples import loaded_from

from vfguide.files.data import find_aircraft, shipped_scenarios
from vfguide.files.errors import InputError
from vfguide.preflight.load import load_scenario
from vfguide.runs.models import model_of, require_models
from vfguide.scenario.loaded import LoadedScenario
from vfguide.sim.fdm import stock_root

CESSNA = find_aircraft("c172p").performance.read_text()
SCENARIO = """
name = "x"
[[vehicle]]
id = 1
aircraft = "mine"
position_m = [0.0, 0.0, -500.0]
[[vehicle.goal]]
position_m = [2000.0, 0.0, -500.0]
heading_deg = 0.0
"""


def loaded(folder: Path, model: str) -> LoadedScenario:
    """A scenario with an aircraft of the user's own, of which `model` is the table [model]."""
    text = CESSNA.replace('name = "c172p"', 'name = "mine"').split("[model]")[0] + model
    (folder / "aircraft").mkdir(exist_ok=True)
    (folder / "aircraft" / "mine.toml").write_text(text)
    (folder / "x.toml").write_text(SCENARIO)
    return load_scenario(folder / "x.toml")


@pytest.mark.parametrize("name", ["c172p", "J3Cub"])
def test_a_stock_model_is_that_of_the_jsbsim_package(tmp_path: Path, name: str) -> None:
    model = model_of(loaded(tmp_path, f'[model]\nstock = "{name}"\n'), "mine")
    assert model.file == stock_root() / name / f"{name}.xml"
    assert model.file.is_file()


def test_the_shipped_cessna_has_no_model_of_its_own() -> None:
    assert find_aircraft("c172p").model is None
    assert find_aircraft("easystar").model is not None


def test_a_stock_model_that_there_is_not(tmp_path: Path) -> None:
    scenario = loaded(tmp_path, '[model]\nstock = "c172q"\n')
    with pytest.raises(InputError) as error:
        require_models(scenario)
    file, root = tmp_path / "aircraft" / "mine.toml", stock_root()
    assert str(error.value).startswith(
        f'{file}: model.stock = "c172q": the jsbsim package ships no such aircraft, did you mean'
    )
    assert str(error.value).endswith(f"allowed are the folders of {root}")


def test_two_models_are_one_too_many(tmp_path: Path) -> None:
    own = tmp_path / "aircraft" / "mine" / "mine.xml"
    own.parent.mkdir(parents=True)
    own.write_text("<fdm_config/>")
    scenario = loaded(tmp_path, '[model]\nstock = "c172p"\n')
    with pytest.raises(InputError, match="not allowed beside a model of its own"):
        require_models(scenario)
    assert model_of(loaded(tmp_path, ""), "mine").file == own


@pytest.mark.parametrize(
    ("table", "message"),
    [
        ("stock = 172", "model.stock = 172: wrong type, a string is required"),
        ('stock = ""', 'model.stock = "": allowed is the name of a folder'),
        ('stock = "../c172p"', 'model.stock = "../c172p": allowed is the name of a folder'),
        ('stock = "a/b"', 'model.stock = "a/b": allowed is the name of a folder'),
        ('stok = "c172p"', "model.stok: unknown key, did you mean stock?; allowed: stock"),
    ],
)
def test_what_the_table_does_not_allow(tmp_path: Path, table: str, message: str) -> None:
    with pytest.raises(InputError) as error:
        loaded(tmp_path, f"[model]\n{table}\n")
    assert message in str(error.value)


def test_a_resolved_scenario_of_a_stock_model_can_be_flown_again(tmp_path: Path) -> None:
    scenario = loaded(tmp_path, '[model]\nstock = "c172p"\n')
    run = tmp_path / "run"
    run.mkdir()
    scenario.write_resolved(run / "scenario.toml")
    again = load_scenario(run / "scenario.toml")
    assert model_of(again, "mine") == model_of(scenario, "mine")
    assert not list(run.rglob("*.xml"))


def test_an_aircraft_without_a_model_cannot_be_simulated(tmp_path: Path) -> None:
    shipped = find_aircraft("aerosonde").performance.read_text()
    (tmp_path / "aircraft").mkdir()
    (tmp_path / "aircraft" / "aerosonde.toml").write_text(shipped)
    loaded = loaded_from(tmp_path)
    with pytest.raises(InputError) as error:
        require_models(loaded)
    missing = tmp_path / "aircraft" / "aerosonde" / "aerosonde.xml"
    expected = f"{missing}: no such file, the simulation of aerosonde needs it"
    assert str(error.value) == expected


@pytest.mark.parametrize("name", shipped_scenarios())
def test_shipped_scenarios_can_be_flown(name: str) -> None:
    loaded = load_scenario(name)
    assert loaded.scenario.name == name.replace("/", "-")
    require_models(loaded)
