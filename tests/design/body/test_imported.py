"""Bodies from files: STL and STEP, repaired with a warning or refused with the reason."""

import contextlib
import io
import warnings
from pathlib import Path

import cadquery as cq
import numpy as np
import pytest
import trimesh
from numpy.testing import assert_allclose

from design.body import sampled
from design.body.imported import body_of_file, read_surface, united_surface
from design.body.kinds.registry import KINDS
from design.body.meshes import manifold_of
from design.body.sampled import measured_distance_mm, sampled_core
from design.errors import InputError
from design.layout.body import body_of, core_frames, face_frames
from design.layout.places.positions import magnet_layout
from design.processes import ChildFailed
from design.solids import foreign
from design.solids.sampled import sampled_core_part, sampled_shell
from design.spec.object import ObjectSpec
from design.spec_io import load_spec, parse_spec

TEXT = """
name = "pebble"
[body]
kind = "imported"
file = "{file}"
sensed_faces = [1, 3]
[magnets]
positions_mm = [[0, 0]]
[sensors]
positions_mm = [[0, 0]]
radius_mm = 4.0
package_mm = [6.6, 6.0, 1.6]
[core]
wall_mm = 5.5
recess_inner_radius_mm = 1.0
recess_outer_radius_mm = 7.0
[contact_grid]
count = [3, 3]
pitch_mm = 3.0
"""
SIZE = (52.0, 46.0, 50.0)


def _pebble(subdivisions: int = 4) -> trimesh.Trimesh:
    """An ellipsoid off the origin."""
    surface = trimesh.creation.icosphere(subdivisions, 0.5)
    surface.apply_scale(SIZE / surface.extents)
    surface.apply_translation((7.0, -4.0, 2.0))
    return surface


def _load(folder: Path, name: str, **overrides: str):
    (folder / "pebble.toml").write_text(TEXT.format(file=name))
    return load_spec(folder / "pebble.toml", [f"{k}={v}" for k, v in overrides.items()])


def _read_here(arguments, *limits):
    """The reader without its process, which costs 2 s and has tests of its own (test_foreign.py)."""
    with contextlib.redirect_stderr(io.StringIO()) as said:
        code = foreign.main(*arguments[-2:])
    if code:
        raise ChildFailed(said.getvalue().strip())


@pytest.fixture(scope="module", autouse=True)
def _no_process():
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("design.body.foreign.run_child", _read_here)
        yield


@pytest.fixture(scope="module")
def pebble(tmp_path_factory):
    folder = tmp_path_factory.mktemp("pebble")
    _pebble().export(folder / "pebble.stl")
    return _load(folder, "pebble.stl")


def test_the_size_is_that_of_the_file_and_the_body_is_centred(pebble):
    assert_allclose(pebble.body.size_mm, SIZE, rtol=1e-5)
    top, side = face_frames(pebble)
    assert_allclose(top.centre_mm, [0, 0, 25], rtol=0, atol=0.05)
    assert_allclose(side.centre_mm, [26, 0, 0], rtol=0, atol=0.05)


def test_magnets_stand_normal_to_the_sampled_surface(pebble):
    axis = magnet_layout(pebble).axis
    assert_allclose(axis, [[0, 0, 1], [1, 0, 0]], rtol=0, atol=0.01)
    inner = core_frames(pebble)[0]
    assert_allclose(inner.centre_mm, [0, 0, 17], rtol=0, atol=0.06)


def test_the_wall_measures_its_thickness_and_the_parts_are_closed(pebble):
    body = body_of(pebble)
    wall = -measured_distance_mm(body.outer_surface(), np.asarray(sampled_core(body).vertices))
    assert 7.9 < wall.min() <= wall.max() < 8.1
    for part in (sampled_shell(pebble), sampled_core_part(pebble)):
        assert part.is_watertight
        assert part.volume > 5000


