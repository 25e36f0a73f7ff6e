"""Candidate motions: against direct solves and magnets in the mesh; interpolation; files."""

from threading import get_ident

import numpy as np
import pytest
from numpy.testing import assert_allclose
from threadpoolctl import threadpool_info, threadpool_limits

from design.errors import InputError
from design.layout.body import face_frames
from design.layout.places.contact_grid import press_lattice
from design.spec.object import ContactGridSpec, ScoreSpec
from design.spec_io import parse_spec
from fem.candidates.cubic_convolution import axis_weights
from fem.candidates.motions import MOTIONS_FILE, candidate_lattices, load_candidates
from fem.candidates.presses import presses_at_forces
from fem.candidates.presses import simulate_candidates as simulate
from fem.candidates.rigid_body import candidate_rows, tied_magnets
from fem.linear.response import displacements, face_pressure_loads
from fem.presses.table import surface_weights_mm2
from tests.support.mechanics.candidate_cases import motion_of, motions_at
from tests.support.mechanics.fem_cases import paper_cube

FACE = 3
"""Its x is −z and its y is +y: a mix-up of axes shows."""


@pytest.fixture(scope="module")
def spec(cube):
    grid = ContactGridSpec(count=(3, 2), pitch_mm=7.0)
    search = cube.spec.search.changed(forces_n=())
    return cube.spec.changed(contact_grid=grid, score=ScoreSpec(force_n=1.0), search=search)


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    return tmp_path_factory.mktemp("candidates")


@pytest.fixture(scope="module")
def table(cube, spec, folder, lattices):
    return simulate(spec, cube.mesh, cube.response, lattices, folder, force_shares=(0.5, 1.0))


def test_a_run_that_was_broken_off_goes_on_from_the_faces_that_it_had(
    cube, spec, lattices, table, tmp_path
):
    parts, unfinished = (spec, cube.mesh, cube.response, lattices), tmp_path / "unfinished"

    def stop(text):
        if text.startswith("face 2"):
            raise KeyboardInterrupt

    options = {"force_shares": (0.5, 1.0), "unfinished": unfinished}
    with pytest.raises(KeyboardInterrupt):
        simulate(*parts, tmp_path, progress=stop, **options)
    kept = {path: path.stat().st_mtime_ns for path in unfinished.iterdir()}
    assert len(kept) == 2
    again = simulate(*parts, tmp_path, **options)
    assert all(path.stat().st_mtime_ns == then for path, then in kept.items())
    np.testing.assert_array_equal(again.by_candidate, table.by_candidate)


def test_results_are_the_same_bytes_whatever_threads_linear_algebra_has(
    cube, spec, lattices, table, folder, tmp_path
):
    """It takes one throughout. What is being done is said by the thread that asked."""
    said = set()

    def note(text):
        linear_algebra = [lib for lib in threadpool_info() if lib["user_api"] == "blas"]
        said.add((get_ident(), frozenset(lib["num_threads"] for lib in linear_algebra)))

    with threadpool_limits(2, "blas"):
        simulate(spec, cube.mesh, cube.response, lattices, tmp_path, (0.5, 1.0), note)
    assert said == {(get_ident(), frozenset({1}))}
    motions = [(path / MOTIONS_FILE).read_bytes() for path in (folder, tmp_path)]
    assert motions[0] == motions[1]
    again = load_candidates(tmp_path)
    for name in ("presses", "force_n", "strain"):
        assert getattr(again, name).tobytes() == getattr(table, name).tobytes()


@pytest.fixture(scope="module")
def body(disks):
    return disks[0]


@pytest.fixture(scope="module")
def fields(cube, spec, factor):
    """Nodal displacements of every press of face 3 at the second force; (3·node, place)."""
    press = presses_at_forces(spec, cube.response, FACE - 1, (0.5, 1.0))
    assert len(press.force_n) == len(press_lattice(spec)) == 35
    tractions = face_pressure_loads(cube.space, spec)[1]
    loads = tractions[:, cube.response.face_loads(FACE - 1)]
    return displacements(cube.system, factor, loads @ press.pressure_mpa[:, 1].T)


def test_the_paper_s_cube_has_19_by_19_places_at_six_depths():
    lattices = candidate_lattices(paper_cube((1.2, 4.0)))
    assert [lattice.shape for lattice in lattices] == [(19, 19, 6)] * 5
    assert_allclose(lattices[2].x_mm[[0, -1]], [-18, 18], rtol=0, atol=1e-12)
    assert_allclose(lattices[2].depth_mm, [1.5, 2.5, 3.5, 4.5, 5.5, 6.5], rtol=0, atol=1e-12)


