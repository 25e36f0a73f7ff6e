"""Sensors in the shell, magnets in the core: batched scores against the ordinary chain, and their limits."""

from dataclasses import replace
from functools import cache
from itertools import combinations

import numpy as np
import pytest
import torch
from numpy.testing import assert_allclose

from design.errors import InputError
from design.layout.body import core_frames, face_frames
from design.layout.places.positions import magnet_layout, sensor_layout
from design.layout.pockets import core_pockets, sensor_boards
from design.layout.template_marks import CORNER_MM
from design.search.space import params_at, search_space, with_layout
from design.search.structure import with_structure
from design.spec_io import parse_spec
from estimator.field.environment import environment
from estimator.field.models import FieldModel
from estimator.layouts.batch import layouts_of
from estimator.layouts.cross_face import neighbour_changes
from estimator.layouts.limits.rules import RULES, constraint_violations_mm
from estimator.layouts.polish import descend
from estimator.layouts.presses.basis import press_basis
from estimator.layouts.presses.changes import press_changes
from estimator.layouts.scorer import layout_scorer
from estimator.layouts.scoring import place_information
from estimator.layouts.vectors import layout_space, layouts_at
from estimator.signals.field_setup import Scene, sensed_field
from estimator.signals.hall import chip_errors, counts_of_field
from tests.support.mechanics.candidate_cases import (
    FACE,
    at_contacts,
    chain_of_scene,
    made_up_motions,
    made_up_spec,
    motions_at,
)

BOUND_TOLERANCE = 0.03
"""As of magnets in the shell; measured 1.3 %."""
SIZES = {"cube": (42.0, 42.0, 42.0), "box": (60.0, 44.0, 42.0)}


def reverse_spec(body="cube", seed=0, **search):
    """Four magnets in the core and three boards in the shell, anywhere they fit."""
    rng = np.random.default_rng(seed)
    corners = np.array([[1, 1], [-1, 1], [-1, -1], [1, -1]])
    magnets = 7.5 * corners + rng.uniform(-0.7, 0.7, (4, 2))
    around = np.deg2rad(120 * np.arange(3) + rng.uniform(0, 120))
    sensors = 8.5 * np.stack([np.cos(around), np.sin(around)], axis=1) + rng.uniform(-1, 1, (3, 2))
    content = {
        "name": "reverse",
        "arrangement": "sensors-in-shell",
        "body": {"size_mm": SIZES[body]},
        "magnets": {
            "positions_mm": magnets.tolist(),
            "depth_below_core_face_mm": 0.0,
            "north": rng.choice(["outward", "inward"], 4).tolist(),
        },
        "sensors": {"package_mm": [6.6, 6.2, 1.6], "positions_mm": sensors.tolist()},
        "contact_grid": {"count": [5, 4], "pitch_mm": 6.0},
        "search": search,
    }
    return made_up_spec(parse_spec(content, "made up"))


@cache
def made(body, seed):
    """A specification with its motions and the scorer of one face, for all tests that ask for them."""
    spec = reverse_spec(body, seed)
    motions = made_up_motions(spec)
    return spec, motions, layout_scorer(spec, press_basis(spec, motions, FACE))


def chain(spec, motions, pressed, reads):
    """Of the sensors of one face in presses of another, or of its own."""
    return chain_of_scene(spec, motions, pressed, *scene_of(spec, motions, pressed, reads))


def scene_of(spec, motions, pressed, reads):
    sensors, magnets = sensor_layout(spec), magnet_layout(spec)
    own = sensors.face == reads
    sensors = replace(
        sensors,
        position_mm=sensors.position_mm[own],
        axes=sensors.axes[own],
        face=sensors.face[own],
    )
    chips = chip_errors(spec.sensors, int(own.sum()), 1)
    index = spec.body.sensed.index(reads)
    centres = np.array([board.centre_mm for board in sensor_boards(spec)[index]])
    along = face_frames(spec)[index].from_plane(centres[:, :2])
    row = motions.faces.tolist().index(pressed)
    motion = motions_at(motions, reads, along, -centres[:, 2])[row]
    return Scene(magnets, sensors, chips, environment(spec), sensors_move=True), motion


