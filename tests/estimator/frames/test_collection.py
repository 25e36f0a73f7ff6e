"""Simulated recordings: what the paper's collection holds, joint contact, labels, relaxation."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import InputError
from design.layout.body import face_frames
from design.layout.places.contact_grid import contact_grid
from design.spec.learning import CollectionSpec
from estimator.frames import collection, contact_cases
from estimator.frames import contact_traces as traces_of_cases
from estimator.frames.collection import joined, simulate_collection
from estimator.frames.contact_cases import (
    DUAL_CASES,
    TRIPLE_CASES,
    grasp_cases,
    paper_cases,
    random_case,
)
from estimator.frames.contact_traces import JointMechanics, contact_traces
from estimator.frames.dataset import NO_FACE, load_frames, save_frames
from estimator.information.shear import ShearSignals
from estimator.signals.interpolation import counts_at_force, press_traces
from estimator.signals.presses import press_signals
from estimator.tolerances.assembly import designed
from fem.presses.joint import Tip, press_tips
from fem.presses.viscoelastic import relaxed_force_n
from tests.support.mechanics.half_space_response import half_space_response
from tests.support.mechanics.synthetic_presses import coarse_spec, synthetic_presses

SMALL = {
    "faces": (2, 5),
    "frames_per_case": 90,
    "non_contact_cases": 2,
    "poses": (((0.5, -2.0, 0.0), (3.0, 1.0, 90.0)), ((-1.0, -2.0, 180.0),)),
    "grasp_force_n": 6.0,
}
QUIET = {"noise_counts": (1e-6, 1e-6, 1e-6), "zeroing_counts": 0, "drift_counts": 0}
PROTOCOL = {"frames_per_press": (5, 30), "peak_force_n": (4.0, 6.0)}


def spec_of(sensors=None, protocol=None, **changes):
    return coarse_spec(
        seed=3,
        collection={**SMALL, **changes},
        protocol={**PROTOCOL, **(protocol or {})},
        sensors=sensors or {},
        silicone={"youngs_modulus_mpa": 0.4, "poisson_ratio": 0.4999},
    )


@pytest.fixture(scope="module", autouse=True)
def _pressed_once():
    """Tips of the same probes go equally deep in most tests: each press is solved once."""
    known, press = {}, traces_of_cases.press_path

    def remembered(spec, response, tips, depths_mm, faces):
        key = (spec.indenter, spec.mechanics, id(response), repr(tips), depths_mm.tobytes())
        if key not in known:
            known[key] = press(spec, response, tips, depths_mm, faces)
        return known[key]

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(traces_of_cases, "press_path", remembered)
        yield


@pytest.fixture(scope="module")
def signals():
    spec = spec_of()
    return press_signals(spec, *synthetic_presses(spec))


@pytest.fixture(scope="module")
def mechanics():
    return JointMechanics(half_space_response(spec_of(), 15))


@pytest.fixture(scope="module")
def paper(signals, mechanics):
    return simulate_collection(spec_of(), signals, "hash", mechanics)


def test_every_case_has_its_frames_and_its_labels(paper):
    assert len(paper) == 2 * (20 + 2 + 1 + 2) * 90
    names, counts = np.unique(paper.place_id, return_counts=True)
    expected = [1000 * face + place for face in (2, 5) for place in range(20)]
    expected += [DUAL_CASES + 1000 * face + k for face in (2, 5) for k in (0, 1)]
    expected += [TRIPLE_CASES + 1000 * face for face in (2, 5)]
    assert names.tolist() == [-1, *sorted(expected)]
    assert counts.tolist() == [2 * 2 * 90, *[90] * 46]
    assert paper.contact_face.shape == (len(paper), 3)
    tips = (paper.contact_face > 0).sum(axis=1)
    np.testing.assert_array_equal(tips[paper.place_id >= TRIPLE_CASES], 3)
    np.testing.assert_array_equal(tips[paper.place_id == -1], 0)
    assert np.isnan(paper.force_n[paper.contact_face == 0]).all()
    assert len(np.unique(paper.session_id)) == 50
    assert_allclose(np.diff(paper.time_s), 1 / 10.5)
    periods = [len(np.unique(paper.press_id[paper.session_id == s])) for s in range(50)]
    assert set(periods) <= {3, 4, 5}


def test_tips_of_a_probe_share_the_load_cells_force_but_do_not_bear_it_alike(paper):
    three = paper.select((paper.place_id >= TRIPLE_CASES) & paper.valid)
    label, true = three.force_n[..., 2], three.true_force_n[..., 2]
    assert_allclose(label, label[:, :1].repeat(3, axis=1))
    assert_allclose(label.sum(axis=1) - true.sum(axis=1), 0, atol=6 * 0.12)
    assert np.std(label.sum(axis=1) - true.sum(axis=1)) == pytest.approx(0.12, rel=0.2)
    one = paper.select((paper.place_id >= 0) & (paper.place_id < DUAL_CASES) & paper.valid)
    assert np.std((one.force_n - one.true_force_n)[:, 0, 2]) == pytest.approx(0.12, rel=0.1)


def test_single_cases_press_all_places_to_one_travel(paper, signals):
    spec = spec_of()
    cases = paper_cases(spec, 2)[:20]
    reached = contact_traces(spec, signals, cases)
    peaks = [np.nanmax(paper.true_force_n[paper.place_id == c.place_id]) for c in cases]
    travel = [
        np.interp(p, f, t)
        for p, f, t in zip(peaks, reached.force_n, reached.travel_mm, strict=True)
    ]
    assert np.ptp(travel) < 0.03 * np.mean(travel)
    assert np.ptp(peaks) > 0.1 * np.mean(peaks)


def test_without_disturbances_frames_are_the_table(signals, mechanics):
    spec = spec_of(sensors=QUIET, protocol={"force_noise_n": 0.0})
    frames = simulate_collection(spec, signals, "hash", mechanics)
    chosen = frames.select((frames.place_id == 2013) & frames.valid)
    case = paper_cases(spec, 2)[13]
    traces = press_traces(signals, np.array([2]), *case.xy_mm.T)
    expected = counts_at_force(traces, chosen.force_n[None, :, 0, 2]).counts[0]
    off = np.abs(chosen.signal_counts.reshape(len(chosen), -1) - expected).max()
    assert off <= 0.51


@pytest.mark.parametrize("solved", ["jointly", "each alone"])
def test_neighbouring_tips_feel_each_other(signals, mechanics, solved):
    """A half-space: F at 15 mm sinks the surface by F/(π E* r), and Hertz's force goes as 3/2."""
    spec = spec_of()
    dual = paper_cases(spec, 2)[20]
    traces, step = contact_traces(spec, signals, [dual], mechanics), 2
    depth = float(signals.depth_mm[step])
    alone = [
        press_tips(spec, mechanics.response, [Tip(2, float(x), float(y))], np.array([depth]))
        for x, y in dual.xy_mm
    ]
    forces = traces.tip_force_n[0, step + 1]
    if solved == "each alone":
        forces = np.array([press.force_n[0] for press in alone])
    sunk = forces[::-1] / (np.pi * 0.4 / (1 - 0.4999**2) * 15.0)
    lost = 1 - forces / [press.force_n[0] for press in alone]
    expected = 1 - (1 - sunk / depth) ** 1.5
    assert expected.min() > 0.05
    assert np.allclose(lost, expected, rtol=0.15) == (solved == "jointly")