def test_a_step_file_gives_the_same_body(tmp_path):
    solid = cq.Workplane().box(40, 44, 48).edges().fillet(16).val()
    solid.exportStep(str(tmp_path / "brick.step"))
    spec = _load(tmp_path, "brick.step")
    assert_allclose(spec.body.size_mm, (40, 44, 48), rtol=0, atol=0.05)


def _holed(surface: trimesh.Trimesh) -> trimesh.Trimesh:
    surface.update_faces(np.arange(len(surface.faces)) != 5)
    return surface


def _halved(surface: trimesh.Trimesh) -> trimesh.Trimesh:
    surface.update_faces(surface.triangles_center[:, 2] < surface.centroid[2])
    return surface


def _inverted(surface: trimesh.Trimesh) -> trimesh.Trimesh:
    surface.invert()
    return surface


def _some_inverted(surface: trimesh.Trimesh) -> trimesh.Trimesh:
    surface.faces[3:40] = surface.faces[3:40, ::-1]
    return surface


def _crossing(surface: trimesh.Trimesh) -> trimesh.Trimesh:
    """One closed surface that runs through itself: its top is pushed out at the bottom."""
    points = surface.vertices - surface.bounds.mean(axis=0)
    points[:, 2] = np.where(points[:, 2] > 10, 10 - 3 * (points[:, 2] - 10), points[:, 2])
    return trimesh.Trimesh(points, surface.faces)


def _dented(surface: trimesh.Trimesh) -> trimesh.Trimesh:
    """The same on a small part: one corner is pushed through to the other side (0.1 % of volume)."""
    surface.vertices[surface.vertices[:, 2].argmax(), 2] -= SIZE[2] + 3.0
    return surface


def _moved(surface: trimesh.Trimesh, x_mm: float) -> trimesh.Trimesh:
    return surface.copy().apply_translation((x_mm, 0, 0))


def _hollow(surface: trimesh.Trimesh) -> trimesh.Trimesh:
    inner = surface.copy().apply_transform(
        trimesh.transformations.scale_matrix(0.5, surface.centroid)
    )
    inner.invert()
    return surface + inner


def _finned(surface: trimesh.Trimesh) -> trimesh.Trimesh:
    """With a triangle that stands on an edge of the surface."""
    corners = np.vstack([surface.vertices, surface.vertices[surface.faces[7]].mean(axis=0) * 1.2])
    a, b, _ = surface.faces[7]
    return trimesh.Trimesh(corners, np.vstack([surface.faces, [a, b, len(corners) - 1]]))


def _jittered(surface: trimesh.Trimesh) -> trimesh.Trimesh:
    """Every triangle with corners of its own, up to 0.0007 mm from those of its neighbours."""
    corners = surface.triangles.reshape(-1, 3)
    moved = corners + np.random.default_rng(3).uniform(-2e-4, 2e-4, corners.shape)
    return trimesh.Trimesh(moved, np.arange(len(moved)).reshape(-1, 3), process=False)


def _apart(surface: trimesh.Trimesh) -> trimesh.Trimesh:
    """The same farther apart than corners are welded."""
    corners = surface.triangles.reshape(-1, 3)
    moved = corners + np.random.default_rng(3).uniform(-0.02, 0.02, corners.shape)
    return trimesh.Trimesh(moved, np.arange(len(moved)).reshape(-1, 3), process=False)


def _soup(_: trimesh.Trimesh) -> trimesh.Trimesh:
    corners = np.random.default_rng(0).uniform(0, 50, (300, 3))
    return trimesh.Trimesh(corners, np.arange(300).reshape(-1, 3), process=False)


def _with_stray(surface: trimesh.Trimesh) -> trimesh.Trimesh:
    """A single triangle within the body's box."""
    return surface + trimesh.Trimesh([[30, 15, 20], [32, 15, 20], [30, 17, 20]], [[0, 1, 2]])


def _beside_its_twin(surface: trimesh.Trimesh) -> trimesh.Trimesh:
    """Two boxes that share one edge."""
    box = trimesh.creation.box(surface.extents)
    return box + box.copy().apply_translation((*SIZE[:2], 0.0))


