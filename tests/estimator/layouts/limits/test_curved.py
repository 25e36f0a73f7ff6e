"""Limits of layouts under curved surfaces against what check and fabrication say of the same layouts."""

from dataclasses import replace
from functools import cache
from itertools import product
from types import SimpleNamespace

import numpy as np
import pytest
import torch
from numpy.testing import assert_allclose
from scipy.spatial import ConvexHull
from trimesh.creation import icosphere

from design.body.imported import body_of_file
from design.errors import InputError
from design.fabrication.layout import failures, layout_findings
from design.fit.parts import distance_mm
from design.layout.boards import passage_radius_mm
from design.layout.body import face_frames
from design.layout.places.positions import cover_mm
from design.layout.pockets import magnet_bodies
from design.search.space import params_at, search_space, with_layout
from design.search.structure import with_structure
from design.spec_io import parse_spec
from estimator.field.sources import magnet_source
from estimator.layouts.limits import curved
from estimator.layouts.limits.parts import boards_of, chips_near_magnets_mm
from estimator.layouts.limits.rules import RULES, constraint_violations_mm
from estimator.layouts.polish import descend
from estimator.layouts.surfaces import surfaces
from estimator.layouts.vectors import layout_space, layouts_at

VARY = {"magnet_reach_mm": 15.0, "magnet_depth_mm": [1.8, 5.5], "sensor_reach_mm": 9.5}
CORE = {"wall_mm": 5.0}
BODIES = {
    "handle": {"body": {"kind": "cylinder", "size_mm": [42.0, 42.0, 60.0], "open_faces": [6]}},
    "capsule": {"body": {"kind": "capsule", "size_mm": [48.0, 48.0, 76.0], "bore_mm": 10.0}},
    "egg": {"body": {"kind": "ellipsoid", "size_mm": [64.0, 54.0, 54.0]}},
    "box": {"body": {"size_mm": [60.0, 44.0, 40.0]}},
}


@cache
def spec_of(body):
    """Once per body: what is worked out of a specification is kept with it.

    Without a gap of the search's own between pockets: what the silicone needs is left.
    """
    content = {
        "name": body,
        "magnets": {"positions_mm": [[0, 0], [10, 0], [-10, 0]]},
        "sensors": {"positions_mm": [[6, 0], [-6, 0]]},
        "core": CORE,
        "contact_grid": {"count": "fill", "pitch_mm": 4.0},
        "search": {"vary": VARY},
        **BODIES[body],
    }
    return parse_spec(content, "made up")


@cache
def space_of(body):
    """Of its only structure, once per body as well."""
    spec = spec_of(body)
    space = search_space(spec)
    params = params_at(space, np.full(len(space.variables), 0.5))
    return layout_space(space, with_structure(spec, params), torch.float64)


def batch(body, count, seed=0):
    spec, tensors = spec_of(body), space_of(body)
    space = search_space(spec)
    units = np.random.default_rng(seed).random((count, len(space.variables)))
    params = [params_at(space, unit) for unit in units]
    poles = torch.ones(count, spec.magnets.count, dtype=torch.float64)
    return spec, tensors, params, poles, torch.as_tensor(units)


def unchecked(spec, params, monkeypatch):
    monkeypatch.setattr("design.spec_io.require_fit", lambda spec, table=True: None)
    return with_layout(spec, params)


FABRICATION = {
    "pocket gap": "pocket spacing",
    "pocket gap across an edge": "pocket spacing across an edge",
    "boards near the edge": "wall beside a side of the core",
    "board beside the wire hole": "wall beside the wire hole",
    "board gap": "wall between two recesses",
}


def told_and_missing(body, monkeypatch, count=12):
    """Of every rule of fabrication: what the limit says, and what its figure lacks."""
    spec, space, params, poles, units = batch(body, count, 11)
    broken = constraint_violations_mm(space, layouts_at(space, units, poles, 3), 3)
    for row, one in enumerate(params):
        laid = unchecked(spec, one, monkeypatch)
        found = {f.check: f for f in layout_findings(laid)}
        missing = {check: f.limit - f.value for check, f in found.items()}
        silicone = max(missing["seal over the magnets"], missing["breakthrough"])
        wanted = {rule: missing[check] for rule, check in FABRICATION.items() if check in missing}
        for rule, short in (wanted | {"seal": silicone}).items():
            yield rule, float(broken[row, RULES.index(rule)]), short


