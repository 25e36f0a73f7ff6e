"""Specifications held against presses: arrangement, chips, magnets; written and read again."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from design.layout.places.positions import sensor_layout
from design.spec.object import ObjectSpec
from design.spec_io import load_spec, parse_spec
from estimator.adoption.arrangement import LEAST_EXPLAINED, moving_bodies, told_arrangement
from estimator.adoption.boards import boards_of_faces
from estimator.adoption.convention import TURNS, best_convention
from estimator.adoption.fit import (
    ObjectFit,
    Pressed,
    fit_both_hands,
    fit_object,
    halves_of_places,
    judged,
)
from estimator.adoption.nearest_spec import fitted_content
from estimator.adoption.presses import ForeignPresses
from estimator.adoption.sinking import order_by_sinking
from estimator.recordings.formats.files import places_mm
from tests.support.recordings.foreign_logs import ForeignObject, grid
from tests.support.recordings.travel_cases import PAD, pad_model, pressed_places, recorded

EXAMPLES = Path(__file__).parents[3] / "examples"
ORDER, TURN = np.array([2, 0, 1]), -TURNS[9]
MAGNETS = ((7.0, 7.0), (-7.0, 7.0), (-7.0, -7.0))
"""Three corners of four: turned or mirrored they are others."""


def content(arrangement, magnets_mm=MAGNETS):
    """One face of a small cube; the corner without a magnet tells its sides apart."""
    magnets = {
        "positions_mm": [list(place) for place in magnets_mm],
        "diameter_mm": 6.0,
        "height_mm": 2.0,
    }
    sensors = {"package_mm": [3.0, 3.0, 1.6]} if arrangement == "sensors-in-shell" else {}
    core = {
        "wire_hole_top_diameter_mm": 1.0,
        "wire_hole_side_diameter_mm": 1.0,
    }
    return {
        "name": "cube", "arrangement": arrangement, "body": {"sensed_faces": [1]},
        "magnets": magnets, "sensors": sensors, "core": core,
    }  # fmt: skip


def spec_of(arrangement):
    return ObjectSpec.model_validate(content(arrangement))


def foreign(spec):
    """The same face as magpylib's model has it: chips and magnets at the heights of the specification."""
    reverse = spec.arrangement == "sensors-in-shell"
    thing = ForeignObject(
        faces=1, reverse=reverse, ring_mm=8.585, magnets_mm=tuple(spec.magnets.positions_mm),
        magnet_size_mm=(6.0, 2.0),
        spread_mm=6.0, azimuth_deg=240.0, counts_per_mt=1.0,
    )  # fmt: skip
    chips = float(sensor_layout(spec).position_mm[0, 2])
    model = moving_bodies(spec, reverse)
    magnets = float(model.scene.magnets.centre_mm[0, 2])
    low, high = sorted((chips, magnets))
    return replace(thing, core_mm=low, gap_mm=high - low)


def readings(spec, order=(0, 1, 2), turn=TURNS[0], noise=0.01):
    """Presses of 16 places, chips in another order and with other axes."""
    places = grid((4, 4), (6.0, 6.0))
    thing = foreign(spec)
    presses = [(1, x, y, depth) for x, y in places for depth in (1.5, 3.0)]
    levels = thing.counts([*presses, (0, 0, 0, 0)])
    levels += noise * np.random.default_rng(3).standard_normal(levels.shape)
    levels = (levels @ turn.T)[:, np.argsort(order)]
    number = np.repeat(np.arange(16), 2)
    travel = np.array([press[3] for press in presses])
    return Pressed(places[number], travel, number, levels[:-1] - levels[-1], levels[-1])


def test_a_planted_order_and_turn_of_chips_are_found():
    predicted = np.random.default_rng(0).normal(size=(40, 3, 3))
    recorded_ = (predicted @ TURN.T)[:, np.argsort(ORDER)]
    found = best_convention([recorded_], [predicted])
    np.testing.assert_array_equal(found.order, ORDER)
    np.testing.assert_array_equal(found.turn, TURN)
    np.testing.assert_allclose(found.designed(recorded_), predicted, atol=1e-12)