def _without_numbers(surface: trimesh.Trimesh) -> trimesh.Trimesh:
    surface.vertices[9] = np.nan
    return surface


def _with_crumbs(surface: trimesh.Trimesh) -> trimesh.Trimesh:
    crumb = trimesh.creation.icosphere(2, 1.0)
    void = crumb.copy()
    void.invert()
    return surface + crumb.copy().apply_translation((90.0, 0, 0)) + _moved(crumb, 99.0) + void


def _with_lid_over_a_dent(_: trimesh.Trimesh) -> trimesh.Trimesh:
    """A box with a dent 4 mm deep, and a lid that reaches 1 mm into it: a void 3 mm high is left."""
    box, dent = trimesh.creation.box((52, 46, 48)), trimesh.creation.box((2, 2, 4))
    dent.apply_translation((0, 0, 22))
    lid = trimesh.creation.box((30, 30, 3)).apply_translation((0, 0, 24.5))
    return box.difference(dent) + lid


def _with_plate(surface: trimesh.Trimesh) -> trimesh.Trimesh:
    """A plate apart from the body and as long, with 0.2 % of its volume."""
    return surface + trimesh.creation.box((50, 30, 0.1)).apply_translation((7, -4, 40))


def _with_many_crumbs(surface: trimesh.Trimesh) -> trimesh.Trimesh:
    """Twelve crumbs of 0.1 % of the body each."""
    crumb = trimesh.creation.box((4, 4, 4))
    for i in range(12):
        surface = surface + _moved(crumb, 90 + 10 * i)
    return surface


def _written(folder: Path, change, **options) -> Path:
    change(_pebble(3)).export(folder / "body.stl", **options)
    return folder / "body.stl"


@pytest.mark.parametrize(
    ("change", "told"),
    [
        pytest.param(_holed, "closed small holes with 1 triangles", id="a small hole"),
        pytest.param(_inverted, "turned triangles outwards", id="inside out"),
        pytest.param(_some_inverted, "turned triangles outwards", id="some triangles inverted"),
        pytest.param(_jittered, r"welded \d+ corners within 0\.001 mm", id="corners apart"),
        pytest.param(
            _with_stray, "left out 1 flat piece, which encloses nothing", id="a stray triangle"
        ),
        pytest.param(
            _with_crumbs,
            "left out 2 crumbs of up to 2 mm and filled 1 void of up to 2 mm$",
            id="crumbs of a scan",
        ),
        pytest.param(
            lambda one: one + trimesh.creation.box((1, 1, 1)).apply_translation((90, 0, 0)),
            "left out 1 crumb of up to 1 mm$",
            id="one crumb",
        ),
    ],
)
def test_what_can_be_repaired_is_with_a_warning(tmp_path, change, told):
    with pytest.warns(UserWarning, match=told):
        found = body_of_file(_written(tmp_path, change))
    assert_allclose(found["size_mm"], SIZE, rtol=1e-5)


def test_a_wide_hole_is_closed_flat(tmp_path):
    """A ball that stood on a table: a cap 2.5 mm high is gone, its hole 24 mm wide."""
    ball = trimesh.creation.icosphere(4, 30)
    ball.update_faces(ball.triangles[:, :, 2].max(axis=1) > -27.5)
    ball.export(tmp_path / "ball.stl")
    with pytest.warns(
        UserWarning, match=r"closed small holes with \d+ triangles, up to 2\d mm wide"
    ):
        closed = read_surface(str(tmp_path / "ball.stl"))
    assert closed.is_watertight
    assert closed.is_winding_consistent
    cap = np.pi * 2.5**2 * (30 - 2.5 / 3)
    assert closed.volume == pytest.approx(4 / 3 * np.pi * 30**3 - cap, rel=5e-3)
    assert closed.extents[2] == pytest.approx(57.5, abs=1.0)