@pytest.mark.parametrize("body", ["handle", "box"])
def test_limits_of_fabrication_have_its_figures(body, monkeypatch):
    """What fails breaks the limit of that name, and nothing is refused that is clear of it: but for recesses
    beside the wire hole, which the figure takes as upright and the limit as turned with the core."""
    seen = dict.fromkeys((*FABRICATION, "seal"), 0)
    for rule, told, short in told_and_missing(body, monkeypatch):
        inward = rule == "board beside the wire hole"
        if np.isfinite(short) and short > 0.03:
            assert told > (0 if inward else short - 0.03), (rule, short, told)
            seen[rule] += 1
        if short < -0.06 and not inward and rule != "boards near the edge":  # which need room too
            assert told == 0, (rule, short, told)
    assert sum(count > 0 for count in seen.values()) >= 3, seen


@pytest.mark.parametrize("body", ["capsule", "box"])
def test_layouts_within_all_limits_fit_and_can_be_made(body):
    spec, space, params, poles, units = batch(body, 4, 2)
    variables = search_space(spec).continuous

    def broken(point):
        return constraint_violations_mm(space, layouts_at(space, point, poles, 3), 3)

    point = descend(lambda u: broken(u).sum(dim=1), units, 25, 0.08)
    kept = 0
    for row, rules in enumerate(broken(point)):
        if float(rules.sum()) > 0:
            continue
        values = zip(variables, point[row].tolist(), strict=True)
        moved = {v.name: v.low + u * (v.high - v.low) for v, u in values}
        try:
            found = with_layout(spec, params[row] | moved)
        except InputError as error:
            pytest.fail(f"{moved}: {error}")
        told = failures(layout_findings(found))
        assert not [one for one in told if "mark of polarity" not in one], told  # of the template
        kept += 1
    assert kept >= 2


def test_gradients_of_limits_are_those_of_differences():
    _, space, _, poles, units = batch("capsule", 4, 7)

    def broken(point):
        return constraint_violations_mm(space, layouts_at(space, point, poles, 3), 3)

    point = units.clone().requires_grad_()
    found = broken(point).sum(dim=0)
    way = torch.as_tensor(np.random.default_rng(1).normal(size=units.shape))
    step = 1e-6
    numeric = (broken(units + step * way) - broken(units - step * way)) / (2 * step)
    for rule in (0, 1, 2, 3, 4, 5, 8):
        (slope,) = torch.autograd.grad(found[rule], point, retain_graph=True)
        along = (slope * way).sum(dim=1)
        assert_allclose(along, numeric[:, rule], rtol=2e-3, atol=2e-3, err_msg=RULES[rule])


def test_silicone_over_magnets_is_that_of_their_rims():
    spec, _, params, _, _ = batch("egg", 5)
    covers = {face: one for face, (one,) in curved.covers_of(spec).items()}
    for one in params:
        depths = [one[f"magnet{k}_depth_mm"] for k in (1, 2, 3)]
        for frame, bodies in zip(face_frames(spec), magnet_bodies(spec), strict=True):
            for depth, body in zip(depths, bodies, strict=True):
                x, y = (one["face1_magnet1_x_mm"], one["face1_magnet2_y_mm"])
                if not frame.covers(1.2 * np.array([x, y])):
                    continue
                wanted = cover_mm(frame, replace(body, centre_mm=np.array([x, y, -depth])))
                found = float(covers[frame.number].wall_over(np.array([[x, y, depth]]))[0, 0])
                assert found == pytest.approx(wanted, abs=0.02)