def test_jaws_press_opposite_places_with_equal_forces(signals, mechanics, monkeypatch):
    spec = spec_of(kind="grasp", grasp_faces=(3, 5))
    cases = grasp_cases(spec)
    assert [len(case.face) for case in cases] == [2] * 5 + [4] * 3 + [6] * 2
    frames = {frame.number: frame for frame in face_frames(spec)}
    for case in cases:
        tips = len(case.face) // 2
        xyz = np.column_stack([case.xy_mm, np.zeros(2 * tips)])
        here, there = frames[3].to_object(xyz[:tips]), frames[5].to_object(xyz[tips:])
        assert_allclose((here - there) @ frames[3].axes[:, :2], 0, atol=1e-12)
    one_of_each = tuple(poses[-1:] for poses in contact_cases.GRASP_POSES)
    monkeypatch.setattr(contact_cases, "GRASP_POSES", one_of_each)
    small = simulate_collection(spec, signals, "hash", mechanics)
    jaws = np.stack(
        [
            np.nansum(np.where(small.contact_face == f, small.true_force_n[..., 2], 0), 1)
            for f in (3, 5)
        ]
    )
    assert_allclose(jaws[0], jaws[1], atol=1e-4)
    assert jaws.max() == pytest.approx(6.0, rel=0.02)
    label = np.where(small.contact_face == 3, small.force_n[..., 2], 0).sum(1) - jaws[0]
    other = np.where(small.contact_face == 5, small.force_n[..., 2], 0).sum(1) - jaws[1]
    pressed = (small.contact_face > 0).any(axis=1)
    assert abs(np.corrcoef(label[pressed], other[pressed])[0, 1]) < 0.15


