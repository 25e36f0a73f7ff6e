"""Limits on flat faces: places of parts are those of the design, and what is missing is by hand."""

from dataclasses import replace

import numpy as np
import torch
from numpy.testing import assert_allclose

from design.layout.boards import sensor_recesses
from design.layout.body import face_frames
from design.layout.pockets import axis_in_object_mm, shell_pockets
from design.spec.object import ObjectSpec
from estimator.layouts.batch import layouts_of
from estimator.layouts.limits import flat, parts
from estimator.layouts.limits.parts import SLACK_MM, boards_of, placed_pockets, pockets_of

SPEC = ObjectSpec.model_validate(
    {
        "name": "cube",
        "body": {"size_mm": [42.0, 46.0, 44.0]},
        "magnets": {
            "positions_mm": [[0.0, 1.0], [9.0, -8.0]],
            "depth_mm": [2.5, 3.0],
            "tilt_deg": [[5.0, -10.0], [0.0, 15.0]],
        },
        "search": {"vary": {"sensor_reach_mm": 9.0}},
    }
)
LAYOUTS = layouts_of(SPEC, 3, torch.float64)


def test_recesses_are_those_cut_from_the_core():
    centres, axes = flat.recess_boxes(SPEC, boards_of(SPEC, LAYOUTS))
    recesses = sensor_recesses(SPEC)
    assert centres.shape == (1, len(recesses), 3)
    for k, recess in enumerate(recesses):
        if recess.face == 3:  # whose places the others share, but for their azimuths
            assert_allclose(centres[0, k], recess.centre_mm, atol=0.1)
            assert_allclose(abs(axes[0, k].numpy() @ recess.axes), np.eye(3), atol=0.05)
        square = axes[0, k].numpy()
        assert_allclose(square @ square.T, np.eye(3), atol=1e-9)


def test_pockets_lie_in_the_object_s_frame_as_the_design_has_them():
    pockets = pockets_of(SPEC, LAYOUTS)
    for frame, made in zip(face_frames(SPEC), shell_pockets(SPEC), strict=True):
        floor, top, axis = placed_pockets(frame, pockets)
        for k, pocket in enumerate(made):
            ends = axis_in_object_mm(frame, pocket)
            assert_allclose(floor[:, 0, k], ends[0], atol=1e-3)
            assert_allclose(top[:, 0, k], ends[1], atol=1e-3)
            assert_allclose(axis[:, 0, k], frame.axes @ pocket.axis, atol=1e-6)


def moved(**changes):
    return replace(LAYOUTS, **{name: torch.tensor(value) for name, value in changes.items()})


UPRIGHT = moved(
    magnet_mm=[[[0.0, 0.0, 2.5], [0.0, 0.0, 2.5]]],
    turn_rad=[[[0.0, 0.0], [0.0, 0.0]]],
)


def test_magnets_are_sealed_by_the_thinnest_wall_on_both_sides():
    """Of 1 mm height: 0.5 mm and the wall from their middles to either side."""
    wall, thick = SPEC.silicone.thinnest_wall_mm, SPEC.shell.thickness_mm
    for depth, missing in ((2.5, 0.0), (1.2, 0.3), (thick - 1.3, 0.2)):
        layouts = replace(
            UPRIGHT, magnet_mm=torch.tensor([[[0.0, 0, depth], [5.0, 0, 2.5]]]).double()
        )
        found = flat.unsealed_mm(SPEC, layouts, pockets_of(SPEC, layouts)).item()
        assert wall == 1.0
        assert abs(found - missing) < (SLACK_MM + 1e-4 if missing else 1e-9)


def test_pockets_keep_off_the_edge_by_as_much_as_their_depth():
    """Of face 1, the smallest half extent of any face counts: 21 − 3 (depth) − 3 (radius) = 15 mm."""
    halves = np.min([frame.half_extents_mm for frame in face_frames(SPEC)], axis=0)
    for beyond, axis in ((0.5, 0), (0.5, 1), (-0.5, 0)):
        place = np.zeros(2)
        place[axis] = halves[axis] - 6.0 + beyond
        magnets = torch.tensor([[[*place, 2.5], [0.0, 0.0, 2.5]]]).double()
        layouts = replace(UPRIGHT, magnet_mm=magnets)
        found = flat.past_edges(SPEC, pockets_of(SPEC, layouts)).item()
        assert abs(found - max(beyond, 0.0)) < (SLACK_MM + 1e-3 if beyond > 0 else 1e-9)


def beside_hole_by_hand(place, wall):
    """What a recess lacks of the wall round the hole, or of holding the middle: by strewn points."""
    core, sensors = SPEC.core, SPEC.sensors
    azimuth = np.arctan2(place[1], place[0])
    radial = np.array([np.cos(azimuth), np.sin(azimuth)])
    across = np.array([-radial[1], radial[0]])
    inner, outer = core.recess_inner_radius_mm, core.recess_outer_radius_mm
    first = np.linalg.norm(place) - sensors.radius_mm
    along = np.linspace(first + inner, first + outer, 401)
    aside = np.linspace(-core.recess_width_mm / 2, core.recess_width_mm / 2, 401)
    border = np.concatenate(
        [along[:, None] * radial + end * across for end in (aside[0], aside[-1])]
        + [end * radial + aside[:, None] * across for end in (along[0], along[-1])]
    )
    away = np.linalg.norm(border, axis=1).min()
    if along[0] < 0 < along[-1]:
        away = -away
    return min(max(wall - away, 0), max(away + SLACK_MM, 0))


def test_a_recess_holds_the_middle_or_leaves_a_wall_round_the_wire_hole():
    """Places at oblique azimuths: on the hole, beside it, round the middle and far away."""
    wall = parts.passage_radius_mm(SPEC) + SPEC.printer.wall_mm + SLACK_MM
    places = [
        radius * np.array([np.cos(azimuth), np.sin(azimuth)])
        for radius in (2.0, 4.0, 5.0, 6.0, 7.0, 14.0)
        for azimuth in (0.5, 2.0, -2.8)
    ]
    wanted = [beside_hole_by_hand(place, wall) for place in places]
    assert sum(value > 0.01 for value in wanted) > 5
    for place, one in zip(places, wanted, strict=True):
        layouts = moved(sensor_mm=[[place.tolist()]])
        found = parts.boards_beside_hole_mm(SPEC, boards_of(SPEC, layouts))
        assert_allclose(float(found[0]), one, atol=0.01)
    both = moved(sensor_mm=[[places[0].tolist(), places[6].tolist()]])
    found = parts.boards_beside_hole_mm(SPEC, boards_of(SPEC, both))
    assert_allclose(float(found[0]), wanted[0] + wanted[6], atol=0.02)


def test_boards_past_the_edge_by_hand():
    """At 45° a board reaches as far along both axes; only what is beyond its limit counts."""
    place = 14.0 * np.array([1.0, 1.0]) / np.sqrt(2)
    found = flat.boards_past_edges(SPEC, boards_of(SPEC, moved(sensor_mm=[[place.tolist()]])))
    far = 14.0 - SPEC.sensors.radius_mm + SPEC.core.recess_outer_radius_mm
    corner = (far + SPEC.core.recess_width_mm / 2) / np.sqrt(2) + SLACK_MM
    half = np.min([frame.half_extents_mm for frame in face_frames(SPEC)], axis=0)
    limit = half - SPEC.shell.thickness_mm - SPEC.printer.wall_mm
    assert_allclose(float(found[0]), np.maximum(corner - limit, 0).sum(), rtol=1e-5)
    assert float(found[0]) > 0
