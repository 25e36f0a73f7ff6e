"""Overview pictures of every body: nothing lies on a map."""

from itertools import combinations, pairwise
from pathlib import Path

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from numpy.testing import assert_allclose

from design.layout.body import face_frames
from design.layout.places.contact_grid import contact_grid
from design.spec_io import load_spec, parse_spec
from instobj.figures.maps import overview

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


@pytest.fixture(scope="module", params=["paper_cube", "handle", "pear", "box", "one face"])
def drawn(request, tmp_path_factory):
    """The specification, and its overview as a figure that was drawn."""
    spec = spec_of(request.param)
    shape = len(spec.body.sensed), len(contact_grid(spec))
    values = np.linspace(0.012, 1234.0, shape[0] * shape[1]).reshape(shape)
    path = tmp_path_factory.mktemp("overview") / "a.png"
    title = "How well a contact of 8 N can be located at best"
    face_map = overview.FaceMap(title, "mm", values, note=CAPTION)
    figure = overview.draw_overview(spec, face_map, path)
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
