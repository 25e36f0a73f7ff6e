"""The verdict: figures against their limits, and what limits the object."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from design.spec_io import load_spec
from estimator.information.scores import score_places
from estimator.signals.presses import press_signals
from estimator.tolerances.saturation import Saturation
from instobj.report import verdict
from tests.support.mechanics.synthetic_presses import coarse_spec, synthetic_presses

EXAMPLES = Path(__file__).parents[3] / "examples"


@pytest.mark.parametrize(
    ("value", "text"),
    [(1.5, "1.50"), (1.504, "1.504"), (1.50001, "1.50001"), (1.496, "1.50"), (1.6, "1.60")],
)
def test_a_figure_that_fails_is_not_shown_as_its_limit(value, text):
    assert verdict.shown_against_limit(value, 1.5) == text


@pytest.mark.parametrize(
    ("out", "margin", "go"), [(0.045, 0.01, True), (0.06, -0.02, False), (0.3, -0.5, False)]
)
def test_chips_of_virtual_objects_decide_beside_the_design(out, margin, go):
    """At most 5 % of the objects may have a chip out of range in the deepest press."""
    limits = {"position_bound_mm": 100.0, "detectable_force_n": 100.0}
    spec = coarse_spec(contact_grid={"count": (4, 4), "pitch_mm": 6.0}, limits=limits)
    scores = score_places(spec, press_signals(spec, *synthetic_presses(spec)))
    objects = Saturation(200, (0.0, 1.5, 2.0, 4.0), (0.0, 0.0, 0.01, out), (0.5, 0.4, 0.3, margin))
    found = verdict.judge(spec, scores, 0.4, objects)
    (strong,) = (check for check in found.checks if check.what.startswith("How strong"))
    assert found.go == strong.passed == go
    assert strong.value == f"40 %; {100 * (1 - out):.1f} %"
    told = f"out of range: 0.0 % at rest, 1.0 % at 2 mm, {100 * out:.1f} % at 4 mm"
    assert told in strong.where
    crowded = verdict.judge(spec, scores, 0.05, objects)
    assert not crowded.go, "the design's own margin still counts"
    assert np.isclose(crowded.checks[2].ratio, max(0.95 / 0.9, 1 - margin))


def test_the_verdict_on_the_place_says_where_readers_do_worse_than_the_bound():
    spec = coarse_spec(contact_grid={"count": (8, 8), "pitch_mm": 3.0}, score={"force_n": 4.0})
    scores = score_places(spec, press_signals(spec, *synthetic_presses(spec)))
    objects = Saturation(200, (0.0, 4.0), (0.0, 0.0), (0.5, 0.3))
    place, *others = verdict.judge(spec, scores, 0.4, objects).checks
    assert scores.exceeds_bound
    assert f". {scores.exceeds_bound}" in place.where
    assert not any("maximum likelihood" in check.where for check in others)


@pytest.mark.parametrize(("share", "said"), [(0.3, True), (0.02, False)])
def test_the_head_gives_readings_that_are_worse_than_the_bound_at_many_locations(share, said):
    """Bounds of 0.8 mm stood there alone, where readings erred by 6 mm."""
    spec = coarse_spec(contact_grid={"count": (8, 8), "pitch_mm": 3.0}, score={"force_n": 4.0})
    scores = score_places(spec, press_signals(spec, *synthetic_presses(spec)))
    error_mm = scores.position_bound_mm.copy()
    count = round(share * scores.judged.sum())
    face, place = np.argwhere(scores.judged)[:count].T
    error_mm[face, place] = 6.0 + error_mm.max()
    scores = replace(scores, position_error_mm=error_mm)
    text, row = verdict.located_text(spec, scores), verdict.score_rows(scores)[2]
    reading = f"{row['95 % below']:.2g} mm at 95 % of all"
    sentence = f"{count} of {scores.judged.sum()} are read worse than the bound: {reading}"
    assert (sentence in text) == said == ("read worse" in text)


def test_locations_that_are_not_judged_cover_nothing():
    """All flat cells are alike: as many of the surface's cells as locations reach the force."""
    spec = coarse_spec(contact_grid={"count": (4, 4), "pitch_mm": 6.0}, score={"force_n": 4.0})
    signals = press_signals(spec, *synthetic_presses(spec))
    objects = Saturation(200, (0.0, 4.0), (0.0, 0.0), (0.5, 0.3))

    def judged(force_n):
        scores = score_places(spec.changed(score={"force_n": force_n}), signals)
        return scores, verdict.judge(spec, scores, 0.4, objects).covered

    low, whole = judged(4.0)
    assert low.judged.sum() == low.places.sum()
    reach_n = signals.force_n[..., -1][signals.pressed]
    hard, covered = judged(float(np.median(reach_n)))
    assert 0 < hard.judged.sum() < hard.places.sum()
    np.testing.assert_allclose(covered / whole, hard.judged.sum() / hard.places.sum())


