"""The command that says what a slipped core costs."""

import json
from pathlib import Path

import pytest

from design.errors import InputError
from instobj.commands.presses.slip import slip_specification

CUBE = Path(__file__).parents[3] / "examples" / "paper_cube.toml"
COARSE = [
    "mesh.surface_edge_mm=3",
    "mesh.rim_edge_ratio=1",
    "mesh.magnet_sides=8",
    "mesh.edge_mm=8",
    "contact_grid.count=[3,4]",
    "press.depths_mm=[1.0,2.0,3.0]",
    "score.force_n=3",
]


@pytest.mark.parametrize(
    ("shift", "rotation", "rim", "words"),
    [
        ((0.0, 0.0, 0.0), (0.0, 0.0, 0.0), "free", "no slip given"),
        ((4.0, 0.0, 0.0), (0.0, 0.0, 0.0), "free", "less than or equal to 3"),
        ((1.0, 0.0, 0.0), (0.0, -11.0, 0.0), "free", "greater than or equal to -10"),
        ((1.0, 0.0, 0.0), (0.0, 0.0, 0.0), "glued", "'free' or 'held'"),
    ],
)
def test_slips_that_make_no_sense_are_refused_before_any_work(
    shift, rotation, rim, words, tmp_path
):
    with pytest.raises(InputError, match=words):
        slip_specification(CUBE, shift, rotation, rim, tmp_path, [])
    assert not (tmp_path / "runs").exists()


@pytest.mark.slow
@pytest.mark.parametrize("rim", ["free", "held"])
def test_a_slip_is_shown_by_both_models(tmp_path, monkeypatch, rim):
    monkeypatch.setenv("INSTOBJ_STORE", str(tmp_path / "store"))
    document = slip_specification(CUBE, (1.0, 0.0, 0.0), (0.0, 0.0, 0.0), rim, tmp_path, COARSE)
    (item,) = document["objects"]
    folder = tmp_path / "runs" / "paper_cube" / f"slip_1_0_0_0_0_0_{rim}"
    assert {path.name for path in folder.iterdir()} == {"slip.json", "slip.png"}
    content = json.loads((folder / "slip.json").read_text(encoding="utf-8"))
    fem, alone = content["models"]["fem"], content["models"]["sensors-only"]
    assert len(content["sensors"]) == 15
    assert 500 < alone["baseline_median_counts"] < 1500
    assert fem["rezeroed_place_mm_median"] > alone["rezeroed_place_mm_median"]
    difference = abs(fem["baseline_median_counts"] - alone["baseline_median_counts"])
    if rim == "free":
        assert difference < 1e-6 * alone["baseline_median_counts"]
    else:
        assert difference > 1
    rows = next(iter(item["summary"].values()))
    assert rows[0]["its error"] == pytest.approx(rows[0]["sensors-only"] - rows[0]["fem"])
