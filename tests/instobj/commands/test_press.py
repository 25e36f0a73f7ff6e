"""The command that presses one place with large deformation: materials, depths, errors, files."""

import json

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import InputError
from design.spec.object import ObjectSpec
from instobj.commands.presses.places import Place
from instobj.commands.presses.press import material_of, press_specification
from tests.support import cli
from tests.support.cli import CUBE

SPEC = ObjectSpec(name="cube")


def run(*arguments, cwd):
    return cli.run("press", CUBE, *arguments, cwd=cwd)


def test_materials_by_name_with_their_constants():
    own = material_of(SPEC, "neo-hookean")
    assert_allclose(own.shear_modulus_mpa, 0.414 / (2 * 1.4999), rtol=1e-12)
    yeoh = material_of(SPEC, "yeoh:0.07, -0.002 0.0001")
    assert yeoh.invariant_coefficients_mpa == (0.07, -0.002, 0.0001)
    ogden = material_of(SPEC, "ogden:0.1,1.5,-0.02,-2")
    assert ogden.ogden_terms == ((0.1, 1.5), (-0.02, -2.0))


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"material_text": "rubber"}, "neo-hookean, yeoh, ogden"),
        ({"material_text": "neo-hookean:0.1"}, "takes its modulus from the specification"),
        ({"material_text": "yeoh"}, "C1,C2,C3"),
        ({"material_text": "yeoh:1,2,3,4"}, "one to three"),
        ({"material_text": "ogden:0.1,2,0.3"}, "μ1,α1"),
        ({"material_text": "yeoh:0.07;0.1"}, "must be numbers"),
        ({"material_text": "yeoh:inf"}, "finite"),
        ({"material_text": "yeoh:0.03"}, "E = 0.18 MPa .* is 0.414"),
        ({"place": Place(6, 5.0, -5.0, 1.0)}, "face 6 is not sensed"),
        ({"place": Place(1, 17.0, 0.0, 1.0)}, "hangs over the border"),
        ({"place": Place(1, 5.0, -5.0, 5.0)}, "stay below the tip's radius"),
        ({"place": Place(1, 5.0, -5.0, -1.0)}, "must be positive"),
        ({"place": Place(1, 5.0, -5.0, float("nan"))}, "must be positive"),
    ],
)
def test_presses_that_make_no_sense_are_refused_before_any_work(change, words, tmp_path):
    press = {
        "path": CUBE,
        "place": Place(1, 5.0, -5.0, 1.0),
        "material_text": "neo-hookean",
        "out": tmp_path,
        "overrides": [],
    }
    with pytest.raises(InputError, match=words):
        press_specification(**(press | change))
    assert not list(tmp_path.iterdir())


def test_a_place_is_asked_for(tmp_path):
    done = run(cwd=tmp_path)
    assert done.returncode == 2
    assert "--at" in done.stderr
    assert "Traceback" not in done.stderr


@pytest.mark.slow
def test_a_press_shows_both_models_writes_its_files_and_is_reused(tmp_path):
    coarse = ["--set", "mesh.surface_edge_mm=2", "--set", "mesh.edge_mm=6", "--json"]
    arguments = ["--at", "3:-5,5.5,0.6", "--material", "neo-hookean", *coarse]
    first, again = run(*arguments, cwd=tmp_path), run(*arguments, cwd=tmp_path)
    assert first.returncode == again.returncode == 0
    document = json.loads(first.stdout)
    (item,) = document["objects"]
    press, steps = item["summary"]["press"], item["summary"]["force and travel"]
    assert document["status"] == press["status"] == "converged"
    assert [step["depth mm"] for step in steps] == [0.2, 0.4, 0.6]
    force = np.array([[step["linear N"], step["nonlinear N"]] for step in steps])
    assert (np.diff(force, axis=0) > 0).all()
    off = 100 * (force[-1, 0] / force[-1, 1] - 1)
    assert steps[-1]["linear off %"] == pytest.approx(off, abs=1e-9)
    assert 0 < abs(off) < 8
    folder = tmp_path / "runs" / item["name"] / "press_3_-5_5.5_neo-hookean"
    names = {"press.json", "press.nc", "force_travel.png", "section.png"}
    names |= {"deformed.vtu", "small_strain.vtu"}
    assert {path.name for path in folder.iterdir()} == names
    assert [stage["reused"] for stage in item["stages"]] == [False, False]
    stages = json.loads(again.stdout)["objects"][0]["stages"]
    assert [stage["reused"] for stage in stages] == [True, True]
