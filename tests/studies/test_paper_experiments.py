"""The paper's experiments in their quick form, on a synthetic object: tables, figures, sense."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.spec.object import ObjectSpec
from estimator.frames.contact_traces import JointMechanics
from estimator.frames.splits import split_paper_random_frames
from estimator.tolerances.virtual_object import drawn_assembly, twin_signals
from studies.layouts import changed
from studies.paper import amounts, general, places, reference, unseen
from studies.paper import object as paper_object
from studies.paper.object import SimulatedObject, metric_row
from studies.paper.places import AREAS, area_places, rank_correlation
from studies.paper.published import TABLE_I, beside
from studies.registry import studies
from tests.support.mechanics.half_space_response import half_space_response
from tests.support.mechanics.synthetic_presses import synthetic_presses

NAMES = (
    "general-performance",
    "linear-baseline",
    "location-wise",
    "force-sensitivity",
    "data-amount",
    "reference-bounds",
    pytest.param("seen-unseen", marks=pytest.mark.slow),
    pytest.param("places-against-frames", marks=pytest.mark.slow),
)


@pytest.fixture(scope="module")
def synthetic_object():
    spec = changed(ObjectSpec(name="synthetic"), paper_object.QUICK)
    assembly = drawn_assembly(spec, 7)
    presses = synthetic_presses(spec)
    signals = twin_signals(spec, assembly, *presses)
    mechanics = JointMechanics(half_space_response(spec, 13), None, assembly)
    return SimulatedObject(spec, signals, mechanics, spec, presses, "synthetic")


class Results(dict):
    """What a study returned and its folder, by its name; run when it is first asked for."""

    def __init__(self, spec, folder):
        super().__init__()
        self.spec, self.folder = spec, folder

    def __missing__(self, name):
        target = self.folder / name
        target.mkdir()
        self[name] = studies()[name].run(self.spec, target, True), target
        return self[name]


@pytest.fixture(scope="module")
def results(synthetic_object, tmp_path_factory):
    """One store for all studies, so that fits are shared."""
    folder = tmp_path_factory.mktemp("experiments")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("INSTOBJ_STORE", str(folder / "store"))
        for module in (general, places, amounts, unseen, reference):
            patch.setattr(module, "simulated_object", lambda spec, quick: synthetic_object)
        yield Results(synthetic_object.spec, folder)


@pytest.mark.parametrize("name", NAMES)
def test_every_study_writes_a_table_and_says_what_it_is(results, name):
    found, folder = results[name]
    assert found.rows
    assert all(row.keys() == found.rows[0].keys() for row in found.rows)
    assert "hidden twin" in found.texts[0]
    figures = list(folder.glob("*.png"))
    assert bool(figures) == (name != "reference-bounds")
    assert all(figure.stat().st_size > 5000 for figure in figures)


def test_table_one_stands_beside_the_papers_and_the_bound(results):
    (row,) = results["general-performance"][0].rows
    assert row["paper E_f %"] == 1.82
    assert row["paper E_loc px"] == pytest.approx(15.3e-4)
    assert row["E_f over bound"] == pytest.approx(row["E_f %"] / row["best E_f %"], abs=1e-3)
    assert row["best E_f %"] < row["E_f %"]
    assert 0 < row["A_sim from 4 N"] <= 1
    assert 0 <= row["false alarms %"] < 20


def test_intervals_stand_beside_the_narrowest_ones(results):
    (row,) = results["general-performance"][0].rows
    assert 75 < row["force in interval %"] <= 100
    assert 75 < row["place in radius %"] <= 100
    assert row["interval ± N"] > row["best interval ± N"] > 1.6 * 0.12  # the load cell's noise
    ratio = row["interval ± N"] / row["best interval ± N"]
    assert row["interval over bound"] == pytest.approx(ratio, rel=2e-3)
    assert row["radius mm"] > row["best radius mm"]


def test_the_network_beats_linear_regression_and_both_beat_chance(results):
    rows = {row["estimator"]: row for row in results["linear-baseline"][0].rows}
    assert rows["compact"]["A_sim"] > rows["linear"]["A_sim"] > rows["always the mean map"]["A_sim"]
    assert rows["compact"]["paper E_f %"] is None


def test_less_data_does_worse(results):
    rows = results["data-amount"][0].rows
    assert rows[0]["training frames"] > 10 * rows[-1]["training frames"]
    assert rows[0]["A_sim"] > rows[-1]["A_sim"]
    assert rows[0]["E_f %"] < rows[-1]["E_f %"]


@pytest.mark.slow
def test_unseen_places_are_harder_than_seen_ones(results):
    rows = results["seen-unseen"][0].rows
    for model in ("heatmap", "position"):
        seen, unseen = (
            next(r for r in rows if (r["model"], r["places"]) == (model, place))
            for place in ("seen", "unseen")
        )
        assert unseen["E_f %"] > seen["E_f %"]
        assert unseen["distance px"] > seen["distance px"]
    assert rows[1]["paper E_f %"] == 32.6


@pytest.mark.slow
def test_a_calibrated_twin_knows_places_that_nobody_pressed(results):
    rows = [row for row in results["seen-unseen"][0].rows if row["places"] == "unseen"]
    errors = {row["model"]: row for row in rows}
    twin = errors["calibrated twin"]
    assert twin["distance px"] < 0.72 * errors["position"]["distance px"]
    assert twin["E_f %"] < 0.5 * errors["heatmap"]["E_f %"]
    assert all(row["best E_f %"] < row["E_f %"] for row in rows)


def test_seen_places_are_every_second_in_x_and_y(synthetic_object):
    frames = synthetic_object.collect(poses=[[], []])
    kept = frames.select(unseen.seen_places(frames))
    places_kept = np.unique(kept.place_id[kept.place_id >= 0] - 1000)
    assert places_kept.tolist() == [5 * x + y for x in (0, 2, 4) for y in (0, 2, 4)]
    assert (kept.place_id < 0).sum() == (frames.place_id < 0).sum()


def test_another_recording_has_other_noise_and_the_same_object(synthetic_object):
    one, again, other = (synthetic_object.collect(seed=seed) for seed in (0, 0, 1))
    np.testing.assert_array_equal(one.signal_counts, again.signal_counts)
    assert not np.array_equal(one.signal_counts, other.signal_counts)
    strongest = [np.nanmax(f.true_force_n[f.place_id == 1012]) for f in (one, other)]
    assert_allclose(*strongest, rtol=0.02)


def test_the_random_split_tears_presses_apart(synthetic_object):
    frames = synthetic_object.collect()
    split = split_paper_random_frames(frames, 1)
    shares = [part.mean() for part in (split.train, split.validation, split.test)]
    assert_allclose(shares, (0.6, 0.2, 0.2), atol=1e-3)
    assert (split.train + split.validation + split.test == 1).all()
    torn = np.intersect1d(frames.press_id[split.train], frames.press_id[split.test])
    assert len(torn) > 0.9 * len(np.unique(frames.press_id[split.test]))


@pytest.mark.parametrize(
    ("b", "expected"), [([1, 2, 3, 9.0], 1.0), ([9, 5, 2, 1.0], -1.0), ([1, 9, 3, np.nan], 0.5)]
)
def test_rank_correlation_by_hand(b, expected):
    assert rank_correlation(np.array([0.1, 5.0, 6.0, 700.0]), np.array(b)) == expected


def test_rank_correlation_of_what_does_not_vary_is_undefined():
    assert np.isnan(rank_correlation(np.arange(4.0), np.ones(4)))


def test_published_columns_stand_after_ours():
    row = beside({"A_sim": 0.5, "total force %": 3.0}, TABLE_I[3])
    assert list(row) == ["A_sim", "paper A_sim", "total force %"]
    assert row["paper A_sim"] == 0.997
    assert metric_row.__doc__


@pytest.mark.slow
def test_the_chain_makes_the_hidden_twin(tmp_path, monkeypatch):
    monkeypatch.setenv("INSTOBJ_STORE", str(tmp_path))
    spec = ObjectSpec(name="cube")
    recorded = paper_object.simulated_object(spec, quick=True)
    again = paper_object.simulated_object(spec, quick=True)
    assert again.key == recorded.key
    np.testing.assert_array_equal(again.signals.delta_counts, recorded.signals.delta_counts)
    assert recorded.mechanics.assembly.modulus_ratio != 1
    frames = recorded.collect(faces=[2])
    assert set(np.unique(frames.contact_face)) == {0, 2}


def test_areas_of_the_papers_grid():
    sizes = {area: int(area_places((10, 10), area).sum()) for area in AREAS}
    assert sizes == {"corner": 4, "edge": 32, "mid_edge": 16, "centre": 16}
    middle = area_places((10, 10), "mid_edge")
    assert np.flatnonzero(middle[0]).tolist() == [3, 4, 5, 6]
    assert middle[9, 3]
    assert middle[5, 0]
    assert not middle[2, 0]
    assert not (area_places((10, 10), "corner") & area_places((10, 10), "edge")).any()


def test_areas_of_a_grid_of_seven_by_six():
    middle = np.zeros((7, 6), bool)
    middle[np.ix_([0, -1], [2, 3])] = True  # within 6/6 rows of the middle, 2.5
    middle[np.ix_([2, 3, 4], [0, -1])] = True  # within 7/6 columns of the middle, 3
    np.testing.assert_array_equal(area_places((7, 6), "mid_edge"), middle)
    centre = np.zeros((7, 6), bool)
    centre[2:5, 1:5] = True
    np.testing.assert_array_equal(area_places((7, 6), "centre"), centre)
