"""Memory is estimated before work: what cannot end is refused with the number and the keys."""

from pathlib import Path

import pytest

from design.errors import InputError
from design.processes import machine_memory_gib
from design.spec_io import load_spec, parse_spec
from fem.mesh.tetrahedra import tetrahedralize
from instobj.stages.resources import mesh_vertices, needed_gib, require_memory, search_seconds
from instobj.stages.run import Run
from instobj.stages.table import STAGES
from tests.support.mechanics.fem_cases import COARSE_EDGES_MM, paper_cube
from tests.support.objects.small_object import small_spec
from tests.support.shared import shared_mesh

EXAMPLES = Path(__file__).parents[3] / "examples"


def spec_with(**parts):
    return parse_spec({"name": "cube", **parts}, "test")


@pytest.mark.parametrize(
    ("stage", "parts", "key"),
    [
        ("response", {"mesh": {"surface_edge_mm": 0.2}}, "mesh.surface_edge_mm"),
        ("response", {"mesh": {"edge_mm": 0.3, "surface_edge_mm": 0.3}}, "mesh.edge_mm"),
        ("candidates", {"mesh": {"surface_edge_mm": 0.2}}, "mesh.surface_edge_mm"),
        (
            "collection",
            {"collection": {"kind": "continuous", "presses": 10**8}},
            "collection.presses",
        ),
        ("collection", {"collection": {"frames_per_case": 10**7}}, "collection.frames_per_case"),
        ("frames", {"protocol": {"frames_per_press": (8, 10**6)}}, "protocol.frames_per_press"),
        ("networks", {"training": {"hidden_units": [10**6, 10**6]}}, "training.hidden_units"),
    ],
)
def test_what_does_not_fit_into_the_machine_is_refused_before_any_work(
    stage, parts, key, monkeypatch, tmp_path
):
    monkeypatch.setenv("INSTOBJ_MEMORY_GIB", "64")
    with pytest.raises(InputError, match=rf"needs about .* GiB .*has 64\. Change .*{key}"):
        Run(spec_with(**parts), root=tmp_path).require(stage)
    assert not list(tmp_path.iterdir())


def test_scores_are_refused_for_memory_before_a_mesh_that_would_fit_is_made(monkeypatch, tmp_path):
    spec, gib = spec_with(), 3.0
    assert needed_gib("mesh", spec) < gib < needed_gib("response", spec)
    monkeypatch.setenv("INSTOBJ_MEMORY_GIB", str(gib))
    with pytest.raises(InputError, match="the stage response of cube needs about"):
        Run(spec, root=tmp_path).require("scores")
    assert not list(tmp_path.iterdir())


def test_the_papers_cube_and_its_estimate(monkeypatch):
    """Default mesh of the paper's cube: 10 500 vertices, 3.9 GB at most for its response."""
    spec = spec_with()
    assert 0.8 * 10_500 < mesh_vertices(spec) < 1.25 * 10_500
    for stage in STAGES:
        require_memory(stage, spec, 8.0)
    with pytest.raises(InputError, match="response"):
        require_memory("response", spec, 3.0)


@pytest.mark.parametrize("spec", [small_spec(), paper_cube(COARSE_EDGES_MM)])
def test_vertices_are_estimated_within_a_factor_of_two(spec):
    assert 0.5 < len(shared_mesh(spec).points_mm) / mesh_vertices(spec) < 2


@pytest.mark.slow
def test_vertices_of_a_small_dome_are_estimated_within_a_factor_of_two():
    spec = load_spec(EXAMPLES / "hollow_dome.toml")
    assert 0.5 < len(tetrahedralize(spec).points_mm) / mesh_vertices(spec) < 2


_ALL_SURFACE = pytest.mark.xfail(
    reason="880 vertices, 2.6 times the estimate: with edges as long as its shell is thick, a small "
    "body's vertices lie on its surfaces"
)


@pytest.mark.slow
@pytest.mark.parametrize(
    "name",
    [
        *("ball", "handle", "egg", "pear", "hall_skin"),
        pytest.param("hollow_dome", marks=_ALL_SURFACE),
    ],
)
def test_vertices_of_other_bodies_are_estimated_within_a_factor_of_two(name):
    coarse = ["mesh.surface_edge_mm=3.0", "mesh.edge_mm=7.0", "mesh.envelope_mm=0.1"]
    spec = load_spec(EXAMPLES / f"{name}.toml", coarse)
    assert 0.5 < len(tetrahedralize(spec).points_mm) / mesh_vertices(spec) < 2


@pytest.mark.parametrize("asked", ["much", "-3", "0", "nan"])
def test_a_wrong_limit_is_told(asked, monkeypatch):
    monkeypatch.setenv("INSTOBJ_MEMORY_GIB", asked)
    with pytest.raises(InputError, match="INSTOBJ_MEMORY_GIB"):
        machine_memory_gib()


def test_a_stage_that_runs_out_of_memory_is_named(monkeypatch, tmp_path):
    def fills(context, folder):
        raise MemoryError

    monkeypatch.setitem(
        STAGES, "plain_mesh", type(STAGES["plain_mesh"])("mesh: small", (), ("mesh",), fills)
    )
    with pytest.raises(InputError, match="mesh: small: the machine has no more memory"):
        Run(spec_with(), root=tmp_path).require("plain_mesh")


def test_mechanics_of_a_search_are_estimated_within_twice_of_what_was_measured():
    """Processor time with other programs running: the cube with one force 144 s, the pear with two 277 s."""
    cube = search_seconds(load_spec(EXAMPLES / "paper_cube.toml", ["search.forces_n=[]"]))
    assert 0.5 < cube.lowest / 144 < 2
    pear = search_seconds(load_spec(EXAMPLES / "pear.toml", ["search.forces_n=[2.0, 8.0]"]))
    assert 0.5 < pear.lowest / 277 < 2
    more = search_seconds(load_spec(EXAMPLES / "pear.toml"))
    assert more == pear, "presses to further forces are made of the same patterns"
    assert pear.chain < pear.lowest
    finer = ["search.forces_n=[2.0, 8.0]", "mesh.surface_edge_mm=1.3"]
    assert search_seconds(load_spec(EXAMPLES / "pear.toml", finer)).lowest > pear.lowest
