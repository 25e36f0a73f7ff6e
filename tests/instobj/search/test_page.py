"""The search page: what it says stands in what it is given, and it is one file of valid markup."""

import json
import re
from dataclasses import fields, replace
from pathlib import Path

import numpy as np
import pytest

from design.build.manifest import BuildManifest, PartManifest
from design.layout.places.contact_grid import contact_grid
from design.layout.places.contact_places import contact_places
from design.spec_io import parse_spec
from estimator.information.scores import PlaceScores, save_scores_csv
from estimator.layouts.fidelity import SCORE_NAMES, FidelityScore
from instobj.figures.maps import overview
from instobj.search.fidelity import TwinRatio
from instobj.search.outcome import page
from instobj.search.outcome.figures import LABELS
from instobj.search.outcome.layouts import ShownLayout
from instobj.search.outcome.page import ChainResults, write_search_page
from instobj.search.verdict import Promoted, Promotion
from instobj.store.readers import CROSS_FACE
from tests.support.markup import read
from tests.support.objects.made_histories import made_up_history
from tests.support.pictures import save_dot

DRAWN = {
    page: ("draw_convergence",),
    overview: ("draw_overview",),
}


def _dots(*given, **_):
    (path,) = [value for value in given if isinstance(value, Path)]
    path.parent.mkdir(exist_ok=True)
    save_dot(path)


def made_up_scores(spec, path):
    grid = contact_grid(spec)
    shape = (5, len(grid))
    values = np.random.default_rng(2).uniform(0.2, 2.0, shape)
    arrays = {field.name: values for field in fields(PlaceScores)[2:]}
    arrays["reaches_score_force"] = np.ones(shape, bool)
    save_scores_csv(PlaceScores(np.arange(1, 6), grid, **arrays), path / "scores.csv")


@pytest.fixture
def results(tmp_path):
    spec = parse_spec({"name": "start"}, "start")
    made_up_scores(spec, tmp_path)
    box = ((0.0, 0.0, 0.0), (1.0, 1.0, 1.0))
    part = PartManifest("core", 12.345, box, (0.5, 0.5, 0.5), 6, 1, 12.345, False, 12)
    BuildManifest("found", "0" * 64, (part,), {}).write(tmp_path)
    save_dot(tmp_path / "parts.png")
    after = tmp_path / "after"
    after.mkdir()
    made_up_scores(spec, after)
    for folder, force_n in ((tmp_path, 20.0), (after, 30.0)):
        adjacent = {"largest_false_force_n": force_n}
        CROSS_FACE.path(folder).write_text(json.dumps({"adjacent": adjacent}))
    return ChainResults(tmp_path, (tmp_path, after))


def promote(objections, levels=("1", "2", "3")):
    def promoted(label, trial, value, **content):
        spec = parse_spec({"name": "a", **content}, "a")
        bounds = (value,) * (len(spec.scoring_forces_n) * int(contact_places(spec).sum()))
        score = FidelityScore(**dict.fromkeys(SCORE_NAMES, value), position_bounds_mm=bounds)
        return Promoted(label, trial, spec, dict.fromkeys(levels, score))

    moved = {"positions_mm": [[0, 0], [9, 8], [-9, 8], [9, -8], [-8, -9]]}
    start, best = promoted("start", None, 2.0), promoted("trial 7 <b>", 7, 1.0, magnets=moved)
    if "3" not in levels:
        return Promotion(start, (best,), (), {}, objections, (1, 1))
    ratios = {"worst_position_bound_mm": TwinRatio(2.0, 1.1, 3.0)}
    return Promotion(start, (best,), (best,), ratios, objections, (1, 1))


def test_without_the_whole_chain_the_page_shows_the_second_level(tmp_path, results, monkeypatch):
    for module, names in DRAWN.items():
        for name in names:
            monkeypatch.setattr(module, name, _dots)
    found = promote(("the time ended before the whole chain",), levels=("1", "2"))
    history, spec = made_up_history(), parse_spec({"name": "start"}, "s")
    layouts = [ShownLayout(one.label, one.spec, (2.0, 3.0)) for one in (found.start, found.best)]
    results = replace(results, scores=None)
    path = write_search_page(spec, found, history, layouts, results, tmp_path, print)
    text = path.read_text(encoding="utf-8")
    told = read(text)
    assert "NOT CONFIRMED" in told
    assert "the time ended before the whole chain" in told
    assert "second fidelity level start found change" in told
    assert "From the scores of all faces at the second fidelity level" in told
    assert "None were scored: the search's time was over." in told
    for absent in ("the whole chain start", "Position bound before", "largest 20 30"):
        assert absent not in told


def test_the_page_says_where_best_toml_is_your_own_layout(tmp_path, results, monkeypatch):
    for module, names in DRAWN.items():
        for name in names:
            monkeypatch.setattr(module, name, _dots)
    promotion, spec = promote(("it is worse",)), parse_spec({"name": "start"}, "s")
    swapped = replace(promotion.best, levels=promotion.start.levels)
    promotion = replace(promotion, start=replace(promotion.start, levels=promotion.best.levels))
    promotion = replace(promotion, leaders=(swapped,), finalists=(swapped,))
    layouts = [
        ShownLayout(one.label, one.spec, (2.0, 3.0)) for one in (promotion.start, promotion.best)
    ]
    path = write_search_page(spec, promotion, made_up_history(), layouts, results, tmp_path, print)
    page_text = read(path.read_text(encoding="utf-8"))
    assert (
        "best.toml is your own layout, unchanged; trial 7 <b>, the best one found, is shown here to compare"
        in page_text
    )


@pytest.mark.parametrize("objections", [(), ("the objectives' mean is not better",)])
def test_the_page_says_what_was_found(tmp_path, results, objections, monkeypatch):
    if objections:  # its pictures are those of the other page
        for module, names in DRAWN.items():
            for name in names:
                monkeypatch.setattr(module, name, _dots)
    found, history = promote(objections), made_up_history()
    layouts = [ShownLayout(one.label, one.spec, (2.0, 3.0)) for one in (found.start, found.best)]
    spec = parse_spec({"name": "start"}, "s")
    path = write_search_page(spec, found, history, layouts, results, tmp_path, print)
    text = path.read_text(encoding="utf-8")
    told = read(text)
    assert ("NOT BETTER" in told) == bool(objections)
    assert "the objectives' mean is not better" in told or not objections
    # the best one found halves every bound here
    assert ("best.toml is trial 7 <b>, which is shown here all the same" in told) == bool(
        objections
    )
    assert "trial 7 <b> against the start." in told, "text is escaped"
    assert "12.35" in told or "12.34" in told
    assert 'class="no-go">NO<' in text, "a part that is not watertight stands out"
    assert "× 0.50" in told
    assert "false force by the next face (N), largest 20 30 × 1.50" in told
    assert "score start / best 95 % from to worst_position_bound_mm 2 1.1 3" in told
    assert text.count("<img") == text.count('src="data:image/webp;base64,')
    assert not re.findall(r"""src=["'](?!data:)|<link|<script src|@import""", text)
    assert "default-src &#39;none&#39;" in text, (
        "the browser refuses whatever else might be asked for"
    )


def test_every_score_has_a_label_of_its_own():
    assert set(LABELS) == set(SCORE_NAMES)
    assert len(set(LABELS.values())) == len(LABELS)
