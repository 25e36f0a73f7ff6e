"""A whole press of the object with large deformation: what it reports, refuses and writes."""

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import InputError
from design.spec.object import MeshSpec, ObjectSpec
from fem.contact.complementarity import contact_pressures
from fem.large_strain import press as large_strain
from fem.large_strain.hyperelastic import neo_hookean, yeoh
from fem.large_strain.newton import StepDivergedError
from fem.large_strain.press import press_large_strain
from fem.large_strain.results import (
    LargeStrainPress,
    linearity_limits,
    save_large_strain_press,
)
from fem.large_strain.single_press import (
    linear_press,
    press_setting,
    require_modulus,
    require_press,
)
from fem.linear.response import build_response
from fem.mesh.tetrahedra import tetrahedralize_for_press
from fem.presses.shape import DeformedShape, save_deformed_shape
from fem.presses.table import press_face, profile_moments_mm3, surface_weights_mm2
from tests.support.mechanics.fem_cases import COARSE_EDGES_MM, paper_cube

SOFT = neo_hookean(0.3, 0.4999)


def made_up_press(linear_force_n, force_n, depth_mm=(0.5, 1.0, 2.0)):
    steps = len(depth_mm)
    corners = np.array([[0, 0, 0], [2, 0, 0], [0, 3, 0], [0, 0, 4.0]])
    edges = [(0, 1), (1, 2), (0, 2), (0, 3), (1, 3), (2, 3)]
    nodes = np.concatenate([corners, [corners[[a, b]].mean(axis=0) for a, b in edges]])
    magnet, pressure = np.array([-1]), nodes @ [1.0, 2.0, 3.0]
    shape = DeformedShape(nodes, np.arange(10)[None], magnet, 0.1 * nodes, pressure, 2 * pressure)
    motion = np.arange(12.0 * steps).reshape(steps, 2, 6)
    area = np.arange(1.0, steps + 1)
    return LargeStrainPress(
        3, 5.0, -4.0, SOFT, np.array(depth_mm), np.array(force_n), np.array(linear_force_n),
        area, area + 1, motion, -motion, "converged", shape, shape,
    )  # fmt: skip


@pytest.mark.parametrize(
    ("linear", "limits"),
    [
        ([1.02, 1.08, 1.10], (0.75, None)),  # 2, 8, 10 % too much: 5 % half way
        ([0.98, 0.92, 0.68], (0.75, 1.5)),  # 2, 8, 32 % too little: 20 % half way
        ([1.0, 1.0, 1.04], (None, None)),
        ([0.90, 0.90, 0.70], (0.25, 1.5)),  # 10 % at once: from agreement at depth 0
    ],
)
def test_limits_of_linearity_are_interpolated(linear, limits):
    found = linearity_limits(made_up_press(linear, [1.0, 1.0, 1.0]))
    for value, expected in zip(
        (found.five_percent_mm, found.twenty_percent_mm), limits, strict=True
    ):
        assert value == (None if expected is None else pytest.approx(expected, rel=1e-12))


def test_depths_without_contact_leave_the_limits_alone():
    press = made_up_press([0.0, 1.08, 1.10], [0.0, 1.0, 1.0])
    assert linearity_limits(press).five_percent_mm == pytest.approx(1.0 * 5 / 8)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"face": 6}, "face 6 is not sensed"),
        ({"x_mm": 16.3}, r"hangs over the border of face 2"),
        ({"y_mm": float("nan")}, r"hangs over the border"),
        ({"depths_mm": [1.0, 0.5]}, "depths must increase"),
        ({"depths_mm": []}, "depths must increase"),
        ({"depths_mm": [1.0, 5.0]}, r"stay below the tip's radius .*5 mm"),
        ({"material": neo_hookean(0.31, 0.4999)}, r"E = 0.31 MPa .* is 0.3"),
        ({"material": yeoh(0.06)}, r"yeoh constants give E = 0.36"),
    ],
)
def test_presses_that_make_no_sense_are_refused(rigid_spec, coarse_mesh, change, words):
    press = {"face": 2, "x_mm": 4.0, "y_mm": -6.0, "depths_mm": [0.5], "material": SOFT}
    with pytest.raises(InputError, match=words):
        press_large_strain(rigid_spec, coarse_mesh, **(press | change))


def test_the_saved_press_comes_back_with_units(tmp_path):
    import xarray as xr

    press = made_up_press([1.0, 2.0, 3.0], [1.1, 2.2, 3.3])
    save_large_strain_press(press, tmp_path / "press.nc")
    with xr.open_dataset(tmp_path / "press.nc", engine="h5netcdf") as data:
        for name in ("force_n", "linear_force_n", "contact_area_mm2", "motion", "linear_motion"):
            np.testing.assert_array_equal(data[name].values, getattr(press, name))
            assert data[name].attrs["units"]
        np.testing.assert_array_equal(data["depth_mm"].values, press.depth_mm)
        assert data.attrs["face"] == 3
        np.testing.assert_array_equal(data.attrs["xy_mm"], [5.0, -4.0])