def test_boards_wider_than_pockets_keep_within_the_face():
    sensors = {"package_mm": [6.6, 6.2, 1.6]}
    magnets = {"positions_mm": [[8, 8], [-8, -8]]}
    content = {"name": "reverse", "arrangement": "sensors-in-shell"}
    spec = parse_spec(content | {"sensors": sensors, "magnets": magnets}, "made up")
    assert max(spec.sensors.package_mm[:2]) > spec.shell.pocket_diameter_mm
    for lattice in candidate_lattices(spec):
        assert_allclose(lattice.x_mm[[0, -1]], [-17.7, 17.7])


def test_axes_and_candidates_are_in_order(table, spec):
    count = sum(len(lattice) for lattice in table.candidates)
    assert table.by_candidate.shape == (count, 5, table.presses.shape[3], 6)
    assert table.presses.shape[:3] == (5, 35, 2)
    assert table.by_candidate.dtype == np.float32
    assert list(table.faces) == [1, 2, 3, 4, 5]
    lattice = table.candidates[1]
    ix, iy, iz = 3, 1, 2
    index = (ix * lattice.shape[1] + iy) * lattice.shape[2] + iz
    wanted = [lattice.x_mm[ix], lattice.y_mm[iy], lattice.depth_mm[iz]]
    assert_allclose(lattice.xyd_mm[index], wanted, rtol=0, atol=0)
    assert_allclose(table.places.xy_mm, press_lattice(spec).xy_mm, rtol=0, atol=0)


def test_candidates_move_as_the_solved_field_does(cube, table, fields, body):
    """Every candidate of faces 3 and 4 under presses of face 3, with its own rows; modes that are left out
    are small beside the largest."""
    first = sum(len(lattice) for lattice in table.candidates[: FACE - 1])
    for lattice, frame in zip(table.candidates[2:4], face_frames(cube.spec)[2:4], strict=True):
        points = frame.to_object(lattice.xyd_mm * [1, 1, -1])
        rows = candidate_rows(cube.space, points, frame.axes, body).motions
        direct = (rows @ fields).reshape(len(lattice), 6, -1)
        found = motion_of(table)[FACE - 1, :, 1, first : first + len(lattice)]
        assert_allclose(np.moveaxis(found, 0, 2), direct, rtol=0, atol=1e-3 * abs(direct).max())
        first += len(lattice)


def test_forces_are_those_asked_for_or_shares_of_the_reachable(cube, spec, table):
    assert_allclose(table.force_n[..., 1], 1.0, rtol=1e-9)
    assert_allclose(table.force_n[..., 0], 0.5, rtol=1e-9)
    assert (np.diff(table.depth_mm, axis=2) > 0).all()
    far = spec.model_copy(update={"score": ScoreSpec(force_n=500.0)})
    press = presses_at_forces(far, cube.response, 0, (0.5, 1.0))
    weights = surface_weights_mm2(cube.response.surfaces[0])
    assert_allclose(press.depth_mm[:, 1], spec.press.depths_mm[-1], rtol=1e-12)
    assert_allclose(press.pressure_mpa @ weights, press.force_n, rtol=1e-12)
    assert_allclose(press.force_n[:, 0], press.force_n[:, 1] / 2, rtol=1e-12)
    assert_allclose(press.deepest_n, press.force_n[:, 1], rtol=1e-12)
    assert_allclose(table.deepest_n[0], press.deepest_n, rtol=1e-12)


def test_a_force_out_of_reach_leaves_the_others_as_they_are(cube, spec):
    search = spec.search.changed(forces_n=(0.5, 1.0, 500.0))
    press = presses_at_forces(spec.changed(search=search), cube.response, 0, (0.8, 1.2))
    assert_allclose(press.force_n[:, :4], np.tile([0.4, 0.6, 0.8, 1.2], (len(press.force_n), 1)))
    assert_allclose(press.depth_mm[:, 5], spec.press.depths_mm[-1], rtol=1e-12)
    assert_allclose(press.force_n[:, 4], press.force_n[:, 5] / 1.5, rtol=1e-12)


def test_at_a_candidate_interpolation_gives_its_own_motion(table):
    lattice = table.candidates[FACE - 1]
    index = np.array([0, 17, len(lattice) - 1])
    first = sum(len(one) for one in table.candidates[: FACE - 1])
    at = lattice.xyd_mm[index]
    stored_motion = motions_at(table, FACE, at[:, :2], at[:, 2])
    assert_allclose(stored_motion, motion_of(table)[:, :, :, first + index], rtol=0, atol=1e-6)


