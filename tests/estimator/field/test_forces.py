"""Forces between magnets and on plates: magpylib, closed forms, balance, virtual work."""

import magpylib
import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.integrate import quad
from scipy.spatial.transform import Rotation
from scipy.special import j1

from design.layout.places.positions import MagnetLayout, magnet_layout
from design.spec.magnets import MagnetSpec
from design.spec.object import ObjectSpec
from estimator.field.environment import Plate, environment
from estimator.field.forces import loads_by_each, mirrored, plate_loads, resting_loads
from estimator.field.sources import magnet_source
from tests.support.mechanics.odd_presses import SPEC

MU0 = 4e-7 * np.pi
DISK = MagnetSpec.model_validate({"remanence_t": 1.4})
RING = MagnetSpec.model_validate({"remanence_t": 1.4, "shape": "ring", "inner_diameter_mm": 2.0})
BLOCK = MagnetSpec.model_validate(
    {"remanence_t": 1.4, "shape": "block", "size_mm": [5.0, 3.0], "height_mm": 2.0}
)


def polarization_t(magnets):
    return magnet_source(magnets).polarization_t


def one(centre_mm, turn=(0.0, 0.0, 0.0), strength=1.0):
    """A layout of one magnet, turned by a rotation vector."""
    frame = Rotation.from_rotvec(turn).as_matrix().T
    number = np.zeros(1, int)
    return MagnetLayout(
        np.array([centre_mm], float), frame[2:], number, frame[:1], np.array([strength]), number
    )


def magpylib_magnet(magnets, centre_mm, turn, strength=1.0):
    size, polarization = magnets.sizes[0], (0, 0, polarization_t(magnets) * strength)
    height = size.height_mm / 1e3
    if magnets.shape == "block":
        edges = (*(edge / 1e3 for edge in size.edges_mm), height)
        body = magpylib.magnet.Cuboid(polarization=polarization, dimension=edges)
    elif magnets.shape == "ring":
        radii = (size.inner_diameter_mm / 2e3, size.diameter_mm / 2e3)
        body = magpylib.magnet.CylinderSegment(
            polarization=polarization, dimension=(*radii, height, 0, 360)
        )
    else:
        body = magpylib.magnet.Cylinder(
            polarization=polarization, dimension=(size.diameter_mm / 1e3, height)
        )
    body.rotate(Rotation.from_rotvec(turn))
    body.position = np.array(centre_mm) / 1e3
    return body


POSES = [
    ((8.0, 1.0, 2.0), (0.3, 0.2, 0.0), (0.1, -0.5, 0.4), 0.004),
    ((-1.0, 2.0, 5.0), (0.3, 0.2, -0.7), (0.1, -0.5, 0.4), 0.004),
    ((2.0, 13.0, -11.0), (0.3, 0.2, -0.7), (1.1, 2.5, 0.4), 0.01),
]
"""A neighbour, one across a shell, and a far one, of which few points are summed; shares of error."""


@pytest.mark.parametrize("magnets", [DISK, RING, BLOCK], ids=["disk", "ring", "block"])
@pytest.mark.parametrize(("place", "turn", "other_turn", "error"), POSES)
def test_forces_and_torques_are_magpylibs(magnets, place, turn, other_turn, error):
    target, source = one(place, turn, 0.9), one((0, 0, 0), other_turn, -1.1)
    load = loads_by_each(target, source, magnets)[0, 0]
    bodies = (
        magpylib_magnet(magnets, (0, 0, 0), other_turn, -1.1),
        magpylib_magnet(magnets, place, turn, 0.9),
    )
    meshing = (30, 22, 16) if magnets.shape == "block" else (32, 12, 6)
    force_n, torque_nm = magpylib.getFT(*bodies, meshing=meshing)
    assert_allclose(load[:3], force_n, atol=error * np.linalg.norm(force_n))
    assert_allclose(load[3:], 1e3 * torque_nm, atol=2 * error * 1e3 * np.linalg.norm(torque_nm))


