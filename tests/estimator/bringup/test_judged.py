"""What recordings of a bring-up are judged by, with the judges made up: which recordings go where."""

from types import SimpleNamespace

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from design.layout.places.positions import magnet_layout
from design.spec.object import ObjectSpec
from estimator.bringup import verdict
from estimator.bringup.asking.asked import (
    STILL,
    STILL_AGAIN,
    Recording,
    asked_of,
    further_holds,
    magnet_names,
)
from estimator.bringup.diagnosis import levels
from estimator.bringup.diagnosis.channels import signed_permutations
from estimator.bringup.diagnosis.findings import ChipFound, Finding
from estimator.bringup.diagnosis.poles import MagnetFound
from estimator.tolerances.selftest import POOR_FIT, Fault, Hypothesis

SPEC = ObjectSpec(name="cube")
CHIPS = 15
AS_DRAWN = verdict.as_drawn(SPEC)
HELD = [asked for asked in asked_of(SPEC) if asked.step == "held"]


def recording(name, level, at_ms=0, frames=4):
    counts = np.resize([1.0, -1.0], frames)[:, None, None] + np.zeros((frames, CHIPS, 3)) + level
    return Recording(name, counts, np.arange(frames), at_ms + np.arange(frames))


@pytest.mark.parametrize("turn", signed_permutations()[::7])
def test_levels_are_turned_back_to_the_axes_drawn_at_the_chip_s_place(turn):
    chips = [ChipFound(1, turn), ChipFound(0, np.eye(3))]
    field = np.array([[1.0, 2, 3], [4, 5, 6]])
    counts = np.stack([turn @ field[1], field[0]])
    assert_allclose(levels.in_designed_axes(chips, counts), field)
    lame = counts.copy()
    lame[0, 1] = np.nan
    found = levels.in_designed_axes(chips, lame)
    (lost,) = np.flatnonzero(abs(turn[1]) > 0.5)
    assert np.flatnonzero(np.isnan(found[1])).tolist() == [lost]
    assert_allclose(np.delete(found[1], lost), np.delete(field[1], lost))
    assert_allclose(found[0], field[0])


def test_flips_that_are_known_are_built_into_the_model_magnet_by_magnet():
    count = SPEC.magnets.count
    found = levels._with_flips(SPEC, [count, 1, 2 * count + 1]).as_built.magnets
    sensed = SPEC.body.sensed
    assert [(one.face, one.magnet, one.flipped) for one in found] == [
        (sensed[0], 2, True), (sensed[1], 1, True), (sensed[2], 2, True),
    ]  # fmt: skip


def test_faults_that_others_have_judged_are_not_looked_for_again(monkeypatch):
    made = [Fault("dead sensor", "a"), Fault("flipped magnet", "b"), Fault("swapped channels", "c")]
    asked = {}

    def rank(model, counts, looked_for):
        asked.update(model=model, counts=counts, looked_for=looked_for)
        return ["first", "second"]

    def rest_model(spec, noise):
        assert noise == SPEC.sensors.drift_counts
        return SimpleNamespace(faults=made, flips=len(spec.as_built.magnets))

    monkeypatch.setattr(levels, "rank", rank)
    monkeypatch.setattr(levels, "rest_model", rest_model)
    counts = np.arange(45.0).reshape(15, 3)
    given = levels.judge_levels.__wrapped__(SPEC, [3, 4], counts, ["dead sensor"])
    assert given == "first"
    assert asked["model"].flips == 2
    assert_array_equal(asked["counts"], np.arange(45.0))
    assert asked["looked_for"] == [(), (made[1],), (made[2],)]


def test_levels_beyond_all_tolerances_are_told_as_such_below_a_thousandth():
    fault = Fault("flipped magnet", "F3-M1")
    assert levels.level_findings(Hypothesis((), 0.0, 0.5)) == []
    (told,) = levels.level_findings(Hypothesis((fault,), 12.34, POOR_FIT))
    assert (told.kind, told.where) == ("resting levels", "flipped magnet: F3-M1")
    assert told.measured == "ln of the odds 12.3, as far off with probability 0.001"
    (far,) = levels.level_findings(Hypothesis((fault,), 12.34, 0.99 * POOR_FIT))
    assert far.where == "object"
    assert far.measured.startswith("beyond all tolerances (ln of the odds 12.3")