def worst_error(spec, motions, scorer):
    found = place_information(scorer, layouts_of(spec, FACE))
    bounds, _, _ = chain(spec, motions, FACE, FACE)
    return max(
        float(abs(part[0].numpy() / wanted - 1).max())
        for part, wanted in (
            (found.position_bound_mm, bounds.position_mm),
            (found.force_bound_n, bounds.force_n),
        )
    )


@pytest.mark.parametrize(
    ("body", "seed"), [pytest.param("cube", 0, marks=pytest.mark.slow), ("box", 1)]
)
def test_bounds_are_those_of_the_ordinary_chain(body, seed):
    assert worst_error(*made(body, seed)) < BOUND_TOLERANCE


@pytest.mark.parametrize("body", SIZES)
def test_neighbours_read_what_the_chain_reads(body):
    spec, motions, scorer = made(body, 0)
    places = scorer.presses.count
    columns, layouts = torch.arange(3 * places, 4 * places), layouts_of(spec, FACE)
    found = neighbour_changes(scorer, layouts, columns)[0]
    resting = press_changes(scorer, layouts).resting_counts[0].flatten()
    for number, face in enumerate(scorer.presses.neighbours):
        _, counts, rest = chain(spec, motions, FACE, face)
        wanted = counts.T / np.tile(scorer.sigma_counts, counts.shape[1] // 3)[:, None]
        assert_allclose(found[number], wanted, rtol=0, atol=0.05 * abs(wanted).max())
        assert rest.size == resting.numel()


def test_resting_counts_are_the_chain_s():
    spec, motions, scorer = made("box", 1)
    found = press_changes(scorer, layouts_of(spec, FACE)).resting_counts[0]
    _, _, rest = chain(spec, motions, FACE, FACE)
    assert_allclose(found, rest, rtol=0, atol=0.02 * abs(rest).max())


@pytest.mark.parametrize("body", SIZES)
def test_boards_pressed_near_magnets_have_their_counts_in_full(body):
    """Motions in proportion to force, of some millimetres in the deepest press."""
    spec, motions, _ = made(body, 0)
    motions = replace(motions, by_candidate=5e3 * motions.by_candidate)
    scorer = layout_scorer(spec, press_basis(spec, motions, FACE))
    layouts = layouts_of(spec, FACE)
    found = float(place_information(scorer, layouts).largest_counts)
    scene, motion = scene_of(spec, motions, FACE, FACE)
    motion = at_contacts(spec, motion)
    share = motions.deepest_n[0, 0] / motions.force_n[0, 0, -1]
    field = 1e3 * sensed_field(scene, share * motion[:, -1], FieldModel(scorer.sizes[0], "exact"))
    wanted = abs(counts_of_field(field, scene.sensors.axes, spec.sensors)).max()
    assert_allclose(found, wanted, rtol=0.03)
    changes = press_changes(scorer, layouts)
    sigma = scorer.sigma_counts.repeat(3)[:, None]
    linear = changes.resting_counts[0].flatten()[:, None] + share * 1.2 * (
        sigma * changes.by_parameter[:, 0, 3]
    )
    assert float(linear.abs().max()) < 0.9 * wanted, "linear signals would miss it"


VARY = {"magnet_reach_mm": 11.0, "sensor_reach_mm": 15.0}


def broken_of_random_layouts(count=40, seed=3, **given):
    spec = reverse_spec(**given, vary=VARY)
    space = search_space(spec)
    units = np.random.default_rng(seed).random((count, len(space.variables)))
    tensors = layout_space(space, with_structure(spec, params_at(space, units[0])), torch.float64)
    point, poles = torch.as_tensor(units), torch.ones(count, 4)
    return spec, space, tensors, poles, point


def thinnest_of_template_mm(spec):
    """Between its holes, with their play, and from a hole to the corner that is cut off it."""
    found = []
    for core, pockets in zip(core_frames(spec), core_pockets(spec), strict=True):
        at = np.array([pocket.body.centre_mm[:2] for pocket in pockets])
        radius = pockets[0].outline.radius_mm + spec.printer.clearance_mm
        found += [np.hypot(*(a - b)) - 2 * radius for a, b in combinations(at, 2)]
        x, y = core.half_extents_mm
        found += [(x + y - CORNER_MM - place.sum()) / np.sqrt(2) - radius for place in at]
    return min(found)


@pytest.mark.parametrize("body", ["box"])
def test_layouts_within_all_limits_pass_the_specification_s_own_check(body):
    """What breaks no rule is accepted, and what the check refuses breaks one."""
    spec, space, tensors, poles, point = broken_of_random_layouts(body=body)

    def broken(point):
        return constraint_violations_mm(tensors, layouts_at(tensors, point, poles, FACE), FACE).sum(
            dim=1
        )

    point = torch.cat([point, descend(broken, point, 60)])
    poles, accepted, walls = torch.cat([poles, poles]), [], []
    clear = (broken(point) == 0).numpy()
    for one in (params_at(space, unit) for unit in point.numpy()):
        try:
            walls.append(thinnest_of_template_mm(with_layout(spec, one)))
        except InputError:
            accepted.append(False)
        else:
            accepted.append(True)
    assert 0 < clear.sum() < len(clear)
    assert not (clear & ~np.array(accepted)).any()
    assert not np.all(accepted)
    assert min(np.array(walls)[clear[accepted]]) >= spec.printer.wall_mm


@pytest.mark.parametrize(
    ("diameter_mm", "place", "missing_mm"),
    [
        (6.0, (2.7, 8.1), 0.0),
        (6.0, (1.3, 8.1), 0.1),
        (6.0, (8.1, 8.1), 0.0),
        (4.0, (9.1, 9.1), 0.9 - (3.8 / 2**0.5 - 2)),
        (4.0, (9.4, 3.0), 0.2),
    ],
)
def test_walls_in_the_core_by_hand(diameter_mm, place, missing_mm):
    """0.8 mm of wall, 0.1 mm of play round a hole of the template.

    Beside the next magnet, beside the corner of 4 mm cut off 26 mm, and beside the pockets of the next
    side, 1 mm deep.
    """
    spec = reverse_spec(vary={"magnet_reach_mm": 11.0})
    places = ((-5.6, 8.1), place, (-8.0, -8.0), (8.0, -8.0))
    magnets = spec.magnets.changed(positions_mm=places, north=(), diameter_mm=diameter_mm)
    spec = spec.changed(magnets=magnets)
    space = layout_space(search_space(spec), spec, torch.float64)
    found = constraint_violations_mm(space, layouts_of(spec, FACE, torch.float64), FACE)
    told = float(found[0, RULES.index("magnets in the core")])
    assert told == pytest.approx(missing_mm + 0.02 * (missing_mm > 0), abs=2e-5)


REVERSE_RULES = ("pocket gap", "pockets near the edge", "magnets in the core")


@pytest.mark.parametrize("rule", REVERSE_RULES)
def test_gradients_of_limits_are_those_of_differences(rule):
    _, _, tensors, poles, units = broken_of_random_layouts()

    def broken(point):
        laid = layouts_at(tensors, point, poles, FACE)
        return constraint_violations_mm(tensors, laid, FACE)[:, RULES.index(rule)]

    point = units.clone().requires_grad_()
    (slope,) = torch.autograd.grad(broken(point).sum(), point)
    way = torch.as_tensor(np.random.default_rng(1).normal(size=units.shape))
    numeric = (broken(units + 1e-6 * way) - broken(units - 1e-6 * way)) / 2e-6
    assert_allclose((slope * way).sum(dim=1), numeric, rtol=1e-3, atol=1e-4)
    assert float(broken(units).max()) > 0
