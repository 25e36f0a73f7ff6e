"""The picture of the parts: its depth buffer against hand-made triangles, and a whole figure."""

import numpy as np
import pytest
import trimesh
from numpy.testing import assert_allclose

from design.build.manifest import BuildManifest, PartManifest
from design.errors import InputError
from instobj.render.parts import VIEWS, draw_parts
from instobj.render.raster import camera_axes, depth_image


def write_build(folder):
    """Stand-in parts: boxes, as binary STL, and their manifest."""
    parts = []
    for view in VIEWS.values():
        if view.part == "mould_half_a":
            continue
        mesh = trimesh.creation.box(bounds=[(-4, -5, -6), (4, 5, 6)])
        mesh.export(folder / f"{view.part}.stl")
        box = ((-4.0, -5.0, -6.0), (4.0, 5.0, 6.0))
        parts.append(PartManifest(view.part, 960.0, box, (0.0, 0.0, 0.0), 6, 1, 960.0, True, 12))
    BuildManifest("boxes", "0" * 64, tuple(parts), {}).write(folder)


def test_the_nearest_triangle_wins_whatever_the_order():
    square = np.array([[[0, 0, 0], [4, 0, 0], [4, 4, 0]], [[0, 0, 0], [4, 4, 0], [0, 4, 0]]], float)
    near = np.array([[[1, 1, 2], [3, 1, 2], [1, 3, 2]]], float)
    for triangles, top in (
        (np.concatenate([square, near]), 2),
        (np.concatenate([near, square]), 0),
    ):
        image = depth_image(triangles)
        rows, columns = image.triangle.shape
        pixel = (image.extent_mm[1] - image.extent_mm[0]) / columns
        assert_allclose((image.triangle == top).sum() * pixel**2, 2, rtol=0.02)
        assert_allclose((image.triangle >= 0).sum() * pixel**2, 16, rtol=0.02)
        assert_allclose(image.depth_mm[image.triangle == top], 2, rtol=0, atol=1e-9)
        # Row 0 is the top of the picture: the near triangle lies below and left of the middle.
        seen = np.argwhere(image.triangle == top).mean(axis=0)
        assert seen[0] > rows / 2
        assert seen[1] < columns / 2


def test_triangles_that_face_away_are_not_drawn():
    away = np.array([[[0, 0, 0], [0, 4, 0], [4, 0, 0]]], float)
    assert (depth_image(away).triangle < 0).all()


def test_the_camera_is_right_handed_and_upright():
    camera = camera_axes((1, -1.25, 1), (0, 0, 1))
    assert_allclose(camera @ camera.T, np.eye(3), rtol=0, atol=1e-12)
    assert_allclose(np.linalg.det(camera), 1, rtol=1e-12)
    assert camera[1, 2] > 0
    # Seen from (+x, −y), the x axis points right.
    assert camera[0, 0] > 0


def test_a_figure_is_drawn_and_shows_all_six_parts(tmp_path, monkeypatch):
    monkeypatch.setattr("instobj.figures.saving.DPI", 120)
    from matplotlib.image import imread

    write_build(tmp_path)
    png = draw_parts(tmp_path / "manifest.json", tmp_path / "parts.png")
    picture = imread(png)[..., :3]
    assert min(picture.shape[:2]) > 1000
    for row in np.array_split(picture, 2, axis=0):
        for part in np.array_split(row, 3, axis=1):
            assert (part.min(axis=-1) < 0.9).mean() > 0.2


def test_the_shell_is_cut_open(tmp_path):
    from matplotlib.image import imread

    write_build(tmp_path)
    picture = imread(draw_parts(tmp_path, tmp_path / "parts.png"))[..., :3]
    red, green, blue = np.moveaxis(picture, -1, 0)
    cut = (red > 1.7 * green) & (red > 1.7 * blue) & (red > 0.2)
    rows, columns = np.nonzero(cut)
    assert cut.mean() > 0.01
    assert rows.max() < picture.shape[0] / 2
    assert columns.min() > picture.shape[1] / 3
    assert columns.max() < picture.shape[1] * 2 / 3


def test_a_missing_part_is_named(tmp_path):
    write_build(tmp_path)
    (tmp_path / "mould_plug.stl").unlink()
    with pytest.raises(InputError, match=r"no part at .*mould_plug\.stl"):
        draw_parts(tmp_path, tmp_path / "parts.png")
    assert not (tmp_path / "parts.png").exists()
