"""Weak areas in words and rows, as report and command line tell them."""

import json

import numpy as np
import pytest
from PIL import Image

from design.spec_io import load_spec
from estimator.information.weak_areas import weak_areas
from instobj.cli.tables import print_result
from instobj.figures.maps.files import draw_measure_maps
from instobj.figures.weak_areas import draw_weak_areas
from instobj.report.weak_areas import (
    WEAK_TITLE,
    edge_text,
    weak_areas_section,
    weak_rows,
    weak_text,
)
from instobj.store.content import StoredResult
from tests.support.objects.made_scores import scores_of
from tests.support.pages import ROOT

THIRDS = {
    "border_mm": ((7.0, 11.0, 1.4), (11.0, 15.0, 1.1), (15.0, 19.0, 0.8)),
    "magnet_mm": ((0.0, 4.0, 0.5), (4.0, 8.0, 1.0), (8.0, 12.0, 2.5)),
    "curvature_per_mm": ((0.0, 0.01, 1.0), (0.01, 0.02, 1.0), (0.02, 0.024, 1.1)),
}
CONTENT = {
    "told_by": "magnet_mm",
    "edge_ratio": 1.75,
    "edge_paths_mm": [18.0, 9.0],
    "beyond_rule": 0.25,
    "rank_correlation": {"border_mm": -0.31, "magnet_mm": 0.82, "curvature_per_mm": 0.05},
    "weakest_tenth": {"border_mm": 7.0, "magnet_mm": 12.0, "curvature_per_mm": 0.01},
    "thirds": [
        {"measure": name, "low": low, "high": high, "places": 10, "bound_mm": bound}
        for name, thirds in THIRDS.items()
        for low, high, bound in thirds
    ],
}


def test_the_sentence_says_what_weak_locations_go_with_and_how_much():
    told = weak_text(CONTENT)
    assert "where the distance to the nearest magnet is large (rank correlation" in told
    assert "+0.82" in told
    assert "25 % of the locations are far from a magnet and a sensor" in told
    assert "2.5 mm at 8 to 12 mm and 0.5 mm at 0 to 4 mm" in told
    assert "edge" not in told, "edges have one figure, that of `edge_text`"
    flat = CONTENT | {"told_by": None, "rank_correlation": {}, "thirds": []}
    assert "none of the measures tells" in weak_text(flat)
    vague = {"border_mm": -0.31, "magnet_mm": 0.42}
    assert "none of the measures clearly" in weak_text(CONTENT | {"rank_correlation": vague})


@pytest.mark.parametrize(
    ("ratio", "paths", "text"),
    [
        (
            1.54,
            (18.0, 9.0),
            "weak, 1.5 times as uncertain as the middle (1.4 mm instead of 0.8 mm), because magnets",
        ),
        (1.54, (9.0, 9.0), "weak, 1.5 times as uncertain as the middle (1.4 mm instead"),
        (1.44, (9.0, 9.0), "not weak, 1.4 times as uncertain as the middle"),
        (1.04, (18.0, 9.0), "as good as the middle"),
        (0.8, (9.0, 18.0), "less uncertain than the middle (0.8 times)"),
        (float("inf"), (9.0, 9.0), "the middle is located, the edges are not"),
        (float("nan"), (float("nan"),) * 2, "the same as the middle"),
    ],
)
def test_edges_have_one_figure_and_a_verdict_that_follows_from_it_rounded(ratio, paths, text):
    told = edge_text(CONTENT | {"edge_ratio": ratio, "edge_paths_mm": paths})
    assert told.startswith(text)
    assert ("because" in told) == ("because" in text)


def test_rows_fit_a_terminal_and_curvature_is_told_per_metre(tmp_path, capsys, monkeypatch):
    monkeypatch.setenv("COLUMNS", "80")
    (tmp_path / "weak_areas.json").write_text(json.dumps(CONTENT))
    rows = weak_rows(StoredResult("weak_areas", "key", tmp_path, True, 0.0, ""))
    print_result({"tables": {WEAK_TITLE: rows}})
    lines = capsys.readouterr().out.splitlines()
    assert max(map(len, lines)) <= 80
    last = lines[-1] if lines[-1].strip() else lines[-2]
    assert last.split()[:4] == ["curvature,", "1/m", "20", "24"]


@pytest.mark.parametrize(("example", "maps"), [("paper_cube", 3), ("handle", 4)])
def test_figure_and_maps_are_drawn_for_flat_and_curved_bodies(tmp_path, example, maps):
    """A flat body has no map of curvature."""
    spec = load_spec(ROOT / f"examples/{example}.toml", ["body.sensed_faces=[1, 3]"])
    scores = scores_of(spec, np.random.default_rng(0).uniform(0.5, 3, (2, 1)))
    areas = weak_areas(spec, scores)
    (tmp_path / "maps").mkdir()
    draw_weak_areas(scores, areas, 1.5, tmp_path / "weak_areas.png")
    draw_measure_maps(spec, scores, areas, tmp_path / "maps", lambda _: None)
    (tmp_path / "weak_areas.json").write_text(json.dumps(CONTENT))
    section = weak_areas_section(tmp_path)
    assert len(section["weak_maps"]) == maps
    for path in (section["weak_picture"], *section["weak_maps"]):
        with Image.open(path) as image:
            assert min(image.size) > 150
    assert section["weak_areas"] == weak_rows(
        StoredResult("weak_areas", "key", tmp_path, True, 0.0, "")
    )


def test_locations_that_lie_alike_have_a_figure_that_says_so(tmp_path):
    """As of one location, that a high force leaves: no measure varies."""
    spec = load_spec(
        ROOT / "examples/hall_skin.toml",
        ["contact_grid.count=[2, 2]", "magnets.positions_mm=[[0.0, 0.0]]"],
    )
    spec = spec.changed(body=spec.body.changed(size_mm=(40.0, 40.0, spec.body.size_mm[2])))
    scores = scores_of(spec, np.ones(4))
    areas = weak_areas(spec, scores)
    assert areas.told_by is None
    draw_weak_areas(scores, areas, 1.5, tmp_path / "weak_areas.png")
    with Image.open(tmp_path / "weak_areas.png") as image:
        assert min(image.size) > 50