def test_silicone_over_magnets_is_that_of_the_file_s_content(tmp_path):
    """An ellipsoid, then one with fuller sides of the same box and name, has walls as under a new name."""
    walls = []
    for power, name in ((1.0, "a.stl"), (0.8, "a.stl"), (0.8, "b.stl")):
        ball = icosphere(4, 1.0)
        ball.vertices = np.sign(ball.vertices) * abs(ball.vertices) ** power
        ball.apply_scale(np.array([64.0, 54.0, 54.0]) / ball.extents)
        ball.export(tmp_path / name)
        body = {"kind": "imported", "sensed_faces": [1], **body_of_file(tmp_path / name)}
        spec = parse_spec({"name": "ball", "body": body}, "test")
        walls.append(curved.covers_of(spec)[1][0].wall_over(np.array([[9.0, 9.0, 4.0]]))[0, 0])
    assert walls[1] == walls[2] != walls[0]


@pytest.mark.parametrize("body", ["box", "egg"])
def test_a_recess_leaves_a_wall_round_the_wire_hole_as_it_is_turned(body):
    """Against the convex hull of its corners, seen along the hole of its face; an upright one's, which the
    rule keeps too, asks for less here."""
    spec, space, _, poles, units = batch(body, 40, 5)
    known, layouts = surfaces(space.structured), layouts_at(space, units, poles, 3)
    least, seen = passage_radius_mm(spec) + spec.printer.wall_mm + curved.SLACK_MM, []
    for number, surface in known.items():
        laid, core = layouts.layouts_of_face(number), surface.core
        recesses = curved.recess_boxes(surface, laid, boards_of(spec, laid))
        found = curved.boards_beside_hole(surface, recesses)
        centre, axes, half = (part.numpy() for part in recesses)
        signs = np.array(list(product((-1, 1), repeat=3)))
        corners = centre[..., None, :] + (signs * half[..., None, :]) @ axes
        along = (corners - core.centre_mm) @ core.axes[:, :2]
        for row, places in enumerate(along):
            if not np.isfinite(places).all():
                continue
            wanted = 0.0
            for hull in map(ConvexHull, places):
                away = hull.equations[:, 2].max()
                if away > 0:
                    away = distance_mm(hull.points[hull.vertices], np.zeros(2))
                wanted += min(max(0.0, least - away), max(0.0, away + curved.SLACK_MM))
            assert float(found[row]) == pytest.approx(wanted, abs=1e-6)
            seen.append(wanted)
    assert max(seen) > 0.5
    assert min(seen) == 0


@pytest.mark.parametrize("farthest", [(1, 1), (1, -1), (-1, 1), (-1, -1)], ids=str)
def test_the_corner_of_a_recess_s_floor_that_goes_farthest_beyond_the_core_counts(
    monkeypatch, farthest
):
    """The core ends at a plane through the origin, whichever way it lies; a wall must be left."""
    spec, rng = spec_of("box"), np.random.default_rng(3)
    axes, half = np.linalg.qr(rng.normal(size=(3, 3)))[0], rng.uniform(1, 4, 3)
    centre, out = rng.normal(size=3), np.array([*farthest, -0.5]) @ axes
    monkeypatch.setattr(curved, "distance_beyond_core_mm", lambda spec, points: points @ out)
    flat = SimpleNamespace(flat=True)
    surface = SimpleNamespace(spec=spec, core=flat, reach_mm=lambda at: np.full(len(at), 99.0))
    recesses = tuple(torch.as_tensor(one[None, None]) for one in (centre, axes, half))
    place = SimpleNamespace(sensor_mm=torch.zeros(1, 1, 2, dtype=torch.float64))
    found = curved.boards_past_edges.__wrapped__(surface, place, recesses)
    corners = [centre + (half * [x, y, -1]) @ axes for x in (-1, 1) for y in (-1, 1)]
    wanted = max(0.0, np.max(np.array(corners) @ out) + spec.printer.wall_mm + curved.SLACK_MM)
    assert_allclose(found.numpy(), [wanted])


