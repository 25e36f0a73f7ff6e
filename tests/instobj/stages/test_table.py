"""What each stage depends on: the right changes make it anew, all others reuse it."""

from pathlib import Path

import pytest

from design.spec.object import MechanicsSpec, ObjectSpec
from design.spec_io import load_spec, parse_spec, with_overrides
from instobj.stages.inputs import stage_inputs
from instobj.stages.table import STAGES
from instobj.store.keys import stage_key


def _keys(*overrides: str, example: str = "") -> dict[str, str]:
    spec = parse_spec(with_overrides({"name": "cube"}, overrides), "test")
    if example:
        spec = load_spec(EXAMPLES / f"{example}.toml", overrides)
    keys: dict[str, str] = {}
    for name, stage in STAGES.items():
        needs = {need: keys[need] for need in stage.needs}
        keys[name] = stage_key(name, stage_inputs(stage, spec, needs, {}))
    return keys


EXAMPLES = Path(__file__).parents[3] / "examples"
SENSED = {"build", "compliance", "signals", "robustness"}
CAST_IN = SENSED | {"mesh", "coarse_response"}
MESHED = {"plain_mesh", "mesh", "coarse_response"}
ELASTIC = {"plain_response", "response", "coarse_response"}
PRESSED = {"presses", "shear", "discretisation"}
WHERE_PRESSED = PRESSED | {"build", "plain_presses", "candidates"}
RECORDED = {"frames", "collection", "pulled_collection"}
DOWNSTREAM: dict[str, set[str]] = {
    "sensors.radius_mm=8.0": SENSED,
    "sensors.noise_counts=[20.0,22.0,11.0]": SENSED,
    "sensors.averaging=32": SENSED,
    "silicone.youngs_modulus_mpa=0.3": ELASTIC,
    "silicone.density_g_per_cm3=1.1": {"report"},
    "silicone.youngs_modulus_range_mpa=[0.3, 0.5]": {"report"},
    "silicone.prony=[[0.1, 2.0]]": RECORDED,
    "silicone.modulus_from=A12": ELASTIC | {"report"},
    "mechanics.element=p2-p0": ELASTIC,
    "mechanics.interface=frictionless": ELASTIC,
    "mechanics.slip.rim=held": ELASTIC | {"presses", "shear"},
    "mechanics.slip.shift_mm=[1.0,0.0,0.0]": {"presses", "shear"},
    "magnets.tilt_deg=[[1,2],[0,0],[0,0],[0,0],[0,0]]": CAST_IN,
    "magnets.depth_mm=3": CAST_IN,
    "magnets.positions_mm=[[0,0],[9,8]]": CAST_IN,
    "magnets.diameter_mm=5": CAST_IN | {"candidates"},
    "magnets.remanence_t=1.4": SENSED,
    "magnets.grade=N45": SENSED,
    'magnets.grade=["N35","N52","N35","N35","N42"]': SENSED,
    "contact_grid.pitch_mm=2.5": WHERE_PRESSED,
    "press.depths_mm=[1.0,2.0]": WHERE_PRESSED,
    "indenter.radius_mm=4.5": WHERE_PRESSED,
    "mesh.edge_mm=5": MESHED,
    "environment.earth_ut=50": {"signals", "robustness"},
    "load_cell.kind=hx711": {"sheet"},
    "shell.thickness_mm=9": MESHED | {"build"},
    "shell.slits.depth_mm=3": MESHED | {"build"},
    "core.keys.positions_mm=[[11.4,11.4]]": MESHED | {"build"},
    "shell.seal_layer_mm=0.5": {"build"},
    "core.wall_mm=4": {"build"},
    "mould.style=split": {"build"},
    "printer.name=resin": {"build"},
    "score.force_n=6": {
        *("candidates", "robustness", "scores", "shear_scores", "identify", "surroundings"),
    },
    "protocol.presses_per_place=4": RECORDED,
    "collection.presses=5": {"collection", "pulled_collection"},
    "tolerances.magnet_tilt_deg=1": {"robustness", "alternatives"},
    "as_built.magnets=[{face=2, magnet=1, flipped=true}]": {"signals", "robustness"},
    "as_built.magnets=[{face=2, magnet=1, dent_mm=0.5}]": {
        *("signals", "robustness", "shapes", *PRESSED),
    },
    "training.epochs=5": {"networks"},
    "limits.position_bound_mm=2": {"report", "identify", "weak_areas", "second_fidelity"},
    "inversion.contacts=3": set(),
    "seed=2": {"signals", "robustness", "identify", "frames", "networks"},
}


PRESSED_ON_THEIR_OWN = (
    "silicone.youngs_modulus_mpa=0.3",
    "silicone.modulus_from=A12",
    "mechanics.element=p2-p0",
    "mechanics.interface=frictionless",
    "mechanics.slip.rim=held",
    "magnets.tilt_deg=[[1,2],[0,0],[0,0],[0,0],[0,0]]",
    "magnets.depth_mm=3",
    "magnets.positions_mm=[[0,0],[9,8]]",
    "magnets.diameter_mm=5",
    "contact_grid.pitch_mm=2.5",
    "press.depths_mm=[1.0,2.0]",
    "indenter.radius_mm=4.5",
    "mesh.edge_mm=5",
    "shell.thickness_mm=9",
    "shell.slits.depth_mm=3",
    "core.keys.positions_mm=[[11.4,11.4]]",
)
"""These also make the presses with large deformation anew."""
for _override in PRESSED_ON_THEIR_OWN:
    DOWNSTREAM[_override] = DOWNSTREAM[_override] | {"large_strain"}
