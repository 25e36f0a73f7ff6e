"""Maps tell the truth: places, turns, colours, numbers and limits."""

import numpy as np
import pytest
from matplotlib.figure import Figure
from matplotlib.image import imread
from numpy.testing import assert_allclose

from design.errors import InputError
from design.layout.body import face_frames
from design.layout.places.contact_grid import contact_grid
from design.spec.object import ObjectSpec
from instobj.figures.maps import heatmaps, overview
from instobj.figures.maps.scale import finite_limits, map_scale

SPEC = ObjectSpec.model_validate(
    {
        "name": "brick",
        "body": {"size_mm": (46.0, 44.0, 42.0)},
        "contact_grid": {"count": (10, 10)},
    }
)
VALUES = np.geomspace(0.1, 90.0, 100)


def test_net_joins_the_maps_along_the_object_s_edges():
    """The edge that a side face shares with face 1 lies beside it, point for point."""
    top = face_frames(SPEC)[0]
    for frame in face_frames(SPEC)[1:]:
        side = overview.net_pose(SPEC, frame.number)
        for share in (-0.8, 0.5):
            half_x, half_y = frame.half_extents_mm
            on_edge = np.array([-half_x, share * half_y])
            in_object = frame.to_object(np.append(on_edge, 0.0))
            on_top = top.from_object(in_object)
            assert_allclose(on_top[2], 0, atol=1e-9)
            apart = side.apply(on_edge) - on_top[:2]
            assert_allclose(np.linalg.norm(apart), overview.GAP_MM, rtol=1e-9)


def drawn_on_face_4(values):
    """Axes with face 4's map, which is turned by 90 degrees in the net, its pose and the mesh."""
    axes, pose = Figure().add_subplot(), overview.net_pose(SPEC, 4)
    scale = map_scale("mm", 0.1, 90.0, log=True)
    heatmaps.draw_ground(axes, SPEC, 4, pose)
    return axes, pose, heatmaps.draw_values(axes, values, SPEC, 4, scale, pose)


def test_every_value_colours_the_cell_of_its_place_and_what_is_not_finite_stays_blank():
    values = VALUES.copy()
    values[37] = np.inf
    axes, pose, mesh = drawn_on_face_4(values)
    corners = mesh.get_coordinates()
    centres = (corners[:-1, :-1] + corners[1:, 1:]) / 2
    on_net = (mesh.get_transform() - axes.transData).transform(centres.reshape(-1, 2))
    place = contact_grid(SPEC).xy_mm
    cells = np.ma.filled(mesh.get_array(), np.nan).ravel()
    order = [int(abs(on_net - at).sum(axis=1).argmin()) for at in pose.apply(place)]
    assert_allclose(on_net[order], pose.apply(place), atol=1e-9)
    assert_allclose(cells[order], np.where(np.isfinite(values), values, np.nan))
    # x of the face points up in the net and y to the left
    assert np.all(on_net[order][99] * [-1, 1] > on_net[order][0] * [-1, 1])


def test_what_no_contact_location_covers_is_hatched():
    axes, _, mesh = drawn_on_face_4(VALUES)
    border, *covered = axes.patches[: len(axes.patches) - 8]
    assert border.get_hatch()
    assert not any(patch.get_hatch() for patch in covered)
    area = sum(patch.get_width() * patch.get_height() for patch in covered)
    assert_allclose(area, 100 * SPEC.contact_grid.pitch_mm**2)
    assert_allclose(mesh.get_coordinates().reshape(-1, 2).max(axis=0), [15.0, 15.0])


def test_pictures_are_written_whole(tmp_path, monkeypatch):
    monkeypatch.setattr("instobj.figures.saving.DPI", 120)
    values = np.tile(VALUES, (5, 1)) * np.arange(1, 6)[:, None] * 1e15
    face_map = overview.FaceMap("δ", "counts", values, note="two\nlines")
    overview.draw_overview(SPEC, face_map, tmp_path / "a.png")
    assert imread(tmp_path / "a.png").shape[0] > 1000
    assert [file.name for file in tmp_path.iterdir()] == ["a.png"]


def test_scale_shows_large_numbers_with_a_power_of_ten():
    scale = map_scale("counts", 2e14, 3.1e16)
    assert scale.exponent == 16
    assert scale.label == "10$^{16}$ counts"
    assert_allclose([scale.norm.vmin, scale.norm.vmax], [0.02, 3.1])
    assert map_scale("mm", 0.1, 4.0).label == "mm"
    assert finite_limits(np.array([np.inf, 2.0, np.nan, 1.0])) == (1.0, 2.0)


def test_limits_that_cannot_be_drawn_are_refused():
    with pytest.raises(InputError, match="no value is finite"):
        finite_limits(np.array([np.inf, np.nan]))
    with pytest.raises(InputError, match="0 < vmin"):
        map_scale("mm", 0.0, 4.0, log=True)
    with pytest.raises(InputError, match="vmin ≤ vmax"):
        map_scale("mm", 5.0, 4.0)


def test_blind_directions_are_drawn_through_blind_places_only():
    figure = Figure()
    axes = figure.add_subplot()
    blind = np.zeros(100, bool)
    blind[[4, 37]] = True
    pose = overview.net_pose(SPEC, 4)
    overview.draw_directions(axes, SPEC, np.full(100, 30.0), blind, pose)
    (lines,) = axes.collections
    drawn = np.array(lines.get_segments())
    assert_allclose(drawn.mean(axis=1), pose.apply(contact_grid(SPEC).xy_mm[blind]))
    # face 4's map is turned by 90 degrees in the net
    along = drawn[:, 1] - drawn[:, 0]
    assert_allclose(np.rad2deg(np.arctan2(along[:, 1], along[:, 0])), 120.0)