def test_presses_anywhere_fill_the_faces(signals):
    spec = spec_of(kind="continuous", presses=300)
    frames = simulate_collection(spec, signals, "hash")
    assert len(frames) == 300 * 35
    pressed = frames.select(frames.contact_face[:, 0] > 0)
    xy = pressed.contact_xy_mm[:, 0]
    assert_allclose(xy.min(axis=0), [-4.5, -6.0], atol=0.3)
    assert_allclose(xy.max(axis=0), [4.5, 6.0], atol=0.3)
    assert set(np.unique(pressed.contact_face)) == {2, 5}
    assert len(np.unique(xy, axis=0)) == 300
    rest = frames.select(frames.contact_face[:, 0] == 0)
    assert len(rest) == 300 * 5
    assert rest.valid.all()
    assert (rest.place_id == -1).all()
    peak = np.array([pressed.true_force_n[pressed.press_id == p].max() for p in range(300)])
    assert 3.8 < peak.min() < 4.4
    assert 5.6 < peak.max() < 6.01


def test_several_contacts_anywhere(signals, mechanics):
    spec = spec_of(kind="continuous", presses=6, contacts=3)
    frames = simulate_collection(spec, signals, "hash", mechanics)
    pressed = frames.select(frames.contact_face[:, 0] > 0)
    true, label = pressed.true_force_n[..., 2], pressed.force_n[..., 2]
    assert (label - true).std() == pytest.approx(0.12, rel=0.15)
    deep = true.sum(axis=1) > 8
    assert np.std(true[deep] / true[deep].sum(axis=1, keepdims=True), axis=1).min() > 0.02
    for press in range(6):
        one = pressed.select(pressed.press_id == press)
        assert len(np.unique(one.contact_xy_mm, axis=0)) == 1


def test_relaxation_lowers_the_felt_force_but_not_the_signals(signals, mechanics):
    prony = ((0.3, 1.5),)
    plain = spec_of(sensors=QUIET, protocol={"force_noise_n": 0.0})
    soft = plain.model_copy(
        update={
            "silicone": plain.silicone.model_validate(
                {"youngs_modulus_mpa": 0.4, "poisson_ratio": 0.4999, "prony": prony}
            )
        }
    )
    a, b = (simulate_collection(s, signals, "hash", mechanics) for s in (plain, soft))
    np.testing.assert_array_equal(a.signal_counts, b.signal_counts)
    chosen = a.place_id == DUAL_CASES + 2000
    elastic, felt = (f.true_force_n[chosen][..., :2, 2] for f in (a, b))
    total = relaxed_force_n(elastic.sum(axis=1), np.arange(90) / 10.5, soft.silicone.prony)
    assert_allclose(felt.sum(axis=1), total, rtol=1e-8, atol=1e-8)
    top = int(np.argmax(felt.sum(axis=1)))
    assert_allclose(felt[top] / felt[top].sum(), elastic[top] / elastic[top].sum())


def test_the_seed_fixes_everything_and_the_file_keeps_it(paper, signals, mechanics, tmp_path):
    again = simulate_collection(spec_of(), signals, "hash", mechanics)
    np.testing.assert_array_equal(again.signal_counts, paper.signal_counts)
    np.testing.assert_array_equal(again.force_n, paper.force_n)
    save_frames(paper, tmp_path / "frames.nc")
    read = load_frames(tmp_path / "frames.nc")
    np.testing.assert_array_equal(read.true_force_n, paper.true_force_n)
    np.testing.assert_array_equal(
        read.select(read.valid).true_force_n, paper.true_force_n[paper.valid]
    )
    other = simulate_collection(
        spec_of().model_copy(update={"seed": 4}), signals, "hash", mechanics
    )
    assert not np.array_equal(other.signal_counts, paper.signal_counts)


def test_blocks_of_cases_do_not_change_forces(paper, signals, mechanics, monkeypatch):
    monkeypatch.setattr(collection, "BLOCK_FRAMES", 200)
    again = simulate_collection(spec_of(), signals, "hash", mechanics)
    np.testing.assert_array_equal(again.true_force_n, paper.true_force_n)


@pytest.fixture(scope="module")
def shear():
    """Counts per newton that grow with depth and turn with the place, the same on every face."""
    spec = spec_of()
    grid, depth = contact_grid(spec), np.asarray(spec.press.depths_mm)
    slope = np.random.default_rng(1).normal(0, 40, (2, 15, 3))
    turned = 1 + 0.05 * grid.xy_mm[:, 0]
    per_n = turned[:, None, None, None, None] * (1 + depth[:, None, None, None] / 4) * slope
    return ShearSignals(np.arange(1, 6), grid, depth, np.tile(per_n, (5, 1, 1, 1, 1, 1)))


