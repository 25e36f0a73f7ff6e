"""Place errors by a slipped core and within tolerance: in batches, and on simulated presses."""

from dataclasses import replace

import numpy as np
import pytest
import torch
from numpy.testing import assert_allclose

from design.layout.body import face_frames
from estimator.field.models import FieldModel
from estimator.field.sources import magnet_source
from estimator.information.fisher import disturbance_counts
from estimator.layouts import robustness as layout_robustness
from estimator.layouts.presses.changes import press_changes
from estimator.layouts.robustness import slip_places_mm, tolerance_places_mm
from estimator.signals.field_setup import sensed_field
from estimator.signals.hall import counts_of_field
from estimator.tolerances.budget import robustness
from estimator.tolerances.localisation_bias import false_places_mm
from tests.support.mechanics.candidate_cases import (
    FACE,
    at_contacts,
    layout_scene,
    random_layouts,
)
from tests.support.mechanics.synthetic_presses import coarse_spec, synthetic_presses

COUNT = 4
TOLERANCE = 0.08
"""Of a layout's median; measured at most 6 % (slip) and 5 % (tolerances), from the short basis."""


def exact_change(spec, motions, one, row):
    """Change (place, sensor, 3) of counts in presses, with exact fields of all 25 magnets; a uniform field
    comes with the press."""
    parts = [
        np.asarray(getattr(one.layouts, name)[row], float)
        for name in ("magnet_mm", "turn_rad", "polarity", "sensor_mm")
    ]
    scene, motion = layout_scene(spec, motions, FACE, *parts)
    motion = at_contacts(spec, motion)
    axes = next(frame.axes for frame in face_frames(spec) if frame.number == FACE)
    shift = one.sensor_shift_mm[row].double().numpy() @ axes.T
    sensors = replace(scene.sensors, position_mm=scene.sensors.position_mm + shift)
    scene = replace(scene, sensors=sensors)
    moved = motion.mean(axis=1) / one.modulus_ratio  # of 0.8 and 1.2 times the score's force
    model = FieldModel(magnet_source(spec.magnets), "exact")
    states = np.concatenate([moved, 0 * moved[:1]])
    field = sensed_field(scene, states, model)
    field[:-1] += axes @ one.uniform_t.double().numpy()
    counts = counts_of_field(1e3 * field, sensors.axes, spec.sensors)
    change = counts[:-1] - counts[-1]
    return np.einsum("sij,psj->psi", one.chips.double().numpy(), change)


def exact_places(spec, motions, scorer, layouts, objects):
    """Place errors (layout, place), read by a pseudo-inverse in double precision."""
    nominal = next(iter(layout_robustness.slipped_scores(layouts)))
    nominal = replace(nominal, sensor_shift_mm=0 * nominal.sensor_shift_mm)
    jacobian = press_changes(scorer, layouts).by_parameter[:, :, :3].double().numpy()
    sigma = disturbance_counts(spec.sensors, "fresh", len(jacobian))
    found = []
    for row in range(len(layouts)):
        before = exact_change(spec, motions, nominal, row)
        read = np.linalg.pinv(jacobian[:, row].transpose(2, 0, 1))
        errors = [
            np.einsum("pkc,pc->pk", read, (after - before).reshape(len(before), -1) / sigma)
            for after in (exact_change(spec, motions, one, row) for one in objects)
        ]
        weights = [one.weight for one in objects]
        found.append(np.sqrt(weights @ np.sum(np.square(errors)[..., :2], axis=-1)))
    return np.stack(found)


CASES = {
    "slip": (slip_places_mm, lambda scorer, layouts: layout_robustness.slipped_scores(layouts)),
    "tolerance": (tolerance_places_mm, layout_robustness.toleranced_scores),
}


def worst_median_error(case, spec, motions, scorer, wanted_of):
    layouts = random_layouts(COUNT, seed=4)
    places, objects = CASES[case]
    found = np.median(places(scorer, layouts).numpy(), axis=1)
    every = list(objects(wanted_of, layouts))
    wanted = np.median(exact_places(spec, motions, wanted_of, layouts, every), axis=1)
    return np.max(abs(found / wanted - 1))


@pytest.mark.parametrize("case", CASES)
def test_place_errors_are_those_of_exact_fields(spec, motions, scorer, case):
    assert worst_median_error(case, spec, motions, scorer, scorer) < TOLERANCE


SIZES = [
    "magnet_seat_mm",
    "magnet_seat_depth_mm",
    "magnet_tilt_deg",
    "remanence_relative",
    "sensor_seat_mm",
    "sensor_rotation_deg",
    "sensor_gain_relative",
    "core_shift_mm",
    "earth_field_ut",
]


