"""Tied magnets against a mesh that resolves them: presses beside and over one magnet a face."""

import numpy as np
import pytest
from fem_cases import paper_cube

from design.spec import MagnetSpec
from fem.factorization import Factorization
from fem.magnet_free import without_magnets
from fem.presses import surface_weights_mm2
from fem.response import build_response, elastic_system
from fem.tet_mesh import tetrahedralize
from fem.tied_magnets import rigid_magnet_response

pytestmark = pytest.mark.slow
MAGNET_MM = (3.0, 2.0)
PLACES_MM = np.array([[3.0, 2.0], [0.0, 0.0], [6.0, -1.0], [7.0, 4.0]])


def cube():
    spec = paper_cube("rigid", (1.2, 4.0))
    return spec.model_copy(update={"magnets": MagnetSpec(positions_mm=(MAGNET_MM,))})


def fine_at_the_magnet(points_mm):
    """0.8 mm at the magnet of face 1, growing to 7 mm."""
    distance = np.linalg.norm(points_mm - [*MAGNET_MM, 18.5], axis=1)
    return np.interp(distance, [4, 12, 26], [0.8, 1.3, 7.0])


def fine_below_face_1(layer_mm):
    """1.2 mm at the surface, `layer_mm` from 4.5 mm below it, for some 11 mm around the magnet."""

    def edge_length(points_mm):
        aside = np.linalg.norm(points_mm[:, :2] - MAGNET_MM, axis=1)
        below = np.interp(21 - points_mm[:, 2], [0.5, 4.5], [1.2, layer_mm])
        return below + np.interp(aside, [11, 22], [0, 1]) * (7.0 - below)

    return edge_length


def pressed(response):
    """Compliance (mm/N) of (1 − r²/25)² about each place, and face 1's magnet per newton (place, 6)."""
    surface, loads = response.surfaces[0], response.face_loads(0)
    distance = np.linalg.norm(surface.xy_mm - PLACES_MM[:, None], axis=2)
    pressure = np.clip(1 - distance**2 / 25, 0, None) ** 2
    pressure /= (pressure @ surface_weights_mm2(surface))[:, None]
    compliance = np.einsum("pi,ij,pj->p", pressure, response.compliance[loads, loads], pressure)
    return compliance, pressure @ response.compliance[response.magnet_loads, loads][:6].T


def tied_presses(spec, layer_mm, degrees):
    mesh = tetrahedralize(spec, fine_below_face_1(layer_mm), magnets=False)
    plain = without_magnets(spec)
    system, response = elastic_system(mesh, plain), build_response(mesh, plain)
    with Factorization(system.matrix) as factor:
        return {
            degree: pressed(rigid_magnet_response(spec, system, factor, response, degree))
            for degree in degrees
        }


def relative_errors(found, exact):
    """Largest of compliance, of displacement and of rotation over the places."""
    force = abs(found[0] / exact[0] - 1).max()
    size = np.linalg.norm(exact[1].reshape(-1, 2, 3), axis=2).max(axis=0)
    miss = np.linalg.norm((found[1] - exact[1]).reshape(-1, 2, 3), axis=2).max(axis=0)
    return np.array([force, *(miss / size)])


@pytest.fixture(scope="module")
def resolved():
    spec = cube()
    return pressed(build_response(tetrahedralize(spec, fine_at_the_magnet), spec))


def test_ties_on_edges_of_1_mm_agree_with_resolved_magnets(resolved):
    """Compliance, displacement and rotation; the tie's degree matters more than its last percent."""
    tied = tied_presses(cube(), 1.0, (1, 2))
    assert (relative_errors(tied[2], resolved) < [0.045, 0.025, 0.03]).all()
    assert relative_errors(tied[1], resolved).max() > 0.04


def test_no_magnet_at_all_is_far_off(resolved):
    """The fault that the agreement must not overlook."""
    spec = cube()
    mesh = tetrahedralize(spec, fine_below_face_1(4.0), magnets=False)
    plain = build_response(mesh, without_magnets(spec))
    surface, loads = plain.surfaces[0], plain.face_loads(0)
    distance = np.linalg.norm(surface.xy_mm - PLACES_MM[0], axis=1)
    pressure = np.clip(1 - distance**2 / 25, 0, None) ** 2
    force = pressure @ surface_weights_mm2(surface)
    compliance = pressure @ plain.compliance[loads, loads] @ pressure / force**2
    assert compliance / resolved[0][0] > 1.3
