"""Energies, stresses and moduli of one odd deformation, and corrections of tables, on record.

Where this fails after a deliberate change see `tests/support/recorded_facts.py`.
"""

import numpy as np
import pytest

from fem.large_strain.correction import StrainCorrection, corrected_table
from fem.large_strain.hyperelastic import (
    energy_density,
    first_piola_stress,
    neo_hookean,
    ogden,
    tangent_modulus,
    yeoh,
)
from fem.large_strain.linearity import depth_of_force_error_mm, linear_error
from tests.support.mechanics.odd_presses import SPEC, presses
from tests.support.recorded_facts import assert_on_record, told, told_whole

SOLIDS = {
    "neo-hookean": neo_hookean(0.6, 0.45),
    "yeoh": yeoh(0.1, -0.004, 0.0006),
    "ogden": ogden((0.12, -0.03), (2.4, -1.7)),
}


def on_record(section, lines):
    assert_on_record("presses", section, lines, "fem")


@pytest.mark.parametrize("name", SOLIDS)
def test_a_solid_is_as_on_record(name):
    deformation = np.eye(3) + 0.4 * np.random.default_rng(2).uniform(-1, 1, (2, 3, 3))
    solid = SOLIDS[name]
    lines = [
        *told_whole("solid", solid),
        told("shear modulus", solid.shear_modulus_mpa),
        told("energy", 10 * energy_density(solid, deformation)),
        told("stress", 10 * first_piola_stress(solid, deformation)),
        told("modulus", 10 * tangent_modulus(solid, deformation)),
    ]
    on_record(f"solid: {name}", lines)


def test_corrected_tables_are_as_on_record():
    correction = StrainCorrection(8.0, (0.4, -0.9), (-0.5, 0.7), (0.3,))
    forces, motions = corrected_table(SPEC, *presses(), correction)
    lines = [told("forces", forces.force_n), told("motions", 10 * motions.motion)]
    lines += [told("reach", [depth_of_force_error_mm(share, 6.0) for share in (0.01, 0.06, 0.2)])]
    for depth_mm in (0.2, 1.4, 2.9, 3.1):
        lines += told_whole(f"error at {depth_mm:g}", linear_error(depth_mm, 6.0))
    on_record("corrected", lines)