def test_silicone_is_missing_over_a_leaning_magnet_and_under_its_pocket():
    """By hand on a flat face: 2 mm deep, and 2 mm deep leaning 30°; one pocket goes 0.2 mm too deep."""
    two = ((0.0, 0.0), (9.0, 0.0))
    spec, lean = spec_of("box"), np.deg2rad(30)
    spec = spec.changed(magnets=spec.magnets.changed(positions_mm=two))
    least = spec.silicone.thinnest_wall_mm + curved.SLACK_MM
    axis = torch.tensor([[[0.0, np.sin(lean)]], [[0.0, 0.0]], [[1.0, np.cos(lean)]]]).double()
    lowest = torch.tensor([[-1.0, least - spec.shell.thickness_mm - 0.2]]).double()
    depth = torch.tensor([[[0.0, 0, 2.0], [0.0, 0, 2.0]]]).double()
    surface = SimpleNamespace(spec=spec, frame=SimpleNamespace(flat=True))
    pockets = SimpleNamespace(axis=axis, lowest=lowest)
    found = curved.unsealed_mm.__wrapped__(surface, SimpleNamespace(magnet_mm=depth), pockets)
    radius, half = spec.magnets.diameter_mm / 2, spec.magnets.height_mm / 2
    covers = [2 - half, 2 - radius * np.sin(lean) - half * np.cos(lean)]
    wanted = sum(max(0.0, least - cover) for cover in covers) + 0.2
    assert_allclose(found.numpy(), [wanted], atol=1e-5)


def test_pockets_keep_their_slack_from_the_edge_of_their_patch():
    """A hundredth of a millimetre too near along x, a tenth beyond along y; on a box's face further in
    by the deepest pocket; on an ellipse by the share of its half axes."""
    reach = torch.as_tensor(np.array([[[9.99, 9.97]], [[5.0, 8.1]]]))
    pockets = SimpleNamespace(reach=reach, lowest=torch.tensor([[-2.5, -3.5]]).double())

    def beyond(body, is_round=False):
        frame = SimpleNamespace(half_extents_mm=(10.0, 8.0), round=is_round)
        surface = SimpleNamespace(frame=frame, spec=spec_of(body))
        return float(curved.past_border.__wrapped__(surface, pockets)[0])

    slack = curved.SLACK_MM
    assert slack > 0.01
    assert beyond("handle") == pytest.approx(slack - 0.01 + max(0.0, slack - 0.03) + slack + 0.1)
    deep = [9.99 + 3.5 - 10, 9.97 + 3.5 - 10, 5 + 3.5 - 8, 8.1 + 3.5 - 8]
    assert beyond("box") == pytest.approx(sum(deep) + 4 * slack)
    shares = [np.hypot((x + slack) / 10, (y + slack) / 8) for x, y in ((9.99, 5.0), (9.97, 8.1))]
    assert beyond("handle", True) == pytest.approx(sum(8 * (share - 1) for share in shares))


def test_chips_keep_their_slack_from_where_the_series_of_magnets_is_right():
    """Two chips, one magnet of their own face and one of another, on a line through the first chip."""
    spec = spec_of("box")
    spec = spec.changed(magnets=spec.magnets.changed(positions_mm=((0.0, 0.0),)))
    radius, slack = magnet_source(spec.magnets).circumscribed_radius_mm, curved.SLACK_MM
    way = np.array([0.6, 0.0, 0.8])
    chips = torch.as_tensor(np.array([[[1.0, 2.0, 3.0], [1.0, 42.0, 3.0]]]))

    def short(own, other):
        place = {3: own * way, 5: -other * way}
        centres = {n: torch.as_tensor(np.array([[[1.0, 2, 3]]]) + at) for n, at in place.items()}
        return float(chips_near_magnets_mm(spec, 3, chips, centres)[0])

    least = {"own": 1.4 * radius, "other": 2.0 * radius}
    assert short(least["own"] + slack + 0.01, least["other"] + slack + 0.01) == 0
    assert short(least["own"] + 0.01, 30.0) == pytest.approx(slack - 0.01)
    assert short(30.0, least["other"] + 0.005) == pytest.approx(slack - 0.005)
    assert short(least["own"] - 1, least["other"] - 0.5) == pytest.approx(1.5 + 2 * slack)
