"""`build --twin`: files for simulators, with contacts of stored presses or of a flat layer."""

import json
from xml.etree import ElementTree

import numpy as np
import pytest

from design.build.masses import masses_of, total
from design.spec_io import load_spec
from instobj.commands.twin import contact_spring
from instobj.stages.run import Run
from tests.support.cli import run
from tests.support.objects.tiny_cube import SMALL_CUBE, lend_mechanics, tiny_cube

MASS_G = 70.0


@pytest.fixture(scope="module")
def store(tmp_path_factory):
    folder = tmp_path_factory.mktemp("store")
    lend_mechanics(folder)
    return folder


def test_stiffness_is_that_of_stored_presses_and_near_that_of_a_layer(store):
    run = Run(tiny_cube(), root=store)
    layer = contact_spring(run, MASS_G)
    run.require("presses")
    pressed = contact_spring(run, MASS_G)
    assert "presses" in pressed.source
    assert "presses" not in layer.source
    forces = run.presses.force_n.values[0, :, 0]
    assert pressed.n_per_mm == pytest.approx(np.median(forces), rel=1e-6)
    assert pressed.lowest_n_per_mm < pressed.n_per_mm < pressed.highest_n_per_mm
    # both for a press of 1 mm: the layer is flat, wide and without magnets
    assert layer.lowest_n_per_mm < pressed.n_per_mm < 1.3 * layer.highest_n_per_mm
    assert layer.n_per_mm == pytest.approx(pressed.n_per_mm, rel=0.1)


def test_damping_is_that_of_the_relaxation():
    spec = tiny_cube()
    terms = ((0.3, 2e-3),)
    soft = spec.changed(silicone=spec.silicone.changed(prony=terms))
    spring = contact_spring(Run(soft, checked=False), MASS_G)
    stiffness, mass = 1e3 * spring.n_per_mm, MASS_G / 1e3
    omega = np.sqrt(stiffness / mass)
    # the complex modulus of a spring beside a Maxwell element
    modulus = 0.7 + 0.3 * 1j * omega * 2e-3 / (1 + 1j * omega * 2e-3)
    expected = modulus.imag / modulus.real * stiffness / omega
    assert 1e3 * spring.n_s_per_mm == pytest.approx(expected, rel=1e-9)


def test_build_with_twin_writes_the_files_and_lists_them(tmp_path, monkeypatch):
    monkeypatch.setenv("INSTOBJ_STORE", str(tmp_path / "store"))
    done = run("build", SMALL_CUBE, "--twin", "--json", "--out", tmp_path, cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    listed = {row["path"] for row in json.loads(done.stdout)["objects"][0]["files"]}
    folder = tmp_path / "runs" / "small_cube" / "twin"
    for suffix in (".xml", ".urdf", ".usda"):
        assert str(folder / f"small_cube{suffix}") in listed
    inertial = ElementTree.parse(folder / "small_cube.xml").find("worldbody/body/inertial")
    expected = total(masses_of(load_spec(SMALL_CUBE)).values())
    assert 1e3 * float(inertial.get("mass")) == pytest.approx(expected.mass_g, rel=1e-6)
    assert (folder / "meshes" / "collision_1.stl").is_file()