def test_a_magnet_s_step_is_seen_against_the_one_before(monkeypatch):
    """Magnet k is the change from the recording of magnet k − 1; the first from the closed object."""
    steps = [asked for asked in asked_of(SPEC) if asked.step == "magnet"]
    names = magnet_names(SPEC)
    assert verdict.magnet_before(SPEC, steps[0]) == "closed"
    assert verdict.magnet_before(SPEC, steps[2]) == f"magnet {names[1]}"
    seen = []
    monkeypatch.setattr(verdict, "pocket_fields", lambda spec, chips: "fields")
    monkeypatch.setattr(
        verdict, "find_magnet",
        lambda spec, fields, part, change: seen.append((part, change))
        or MagnetFound(part, part, 1.0),
    )  # fmt: skip
    dead = (*AS_DRAWN[:1], ChipFound(1, np.eye(3), dead=(False, True, False)), *AS_DRAWN[2:])
    recordings = {"closed": recording("closed", 10.0)}
    for level, k in ((17.0, 0), (30.0, 1), (99.0, 4)):
        recordings[steps[k].name] = recording(steps[k].name, level)
    found = list(verdict.magnets_found(SPEC, recordings, dead))
    assert [one.asked for one in found] == [0, 1]
    for (_, change), step in zip(seen, (7.0, 13.0), strict=True):
        assert np.isnan(change[1, 1])
        assert np.isfinite(change).sum() == 44
        assert_allclose(change[np.isfinite(change)], step)


def judged(monkeypatch, magnets, chips_seen, rest=True):
    asked = []

    def judge_levels(spec, flipped, counts, seen):
        asked.append((list(flipped), counts, list(seen)))
        return Hypothesis((), 0.0, 1.0)

    monkeypatch.setattr(verdict, "judge_levels", judge_levels)
    recordings = {"rest": recording("rest", 5.0)} if rest else {}
    found = verdict._levels(SPEC, recordings, AS_DRAWN, chips_seen, tuple(magnets))
    return found, asked


def test_resting_levels_are_judged_for_what_no_other_recording_tells(monkeypatch):
    count = len(magnet_layout(SPEC).face)
    every = [MagnetFound(k, k, -1.0 if k in (2, 5) else 1.0) for k in range(count)]
    with_chips = ["swapped sensors", "swapped channels", "dead sensor", "dead channel"]
    _, ((flipped, counts, seen),) = judged(monkeypatch, every, True)
    assert flipped == [2, 5]
    assert seen == [*with_chips, "flipped magnet"]
    assert_allclose(counts, 5)
    _, ((flipped, _, seen),) = judged(monkeypatch, every[:-1], True)
    assert (flipped, seen) == ([2, 5], with_chips)
    _, ((flipped, _, seen),) = judged(monkeypatch, every, False)
    assert seen == ["flipped magnet"]
    zero = [MagnetFound(0, 0, 0.0)]
    _, ((flipped, _, seen),) = judged(monkeypatch, zero, False)
    assert (flipped, seen) == ([], [])
    found, asked = judged(monkeypatch, every, True, rest=False)
    assert found is None
    assert not asked