def test_a_scan_that_crosses_itself_a_little_is_drawn_again(tmp_path):
    """Some corners of a pebble are pushed past their neighbours, as where triangles were left out."""
    scan = _pebble(4)
    volume = scan.volume
    _crossed(scan, 3).export(tmp_path / "scan.stl")
    with pytest.warns(
        UserWarning, match=r"drawn again on a grid of 0\.\d+ mm, as it crosses itself"
    ):
        drawn = read_surface(str(tmp_path / "scan.stl"))
    assert drawn.is_watertight
    assert drawn.volume == pytest.approx(volume, rel=0.01)
    assert_allclose(drawn.extents, SIZE, atol=0.3)


def _crossed(surface: trimesh.Trimesh, share: float) -> trimesh.Trimesh:
    """Some corners are pushed past their neighbours, by that many of their distances."""
    for corner in range(0, 2000, 250):
        near = surface.vertices[surface.vertex_neighbors[corner]]
        step = share * (near[0] - near.mean(axis=0)) - surface.vertex_normals[corner] / 2
        surface.vertices[corner] += step
    return surface


@pytest.mark.parametrize("radius_mm", [0.25, 6.0])
def test_two_balls_on_a_bar_are_kept_whole_or_refused(tmp_path, radius_mm):
    """Nothing would be left of a bar thinner than the grid's step, 1.2 mm."""
    bar = trimesh.creation.cylinder(radius_mm, 120, sections=32)
    bar.apply_transform(trimesh.transformations.rotation_matrix(np.pi / 2, [0, 1, 0]))
    ball = trimesh.creation.icosphere(4, 25.0)
    bar.apply_translation((0.0, 0.6, 0.6))  # between the grid's points
    balls = trimesh.boolean.union([_moved(ball, -60.0), bar, _moved(ball, 60.0)])
    path, volume = tmp_path / "balls.stl", balls.volume
    _crossed(balls, 3).export(path)
    if radius_mm < 1:
        with pytest.raises(InputError, match=r"crosses itself .* it is 2 pieces, not one closed"):
            body_of_file(path)
        return
    with pytest.warns(UserWarning, match=r"drawn again .*; it lies up to 0\.\d+ mm off the file$"):
        drawn = read_surface(str(path))
    assert drawn.volume == pytest.approx(volume, rel=0.01)


def test_a_lost_limb_is_refused(tmp_path):
    """A needle of Ø 0.5 mm that stands out by 15 mm."""
    needle = trimesh.creation.cylinder(0.25, 30).apply_translation((0.4, 0.4, 25))
    body = trimesh.boolean.union([trimesh.creation.icosphere(4, 25.0), needle])
    _crossed(body, 3).export(tmp_path / "body.stl")
    with pytest.raises(InputError, match=r"crosses itself .* its box loses [\d.]+ mm on a side"):
        body_of_file(tmp_path / "body.stl")


def test_a_file_is_mended_alike_at_all_scales(tmp_path):
    """It crosses itself deeper than is left as it is, but at a quarter of its size less deep."""
    scan, surfaces = _crossed(_pebble(4), 3), []
    for name, scale in (("a.stl", 1.0), ("b.stl", 0.25)):
        scan.export(tmp_path / name)
        with pytest.warns(UserWarning, match="drawn again"):
            surfaces.append(read_surface(str(tmp_path / name), scale))
    assert_allclose(surfaces[1].vertices, 0.25 * surfaces[0].vertices, rtol=0, atol=1e-9)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        read_surface(str(tmp_path / "b.stl"), 2.0)


def test_a_file_that_is_overwritten_is_another_body(tmp_path):
    """Box and name stay the same."""
    volumes = []
    for power in (1.0, 0.8):
        body = _pebble(3)
        points = body.vertices - body.bounds.mean(axis=0)
        body.vertices = np.sign(points) * abs(points) ** power
        body.apply_scale(np.asarray(SIZE) / body.extents)
        body.export(tmp_path / "pebble.stl")
        volumes.append(body_of(_load(tmp_path, "pebble.stl")).volume_mm3())
    assert volumes[1] > 1.05 * volumes[0]