def missed(cube, table, fields, body, within=None):
    """Error of interpolation between candidates, rms and worst: of displacements, of rotations.

    At places within the candidates of that table, or of its own.
    """
    frame, lattice = face_frames(cube.spec)[FACE - 1], (within or table).candidates[FACE - 1]
    low, high = lattice.xyd_mm.min(axis=0), lattice.xyd_mm.max(axis=0)
    xyd = np.random.default_rng(9).uniform(low, high, (60, 3))
    points = frame.to_object(xyd * [1, 1, -1])
    direct = candidate_rows(cube.space, points, frame.axes, body).motions @ fields
    direct = np.moveaxis(direct.reshape(len(xyd), 6, -1), 2, 0)
    miss = motions_at(table, FACE, xyd[:, :2], xyd[:, 2])[FACE - 1, :, 1] - direct
    parts = [values.reshape(-1, 2, 3) for values in (miss, direct)]
    wrong, size = (np.linalg.norm(values, axis=2) for values in parts)
    rms = np.sqrt(np.mean(wrong**2, axis=0) / np.mean(size**2, axis=0))
    return rms, wrong.max(axis=0) / size.max(axis=0)


def test_between_candidates_motions_are_those_of_direct_evaluation(cube, table, fields, body):
    """A coarse lattice of 4 mm: displacements to a tenth (rms), rotations to a quarter."""
    rms, worst = missed(cube, table, fields, body)
    assert np.all(rms < [0.1, 0.25])
    assert rms[0] < worst[0] < 0.3


@pytest.mark.slow  # quick ones: the error of one lattice, and the order of convolution
def test_a_finer_lattice_interpolates_better(cube, spec, factor, table, fields, body, tmp_path):
    lattices = candidate_lattices(spec, pitch_mm=2.5)
    finer = simulate(spec, cube.mesh, cube.response, lattices, tmp_path, force_shares=(0.5, 1.0))
    # a magnet's response is that of the mean over all candidates of its lattice
    finer_body = tied_magnets(cube.spec, cube.system, factor, lattices)[0]
    error = missed(cube, table, fields, body)[0][0]
    assert missed(cube, finer, fields, finer_body, table)[0][0] < 0.6 * error


def test_a_table_comes_back_from_its_folder_memory_mapped(table, folder):
    loaded = load_candidates(folder)
    assert isinstance(loaded.by_candidate, np.memmap)
    np.testing.assert_array_equal(loaded.by_candidate, table.by_candidate)
    for name in ("faces", "force_n", "depth_mm", "presses"):
        np.testing.assert_array_equal(getattr(loaded, name), getattr(table, name))
    for read, saved in zip(loaded.candidates, table.candidates, strict=True):
        assert read.face == saved.face
        np.testing.assert_array_equal(read.xyd_mm, saved.xyd_mm)


@pytest.mark.parametrize(
    ("face", "xy", "depth", "what"),
    [
        (3, (30.0, 0.0), 2.5, "30 mm lies outside"),
        (3, (0.0, 0.0), 0.4, "0.4 mm lies outside"),
        (6, (0.0, 0.0), 2.5, "face 6 has no candidates"),
    ],
)
def test_places_without_candidates_are_refused(table, face, xy, depth, what):
    with pytest.raises(InputError, match=what):
        motions_at(table, face, np.array([xy]), np.array([depth]))


def test_a_shell_too_thin_for_the_margins_is_refused(spec):
    with pytest.raises(InputError, match="no room for candidates"):
        candidate_lattices(spec, margin_mm=4.0)


def test_cubic_convolution_keeps_parabolas_up_to_the_border():
    nodes = np.linspace(-3.0, 5.0, 7)
    at = np.random.default_rng(2).uniform(-3, 5, 40)
    at[:2] = nodes[[0, -1]]
    index, weight = axis_weights(nodes, at)
    values = 1 + 2 * nodes - 0.7 * nodes**2
    assert_allclose((weight * values[index]).sum(axis=1), 1 + 2 * at - 0.7 * at**2, atol=1e-13)


def test_cubic_convolution_is_smooth_across_nodes_and_of_third_order():
    error = []
    for count in (9, 17, 33):
        nodes, at = np.linspace(0, 4, count), np.linspace(0.8, 3.2, 501)
        index, weight = axis_weights(nodes, at)
        error.append(abs((weight * np.sin(2 * nodes)[index]).sum(axis=1) - np.sin(2 * at)).max())
    assert error[0] / error[1] > 6
    assert error[1] / error[2] > 6
    index, weight = axis_weights(nodes, nodes[10] + np.array([-2e-6, -1e-6, 1e-6, 2e-6]))
    low, below, above, high = (weight * np.exp(nodes)[index]).sum(axis=1)
    assert_allclose((below - low) / 1e-6, (high - above) / 1e-6, rtol=1e-4)