for _override in (
    "contact_grid.pitch_mm=2.5",
    "press.depths_mm=[1.0,2.0]",
    "indenter.radius_mm=4.5",
):
    DOWNSTREAM[_override] = DOWNSTREAM[_override] | {"shapes"}
for _override, _stages in DOWNSTREAM.items():
    if "build" in _stages or _override.startswith("silicone."):
        DOWNSTREAM[_override] = _stages | {"fabrication", "sheet"}
DOWNSTREAM["mechanics.correction=large-strain"] = {"large_strain"}
_LAID_OUT = ("shell.", "magnets.", "core.", "sensors.", "environment.", "as_built.")
SHOWN_BY_THE_REPORT_ALONE = {
    "surroundings": (*_LAID_OUT, "mechanics.slip.", "score.channels"),
    "press_curves": ("magnets.", "sensors.", "silicone."),
    "slip": ("mechanics.slip.", "score."),
    "alternatives": (
        *(*_LAID_OUT, "mechanics.", "silicone.", "score.", "seed", "contact_grid.", "press."),
        *("indenter.", "mould.", "printer.", "export.", "limits."),
    ),
}
SCORED_BY_A_SEARCH = {
    "second_fidelity": (
        *(*_LAID_OUT, "mechanics.", "silicone.", "score.", "seed", "contact_grid.", "press."),
        *("indenter.", "tolerances."),
    ),
}
CONTACTS_BY_INVERSION = {
    "inversion": (*_LAID_OUT, "mechanics.", "indenter.", "inversion.", "tolerances.", "seed"),
    "contact_metrics": ("collection.", "protocol.", "silicone.prony", "tolerances.", "seed"),
}
"""Stage → beginnings of the keys that make it anew by themselves."""
for _override, _stages in DOWNSTREAM.items():
    _by_key = SHOWN_BY_THE_REPORT_ALONE | SCORED_BY_A_SEARCH | CONTACTS_BY_INVERSION
    _shown = {name for name, keys in _by_key.items() if _override.startswith(keys)}
    DOWNSTREAM[_override] = _stages | _shown


def _with_dependents(changed: set[str]) -> set[str]:
    grown = set(changed)
    for name, stage in STAGES.items():
        if grown & set(stage.needs):
            grown.add(name)
    return grown


@pytest.mark.parametrize("override", DOWNSTREAM)
def test_a_change_reruns_what_depends_on_it_and_nothing_else(override):
    before, after = _keys(), _keys(override)
    changed = {name for name in STAGES if before[name] != after[name]}
    assert changed == _with_dependents(DOWNSTREAM[override])


@pytest.mark.parametrize(("example", "moves"), [("ball", True), ("paper_cube", False)])
def test_recesses_of_a_curved_core_move_its_sensors(example, moves):
    """On a flat one they are holes alone."""
    deeper = "core.recess_outer_radius_mm=11.3"
    before, after = _keys(example=example), _keys(deeper, example=example)
    assert before["build"] != after["build"]
    assert (before["signals"] != after["signals"]) == moves
    assert before["presses"] == after["presses"]


def test_stages_come_after_what_they_need():
    order = list(STAGES)
    for name, stage in STAGES.items():
        assert all(order.index(need) < order.index(name) for need in stage.needs)


MECHANICS = {"mesh", "response", "presses", "plain_mesh", "plain_response", "candidates"}


@pytest.mark.parametrize(
    "override",
    [
        "sensors.radius_mm=8.0",
        "sensors.noise_counts=[9.0,9.0,9.0]",
        "score.channels=own",
        "protocol.presses_per_place=4",
        "training.epochs=5",
        "limits.position_bound_mm=2",
        "seed=2",
    ],
)
def test_sensors_noise_and_estimator_rerun_no_mechanics(override):
    before, after = _keys(), _keys(override)
    assert before != after
    assert all(before[name] == after[name] for name in MECHANICS)


def test_another_layout_reruns_nothing_of_the_shell_without_magnets():
    before, after = _keys(), _keys("magnets.positions_mm=[[0,0],[9,8]]")
    kept = {"plain_mesh", "plain_response", "plain_presses", "candidates"}
    assert {name for name in MECHANICS | kept if before[name] == after[name]} == kept


def test_every_part_of_the_specification_matters_to_some_stage():
    used = {part.split(".")[0] for stage in STAGES.values() for part in stage.depends_on}
    derived = {"shell_bodies", "shell_body_cylinder", "dents"}
    assert used | {"search"} == set(ObjectSpec.model_fields) | derived


def test_every_key_of_mechanics_matters_to_some_stage():
    named = {part for stage in STAGES.values() for part in stage.depends_on}
    keys = {f"mechanics.{key}" for key in MechanicsSpec.model_fields}
    assert keys <= named
