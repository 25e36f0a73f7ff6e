"""The command that turns names, hardness and tensile tests into a modulus; the spread in words."""

import json

import numpy as np
import pytest

from design.catalogue.tensile import nominal_stress_mpa
from design.errors import InputError
from design.layout.positions import press_lattice
from design.spec.object import ObjectSpec
from estimator.signals.presses import Signals
from instobj.commands.material import (
    TravelSpread,
    describe_material,
    force_spread_text,
    modulus_text,
    travel_spread,
)
from tests.support.cli import run

SPEC = ObjectSpec(name="cube")
UNKNOWN = ObjectSpec.model_validate({"name": "cube", "silicone": {"youngs_modulus_mpa": 2.0}})


def summary(source, out):
    (item,) = describe_material(source, out)["objects"]
    return item["summary"], item["files"]


@pytest.mark.parametrize(("source", "modulus"), [("dragon skin 30", 0.87), ("A30", 1.1468)])
def test_names_and_hardness_give_a_modulus_within_its_interval(source, modulus, tmp_path):
    found, files = summary(source, tmp_path)
    assert found["modulus"]["E MPa"] == pytest.approx(modulus, rel=1e-4)
    assert found["modulus"]["from"] < modulus < found["modulus"]["to"]
    assert not files
    assert not list(tmp_path.iterdir())


def test_a_tensile_test_gives_fits_and_a_figure(tmp_path):
    stretch = np.linspace(1.05, 1.9, 15)
    stress = nominal_stress_mpa("yeoh", (0.05, 0.008, -0.0004), stretch)
    lines = ["stretch,nominal_stress_mpa"]
    lines += [f"{a},{b}" for a, b in zip(stretch, stress, strict=True)]
    data = tmp_path / "gel.csv"
    data.write_text("\n".join(lines))
    done = run("material", data, "--json", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    (item,) = json.loads(done.stdout)["objects"]
    solids = {row["solid"]: row for row in item["summary"]["solids"]}
    assert solids["yeoh"]["constants"] == "0.05,0.008,-0.0004"
    assert item["summary"]["modulus"]["E MPa"] == pytest.approx(0.3, rel=1e-6)
    assert (tmp_path / "runs" / "material_gel" / "fit.png").stat().st_size > 10_000


def test_what_is_none_of_the_three_is_refused(tmp_path):
    with pytest.raises(InputError, match=r"'jelly' is no silicone .*no hardness .*no CSV"):
        describe_material("jelly", tmp_path)
    with pytest.raises(InputError, match="cannot read tensile data"):
        describe_material(str(tmp_path / "none.csv"), tmp_path)


def test_the_spread_in_words():
    assert modulus_text(SPEC).startswith("0.414 MPa (0.15 to 0.54; Gent's relation")
    assert force_spread_text(SPEC) == "0.36 to 1.30 times what is shown"
    assert modulus_text(UNKNOWN) == "2 MPa (spread not known; given)"
    assert "not known" in force_spread_text(UNKNOWN)


def test_travel_grows_where_the_silicone_is_softer():
    """Force 6 δ newtons everywhere; 15 N take 2.5 mm at E, 6 δ (0.54 / 0.414) takes 1.917 mm."""
    lattice, depths = press_lattice(SPEC), np.array([1.0, 2.0, 4.0])
    force = np.broadcast_to(6 * depths, (5, len(lattice), 3)).copy()
    empty = np.zeros((5, len(lattice), 3, 15, 3))
    signals = Signals(np.arange(1, 6), lattice, depths, force, empty, np.zeros((15, 3)))
    found = travel_spread(SPEC, signals)
    assert isinstance(found, TravelSpread)
    assert found.nominal_mm == pytest.approx(2.5)
    assert found.stiffest_mm == pytest.approx(2.5 * 0.414 / 0.54)
    assert found.softest_mm is None
    assert travel_spread(UNKNOWN, signals) is None