def test_three_holds_and_a_still_recording_tell_which_chip_is_which(monkeypatch):
    """Channels that are silent at rest say nothing; errors count as followed drift where asked."""
    asked = []
    monkeypatch.setattr(
        verdict, "held_readings",
        lambda spec, counts, share, drift: asked.append((counts, share, drift)) or "readings",
    )  # fmt: skip
    monkeypatch.setattr(verdict, "find_chips", lambda spec, readings, parts: parts)
    recordings = {asked.name: recording(asked.name, 50.0) for asked in HELD[:2]}
    made = verdict.held_so_far.__wrapped__
    assert made(SPEC, recordings) is None
    extra = further_holds(SPEC)[1]
    recordings[extra.name] = recording(extra.name, 60.0)
    assert made(SPEC, recordings) is None
    recordings[STILL] = recording(STILL, 20.0)
    recordings[STILL].counts[:, 3, 1] = 7.0
    recordings[STILL].counts[:, 4, 2] = np.nan
    found = made(SPEC, recordings)
    assert found == ("readings", [HELD[0].part, HELD[1].part, extra.part])
    counts, share, drift = asked[0]
    assert np.isnan(counts[:, 3, 1]).all()
    assert np.isnan(counts[:, 4, 2]).all()
    assert np.isfinite(counts).sum() == 3 * 43
    assert_allclose(counts[:, 0, 0], [30, 30, 40])
    assert_allclose(share, [0.5] * 3)
    assert drift == SPEC.sensors.zeroing_counts
    made(SPEC, recordings, True)
    assert asked[1][2] == pytest.approx(0.3 * SPEC.sensors.zeroing_counts)


def test_earths_field_needs_all_poses_and_leaves_dead_axes_out(monkeypatch):
    poses = [asked for asked in asked_of(SPEC) if asked.step == "earth"]
    asked = []
    monkeypatch.setattr(verdict, "from_earth", lambda *given: asked.append(given) or "found")
    chips = (ChipFound(0, np.eye(3), dead=(True, False, False)), *AS_DRAWN[1:])
    recordings = {one.name: recording(one.name, 3.0 * k, 2000 * k) for k, one in enumerate(poses)}
    made = verdict._earth.__wrapped__
    assert made(SPEC, recordings, chips) == "found"
    ((_, _, means, times_s, frames),) = asked
    assert np.isnan(means[:, 0, 0]).all()
    assert_allclose(means[:, 1, 2], 3.0 * np.arange(len(poses)))
    assert_allclose(times_s, 2.0 * np.arange(len(poses)) + 0.0015)
    assert frames == poses[0].frames
    del recordings[poses[-1].name]
    assert made(SPEC, recordings, chips) is None


def test_a_place_is_named_once_and_every_judge_has_its_say(monkeypatch):
    """A chip that health already names is not named again; what is not recorded is not judged."""
    chips = AS_DRAWN
    monkeypatch.setattr(
        verdict, "health_findings", lambda spec, still: [Finding("silent chip", "F1-S1", "nothing")]
    )
    monkeypatch.setattr(verdict, "which_is_which", lambda spec, given: chips)
    monkeypatch.setattr(verdict, "_earth", lambda spec, given, known: None)
    monkeypatch.setattr(
        verdict, "chip_findings",
        lambda spec, found, earth: [
            Finding("turned chip", "F1-S1", "90°"), Finding("gain", "F1-S2", "1.2"),
        ],
    )  # fmt: skip
    magnet = MagnetFound(0, 0, -1.0)
    monkeypatch.setattr(verdict, "magnets_found", lambda spec, given, known: iter([magnet]))
    monkeypatch.setattr(
        verdict, "magnet_findings", lambda spec, one: [Finding("flipped magnet", "F1-M1", "-1")]
    )
    monkeypatch.setattr(verdict, "_levels", lambda *given: None)
    found = verdict.judge(SPEC, {STILL: recording(STILL, 0.0)})
    assert [(one.kind, one.where) for one in found.findings] == [
        ("silent chip", "F1-S1"), ("gain", "F1-S2"), ("flipped magnet", "F1-M1"),
    ]  # fmt: skip
    assert found.magnets == (magnet,)
    monkeypatch.setattr(verdict, "which_is_which", lambda spec, given: None)
    best = Hypothesis((), 0.0, POOR_FIT / 2)
    monkeypatch.setattr(verdict, "_levels", lambda *given: best)
    bare = verdict.judge(SPEC, {STILL_AGAIN: recording(STILL_AGAIN, 0.0)})
    assert [one.kind for one in bare.findings] == ["flipped magnet", "resting levels"]
    assert (bare.chips, bare.earth, bare.levels) == (None, None, best)
