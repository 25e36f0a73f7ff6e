"""Widths of intervals, sharpness and slopes of novelty from held-out presses whose answers are made up."""

from types import SimpleNamespace

import numpy as np
import pytest
import torch
from numpy.testing import assert_allclose

from design.errors import InputError
from design.spec.object import TrainingSpec
from estimator.frames.face_data import face_data
from estimator.networks.intervals import coverage, held_out
from estimator.networks.intervals.coverage import Slopes, gp_weight, growth
from estimator.networks.network import HeadsNetwork
from estimator.networks.training import face as training
from estimator.networks.training.face import FitSettings
from tests.support.recordings.synthetic_frames import synthetic_frames

FACE, COVER = 2, 0.8
CHANNELS = ((2, 0, 0), (2, 1, 1))


@pytest.fixture(scope="module")
def data():
    """Two presses of each of four places on face 2, and none elsewhere."""
    frames = synthetic_frames(faces=(FACE,), presses=2, places=(0, 4, 9, 17), loaded=6)
    return face_data(frames, FACE)


def quantile(score, group, share):
    """Smallest score below which such a share of the groups lies, all groups weighed alike."""
    weight = 1 / np.bincount(group, minlength=group.max() + 1)[group]
    order = np.argsort(score)
    reached = np.cumsum(weight[order]) / weight.sum()
    return score[order][min(np.searchsorted(reached, share - 1e-9), len(score) - 1)]


def answered(press, rng, scale=1.0):
    """Answers of the network alone at contact frames, off by a spread of their own."""
    count = len(press)
    true_n, true_mm = rng.uniform(1, 9, count), rng.uniform(-5, 5, (count, 2))
    spread_n, spread_mm = rng.uniform(0.2, 0.6, count), rng.uniform(0.3, 0.9, count)
    off_n, off_mm = rng.normal(size=count), rng.normal(size=(count, 2))
    nothing = np.full(count, np.nan), np.full((count, 2), np.nan)
    away = true_mm + scale * spread_mm[:, None] * off_mm
    return held_out.HeldOutFrames(
        press, true_n, true_mm, true_n + scale * spread_n * off_n, away, away, *nothing, *nothing,
        spread_n, spread_mm, rng.uniform(0.5, 3.0, count),
    )  # fmt: skip


@pytest.mark.parametrize("processed", [False, True])
@pytest.mark.parametrize("folds", [1, 2])
def test_widths_cover_the_wanted_share_of_held_out_presses(monkeypatch, data, processed, folds):
    """Errors less what novelty widens, over the spread that the network's share leaves."""
    rng = np.random.default_rng(0)
    given = [answered(np.repeat(np.arange(9) + 9 * k, 5), rng) for k in range(folds)]
    waiting = iter(given)
    slopes = Slopes(0.3, 0.7)
    made = SimpleNamespace(
        forest=None, force_share=torch.tensor(9.0), place_shares=torch.zeros(3),
        force_quantile=torch.tensor(1.0), position_quantile=torch.tensor(1.0),
    )  # fmt: skip
    known = SimpleNamespace(
        scale=torch.tensor(1.0), force_slope_n=torch.tensor(1.0), place_slope_mm=torch.tensor(1.0)
    )
    monkeypatch.setattr(held_out, "held_out_answers", lambda *args: next(waiting))
    monkeypatch.setattr(held_out, "reference_of", lambda *args: known)
    monkeypatch.setattr(held_out, "slopes_at_places_left_out", lambda *args: slopes)
    monkeypatch.setattr(held_out, "ContactEstimator", lambda *args: made)
    monkeypatch.setattr(
        held_out, "blended_errors",
        lambda network, found, new: (
            abs(found.network_n - found.true_n),
            np.linalg.norm(found.network_mm - found.true_mm, axis=1),
        ),
    )  # fmt: skip
    process = object() if processed else None
    parts = [SimpleNamespace(member=None)] * folds
    network, presses = held_out.assembled.__wrapped__(
        parts, data, None, process, CHANNELS, COVER, 0
    )
    assert (network, presses) == (made, 9 * folds)
    columns = {
        name: np.concatenate([getattr(one, name) for one in given])
        for name in ("press_id", "true_n", "network_n", "true_mm", "network_mm", "distance")
    }
    press = columns["press_id"]
    scale = quantile(columns["distance"], press, 0.95)
    assert_allclose(float(known.scale), scale, rtol=1e-6)
    assert_allclose([float(known.force_slope_n), float(known.place_slope_mm)], [0.3, 0.7])
    novelty = torch.as_tensor(columns["distance"] / scale)
    grown = (gp_weight if processed else growth)(novelty).numpy()
    left = 1 - grown if processed else 1.0
    share = COVER if folds > 1 else COVER * 10 / 9
    errors = {
        "force_quantile": (abs(columns["network_n"] - columns["true_n"]), 0.3, "spread_n"),
        "position_quantile": (
            np.linalg.norm(columns["network_mm"] - columns["true_mm"], axis=1), 0.7, "spread_mm",
        ),
    }  # fmt: skip
    for name, (error, slope, spread) in errors.items():
        size = np.concatenate([getattr(one, spread) for one in given])
        score = np.maximum(error - slope * grown, 0) / np.maximum(left * size, 1e-9)
        assert_allclose(float(getattr(made, name)), quantile(score, press, share), rtol=1e-5)


