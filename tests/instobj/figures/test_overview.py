"""Overview pictures of every body: nothing lies on a map, and numbers keep to their cells."""

from itertools import combinations, pairwise
from pathlib import Path

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from numpy.testing import assert_allclose

from design.layout.body import face_frame, face_frames
from design.layout.places.contact_grid import contact_grid
from design.spec_io import load_spec, parse_spec
from instobj.figures.maps import heatmaps, overview
from instobj.figures.maps.scale import map_scale

EXAMPLES = Path(__file__).parents[3] / "examples"
CAPTION = (
    "Cramér–Rao bound √(σx² + σy²) from each face's own sensors, freshly zeroed. Weakest: 12.34 mm on "
    "face 3 at (-10.5, 13.5) mm. ∞: blind, along the line."
)
FLAT_BOX = {
    "name": "box",
    "body": {"size_mm": [60, 40, 30]},
    "core": {"recess_inner_radius_mm": 2.5, "recess_outer_radius_mm": 6.5},
    "sensors": {"positions_mm": [[0, 3]], "radius_mm": 4.4, "package_mm": [6.6, 4.0, 1.6]},
    "magnets": {"positions_mm": [[0, 0]]},
    "contact_grid": {"count": [6, 6], "pitch_mm": 3.0},
}


def spec_of(name):
    if name == "box":
        return parse_spec(FLAT_BOX, "box")
    if name == "one face":
        return parse_spec({"name": "skin", "body": {"sensed_faces": [1]}}, "skin")
    return load_spec(EXAMPLES / f"{name}.toml")


@pytest.fixture(
    scope="module", params=["paper_cube", "handle", "capsule", "pear", "box", "one face"]
)
def drawn(request, tmp_path_factory):
    """The specification, and its overview as a figure that was drawn."""
    spec = spec_of(request.param)
    faces = np.array(spec.body.sensed)
    places = len(contact_grid(spec))
    values = np.linspace(0.012, 1234.0, len(faces) * places).reshape(len(faces), places)
    path = tmp_path_factory.mktemp("overview") / "a.png"
    title = "How well a contact of 8 N can be located at best"
    figure = overview.draw_overview(
        values, faces, spec, title, "mm", 0.012, 1234.0, path, note=CAPTION
    )
    FigureCanvasAgg(figure).draw()
    return spec, figure


def test_numbers_of_the_scale_keep_apart(drawn):
    """From 0.005 to 50 they ran into each other."""
    _, figure = drawn
    shown = [text for text in figure.axes[1].get_xticklabels() if text.get_text()]
    ends = [text.get_window_extent() for text in shown]
    low, high = figure.axes[1].get_window_extent().intervalx
    on_bar = sorted(
        (end.x0, end.x1) for end in ends if low - 1 <= (end.x0 + end.x1) / 2 <= high + 1
    )
    assert len(on_bar) >= 3
    assert all(right < left - 2 for (_, right), (left, _) in pairwise(on_bar))


def boxes_of(spec, figure):
    """Name → corners in pixels of every map and of all that stands beside the maps."""
    net, slot = figure.axes
    renderer = figure.canvas.get_renderer()
    maps = {
        f"map {number}": patch.get_window_extent(renderer)
        for number, patch in zip(spec.body.sensed, outlines(net), strict=True)
    }
    beside = {"scale": slot.get_tightbbox(renderer)}
    beside["legend"] = figure.legends[0].get_window_extent(renderer)
    beside |= {text.get_text()[:20]: text.get_window_extent(renderer) for text in figure.texts}
    names = [text for text in net.texts if text.get_text().startswith("face ")]
    beside |= {text.get_text(): text.get_window_extent(renderer) for text in names}
    return maps | beside


def outlines(net):
    return [patch for patch in net.patches if patch.get_zorder() == 1]


def test_nothing_lies_on_a_map_and_all_is_within_the_picture(drawn):
    spec, figure = drawn
    boxes = boxes_of(spec, figure)
    assert len(boxes) == 2 * len(spec.body.sensed) + 4
    for (one, box), (other, second) in combinations(boxes.items(), 2):
        assert not box.overlaps(second), f"{one} lies on {other}"
    width, height = figure.get_size_inches() * figure.dpi
    for name, box in boxes.items():
        assert min(box.x0, box.y0) >= 0, name
        assert box.x1 <= width, name
        assert box.y1 <= height, name


def numbers_of(axes):
    """Each face's numbers, without the strokes under them."""
    return [one for one in axes.collections if one.get_zorder() == 6][1::2]


def widths_px(numbers):
    scale = numbers.get_transform()
    return [path.get_extents(scale).width for path in numbers.get_paths()]


def test_numbers_are_narrower_than_their_cells_and_can_be_read_or_are_left_out(drawn):
    """In the report, where the picture is 780 px wide, from 5 px on."""
    spec, figure = drawn
    net = figure.axes[0]
    numbers = numbers_of(net)
    assert bool(numbers) is (spec.name not in ("paper_cube", "box", "handle", "capsule", "pear"))
    if not numbers:
        return
    fonts_px = [number.get_transform().get_matrix()[0, 0] for number in numbers]
    assert min(fonts_px) / figure.dpi / figure.get_size_inches()[0] * 780 >= 5
    places = sum(len(number.get_paths()) for number in numbers)
    assert places == len(spec.body.sensed) * len(contact_grid(spec))
    ends = net.transData.transform([[0.0, 0.0], [spec.contact_grid.pitch_mm, 0.0]])
    cell = np.ptp(ends[:, 0])
    widths = [width for number in numbers for width in widths_px(number)]
    assert max(widths) < cell
    assert max(widths) > 0.5 * cell, "as large as they may be"


def test_face_6_joins_face_4_point_for_point():
    spec = parse_spec(FLAT_BOX | {"body": {"size_mm": [60, 40, 30], "open_faces": []}}, "closed")
    frames = {frame.number: frame for frame in face_frames(spec)}
    frame, pose = frames[6], overview.net_pose(spec, 6)
    side, side_pose = frames[4], overview.net_pose(spec, 4)
    half_x, half_y = frame.half_extents_mm
    for share in (-0.8, 0.5):
        on_edge = np.array([share * half_x, -half_y])
        in_object = frame.to_object(np.append(on_edge, 0.0))
        on_side = side.from_object(in_object)
        assert_allclose(on_side[2], 0, atol=1e-9)
        apart = pose.apply(on_edge) - side_pose.apply(on_side[:2])
        assert_allclose(apart, [0, overview.GAP_MM], atol=1e-9)


def test_a_map_of_one_face_keeps_its_numbers_in_their_cells(tmp_path, monkeypatch):
    spec, kept = spec_of("box"), []

    def measure(canvas, path):
        axes = canvas.figure.axes[0]
        (numbers,) = numbers_of(axes)
        cell = np.ptp(axes.transData.transform([[0, 0], [3.0, 0]])[:, 0])
        kept.append((max(widths_px(numbers)), cell))

    monkeypatch.setattr(heatmaps, "save_drawn", measure)
    values = np.linspace(1000, 9000, len(contact_grid(spec)))
    heatmaps.FaceMaps(spec).draw(
        values, 1, "δ", map_scale("counts", 1000, 9000), tmp_path / "a.png"
    )
    ((width, cell),) = kept
    assert 0 < width < cell
    assert face_frame(spec, 1).number == 1
