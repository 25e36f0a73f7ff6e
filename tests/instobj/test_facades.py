"""`instobj.field`, `fem` and `information`: refusals, oracles, and results that say what they are."""

import magpylib
import numpy as np
import pytest

import instobj

POINT = [[0.0, 0.0, 9.0]]
SLOPES = np.diag([20.0, 30.0, 40.0])[None]
MAP = np.zeros((3, 3))


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: instobj.field.disk_field([0, 0, 9], 6, 1, 1.4), "shape"),
        (lambda: instobj.field.disk_field(POINT, 0, 1, 1.4), "diameter_mm must be positive"),
        (lambda: instobj.field.disk_field(POINT, 6, 1, 1.4, 6), "inner_diameter_mm"),
        (lambda: instobj.field.block_field(POINT, (8, 4), 1.4), "three edges"),
        (lambda: instobj.field.block_field(POINT, (8, 4, -1), 1.4), "z edge must be positive"),
        (lambda: instobj.field.polarization(1.2, (5,)), "diameter, height"),
        (lambda: instobj.field.polarization(1.2, (5, 5), 0.9), "recoil_permeability"),
        (lambda: instobj.fem.press(instobj.ObjectSpec(name="a"), [], 1.0), "tips is empty"),
        (lambda: instobj.fem.press(instobj.ObjectSpec(name="a"), [(1, 0, 0)], -1), "depth_mm"),
        (lambda: instobj.fem.indent_half_space([0, 1], 1, 1, 0.3), "shape"),
        (lambda: instobj.fem.indent_half_space(MAP, 0, 1, 0.3), "cell_mm must be positive"),
        (lambda: instobj.fem.indent_half_space(MAP, 1, 1, 0.3, 0.6), "linear elasticity"),
        (lambda: instobj.fem.indent_half_space(np.zeros((80, 80)), 1, 1, 0.3), "larger cell_mm"),
        (lambda: instobj.information.contact_bounds(SLOPES[0], [1.0] * 3), "shape"),
        (lambda: instobj.information.contact_bounds(SLOPES, [1.0, 0.0, 1.0]), "3 positive counts"),
        (lambda: instobj.information.detectable_force([[2, 1]], np.ones((1, 2, 1)), [1]), "rise"),
        (lambda: instobj.information.detectable_force([1, 2], np.ones((1, 2, 1)), [1]), "shape"),
        (lambda: instobj.information.hull_sensitivity(MAP, [1], [1]), "shape"),
        (lambda: instobj.information.hull_sensitivity(MAP[None], [0], [1] * 3), "force_range_n"),
        (lambda: instobj.information.hull_sensitivity(MAP[None], [1], [1] * 3, 3), "frames"),
    ],
)
def test_what_cannot_be_is_refused_with_its_name(call, words):
    with pytest.raises(instobj.InputError, match=words):
        call()


def test_a_ring_and_a_block_have_the_fields_of_magpylib():
    points = np.array([[3.0, -2.0, 5.0], [1.0, 7.0, -4.0]])
    ring = magpylib.magnet.CylinderSegment(
        polarization=(0, 0, 1.3), dimension=(2e-3, 4e-3, 2e-3, 0, 360)
    )
    block = magpylib.magnet.Cuboid(polarization=(0, 0, 1.3), dimension=(8e-3, 4e-3, 2e-3))
    for field, source in (
        (instobj.field.disk_field(points, 8, 2, 1.3, 4), ring),
        (instobj.field.block_field(points, (8, 4, 2), 1.3), block),
    ):
        np.testing.assert_allclose(field.values, source.getB(points * 1e-3), rtol=1e-8)


def test_a_flat_square_punch_presses_twice_as_hard_on_twice_the_modulus():
    """In proportion to depth and modulus, with its largest pressure at the corners."""
    soft = instobj.fem.indent_half_space(np.zeros((9, 9)), 0.5, 0.1, 0.2)
    hard = instobj.fem.indent_half_space(np.zeros((9, 9)), 0.5, 0.2, 0.4)
    assert hard.force_n / soft.force_n == pytest.approx(4, rel=1e-9)
    assert soft.pressure_mpa[0, 0] > 0.99 * soft.pressure_mpa.max()


def test_bounds_of_whitened_noise_do_not_depend_on_the_unit_of_counts():
    mixed = SLOPES @ np.linalg.qr(np.arange(9.0).reshape(3, 3) + np.eye(3))[0]
    one = instobj.information.contact_bounds(mixed, [5.0, 7.0, 9.0])
    ten = instobj.information.contact_bounds(10 * mixed, [50.0, 70.0, 90.0])
    np.testing.assert_allclose(ten.position_bound_mm, one.position_bound_mm, rtol=1e-12)
    # the inverse of the Fisher information, written out
    whitened = mixed[0] / np.array([[5.0], [7.0], [9.0]])
    variance = np.linalg.inv(whitened.T @ whitened).diagonal()
    assert one.position_bound_mm.item() == pytest.approx(np.sqrt(variance[:2].sum()))
    assert one.force_bound_n.item() == pytest.approx(np.sqrt(variance[2]))


def test_a_force_that_is_never_felt_is_infinite():
    felt = instobj.information.detectable_force([[1.0, 2.0]], np.full((1, 2, 1), 0.1), [10.0])
    assert np.isinf(felt.values).all()


def test_results_say_what_they_are():
    shown = repr(instobj.fem.indent_half_space(MAP, 0.5, 0.1, 0.3))
    assert "x 3, y 3" in shown
    assert "pressure_mpa  (x, y)  MPa" in shown
    cube = repr(instobj.ObjectSpec(name="cube"))
    assert "box of 42 × 42 × 42 mm" in cube
    assert len(cube) < 200