def test_a_ragged_hole_is_closed(tmp_path):
    """Corners of this border lie in no plane: VTK at first leaves a hole of four."""
    ball = trimesh.creation.icosphere(3, 30)
    noise = np.random.default_rng(2).normal(0, 1, (len(ball.vertices), 1))
    ball.vertices += noise * ball.vertex_normals
    middles = ball.triangles_center
    ball.update_faces(np.linalg.norm(middles - middles[485], axis=1) > 7)
    ball.export(tmp_path / "ball.stl")
    with pytest.warns(UserWarning, match="closed small holes"):
        assert read_surface(str(tmp_path / "ball.stl")).is_watertight


def test_a_triangle_of_no_height_that_closes_a_side_is_no_hole(tmp_path):
    """One edge is split on one of its sides; its twin on the other side stays whole."""
    box = trimesh.creation.box(SIZE)
    a, b, c = box.faces[0]
    corners = np.vstack([box.vertices, box.vertices[[a, b]].mean(axis=0)])
    split = [[a, 8, c], [8, b, c], [a, b, 8]]
    closed = trimesh.Trimesh(corners, np.vstack([box.faces[1:], split]), process=False)
    assert closed.is_watertight
    closed.export(tmp_path / "body.stl")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        surface = read_surface(str(tmp_path / "body.stl"))
    assert surface.is_watertight
    assert surface.area_faces.min() > 1.0
    assert surface.volume == pytest.approx(np.prod(SIZE))


def test_pieces_that_overlap_are_united_with_a_warning(tmp_path):
    path = _written(tmp_path, lambda one: one + _moved(one, 30.0))
    with pytest.warns(UserWarning, match="united 2 pieces that overlap"):
        found = body_of_file(path)
    assert_allclose(found["size_mm"], (SIZE[0] + 30, *SIZE[1:]), rtol=1e-5)


def test_a_void_that_a_union_leaves_is_filled_and_the_pieces_are_united(tmp_path):
    path = _written(tmp_path, _with_lid_over_a_dent)
    with pytest.warns(
        UserWarning, match=r"filled 1 void of up to 3 mm and united 2 pieces that overlap"
    ):
        surface = read_surface(str(path))
    assert surface.volume == pytest.approx(52 * 46 * 48 + 30 * 30 * 2)


def test_a_piece_of_less_than_a_cubic_millimetre_is_united_too():
    grain = trimesh.creation.icosphere(1, 0.3)
    grain.apply_translation([30.0, 0.0, 0.0])
    box = trimesh.creation.box([60.0, 60.0, 60.0])
    united, _ = united_surface(box + grain, Path("a.stl"))
    assert united.body_count == 1
    assert united.volume == pytest.approx(60.0**3 + grain.volume / 2)


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        pytest.param(_halved, r"is open: \d+ edges have a triangle on one side", id="open"),
        pytest.param(_finned, r"is open: 2 edges .* 1 edges more than two", id="a fin"),
        pytest.param(lambda one: one + _moved(one, 99.0), "2 separate surfaces", id="two pieces"),
        pytest.param(_with_plate, "2 separate surfaces", id="a plate as long as the body"),
        pytest.param(_with_many_crumbs, "4 separate surfaces", id="too many crumbs"),
        pytest.param(_hollow, "2 separate surfaces.*without holes inside", id="a void inside"),
        pytest.param(_crossing, "crosses itself", id="crossing itself"),
        pytest.param(_dented, "crosses itself", id="crossing itself a little"),
        pytest.param(_soup, "is open: 300 edges have a triangle on one side", id="a soup"),
        pytest.param(_apart, r"is open: .* within 0\.001 mm count as one", id="corners far apart"),
        pytest.param(_beside_its_twin, "is closed, but meets itself: 1 edges", id="a common edge"),
        pytest.param(_without_numbers, "is open", id="a corner that is no number"),
    ],
)
def test_surfaces_that_enclose_no_single_body_are_refused(tmp_path, change, reason):
    path = _written(tmp_path, change)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)
        with pytest.raises(InputError, match=reason):
            body_of_file(path)


