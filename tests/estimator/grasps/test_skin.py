"""Skin under a contact by solved presses, and how far off Hertz' half-space is of shells on a core."""

import numpy as np
import pytest

from design.layout.body import face_frame
from estimator.grasps.damage import Sphere
from estimator.grasps.measures import conditions_of
from estimator.grasps.skin import Skin
from estimator.grasps.track import Placed
from estimator.inversion.model.table import skin_table
from estimator.signals.presses import press_signals
from fem.linear.response import build_response
from fem.mesh.tetrahedra import tetrahedralize
from fem.presses.table import simulate_lattice
from tests.estimator.grasps.grasps_by_hand import CONDITIONS, placed
from tests.support.objects.tiny_cube import tiny_cube

DEPTHS_MM = (0.5, 1.0, 2.0, 3.0)
PLACES_MM = ((0, 0), (3, 0), (6, 6), (9, 3), (9, 9), (12, 0))
"""Places from the middle, over a magnet, to near the edge."""


@pytest.fixture(scope="module", params=[8.0, 6.0], ids=["8 mm", "6 mm"])
def pressed(request):
    """Presses of a cube with a shell of that thickness, and its skin by these and by Hertz."""
    spec = tiny_cube().changed(
        shell={"thickness_mm": request.param},
        contact_grid={"count": (9, 9), "pitch_mm": 3.0},
        press={"depths_mm": DEPTHS_MM},
    )
    forces, motions = simulate_lattice(spec, build_response(tetrahedralize(spec), spec))
    table = skin_table(forces, press_signals(spec, forces, motions))
    solved, hertz = conditions_of(spec, table).skin, conditions_of(spec).skin
    return spec, forces, solved, hertz


def contact(spec, place, force_n):
    chart = face_frame(spec, 1)
    point = chart.to_object(np.array([*place, 0.0], float))
    force = np.array([[np.nan, np.nan, force_n]])
    return Placed(np.array([1]), point[None], chart.axes[None], force, np.zeros((1, 5, 5)))


def cases(spec, forces):
    """Contact, depth, area and work of every place at 1 to 3 mm."""
    for place in PLACES_MM:
        row = int(np.argmin(np.linalg.norm(forces.lattice.xy_mm - place, axis=1)))
        np.testing.assert_allclose(forces.lattice.xy_mm[row], place, atol=1e-9)
        force = np.append(0.0, forces.force_n[0, row])
        for step in range(1, len(DEPTHS_MM)):
            depths = np.append(0.0, DEPTHS_MM)[: step + 2]
            work = np.trapezoid(force[: step + 2], depths)
            area = forces.contact_area_mm2[0, row, step]
            yield contact(spec, place, force[step + 1]), DEPTHS_MM[step], area, work


def test_depth_area_and_work_are_those_of_the_presses(pressed):
    spec, forces, solved, _ = pressed
    for at, depth, area, work in cases(spec, forces):
        assert solved.depth_mm(at)[0] == pytest.approx(depth, rel=0.01)
        assert np.pi * solved.patch_radius_mm(at)[0] ** 2 == pytest.approx(area, rel=0.05)
        assert solved.pressure_mpa(at)[0] == pytest.approx(at.force_n[0, 2] / area, rel=0.05)
        # straight lines between four depths are more work than the curve
        assert 0.85 * work < solved.energy_mj(at)[0] < 1.02 * work


def test_hertz_is_off_by_as_much_as_its_docstring_says(pressed):
    spec, forces, solved, hertz = pressed
    deeper, harder, more = (
        np.array(
            [
                getattr(hertz, name)(at)[0] / getattr(solved, name)(at)[0]
                for at, *_ in cases(spec, forces)
            ]
        )
        for name in ("depth_mm", "pressure_mpa", "energy_mj")
    )
    assert 0.8 < deeper.min() < deeper.max() < 2.5
    assert 0.45 < harder.min() < harder.max() < 1.1
    assert 0.8 < more.min() < more.max() < 2.7
    # a layer over a magnet is stiffer than one near the edge
    assert deeper[:3].min() > deeper[-3:].max() - 0.1


def test_without_presses_the_skin_is_that_of_hertz():
    skin = Skin(CONDITIONS.faces, Sphere(0.4, 0.49, 5.0))
    contacts = placed([3, 5], [[0, 0], [1, 2]], [2.0, 4.0])
    # 2/5 F δ of a half-space, by a rule on six nodes
    np.testing.assert_allclose(
        skin.energy_mj(contacts), 0.4 * contacts.force_n[:, 2] * skin.depth_mm(contacts), rtol=1e-3
    )
    np.testing.assert_allclose(
        skin.patch_radius_mm(contacts) ** 2 / 5.0, skin.depth_mm(contacts), rtol=1e-12
    )