def test_a_pull_adds_its_signals_and_its_label(signals, shear):
    quiet = {"sensors": QUIET, "protocol": {"force_noise_n": 0.0}}
    asked = {"kind": "continuous", "presses": 12}
    pulled = spec_of(**quiet, **asked, tangential_share=0.5)
    one, other = (
        simulate_collection(spec, signals, "hash", shear=shear)
        for spec in (pulled, spec_of(**quiet, **asked))
    )
    moving = one.contact_face[:, 0] > 0
    force, xy = one.force_n[moving, 0], one.contact_xy_mm[moving, 0]
    share = np.linalg.norm(force[:, :2], axis=1) / np.maximum(force[:, 2], 1e-9)
    assert share.max() <= 0.5 + 1e-9
    assert len(np.unique(share[force[:, 2] > 0.5].round(6))) == 12
    assert np.nanmax(abs(other.force_n[..., :2])) == 0
    np.testing.assert_array_equal(one.force_n[..., 2], other.force_n[..., 2])
    travel = np.interp(force[:, 2], *_force_of_depth(signals))
    slope = np.random.default_rng(1).normal(0, 40, (2, 15, 3))
    pulled_mt = force[:, :2] @ slope.reshape(2, -1)
    expected = (1 + 0.05 * xy[:, :1]) * (1 + travel[:, None] / 4) * pulled_mt
    change = (one.signal_counts - other.signal_counts)[moving].reshape(len(force), -1)
    strong = force[:, 2] > 1
    off = np.sqrt(np.mean((change - expected)[strong] ** 2) / np.mean(expected[strong] ** 2))
    assert off < 0.05


def _force_of_depth(signals):
    """Median force of all presses at each depth, and the depths: a rough scale of travel."""
    return np.append(0, np.median(signals.force_n, axis=(0, 1))), np.append(0, signals.depth_mm)


def test_recordings_of_one_tip_and_of_three_are_joined(paper, signals):
    """The one with fewer contact slots gets empty ones, and keeps what it says."""
    single = simulate_collection(spec_of(poses=((), ())), signals, "one")
    both = joined([paper, single])
    assert single.contact_face.shape[1] == 1
    assert both.contact_face.shape[1] == 3
    last = both.select(np.arange(len(paper), len(both)))
    np.testing.assert_array_equal(last.contact_face[:, 0], single.contact_face[:, 0])
    assert (last.contact_face[:, 1:] == NO_FACE).all()
    for name in ("contact_xy_mm", "force_n", "true_force_n"):
        np.testing.assert_array_equal(getattr(last, name)[:, :1], getattr(single, name))
        assert np.isnan(getattr(last, name)[:, 1:]).all()
    assert not set(last.press_id) & set(paper.press_id)


def test_what_cannot_be_simulated_is_refused(signals, mechanics):
    with pytest.raises(InputError, match="signals of tangential forces"):
        simulate_collection(
            spec_of(kind="continuous", presses=3, tangential_share=0.2), signals, "hash"
        )
    with pytest.raises(InputError, match="response operator"):
        simulate_collection(spec_of(), signals, "hash")
    with pytest.raises(InputError, match="not opposite"):
        grasp_cases(spec_of(kind="grasp", grasp_faces=(2, 3)))
    with pytest.raises(InputError, match="does not find room"):
        grasp_cases(spec_of(kind="grasp", grasp_faces=(3, 5), random_grasps=1))
    crowded = spec_of(kind="continuous", faces=(1,), contacts=5)
    with pytest.raises(InputError, match="do not find room"):
        random_case(crowded, np.random.default_rng(0), 0, 5)
    with pytest.raises(ValueError, match="names a face twice"):
        spec_of(faces=(1, 1))
    with pytest.raises(ValueError, match="tangential_share"):
        spec_of(tangential_share=0.3)


def test_two_tips_at_once_bear_twice_the_force_on_an_object_of_twice_the_modulus(
    signals, mechanics
):
    """At the same travel, as silicone is linear; counts are those of the same motions."""
    spec = spec_of()
    case = next(case for case in paper_cases(spec, 2) if len(case.face) == 2)
    design = contact_traces(spec, signals, [case], mechanics)
    stiff = replace(mechanics, assembly=replace(designed(spec), modulus_ratio=2.0))
    found = contact_traces(spec, signals, [case], stiff)
    assert_allclose(found.travel_mm, design.travel_mm)
    assert_allclose(found.tip_force_n, 2 * design.tip_force_n, atol=1e-9)
    assert design.force_n.max() > 1
    assert_allclose(found.counts, design.counts, atol=1e-6)