@pytest.mark.parametrize(
    "arrangement", ["sensors-in-core", pytest.param("sensors-in-shell", marks=pytest.mark.slow)]
)
def test_who_moves_is_told_from_presses_of_an_independent_model(arrangement):
    """The field is magpylib's, the motion the log's own: tests/support/recordings/foreign_logs.py."""
    spec = spec_of(arrangement)
    pressed = readings(spec)
    found = told_arrangement(spec, [pressed.select(np.flatnonzero(pressed.place % 4 < 3))], kept=1)
    reverse = arrangement == "sensors-in-shell"
    assert (found.reverse > found.normal) == reverse
    assert found.p < 0.05
    assert max(found.reverse, found.normal) > 0.8


@pytest.mark.slow
def test_magnets_in_wrong_places_do_not_decide_the_arrangement():
    """One magnet over every chip explains a normal object better in reverse, and neither way well."""
    pressed = readings(spec_of("sensors-in-core"))
    over_chips = ((8.5, 0.0), (-4.3, 7.4), (-4.3, -7.4))
    spec = ObjectSpec.model_validate(content("sensors-in-core", over_chips))
    arrangement = told_arrangement(spec, [pressed])
    assert arrangement.reverse > arrangement.normal
    assert max(arrangement.reverse, arrangement.normal) < LEAST_EXPLAINED
    assert arrangement.finding.answer == "cannot be told"


def test_places_of_all_faces_decide_the_arrangement_together():
    """Five places have 32 exchanges of the two ways, two of which are as written: p is 0.06 at least."""
    spec = spec_of("sensors-in-core")
    pressed = readings(spec)
    parts = [
        pressed.select(np.flatnonzero(np.isin(pressed.place, places)))
        for places in ((0, 3, 6, 9, 12), (1, 5, 10, 11, 14))
    ]
    (alone, together) = (told_arrangement(spec, faces, kept=1) for faces in (parts[:1], parts))
    assert alone.finding.answer == "cannot be told"
    assert together.finding.answer.startswith("normal")
    assert together.p < alone.p


def test_chips_and_pose_are_fitted_and_judged_on_unseen_places():
    spec = spec_of("sensors-in-shell")
    pressed = readings(spec, ORDER, TURN)
    half = halves_of_places(pressed, 0)
    fit = fit_object(moving_bodies(spec, True), pressed.select(half))
    figures = judged(fit, pressed.select(~half), exchanges=19)
    assert figures.all.cosine > 0.95
    assert figures.order_of_chips == 1
    assert max(null.cosine for null in figures.places_exchanged) < figures.all.cosine - 0.2
    np.testing.assert_array_equal(fit.convention.order, ORDER)
    np.testing.assert_array_equal(fit.convention.turn, TURN)
    assert fit.pose.symmetry == 0
    assert np.linalg.norm(fit.pose.shift_mm) < 1.0


@pytest.mark.parametrize("magnets_mm", [((0.0, 0.0),), MAGNETS])
def test_a_mirror_image_is_named_where_the_object_is_its_own(magnets_mm):
    """One magnet in the middle of the chips: order and poles of a mirrored object read the same."""
    spec = ObjectSpec.model_validate(content("sensors-in-shell", magnets_mm))
    pressed = readings(spec, ORDER, TURNS[5])
    fit, mirror = fit_both_hands(moving_bodies(spec, True), pressed)
    np.testing.assert_array_equal(fit.convention.turn, TURNS[5])
    np.testing.assert_array_equal(fit.convention.order, ORDER)
    if magnets_mm == MAGNETS:
        assert mirror is None
    else:
        assert mirror is not None
        assert mirror.convention.reversed_poles
        assert not np.array_equal(mirror.convention.order, ORDER)