@pytest.mark.parametrize(("share", "go"), [(0.9, True), (0.6, True), (0.4, False), (0.1, False)])
def test_an_object_that_few_locations_judge_is_no_go(share, go):
    """Whatever the bounds of those that reach the force: most of its surface gives way too far."""
    limits = {"position_bound_mm": 100.0, "detectable_force_n": 100.0}
    spec = coarse_spec(contact_grid={"count": (8, 8), "pitch_mm": 3.0}, limits=limits)
    signals = press_signals(spec, *synthetic_presses(spec))
    reach_n = signals.force_n[..., -1][signals.pressed]
    spec = spec.changed(score={"force_n": float(np.quantile(reach_n, 1 - share))})
    scores = score_places(spec, signals)
    judged = verdict.judge(spec, scores, 0.4)
    assert judged.go == go
    failed = [check.what.split(":")[0] for check in judged.failed]
    assert failed == ([] if go else ["Judged"])
    assert "of the judged locations keep" in verdict.located_text(spec, scores)


def test_the_sentence_s_numbers_are_those_of_the_table():
    spec = coarse_spec(contact_grid={"count": (4, 4), "pitch_mm": 6.0})
    scores = score_places(spec, press_signals(spec, *synthetic_presses(spec)))
    bounds = scores.position_bound_mm[scores.judged]
    limit = round(float(np.quantile(bounds, 0.4)), 3)
    spec = spec.changed(limits={"position_bound_mm": limit})
    row = verdict.score_rows(scores)[0]
    told = verdict.located_text(spec, scores)
    for name in ("median", "95 % below", "worst"):
        assert verdict.shown_against_limit(row[name], limit) in told
    assert f"of face {row['on face']}, at ({row['at x, y mm']}) mm" in told
    within = float(np.mean(bounds <= limit))
    assert 0 < within < 1
    assert f"{100 * within:.0f} % of the locations keep the limit of {limit:g} mm" in told


@pytest.mark.parametrize(
    ("xy_mm", "text"),
    [
        ((0.0, 0.0), "in the middle of face 2"),
        ((18.0, 0.0), "near the middle of the edge +x of face 2"),
        ((-18.0, 10.0), "near the edge −x of face 2"),
        ((18.0, -18.0), "near the corner +x −y of face 2"),
        ((10.0, 0.0), "between middle and edge of face 2"),
    ],
)
def test_a_place_is_said_in_words(xy_mm, text):
    told = verdict.place_text(coarse_spec(), 2, xy_mm)
    assert told == f"{text}, at ({xy_mm[0]:g}, {xy_mm[1]:g}) mm"


@pytest.mark.parametrize(
    ("example", "face", "xy_mm", "text"),
    [
        (
            "capsule",
            1,
            (0.0, 0.0),
            "in the middle of face 1, at (0, 0) mm, towards the body's +z end",
        ),
        ("capsule", 5, (30.0, 0.0), ", towards the body's −x side and −z end"),
        ("egg", 1, (18.0, 0.0), ", towards the body's +z side and +x end"),
        ("ball", 2, (15.0, 0.0), ", towards the body's −y side and −z side"),
    ],
)
def test_a_place_on_a_curved_face_is_said_by_the_body_s_ends_and_sides(example, face, xy_mm, text):
    spec = load_spec(EXAMPLES / f"{example}.toml")
    assert verdict.place_text(spec, face, xy_mm).endswith(text)


def test_a_design_is_judged_before_its_virtual_objects():
    limits = {"position_bound_mm": 100.0, "detectable_force_n": 100.0}
    spec = coarse_spec(contact_grid={"count": (4, 4), "pitch_mm": 6.0}, limits=limits)
    scores = score_places(spec, press_signals(spec, *synthetic_presses(spec)))
    assert verdict.judge(spec, scores, 0.4).go
    assert not verdict.judge(spec, scores, 0.05).go, "too little range stays free"
    tight = spec.changed(limits=spec.limits.changed(position_bound_mm=0.1))
    assert not verdict.judge(tight, scores, 0.4).go