@pytest.mark.parametrize("gap_mm", [1.0, 3.0, 8.0])
def test_coaxial_disks_pull_as_the_closed_form_says(gap_mm):
    """F = −8π R² J²/(2μ₀) ∫ J₁²(q)/q sinh²(qτ) e^(−qζ) dq, τ = t/2R, ζ the distance of centres over R
    (Vokoun and others, J. Magn. Magn. Mater. 321 (2009) 3758)."""
    radius, height, distance = 3.0, 1.0, gap_mm + 1.0
    tau, zeta = height / (2 * radius), distance / radius
    integral = quad(
        lambda q: j1(q) ** 2 / q * np.sinh(q * tau) ** 2 * np.exp(-q * zeta), 0, 80, limit=400
    )[0]
    expected = -8 * np.pi * (radius * 1e-3) ** 2 * polarization_t(DISK) ** 2 / (2 * MU0) * integral
    load = loads_by_each(one((0, 0, distance)), one((0, 0, 0)), DISK)[0, 0]
    assert_allclose(load[2], expected, rtol=0.003)
    assert_allclose(load[[0, 1, 3, 4, 5]], 0, atol=1e-9)


def test_poles_that_oppose_repel_and_neighbours_of_one_pole_do_too():
    """Far away dipoles: 6 μ₀ m²/(4π r⁴) along the axis, 3 μ₀ m²/(4π r⁴) side by side."""
    moment = polarization_t(DISK) / MU0 * np.pi * 9e-9
    unit = 1e-7 * moment**2 / 0.08**4
    turned = one((0, 0, 0), (np.pi, 0, 0))
    for place, source, expected in (
        ((0, 0, 80.0), one((0, 0, 0)), (0, 0, -6 * unit)),
        ((0, 0, 80.0), turned, (0, 0, 6 * unit)),
        ((80.0, 0, 0), one((0, 0, 0)), (3 * unit, 0, 0)),
        ((80.0, 0, 0), turned, (-3 * unit, 0, 0)),
    ):
        force = loads_by_each(one(place), source, DISK)[0, 0, :3]
        assert_allclose(force, expected, atol=0.05 * unit)


def test_forces_in_an_object_balance_and_turn_nothing():
    """Three tilted magnets a face of both poles: 15 loads without a symmetry among them."""
    loads, centre = resting_loads(SPEC), magnet_layout(SPEC).centre_mm
    size = np.linalg.norm(loads[:, :3], axis=1).max()
    assert size > 0.005
    assert_allclose(loads[:, :3].sum(axis=0), 0, atol=2e-3 * size)
    moments = loads[:, 3:] + np.cross(centre, loads[:, :3])
    assert_allclose(moments.sum(axis=0), 0, atol=2e-2 * size * abs(centre).max())


def plated(permeability, gap_mm=0.0):
    plate = {"position_mm": [0, 0, 21 + gap_mm], "normal": [0, 0, -1]}
    plate["relative_permeability"] = permeability
    return ObjectSpec.model_validate({"name": "cube", "environment": {"steel_plates": [plate]}})


def test_steel_pulls_with_half_the_work_of_two_magnets():
    """Virtual work: the energy in front of steel is half of that of magnet and image, −m·B/2, and the
    image moves as the magnet does. Of a small tilted magnet, by differences of that energy."""
    small = DISK.changed(diameter_mm=0.4, height_mm=0.4)
    plate, turn = Plate(np.zeros(3), np.array([0.0, 0.0, 1.0]), 0.6), (0.7, 0.2, 0.0)
    moment = polarization_t(small) / MU0 * np.pi * 0.04e-9 * 0.4

    def energy(height_mm):
        m = moment * one((0, 0, 0), turn).axis[0]
        image = 0.6 * np.array([-m[0], -m[1], m[2]])
        r = 2e-3 * height_mm
        field = 1e-7 * (3 * image[2] * np.array([0, 0, 1.0]) - image) / r**3
        return -m @ field / 2

    magnet = one((0, 0, 5.0), turn)
    load = loads_by_each(magnet, mirrored(magnet, plate), small)[0, 0]
    expected = -(energy(5.001) - energy(4.999)) / 2e-6
    assert expected < 0
    assert_allclose(load[2], expected, rtol=0.01)


def test_aluminium_and_plastic_pull_nothing_at_rest():
    steel, aluminium, plastic = (plated(mu) for mu in (1000.0, 1.000022, 1.0))
    pulls = [
        np.linalg.norm(plate_loads(spec, environment(spec).plates[0])[:5, :3], axis=1)
        for spec in (steel, aluminium, plastic)
    ]
    assert pulls[0].min() > 0.25
    assert_allclose(pulls[1], pulls[0] * 1.1e-5, rtol=0.003)  # image of (μ − 1)/(μ + 1)
    assert_allclose(pulls[2], 0, atol=1e-12)