def test_the_share_of_the_process_is_blended_with_what_the_network_says():
    """Forces that are right by a quarter of the process and the network; places of the heatmap."""
    rng = np.random.default_rng(2)
    given = answered(np.arange(30) // 3, rng)
    new = np.where(np.arange(30) < 10, 0.0, 0.25)
    columns = dict(given.__dict__)
    columns["process_n"] = np.where(new > 0, rng.uniform(1, 9, 30), np.nan)
    columns["process_mm"] = np.where(new[:, None] > 0, rng.uniform(-5, 5, (30, 2)), np.nan)
    columns["heatmap_mm"] = rng.uniform(-5, 5, (30, 2))
    there_n, there_mm = (np.nan_to_num(columns[name]) for name in ("process_n", "process_mm"))
    columns["true_n"] = (1 - new) * given.network_n + new * there_n
    columns["true_mm"] = (1 - new)[:, None] * columns["heatmap_mm"] + new[:, None] * there_mm
    network = SimpleNamespace(
        forest=None, force_share=torch.tensor(9.0), place_shares=torch.full((3,), 9.0)
    )
    missed, away = held_out.blended_errors.__wrapped__(
        network, held_out.HeldOutFrames(**columns), new
    )
    assert_allclose(missed, 0, atol=1e-12)
    assert_allclose(away, 0, atol=1e-12)
    assert float(network.force_share) == 0.0
    assert network.place_shares.tolist() == [0.0, 1.0, 9.0]


def test_sharpness_is_that_of_least_dissimilarity_and_force_error(monkeypatch, data):
    """A made cost whose least is at sharpness 4 and 0.2 of faint shares, in its two parts."""
    member = HeadsNetwork(np.ones(2), data.frames.grid_x_mm, data.frames.grid_y_mm, (4,), 1.0)
    member.force_scale_n.fill_(5.0)
    frames = []

    def read_counts(network, counts):
        frames.append(len(counts))
        return SimpleNamespace(heatmap_n=np.zeros((len(counts), 1, 4, 5)))

    def judged(face, maps, true_n, reference):
        off = abs(np.log2(float(member.sharpness)) - 2) / 10
        aside = abs(float(member.faint) - 0.2)
        return SimpleNamespace(similarity=1 - off, force_error_n=5.0 * aside)

    monkeypatch.setattr(held_out, "read_counts", read_counts)
    monkeypatch.setattr(held_out, "face_metrics", judged)
    found = held_out.sharpened.__wrapped__(member, data, CHANNELS)
    assert_allclose([float(found.sharpness), float(found.faint)], [4, 0.2])
    assert frames == [int(data.contact.sum())] * 15

    def forceful(face, maps, true_n, reference):
        off = abs(np.log2(float(member.sharpness)) - 2) / 10
        return SimpleNamespace(similarity=1 - off, force_error_n=-5.0 * float(member.faint))

    monkeypatch.setattr(held_out, "face_metrics", forceful)
    found = held_out.sharpened.__wrapped__(member, data, CHANNELS)
    assert_allclose([float(found.sharpness), float(found.faint)], [4, 0.4])
    continuous = HeadsNetwork(
        np.ones(2), data.frames.grid_x_mm, data.frames.grid_y_mm, (4,), 1.0, 1, True
    )
    before = float(continuous.sharpness)
    held_out.sharpened.__wrapped__(continuous, data, CHANNELS)
    assert float(continuous.sharpness) == before


def left_out(monkeypatch, data, of_process, force_off=0.5, place_off=(0.6, 0.8)):
    """Slopes where trees or a process err by so much everywhere, and how many frames each learned."""
    truth_n, truth_mm = data.heatmap_n.sum(axis=(1, 2)), data.centre_mm
    learned, asked = [], []
    counts_of = coverage.channel_counts

    def fitted(known, *args, **named):
        learned.append(set(known.frames.place_id[known.contact].tolist()))

        def answer(counts):
            every = torch.as_tensor(counts_of(data.frames, CHANNELS).astype(np.float32))
            rows = [int((every == one).all(dim=1).nonzero()[0]) for one in counts]
            asked.append(rows)
            return (
                torch.as_tensor(truth_n[rows] + force_off),
                torch.as_tensor(truth_mm[rows] + np.array(place_off)),
            )

        return answer

    monkeypatch.setattr(coverage, "PLACE_GROUPS", 6)
    monkeypatch.setattr(coverage, "fit_forest", fitted)
    monkeypatch.setattr(coverage, "fit_process", fitted)
    monkeypatch.setattr(
        coverage, "reference_of",
        lambda *args: SimpleNamespace(distance=lambda counts: torch.full((len(counts),), 10.0)),
    )  # fmt: skip
    slopes = coverage.slopes_at_places_left_out.__wrapped__(
        data, CHANNELS, np.ones(2), 2.0, 0.7, 0, of_process
    )
    return slopes, learned, asked


def test_slopes_are_errors_at_places_left_out_over_their_growth(monkeypatch, data):
    """Every place is left out once; a distance of 10 at a scale of 2 is √4 of growth: 0.5 N and 1 mm
    of error are slopes of 0.25 N and 0.5 mm. A process' own growth is 1."""
    slopes, learned, asked = left_out(monkeypatch, data, of_process=False)
    assert_allclose([slopes.force_n, slopes.place_mm], [0.25, 0.5], rtol=1e-6)
    cases = set(data.frames.place_id[data.contact].tolist())
    assert [len(cases - known) for known in learned] == [1, 1, 1, 1]
    assert set.union(*(cases - known for known in learned)) == cases
    assert sorted(row for rows in asked for row in rows) == np.flatnonzero(data.contact).tolist()
    slopes, _, _ = left_out(monkeypatch, data, of_process=True)
    assert_allclose(slopes.force_n, 0.5, rtol=1e-6)


def test_of_few_places_a_process_may_err_as_far_as_the_grid(monkeypatch, data):
    """70 % of 4 places need 0.7 × 5 = 3.5 of them: enough. 90 % would need 4.5."""
    slopes, _, _ = left_out(monkeypatch, data, of_process=True)
    assert_allclose(slopes.place_mm, 1.0, rtol=1e-6)
    monkeypatch.setattr(coverage, "radius_of_grid", lambda data, said, cover: 77.0 + cover)
    many = coverage.slopes_at_places_left_out.__wrapped__(
        data, CHANNELS, np.ones(2), 2.0, 0.9, 0, True
    )
    assert many.place_mm == pytest.approx(77.9)
    assert many.force_n == pytest.approx(2.131847 * 0.5)  # Student's t, 95 %, 4 degrees
    exact = coverage.slopes_at_places_left_out.__wrapped__(
        data, CHANNELS, np.ones(2), 2.0, 0.8, 0, True
    )
    assert exact.place_mm == pytest.approx(1.0)
    assert exact.force_n == pytest.approx(0.5)
    one = data.select(
        ~data.contact | (data.frames.place_id == data.frames.place_id[data.contact][0])
    )
    alone = coverage.slopes_at_places_left_out.__wrapped__(
        one, CHANNELS, np.ones(2), 2.0, 0.6, 0, True
    )
    assert alone.place_mm == pytest.approx(77.6)
    assert alone.force_n == pytest.approx(float(one.heatmap_n.sum(axis=(1, 2)).max()))


def test_of_few_places_a_force_errs_by_no_more_than_the_largest(monkeypatch, data):
    """Unless errors were seen that are larger."""
    largest_n = float(data.heatmap_n.sum(axis=(1, 2)).max())
    for off_n, slope_n in ((0.9, largest_n), (0.3, 2.131847 * 0.3 * largest_n), (1.2, None)):
        left_out(monkeypatch, data, of_process=True, force_off=off_n * largest_n)
        found = coverage.slopes_at_places_left_out.__wrapped__(
            data, CHANNELS, np.ones(2), 2.0, 0.9, 0, True
        )
        assert found.force_n == pytest.approx(slope_n or off_n * largest_n, rel=1e-5)


def test_one_member_is_stopped_by_the_validation_part_several_by_a_fold_each(data):
    rows = np.arange(len(data))
    parts = [data.select(data.frames.press_id < 5), data.select(data.frames.press_id >= 5)]
    one = FitSettings(FACE, TrainingSpec(ensemble=1))
    ((fitted, stopped),) = training.folds_of.__wrapped__(parts, one)
    assert (fitted, stopped) == (parts[0], parts[1])
    folds = training.folds_of.__wrapped__(parts, FitSettings(FACE, TrainingSpec(ensemble=3)))
    assert len(folds) == 3
    held = [set(part.frames.press_id.tolist()) for _, part in folds]
    assert set.union(*held) == set(data.frames.press_id.tolist())
    assert sum(map(len, held)) == len(set.union(*held))
    for fitted, stopped in folds:
        assert len(fitted) + len(stopped) == len(rows)
        assert not set(fitted.frames.press_id.tolist()) & set(stopped.frames.press_id.tolist())


def test_channels_are_those_that_are_alive_in_both_parts(data):
    def without(*channels):
        signal = data.frames.signal_counts.copy()
        for sensor, axis in channels:
            signal[:, FACE - 1, sensor, axis] = np.nan
        frames = SimpleNamespace(**{**data.frames.__dict__, "signal_counts": signal})
        made = object.__new__(type(data.frames))
        made.__dict__.update(frames.__dict__)
        return face_data(made, FACE)

    parts = [without((0, 1)), without((2, 2), (1, 0))]
    found = training.common_channels(parts, TrainingSpec())
    every = [(FACE, sensor, axis) for sensor in range(3) for axis in range(3)]
    gone = {(FACE, 0, 1), (FACE, 2, 2), (FACE, 1, 0)}
    assert list(found) == [channel for channel in every if channel not in gone]
    silent = without(*((sensor, axis) for _, sensor, axis in every if (sensor, axis) != (0, 1)))
    with pytest.raises(InputError, match=f"no channel of face {FACE}"):
        training.common_channels([parts[0], silent], TrainingSpec())