def test_the_deformed_shape_is_written_deformed(tmp_path):
    """A tetrahedron of edges 2, 3, 4 blown up by 1.1: volume 4 · 1.331."""
    import pyvista

    press = made_up_press([1.0], [1.0], (1.0,))
    save_deformed_shape(press.shape, tmp_path / "deformed.vtu", press.motion[-1])
    grid = pyvista.read(tmp_path / "deformed.vtu")
    assert_allclose(grid.points, 1.1 * press.shape.nodes_mm, rtol=1e-6)
    assert_allclose(grid.point_data["displacement_mm"], press.shape.displacement_mm, rtol=1e-6)
    assert_allclose(grid.point_data["pressure_mpa"], press.shape.pressure_mpa, rtol=1e-6)
    assert_allclose(grid.point_data["contact_pressure_mpa"], 2 * press.shape.pressure_mpa)
    assert grid.cell_data["magnet"].tolist() == [-1]
    assert_allclose(grid.field_data["magnet_motion"], press.motion[-1])
    sizes = grid.compute_cell_sizes(length=False, area=False)
    assert_allclose(sizes.cell_data["Volume"], [4 * 1.331], rtol=1e-5)
    with pytest.raises(InputError, match=r"\.vtu"):
        save_deformed_shape(press.shape, tmp_path / "deformed.stl")


@pytest.mark.slow
def test_the_mesh_of_a_press_is_fine_where_the_press_is(rigid_spec):
    """Face 4 at (−6, 5): its x is −z and its y is −x, so the place is (−5, 21, 6)."""
    spec = rigid_spec.model_copy(
        update={"mesh": rigid_spec.mesh.model_copy(update={"surface_edge_mm": 1.4})}
    )
    mesh = tetrahedralize_for_press(spec, 4, -6.0, 5.0)

    def vertices_near(centre):
        near = np.linalg.norm(mesh.points_mm - centre, axis=1) < 5
        return int((near & (abs(mesh.points_mm[:, 1] - 21) < 0.1)).sum())

    elsewhere = [(5, 21, -6), (-5, 21, -6), (5, 21, 6)]
    assert vertices_near((-5, 21, 6)) > 2 * max(map(vertices_near, elsewhere))
    assert mesh.magnet.max() == 24


@pytest.mark.slow
def test_vertices_that_come_into_contact_hardly_show_in_the_force_of_a_single_press():
    """Against contact finer than the mesh, on the same mesh; face 1's centre, every 0.25 mm."""
    cube, place, depths = paper_cube((1.7, 4.0)), np.zeros(2), np.arange(1, 4.1, 0.25)
    spec = cube.changed(mesh=MeshSpec(), body=cube.body.changed(sensed_faces=(1,)))
    mesh = tetrahedralize_for_press(spec, 1, *place)
    rows = linear_press(press_setting(spec, mesh, 1, place, SOFT), depths).rows
    finer = press_face(spec, build_response(mesh, spec), 0, place[None], depths)
    error = np.array([row.force_n for row in rows]) / finer.force_n[0] - 1
    assert np.sqrt(np.mean(error**2)) < 0.008
    assert abs(error).max() < 0.02


def one_face():
    """The paper's cube with one sensed face, its mesh as by default."""
    cube = paper_cube(COARSE_EDGES_MM)
    return cube.changed(mesh=MeshSpec(), body=cube.body.changed(sensed_faces=(1,)))


@pytest.fixture(scope="module")
def fine_mesh():
    """Fine where the tests press: on the coarse mesh forces differ by 20 % from mesh to mesh."""
    return tetrahedralize_for_press(one_face(), 1, 5.0, -4.0)


@pytest.fixture(scope="module")
def interrupted(fine_mesh):
    """Pressed to 0.6 and 1 mm, but Newton's method fails beyond 0.8 mm."""

    def fails_deeper(problem, start, centre):
        if centre[2] < 21 + 5 - 0.8 - 1e-9:
            raise StepDivergedError("no equilibrium")
        return equilibrium(problem, start, centre)

    equilibrium = large_strain.equilibrium
    told = []
    patch = pytest.MonkeyPatch()
    patch.setattr(large_strain, "equilibrium", fails_deeper)
    press = press_large_strain(one_face(), fine_mesh, 1, 5.0, -4.0, [0.6, 1.0], SOFT, told.append)
    patch.undo()
    return press, told


@pytest.mark.slow
def test_a_press_that_diverges_reports_the_last_converged_depth(interrupted):
    press, told = interrupted
    assert press.status == "diverged"
    assert press.depth_mm[0] == 0.6
    assert 0.76 < press.converged_depth_mm <= 0.8
    assert len(press.depth_mm) == 2
    assert any("the load step is halved" in line for line in told)
    assert (np.diff(press.force_n) > 0).all()


