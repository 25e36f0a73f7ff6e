"""Energies, stresses and moduli of one odd deformation, corrected tables: a page that can be judged."""

import numpy as np

from fem.large_strain.correction import StrainCorrection, corrected_table
from fem.large_strain.hyperelastic import (
    first_piola_stress,
    neo_hookean,
    ogden,
    tangent_modulus,
    yeoh,
)
from fem.large_strain.linearity import depth_of_force_error_mm, linear_error
from tests.support.mechanics.large_strain_cases import energy_density
from tests.support.mechanics.odd_presses import SPEC, presses
from tests.support.physics_pages import assert_page

SOLIDS = {
    "neo-hookean": neo_hookean(0.6, 0.45),
    "yeoh": yeoh(0.1, -0.004, 0.0006),
    "ogden": ogden((0.12, -0.03), (2.4, -1.7)),
}


def of_solids():
    deformation = np.eye(3) + 0.4 * np.random.default_rng(2).uniform(-1, 1, (2, 3, 3))
    for name, solid in SOLIDS.items():
        energies = 1e3 * energy_density(solid, deformation)
        yield f"{name}: shear modulus, energies (kPa)", [1e3 * solid.shear_modulus_mpa, *energies]
        yield f"{name}: stresses (kPa)", 1e3 * first_piola_stress(solid, deformation)
        yield f"{name}: tangent moduli (kPa)", 1e3 * tangent_modulus(solid, deformation)


def of_corrections():
    correction = StrainCorrection(8.0, (0.4, -0.9), (-0.5, 0.7), (0.3,))
    forces, motions = corrected_table(SPEC, *presses(), correction)
    yield "corrected forces (N)", forces.force_n
    yield "corrected motions (mm, rad)", motions.motion
    reach_mm = [depth_of_force_error_mm(share, 6.0) for share in (0.01, 0.06, 0.2)]
    yield "depths of errors of 1, 6, 20 % (mm)", reach_mm
    for depth_mm in (0.2, 1.4, 2.9):
        error = linear_error(depth_mm, 6.0)
        yield f"errors of force and motion at {depth_mm:g} mm", [error.force, error.motion]


def test_the_page_of_large_strain():
    assert_page("fem/large_strain", [*of_solids(), *of_corrections()])