@pytest.mark.parametrize("kind", ["stl", "stl_ascii"])
def test_a_file_that_was_cut_off_is_refused(tmp_path, kind):
    path = _written(tmp_path, lambda one: one, file_type=kind)
    path.write_bytes(path.read_bytes()[: path.stat().st_size // 2])
    with pytest.raises(InputError, match=r"Export|is open"):
        body_of_file(path)


@pytest.mark.parametrize(
    ("name", "content"),
    [
        ("text.stl", b"solid of nothing"),
        ("empty.stl", b""),
        ("bytes.stl", bytes(range(256)) * 9),
        ("text.step", b"ISO-10303-21; end"),
        ("empty.step", b""),
        ("picture.png", b"no body at all"),
    ],
)
def test_corrupt_files_are_refused(tmp_path, name, content):
    (tmp_path / name).write_bytes(content)
    with pytest.raises(InputError, match="Export"):
        body_of_file(tmp_path / name)


def _step(folder: Path, *shapes: cq.Shape) -> Path:
    work = cq.Workplane().newObject(list(shapes))
    cq.exporters.export(work, str(folder / "body.step"))
    return folder / "body.step"


def _brick(x_mm: float = 0.0) -> cq.Shape:
    return cq.Solid.makeBox(40, 44, 48, cq.Vector(x_mm, 0, 0))


def test_two_solids_of_a_step_file_that_overlap_are_united(tmp_path):
    with pytest.warns(UserWarning, match="united 2 pieces"):
        found = body_of_file(_step(tmp_path, _brick(), _brick(25.0)))
    assert_allclose(found["size_mm"], (65, 44, 48), rtol=0, atol=1e-3)


@pytest.mark.parametrize(
    ("shapes", "reason"),
    [
        pytest.param((_brick(), _brick(60.0)), "2 separate surfaces", id="two solids"),
        pytest.param((_brick().Faces()[0],), "is open", id="a face"),
        pytest.param((_brick().Edges()[0],), "holds no solid", id="an edge"),
    ],
)
def test_step_files_without_one_solid_are_refused(tmp_path, shapes, reason):
    path = _step(tmp_path, *shapes)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", UserWarning)
        with pytest.raises(InputError, match=reason):
            body_of_file(path)


def test_a_missing_file_and_a_missing_name_are_told(tmp_path):
    with pytest.raises(InputError, match="no body at"):
        body_of_file(tmp_path / "nowhere.stl")
    with pytest.raises(InputError, match=r"goes with body\.kind = 'imported'"):
        parse_spec({"name": "a", "body": {"kind": "imported"}}, "test")


@pytest.mark.parametrize(
    ("factor", "overrides"),
    [
        (0.001, {"body.scale": "1000"}),
        pytest.param(1 / 25.4, {"body.scale": "25.4"}, marks=pytest.mark.slow),
        pytest.param(2.0, {"body.scale": "0.5"}, marks=pytest.mark.slow),
    ],
)
def test_a_body_in_another_unit_is_the_same_body(tmp_path, factor, overrides):
    scaled = _pebble()
    scaled.apply_scale(factor)
    scaled.export(tmp_path / "scaled.stl")
    spec = _load(tmp_path, "scaled.stl", **overrides)
    assert_allclose(spec.body.size_mm, SIZE, rtol=1e-3)
    assert_allclose(body_of(spec).outer_surface().extents, SIZE, rtol=1e-3)


@pytest.mark.parametrize(
    ("scale", "overrides", "reason"),
    [
        pytest.param(0.25, {}, "half the core|no room for a core", id="smaller than two walls"),
        pytest.param(0.42, {}, r"half the core is .* thick and must be more", id="no recesses"),
        pytest.param(
            0.001,
            {},
            r"5 to 1000 mm; got 0\.05\d* .* In which unit .* m: body\.scale = 1000",
            id="in metres",
        ),
        pytest.param(1.0, {"body.scale": "1e7"}, r"body\.scale", id="large"),
        pytest.param(
            0.7, {"magnets.positions_mm": "[[14, 0]]"}, "pocket outside face", id="pocket"
        ),
        pytest.param(
            0.7, {"sensors.positions_mm": "[[12, 0]]"}, "outside the core's patch", id="sensors"
        ),
        pytest.param(0.7, {"contact_grid.pitch_mm": "9.0"}, "leave face", id="contact locations"),
        pytest.param(0.7, {"body.bore_mm": "60.0"}, "below the core's width", id="bore"),
    ],
)
def test_bodies_too_small_for_their_parts_are_refused(tmp_path, scale, overrides, reason):
    small = _pebble(3)
    small.apply_scale(scale)
    small.export(tmp_path / "small.stl")
    with pytest.raises(InputError, match=reason):
        _load(tmp_path, "small.stl", **overrides)


@pytest.mark.parametrize("size_mm", [pytest.param(120.0, marks=pytest.mark.slow), 800.0])
def test_large_bodies_take_no_finer_grids_than_small_ones(tmp_path, monkeypatch, size_mm):
    """Work grew with the cube of the size; from 1 m on it did not end."""
    egg = trimesh.creation.icosphere(5, 0.5)
    egg.apply_scale((size_mm, 0.8 * size_mm, 0.7 * size_mm))
    egg.export(tmp_path / "pebble.stl")
    grids, grid = [], sampled.grid_points
    monkeypatch.setattr(
        sampled, "grid_points", lambda *given: grids.append(grid(*given)) or grids[-1]
    )
    spec = _load(tmp_path, "pebble.stl", **{"body.sensed_faces": "[1]"})
    body = body_of(spec)
    wall = -measured_distance_mm(body.outer_surface(), sampled_core(body).vertices)
    assert_allclose(wall, 8, rtol=0, atol=max(0.03, 2e-4 * size_mm))
    assert max(len(points) for points, _ in grids) < 140**3
    (frame,) = face_frames(spec)
    assert frame.relief.spline.get_coeffs().size <= 140**2


def test_a_patch_of_less_than_a_millimetre_is_a_patch(tmp_path):
    """Its spline had three nodes along that axis, and SciPy's own error was raised."""
    trimesh.creation.box((30.0, 25.0, 17.2)).export(tmp_path / "slab.stl")
    keys = body_of_file(tmp_path / "slab.stl")
    body = KINDS["imported"](tuple(keys["size_mm"]), 8.0, 0.1, file=keys["file"])
    reach_mm = min(body.core_frame(3).half_extents_mm)
    assert 0 < reach_mm < 0.6


def test_wire_holes_of_leaning_faces_are_open(tmp_path):
    """The core stands on beside the middle of a face that leans: at the hole's rim by 0.8 mm here."""
    surface = _pebble()
    surface.vertices[:, 0] += 0.4 * (surface.vertices[:, 2] - 2.0)
    surface.export(tmp_path / "leaning.stl")
    body = {"kind": "imported", **body_of_file(tmp_path / "leaning.stl"), "sensed_faces": [3]}
    sensors = {"positions_mm": [[0.0, 8.0]], "radius_mm": 4.0}
    core = {"recess_inner_radius_mm": 1.5, "recess_outer_radius_mm": 6.5}
    spec = ObjectSpec.model_validate(
        {"name": "leaning", "body": body, "sensors": sensors, "core": core}
    )
    (frame,) = core_frames(spec)
    way = trimesh.creation.cylinder(
        spec.core.wire_hole_side_diameter_mm / 2 - 0.05,
        segment=[0 * frame.normal, frame.centre_mm + 5 * frame.normal],
    )
    assert (manifold_of(way) ^ manifold_of(sampled_core_part(spec))).volume() < 0.01