def within(scorer, tolerances):
    """The same scorer for other tolerances."""
    return replace(scorer, spec=scorer.spec.model_copy(update={"tolerances": tolerances}))


@pytest.mark.parametrize("size", SIZES)
def test_each_tolerance_alone_is_that_of_exact_fields_and_its_lack_would_show(
    spec, motions, scorer, size
):
    none = dict.fromkeys(type(spec.tolerances).model_fields, 0.0)
    own = none | {size: getattr(spec.tolerances, size)}
    alone, without = (within(scorer, spec.tolerances.model_copy(update=of)) for of in (own, none))
    assert worst_median_error("tolerance", spec, motions, alone, alone) < TOLERANCE
    assert worst_median_error("tolerance", spec, motions, without, alone) > 0.9


def test_slipped_objects_are_moved_by_a_millimetre_each_way_and_else_as_designed():
    layouts = random_layouts(2, seed=1)
    found = list(layout_robustness.slipped_scores(layouts))
    shifts = torch.stack([one.sensor_shift_mm[1, 0] for one in found])
    assert_allclose(shifts, np.concatenate([np.eye(3), -np.eye(3)]))
    for one in found:
        assert one.modulus_ratio == 1.0
        assert one.layouts is layouts
        assert_allclose(one.chips, np.broadcast_to(np.eye(3), one.chips.shape))
        assert_allclose(one.sensor_shift_mm - one.sensor_shift_mm[:1, :1], 0)


def test_softness_alone_shifts_forces_not_places(spec, scorer):
    none = dict.fromkeys(type(spec.tolerances).model_fields, 0.0)
    stiff = spec.tolerances.model_copy(update=none | {"modulus_relative": 0.2})
    layouts = random_layouts(COUNT, seed=4)
    with_all = tolerance_places_mm(scorer, layouts)
    alone = tolerance_places_mm(within(scorer, stiff), layouts)
    assert float(alone.median()) < 0.02 * float(with_all.median())


def test_errors_grow_as_the_tolerance_that_makes_them(spec, scorer):
    none = dict.fromkeys(type(spec.tolerances).model_fields, 0.0)
    layouts = random_layouts(COUNT, seed=4)

    def errors(gain):
        sizes = spec.tolerances.model_copy(update=none | {"sensor_gain_relative": gain})
        return tolerance_places_mm(within(scorer, sizes), layouts)

    assert_allclose(errors(0.02), 2 * errors(0.01), rtol=1e-2)


def test_errors_have_gradients(scorer):
    layouts = random_layouts(1, seed=2)
    place = layouts.magnet_mm.clone().requires_grad_()
    tolerance_places_mm(scorer, replace(layouts, magnet_mm=place)).mean().backward()
    step = torch.zeros_like(place)
    step[0, 2, 1] = 0.02
    ahead, behind = (
        tolerance_places_mm(scorer, replace(layouts, magnet_mm=layouts.magnet_mm + sign * step))
        for sign in (1, -1)
    )
    slope = float(ahead.mean() - behind.mean()) / 0.04
    assert_allclose(float(place.grad[0, 2, 1]), slope, rtol=0.05, atol=1e-3)


@pytest.fixture(scope="module")
def simulated():
    spec = coarse_spec(contact_grid={"count": (3, 4), "pitch_mm": 4.0})
    return spec, synthetic_presses(spec)


def test_a_small_slip_errs_as_the_budgets_first_order(simulated):
    spec, presses = simulated
    none = dict.fromkeys(type(spec.tolerances).model_fields, 0.0)
    sizes = spec.tolerances.model_copy(update=none | {"core_shift_mm": 0.1})
    loose = spec.model_copy(update={"tolerances": sizes})
    row = next(r for r in robustness(loose, *presses, draws=2).contributions if "shift" in r.name)
    found = false_places_mm(loose, *presses, slip_mm=0.1)
    assert_allclose(np.median(found["slip"]), row.false_place_mm / np.sqrt(3), rtol=0.03)
    assert_allclose(found["slip"].max(), row.false_place_worst_mm / np.sqrt(3), rtol=0.05)


def test_without_tolerances_nothing_errs(simulated):
    spec, presses = simulated
    none = dict.fromkeys(type(spec.tolerances).model_fields, 0.0)
    exact = spec.model_copy(update={"tolerances": spec.tolerances.model_copy(update=none)})
    found = false_places_mm(exact, *presses, slip_mm=1.0)
    assert found["tolerance"].max() < 1e-9
    assert np.median(found["slip"]) > 0.05
    assert false_places_mm(spec, *presses, slip_mm=1.0)["tolerance"].min() > 1e-3
