"""The command that turns names, hardness and tensile tests into a modulus."""

import json
import os

import numpy as np
import pytest

from design.catalogue.silicones import SILICONES
from design.catalogue.tensile import nominal_stress_mpa
from design.errors import InputError
from instobj.commands.material import (
    describe_material,
)
from tests.support.cli import run


def summary(source, out):
    (item,) = describe_material(source, out)["objects"]
    return item["summary"], item["files"]


def test_the_old_name_works_and_says_the_new_one(tmp_path):
    done = run("material", "A30", cwd=tmp_path)
    assert done.returncode == 0
    assert "`instobj material` is now `instobj bench material`" in done.stderr
    assert "Gent" in done.stdout


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
    done = run("bench", "material", data, "--json", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    (item,) = json.loads(done.stdout)["objects"]
    solids = {row["solid"]: row for row in item["summary"]["solids"]}
    assert solids["yeoh"]["constants"] == "0.05,0.008,-0.0004"
    assert item["summary"]["modulus"]["E MPa"] == pytest.approx(0.3, rel=1e-6)
    assert (tmp_path / "runs" / "material_gel" / "fit.png").stat().st_size > 10_000


def test_a_published_test_stands_beside_the_catalogue_and_tells_whose_strain_it_is(tmp_path):
    stretch = np.linspace(1.05, 2.1, 22)
    stress = nominal_stress_mpa("yeoh", (0.008, 0.0006, -0.0001), stretch)
    data = tmp_path / "gel.csv"
    head = [
        "Strain calculation;Derived from the machine crosshead displacement readings",
        "Material;EcoFlex30",
        "Engineering Strain;Engineering Stress (MPa)",
    ]
    rows = [f"{a - 1};{p}" for a, p in zip(stretch, stress, strict=True)]
    data.write_text("\n".join([*head, *rows]))
    found = describe_material(str(data), tmp_path)
    (item,) = found["objects"]
    assert (
        item["summary"]["catalogue"]["E MPa"]
        == SILICONES["Ecoflex 00-30"].modulus.youngs_modulus_mpa
    )
    assert any("crosshead" in text for text in found["texts"])
    to_2 = [row for row in item["summary"]["ranges"] if row["to stretch"] == 2.0]
    yeoh = next(row for row in to_2 if row["solid"] == "yeoh")
    assert yeoh["from"] <= yeoh["E MPa"] <= yeoh["to"]
    assert yeoh["E MPa"] == pytest.approx(0.048, rel=1e-6)


def pull_to(largest, folder):
    stretch = np.linspace(1.05, largest, 15)
    stress = nominal_stress_mpa("yeoh", (0.05, 0.008, -0.0004), stretch)
    lines = [f"{a},{b}" for a, b in zip(stretch, stress, strict=True)]
    data = folder / "gel.csv"
    data.write_text("\n".join(["stretch,nominal_stress_mpa", *lines]))
    return describe_material(str(data), folder), int((stretch > 2).sum())


def test_points_that_are_not_fitted_are_told(tmp_path):
    found, beyond = pull_to(3.0, tmp_path)
    assert beyond > 3
    assert found["texts"][0].startswith(
        f"{beyond} of 15 points lie beyond a stretch of 2 (up to 3)"
    )
    assert "texts" not in pull_to(1.9, tmp_path)[0]


def test_a_pipe_is_no_tensile_test(tmp_path):
    os.mkfifo(tmp_path / "pipe.csv")
    with pytest.raises(InputError, match="a pipe, socket or device"):
        describe_material(str(tmp_path / "pipe.csv"), tmp_path)


def test_what_is_none_of_the_three_is_refused(tmp_path):
    with pytest.raises(InputError, match=r"'jelly' is no silicone .*no hardness .*no CSV"):
        describe_material("jelly", tmp_path)
    with pytest.raises(InputError, match="cannot read tensile data"):
        describe_material(str(tmp_path / "none.csv"), tmp_path)


def test_a_fruit_names_the_layer_that_gives_way_as_it_does(tmp_path):
    from design.catalogue.fruits import FRUITS
    from fem.contact.bonded_layer import layer_force_n

    document = describe_material("tomato", tmp_path)
    (item,) = document["objects"]
    layers = {row["silicone"]: row for row in item["summary"]["layers of silicone"]}
    named = next(name for name in layers if document["texts"][0].startswith(name))
    thickness = layers[named]["thickness mm"]
    fruit = FRUITS["tomato"]
    # Hertz by hand: F = 4/3 E/(1 − ν²) √R δ^1.5 with 1/R = 1/32 + 1/5
    stiffness = 4 / 3 * fruit.youngs_modulus_mpa / (1 - 0.35**2) * np.sqrt(1 / (1 / 32 + 1 / 5))
    depth = (5.0 / stiffness) ** (2 / 3)
    modulus = SILICONES[named].modulus.youngs_modulus_mpa
    assert layer_force_n(depth, modulus, 5.0, thickness) == pytest.approx(5.0, rel=1e-6)
    # a layer that is thick beside the contact is a half-space
    half_space = 16 / 9 * modulus * np.sqrt(5.0) * depth**1.5
    assert layer_force_n(depth, modulus, 5.0, 1e4) == pytest.approx(half_space, rel=1e-3)
    assert layers[named]["from"] < thickness
    assert "Hertz" in document["texts"][1]