@pytest.mark.parametrize("arrangement", ["sensors-in-core", "sensors-in-shell"])
@pytest.mark.parametrize("turn", [TURNS[7], -TURNS[9]])
def test_a_written_specification_has_the_log_s_order_axes_poles_and_strength(arrangement, turn):
    """At rest the written object reads what the log's chips read, column by column."""
    spec = spec_of(arrangement)
    thing = moving_bodies(spec, arrangement == "sensors-in-shell")
    numbers = np.zeros(12)
    numbers[5], numbers[6:9] = 0.4, (0.2, -0.1, -0.3)
    best = best_convention([np.eye(9).reshape(9, 3, 3)], [np.eye(9).reshape(9, 3, 3)])
    fit = ObjectFit(thing, 0, numbers, replace(best, order=ORDER, turn=turn))
    nothing = Pressed(
        np.zeros((1, 2)), np.zeros(1), np.zeros(1, int), np.zeros((1, 3, 3)), np.eye(3)
    )
    resting = fit.predicted(nothing)[1]
    log = (resting @ turn.T)[np.argsort(ORDER)]
    assert np.allclose(fit.convention.designed(log), resting)
    written = parse_spec(fitted_content(content(arrangement), spec, fit), "written")
    again = moving_bodies(written, arrangement == "sensors-in-shell")
    reread = replace(fit, thing=again, numbers=np.zeros(12)).predicted(nothing)[1]
    np.testing.assert_allclose(reread, log, rtol=2e-3, atol=0.02)


def test_the_order_of_chips_is_found_from_sinking_magnets_alone():
    spec, model = load_spec(PAD), pad_model()
    field = recorded(model, pressed_places())
    order = np.array([3, 0, 4, 1, 2])
    found, finding = order_by_sinking(spec, field[:, np.argsort(order)])
    assert found == tuple(order)
    assert finding.p == pytest.approx(1 / 120)
    noise = np.random.default_rng(1).normal(size=field.shape)
    assert "number 1 of 120" not in order_by_sinking(spec, noise)[1].answer


def grasps(count=8, seed=5):
    """Presses of faces 3 and 5 at once at random labels, boards of five faces in the order 5, 3, 1, 2, 4."""
    turned = {**content("sensors-in-core"), "body": {}}
    spec = ObjectSpec.model_validate({**turned, "sensors": {"first_azimuth_deg": [240.0] * 5}})
    thing = replace(foreign(spec_of("sensors-in-core")), faces=5)
    label = np.random.default_rng(seed).integers(1, 101, (count, 2))
    xy = places_mm(label[:, :, None])[:, :, 0]
    change = sum(
        thing.counts([(face, *xy[k, contact], 2.0) for k in range(count)])
        - thing.counts([(0, 0, 0, 0)])
        for contact, face in enumerate((3, 5))
    )
    boards = np.array([4, 2, 0, 1, 3])
    change = change.reshape(count, 5, 3, 3)[:, boards].reshape(count, 15, 3)
    face = np.tile([3, 5], (count, 1))
    still = np.zeros((0, 15, 3))
    presses = ForeignPresses(face, label, np.ones((count, 2)), change, np.zeros((15, 3)), still)
    return spec, presses


def test_boards_of_faces_held_by_jaws_are_found_with_their_axes():
    spec, presses = grasps()
    found = boards_of_faces(spec, replace(presses, change=presses.change @ TURNS[5].T))
    assert found.chips_of_face == {3: [3, 4, 5], 5: [0, 1, 2]}
    np.testing.assert_array_equal(found.turn, TURNS[5])
    assert found.p < 0.03
    (finding,) = found.findings("as designed")
    assert "face 5: chips 1-3" in finding.answer


def test_boards_are_not_told_from_places_that_say_nothing():
    spec, presses = grasps()
    mixed = np.random.default_rng(8).permutation(len(presses))
    (finding,) = boards_of_faces(spec, replace(presses, place=presses.place[mixed])).findings("")
    assert finding.answer == "cannot be told"
