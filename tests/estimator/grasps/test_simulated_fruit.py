"""Transfer by Hertz from the silicone's force to a fruit, held against a fruit solved by finite elements."""

import numpy as np
import pytest

from design.catalogue.silicones import SILICONES
from estimator.grasps.damage import DamageLimit, Sphere, indentation_mm
from fem.contact.bonded_layer import layer_force_n, layer_thickness_mm
from tests.support.mechanics.fruit import pressed_fruit

RADIUS_MM, MODULUS_MPA, POISSON, TIP_MM = 25.0, 1.0, 0.35, 5.0
SKIN_MM, STIFFER = 0.3, 10.0
FORCES_N = (1.0, 2.0, 4.0, 6.0)


def fruit(stiffer):
    return pressed_fruit(RADIUS_MM, MODULUS_MPA, POISSON, SKIN_MM, stiffer, TIP_MM, 0.45)


def by_hertz(quantity, force_n):
    limit = DamageLimit("fruit", quantity, 1.0, 0.2, "made up", "", MODULUS_MPA, POISSON, RADIUS_MM)
    return float(limit.load(np.array([force_n]), TIP_MM)[0])


@pytest.mark.parametrize("force_n", FORCES_N)
def test_strain_and_work_of_bare_flesh_are_those_of_hertz(force_n):
    depth_mm, _, energy_mj = fruit(1.0).at(force_n)
    assert by_hertz("strain", force_n) == pytest.approx(depth_mm / RADIUS_MM, rel=0.03)
    assert by_hertz("energy_mj", force_n) == pytest.approx(energy_mj, rel=0.03)


def test_pressure_of_bare_flesh_is_that_of_hertz_as_far_as_the_mesh_resolves_it():
    """Edges of 0.45 mm under contacts of 1.5 to 3 mm; edges of 0.6 mm leave up to twice the difference."""
    for force_n in FORCES_N:
        assert by_hertz("pressure_mpa", force_n) == pytest.approx(
            fruit(1.0).at(force_n)[1], rel=0.16
        )


@pytest.mark.parametrize("force_n", FORCES_N)
def test_under_a_skin_hertz_overstates_strain_and_work_and_understates_pressure(force_n):
    depth_mm, pressure_mpa, energy_mj = fruit(STIFFER).at(force_n)
    assert 1.05 < by_hertz("strain", force_n) / (depth_mm / RADIUS_MM) < 1.13
    assert 1.0 < by_hertz("energy_mj", force_n) / energy_mj < 1.08
    # against bare flesh on the same mesh, whose error is then the same
    assert 1.1 < pressure_mpa / fruit(1.0).at(force_n)[1] < 1.45


def test_a_stiffer_skin_biases_more():
    depths = [fruit(stiffer).at(2.0)[0] for stiffer in (1.0, 10.0, 30.0)]
    pressures = [fruit(stiffer).at(2.0)[1] for stiffer in (1.0, 10.0, 30.0)]
    assert depths == sorted(depths, reverse=True)
    assert pressures == sorted(pressures)


def test_the_stand_in_reads_less_than_the_fruit_would_bear_at_the_same_travel():
    """Layers matched at 5 N harden faster: below it a gripper that closes to a width is flattered."""
    pair = Sphere(MODULUS_MPA, POISSON, 1 / (1 / RADIUS_MM + 1 / TIP_MM))
    matched_mm = float(indentation_mm(np.array([5.0]), pair)[0])
    for name in ("Platsil Gel-10", "Dragon Skin 20"):
        modulus = SILICONES[name].modulus.youngs_modulus_mpa
        thickness_mm = layer_thickness_mm(5.0, matched_mm, modulus, TIP_MM)
        for force_n in FORCES_N[:3]:
            shares = [
                layer_force_n(fruit(stiffer).at(force_n)[0], modulus, TIP_MM, thickness_mm)
                / force_n
                for stiffer in (1.0, STIFFER)
            ]
            assert 0.6 < shares[1] < shares[0] < 1.0