def test_handling_closes_holds_shakes_and_releases_each_grasp_once(signals, mechanics):
    spec = spec_of(
        kind="handling", frames_per_case=120, non_contact_cases=1, poses=CollectionSpec().poses
    )
    frames = simulate_collection(spec, signals, "hash", mechanics)
    total = np.nansum(frames.true_force_n[..., 2], axis=1).reshape(-1, 120)
    assert total.shape[0] == 10 + 1  # the ten poses of grasps, and one case without contact
    assert_allclose(total[-1], 0)
    peaks = total[:-1].max(axis=1) / 2  # of each jaw
    assert np.all((peaks > 0.75 * 6.0) & (peaks <= 6.01))
    assert np.ptp(peaks) > 0.2
    assert_allclose(total[:, :24], 0)
    assert_allclose(total[:, 109:], 0)
    held = total[:-1, 43:53] / total[:-1].max(axis=1, keepdims=True)
    assert_allclose(held, 1.0, atol=1e-3)
    shaken = total[:-1, 54:78] / total[:-1].max(axis=1, keepdims=True)
    assert np.all((shaken.min(axis=1) > 0.93) & (shaken.min(axis=1) < 0.985))
    assert len(np.unique(frames.press_id)) == 11
    faces = np.unique(frames.contact_face[frames.contact_face != NO_FACE])
    assert faces.tolist() == list(spec.collection.grasp_faces)


OPPOSITE = (((0.0, 0.0, 0.0), (3.0, 2.0, 0.0)), ((0.0, 0.0, 0.0), (3.0, -2.0, 0.0)))
MISSED = (OPPOSITE[0], ((2.5, 0.0, 0.0), (5.5, -2.0, 0.0)))
"""Places of two jaws in the frames of faces 3 and 5, whose y run opposite ways."""


def handled_by(signals, mechanics, indenter=None, poses=OPPOSITE):
    spec = spec_of(
        QUIET, {"force_noise_n": 1e-6}, kind="handling", frames_per_case=60, non_contact_cases=1,
        poses=poses,
    )  # fmt: skip
    spec = spec.changed(indenter=spec.indenter.changed(**(indenter or {})))
    return simulate_collection(spec, signals, "hash", mechanics)


def test_misplaced_jaws_press_alike_and_leave_a_moment(signals, mechanics):
    opposite = handled_by(signals, mechanics)
    missed = handled_by(signals, mechanics, poses=MISSED)
    for frames, lever_mm in ((opposite, 0.0), (missed, 2.5)):
        held = frames.select(np.arange(25, 28))
        force = held.true_force_n[:, :2, 2]
        assert_allclose(force[:, 0], force[:, 1], rtol=1e-4)
        assert force.min() > 0.75 * 6.0
        point = [
            frame.to_object(np.append(frame.to_plane(held.contact_xy_mm[0, slot]), 0.0))
            for slot, face in enumerate((3, 5))
            for frame in face_frames(coarse_spec())
            if frame.number == face
        ]
        assert np.linalg.norm((point[0] - point[1])[1:]) == pytest.approx(lever_mm, abs=1e-9)
    assert_allclose(missed.contact_xy_mm[25, 0], opposite.contact_xy_mm[25, 0])
    change = np.linalg.norm(missed.signal_counts[25] - opposite.signal_counts[25])
    assert change > 0.05 * np.linalg.norm(opposite.signal_counts[25])


def test_tilted_jaws_press_harder_on_one_side(signals, mechanics):
    """At the same places the channels answer otherwise per newton; both jaws still press alike."""
    jaw = {"kind": "cuboid", "size_mm": (8.0, 8.0)}
    straight, tilted = (
        handled_by(signals, mechanics, jaw | {"turn_deg": (0.0, 0.0, tilt)}) for tilt in (0.0, 5.0)
    )
    assert_allclose(tilted.contact_xy_mm[25], straight.contact_xy_mm[25])
    answers = []
    for frames in (straight, tilted):
        force = frames.true_force_n[25, :2, 2]
        assert force[0] == pytest.approx(force[1], rel=1e-4)
        assert force[0] > 0.75 * 6.0
        answers.append(frames.signal_counts[25] / force[0])
    assert np.linalg.norm(answers[1] - answers[0]) > 0.05 * np.linalg.norm(answers[0])
