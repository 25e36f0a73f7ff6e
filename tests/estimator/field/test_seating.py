"""Magnets in open pockets: what pulls them out, what holds them, and what is proposed."""

from pathlib import Path

import magpylib
import numpy as np
import pytest
from numpy.testing import assert_allclose

import instobj
from design.errors import InputError
from design.spec.assembly import AsBuiltSpec, BuiltMagnet
from design.spec.object import ObjectSpec
from design.spec_io import load_spec
from estimator.field.seating import ADHESION_N_PER_MM, all_stay, require_seated, seats
from estimator.field.sources import magnet_source

EXAMPLES = Path(__file__).parents[3] / "examples"
PAIR = ((-5.0, 0.0), (5.0, 0.0))


def cube(sensed=(1,), **magnets):
    return ObjectSpec.model_validate(
        {"name": "cube", "body": {"sensed_faces": list(sensed)}, "magnets": magnets}
    )


def opposed(**magnets):
    return cube(positions_mm=PAIR, north=["outward", "inward"], height_mm=2.5, **magnets)


def test_the_pull_is_that_of_a_neighbour_on_its_way_in_by_magpylib():
    """One pocket is 3 mm deep; the other magnet comes in from 3 mm above its seat."""
    spec = opposed(remanence_t=1.4)

    left_t = magnet_source(spec.magnets).polarization_t

    def disk(x_mm, z_mm, sign):
        body = magpylib.magnet.Cylinder(
            polarization=(0, 0, sign * left_t), dimension=(6e-3, 2.5e-3)
        )
        body.position = (1e-3 * x_mm, 0, 1e-3 * z_mm)
        return body

    heights = 3.0 * np.array([0.0, 0.25, 0.5, 1.0])
    up = [
        magpylib.getFT(disk(5, z, -1), disk(-5, 0, 1), meshing=(32, 12, 10))[0][2] for z in heights
    ]
    assert up[3] > 0.05
    assert_allclose(seats(spec).pull_n, max(up), rtol=0.02)
    assert_allclose(
        seats(spec.changed(magnets=spec.magnets.changed(north=()))).pull_n, 0, atol=1e-9
    )


def test_the_hold_frees_as_much_energy_as_the_surface_takes():
    """A flat punch sinks by F/(2 a E*): the energy freed by a smaller contact is W at Kendall's force."""
    spec = cube(positions_mm=PAIR)
    modulus = spec.silicone.youngs_modulus_mpa / (1 - spec.silicone.poisson_ratio**2)
    force, radius, step = seats(spec).hold_n[0], 3.0, 1e-4
    compliance = [1 / (2 * r * modulus) for r in (radius - step, radius + step)]
    freed = -(force**2) / 2 * (compliance[1] - compliance[0]) / (2 * step)
    assert_allclose(freed / (2 * np.pi * radius), ADHESION_N_PER_MM, rtol=1e-6)


@pytest.mark.parametrize("name", ["paper_cube", "egg", "pear", "better_cube", "reverse_cube"])
def test_objects_that_are_built_so_stay(name):
    require_seated(load_spec(EXAMPLES / f"{name}.toml"))


def test_opposed_neighbours_are_refused_and_each_proposal_does():
    spec = opposed()
    found = seats(spec)
    with pytest.raises(InputError, match=r"pull each other out of their pockets") as refused:
        instobj.check(spec)
    message = str(refused.value)
    assert f"drawn out with {found.pull_n.max():.2g} N" in message
    assert f"holds {found.hold_n[0]:.2g} N" in message

    def stays(**changes):
        try:
            require_seated(spec.changed(magnets=spec.magnets.changed(**changes)))
        except InputError:
            return False
        return True

    assert "turn magnet" in message
    assert stays(north=("outward", "outward"))
    assert "set these two 11 mm apart" in message
    assert stays(positions_mm=((-5.0, 0.0), (6.0, 0.0)))
    assert not stays(positions_mm=((-4.8, 0.0), (5.0, 0.0)))


def test_magnets_as_weak_as_proposed_stay_and_hardly_stronger_ones_do_not():
    """Pulls go with the square of the strength."""
    spec = opposed()
    assert seats(spec).excess.max() > 1.4
    with pytest.raises(InputError) as refused:
        require_seated(spec)
    share = float(str(refused.value).split(" times the strength")[0].split()[-1])

    def excess(remanence_t):
        weaker = spec.magnets.changed(remanence_t=remanence_t)
        return seats(spec.changed(magnets=weaker)).excess.max()

    assert excess(share * 1.43) <= 1 < excess((share + 0.02) * 1.43)


def test_strong_magnets_of_two_faces_near_an_edge_are_drawn_in():
    places = [[-6.0, 0.0], [6.0, 0.0]]
    spec = cube((1, 2, 3, 4, 5), positions_mm=places, diameter_mm=8.0, height_mm=3.0)
    spec = spec.changed(shell=spec.shell.changed(pocket_diameter_mm=8.0, pocket_depth_mm=4.0))
    with pytest.raises(InputError, match=r"draw all magnets in to 0.8 times") as refused:
        require_seated(spec)
    assert "turn magnet" not in str(refused.value)
    drawn_in = [[0.8 * x, 0.8 * y] for x, y in places]
    require_seated(spec.changed(magnets=spec.magnets.changed(positions_mm=drawn_in)))


def test_an_object_that_stands_already_is_judged_as_designed():
    """A magnet found turned over was set, whatever it took."""
    flipped = AsBuiltSpec(magnets=(BuiltMagnet(face=1, magnet=2, flipped=True),))
    built = cube(positions_mm=PAIR, height_mm=2.5).changed(as_built=flipped)
    require_seated(built)


def test_magnets_on_a_core_under_chips_are_glued_whatever_their_number():
    reverse = ObjectSpec(name="cube", arrangement="sensors-in-shell")
    assert all_stay(reverse)
    assert all_stay(reverse.changed(magnets={"positions_mm": [[0.0, 0.0]]}))
