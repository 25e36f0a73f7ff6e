"""Maps tell the truth: places, turns, colours, numbers and limits."""

import numpy as np
import pytest
from matplotlib import colormaps
from matplotlib.figure import Figure
from matplotlib.image import imread
from numpy.testing import assert_allclose

from design.errors import InputError
from design.layout.body import face_frames
from design.layout.places.contact_grid import contact_grid
from design.layout.places.coverage import covered_shares
from design.spec.object import ObjectSpec
from instobj.figures import saving
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


def test_numbers_stand_on_their_places_and_blanks_are_marked():
    figure = Figure()
    axes = figure.add_subplot()
    values = VALUES.copy()
    values[37] = np.inf
    scale = map_scale("mm", 0.1, 90.0, log=True)
    pose = overview.net_pose(SPEC, 4)
    heatmaps.draw_ground(axes, SPEC, 4, pose)
    heatmaps.draw_values(axes, values, SPEC, 4, scale, pose, 0.1)
    stroke, numbers = axes.collections[-2:]
    assert_allclose(stroke.get_offsets(), numbers.get_offsets())
    assert numbers.get_paths()[37] is heatmaps.outline_of("∞")
    assert numbers.get_paths()[99] is heatmaps.outline_of("90")
    assert numbers.get_paths()[0] is heatmaps.outline_of("0.10")
    places = np.asarray(numbers.get_offsets())
    assert_allclose(places, pose.apply(contact_grid(SPEC).xy_mm))
    # face 4: x of the face points up in the net and y to the left
    assert places[99, 0] < places[0, 0]
    assert places[99, 1] > places[0, 1]


def test_outlines_of_numbers_are_centred_and_as_high_as_their_font():
    box = heatmaps.outline_of("0.12").get_extents()
    assert_allclose([box.x0 + box.x1, box.y0 + box.y1], 0, atol=1e-12)
    assert_allclose(box.height, 0.73, atol=0.03)
    assert_allclose(box.width, 2.1, atol=0.2)


ONE_LARGE = np.full(100, 1.0)
ONE_LARGE[3 * 10 + 8] = 5.0


def drawn_as_a_whole(values, scale, path):
    """The picture of face 3 by one figure, as matplotlib draws it."""
    figure = Figure(figsize=heatmaps.PICTURE_INCHES, facecolor=heatmaps.PAPER)
    places = heatmaps.MAP_INCHES, heatmaps.BAR_INCHES
    axes, bar = (figure.add_axes(heatmaps.picture_share(inches)) for inches in places)
    pose, half = heatmaps.Pose(0.0, (0.0, 0.0)), np.array(heatmaps.half_mm(SPEC, 3))
    heatmaps.draw_ground(axes, SPEC, 3, pose)
    inches = (4.6 / half).min() / 2
    mesh, *_ = heatmaps.draw_values(axes, values, SPEC, 3, scale, pose, inches)
    x, y = half + 0.5
    axes.set(xlim=(-x, x), ylim=(-y, y), aspect="equal")
    axes.set(xlabel="x of face 3 (mm)", ylabel="y of face 3 (mm)")
    covered = f"{100 * covered_shares(SPEC)[2]:.0f} % covered"
    axes.set_title(f"bound\nface 3 (+x), seen from outside; {covered}", fontsize=11, y=1.0)
    axes.spines[["top", "right"]].set_visible(False)
    axes.set_facecolor(heatmaps.PAPER)
    heatmaps.set_plain_ticks(figure.colorbar(mesh, cax=bar, label=scale.label), scale)
    handles = heatmaps.legend_handles()
    figure.legend(handles=handles, loc="lower center", ncols=2, frameon=False, fontsize=9)
    figure.savefig(path, dpi=saving.DPI)


@pytest.fixture(scope="module")
def pictures(tmp_path_factory):
    """Of one face in turn: a score, another on another scale, the first again."""
    folder, maps = tmp_path_factory.mktemp("faces"), heatmaps.FaceMaps(SPEC)
    plain, wide = map_scale("mm", 1.0, 5.0), map_scale("mm", 0.1, 90.0, log=True)
    maps.draw(ONE_LARGE, 3, "bound", plain, folder / "first.png")
    maps.draw(VALUES, 3, "bound", wide, folder / "wide.png")
    maps.draw(ONE_LARGE, 3, "bound", plain, folder / "again.png")
    drawn_as_a_whole(VALUES, wide, folder / "whole.png")
    return folder


def test_pictures_made_of_shared_layers_are_those_drawn_as_a_whole(pictures):
    whole = imread(pictures / "whole.png")[..., :3]
    np.testing.assert_array_equal(imread(pictures / "wide.png")[..., :3], whole)
    assert (pictures / "again.png").read_bytes() == (pictures / "first.png").read_bytes()


def test_cell_colours_follow_the_values_on_the_saved_picture(pictures):
    picture = imread(pictures / "first.png")[..., :3]
    dark = np.asarray(colormaps["magma_r"](1.0)[:3])
    rows, columns = np.nonzero(np.abs(picture - dark).max(axis=2) < 0.02)
    pale = np.abs(picture - colormaps["magma_r"](0.0)[:3]).max(axis=2) < 0.02
    grid_rows, grid_columns = np.nonzero(pale[:, : int(0.8 * pale.shape[1])])
    inside = (columns >= grid_columns.min()) & (columns <= grid_columns.max())
    inside &= (rows >= grid_rows.min()) & (rows <= grid_rows.max())
    assert inside.sum() > 300
    across = (np.median(columns[inside]) - grid_columns.min()) / np.ptp(grid_columns)
    down = (np.median(rows[inside]) - grid_rows.min()) / np.ptp(grid_rows)
    assert_allclose([across, down], [0.35, 0.15], atol=0.03)


def test_pictures_are_written_whole(tmp_path, monkeypatch):
    monkeypatch.setattr("instobj.figures.saving.DPI", 120)
    values = np.tile(VALUES, (5, 1)) * np.arange(1, 6)[:, None] * 1e15
    low, high = finite_limits(values)
    path, faces = tmp_path / "a.png", np.arange(1, 6)
    overview.draw_overview(values, faces, SPEC, "δ", "counts", low, high, path, note="two\nlines")
    assert imread(path).shape[0] > 1000
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


def test_what_no_contact_location_covers_is_hatched(pictures):
    picture = imread(pictures / "first.png")[..., :3]
    pale = np.abs(picture - colormaps["magma_r"](0.0)[:3]).max(axis=2) < 0.02
    rows, columns = np.nonzero(pale[:, : int(0.8 * pale.shape[1])])
    pitch = np.ptp(columns) / 10
    beside = slice(int(columns.min() - 1.5 * pitch), int(columns.min() - 0.5 * pitch))
    strip = picture[rows.min() : rows.max(), beside].mean(axis=2)
    lines = (strip < strip.max() - 0.1).mean()
    assert 0.05 < lines < 0.5