def pressures_of_hats(response, xy_mm, depths_mm):
    """Contact of the R 5 mm sphere on face 1 with the mesh's own hats, from the operator."""
    surface = response.surfaces[0]
    near = np.flatnonzero(np.linalg.norm(surface.xy_mm - xy_mm, axis=1) < 5.0)
    weights = surface_weights_mm2(surface)
    profile = profile_moments_mm3(surface, xy_mm, 5.0)[0]
    compliance = np.asarray(response.compliance[np.ix_(near, near)])
    pressures = np.zeros((len(depths_mm), len(weights)))
    pressures[:, near] = contact_pressures(compliance, profile[near], weights[near], depths_mm)
    return pressures


@pytest.mark.slow
def test_both_models_agree_within_what_large_deformation_costs(interrupted, fine_mesh):
    """Beside it stands what the response operator gives on the same mesh.

    Where few vertices touch, the sphere's own normals leave a sideways force on a coarse mesh:
    shifts along the face are compared loosely.
    """
    press, _ = interrupted
    assert_allclose(press.force_n, press.linear_force_n, rtol=0.05)
    response = build_response(fine_mesh, one_face())
    surface, xy = response.surfaces[0], np.array([[5.0, -4.0]])
    pressures = pressures_of_hats(response, xy, press.depth_mm)
    assert_allclose(press.linear_force_n, pressures @ surface_weights_mm2(surface), rtol=1e-8)
    rows = response.compliance[response.magnet_loads, response.face_loads(0)]
    motion = (pressures @ rows.T).reshape(press.linear_motion.shape)
    assert_allclose(press.linear_motion, motion, rtol=0, atol=1e-8)
    below = press.motion[:, 0]
    assert_allclose(below, motion[:, 0], rtol=0, atol=0.4 * abs(motion[:, 0]).max())
    assert_allclose(below[:, 2:], motion[:, 0, 2:], rtol=0, atol=0.15 * abs(motion[:, 0]).max())


@pytest.mark.slow
def test_silicone_keeps_its_volume_in_a_press(interrupted):
    press, _ = interrupted
    shape = press.shape

    def volume(points):
        corner = points[shape.tets[shape.magnet < 0, :4]]
        return np.linalg.det(corner[:, 1:] - corner[:, :1]).sum() / 6

    sunk = -shape.displacement_mm[:, 2].min()
    assert 0.7 < sunk < 0.85
    change = volume(shape.nodes_mm + shape.displacement_mm) / volume(shape.nodes_mm) - 1
    assert abs(change) < 2e-4
    assert shape.pressure_mpa.max() > 0.05


@pytest.mark.parametrize(
    ("indenter", "words"),
    [
        ({}, None),
        ({"kind": "flat"}, "indenter.kind = 'flat'"),
        ({"tip_count": 2}, "tip_count = 2"),
        ({"direction_deg": (0.0, 5.0)}, "direction_deg = .0.0, 5.0."),
        ({"friction": "sticking"}, "friction = 'sticking'"),
    ],
)
def test_another_indenter_than_one_straight_hemisphere_is_refused(indenter, words):
    spec = ObjectSpec.model_validate({"name": "x", "indenter": indenter})
    if words is None:
        require_press(spec, 1, 0.0, 0.0, [0.5])
        return
    with pytest.raises(InputError, match=words):
        require_press(spec, 1, 0.0, 0.0, [0.5])


def test_presses_go_up_to_the_border_and_not_beyond():
    """A tip of 5 mm on a face of ±21 mm; depths from above 0 to below the radius."""
    spec = ObjectSpec(name="x")
    for x, y in ((16.0, 0.0), (0.0, -16.0), (-16.0, 16.0)):
        require_press(spec, 1, x, y, [0.5])
    for x, y in ((16.001, 0.0), (0.0, -16.001)):
        with pytest.raises(InputError, match="hangs over the border"):
            require_press(spec, 1, x, y, [0.5])
    require_press(spec, 1, 0.0, 0.0, [1e-3, 4.999])
    for depths in ([0.0, 1.0], [1.0, 1.0], [1.0, 5.0]):
        with pytest.raises(InputError, match="depths must increase from above 0"):
            require_press(spec, 1, 0.0, 0.0, depths)
    thin = ObjectSpec.model_validate({"name": "x", "shell": {"thickness_mm": 4.0}})
    with pytest.raises(InputError, match=r"thickness \(4 mm\)"):
        require_press(thin, 1, 0.0, 0.0, [4.0])


@pytest.mark.parametrize(
    ("share", "fits"), [(0.991, True), (1.009, True), (0.989, False), (1.011, False)]
)
def test_a_material_has_the_modulus_of_the_specification_to_a_percent(share, fits):
    spec = ObjectSpec(name="x")
    material = neo_hookean(share * spec.silicone.youngs_modulus_mpa, spec.silicone.poisson_ratio)
    if fits:
        require_modulus(spec, material)
        return
    with pytest.raises(InputError, match="at small strain, but"):
        require_modulus(spec, material)
