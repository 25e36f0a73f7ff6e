"""Batched torch field: parity with magpylib and with NumPy, gradients, pieces, devices."""

import numpy as np
import pytest
import torch
from numpy.testing import assert_allclose
from scipy.spatial.transform import Rotation

from design.errors import InputError
from estimator.field.batched import batched_field
from estimator.field.models import FieldModel, field_model, model_error, total_field
from estimator.field.sources import DiskMagnet
from tests.support.mechanics.magnet_poses import DISKS, magpylib_field, random_poses, relative_error

DEVICES = ["cpu", *(["cuda"] if torch.cuda.is_available() else [])]
TYPES = {torch.float32: 3e-6, torch.float64: 1e-13}
"""Rounding error allowed, relative to the local field."""


def tensors(dtype, device, *arrays):
    return [torch.tensor(array, dtype=dtype, device=device) for array in arrays]


def pair_by_pair(model, poses, dtype=torch.float64, device="cpu", gradient=True):
    """Field of one magnet at one point for each pose, through the batched function."""
    turn, centre, point = poses
    axis = turn.apply([0, 0, 1])
    given = tensors(dtype, device, point[:, None], centre[:, None], axis[:, None])
    given[0].requires_grad_(gradient)
    return batched_field(*given, model)[:, 0].detach().cpu().double().numpy()


def random_presses(rng, presses=7, points=5, magnets=4):
    """Points near the origin, magnets 9 to 14 mm away in random directions, random axes."""
    away = rng.standard_normal((presses, magnets, 3))
    away *= rng.uniform(9, 14, (presses, magnets, 1)) / np.linalg.norm(away, axis=-1, keepdims=True)
    axes = Rotation.random(presses * magnets, rng=rng).apply([0, 0, 1])
    return rng.uniform(-1, 1, (presses, points, 3)), away, axes.reshape(away.shape)


@pytest.mark.parametrize("device", DEVICES)
@pytest.mark.parametrize("dtype", TYPES)
@pytest.mark.parametrize("disk", DISKS)
@pytest.mark.parametrize(("reach", "gradient"), [(1.6, True), (2.6, False)])
def test_series_and_dipole_match_magpylib_within_their_stated_error(
    device, dtype, disk, reach, gradient
):
    nearest = reach * disk.circumscribed_radius_mm
    poses = random_poses(disk, nearest, np.random.default_rng(11), 400)
    exact = magpylib_field(disk, *poses)
    model = field_model(disk, nearest)
    series = pair_by_pair(model, poses, dtype, device, gradient)
    assert relative_error(series, exact).max() <= 1e-3
    dipole = pair_by_pair(FieldModel(disk, "dipole"), poses, dtype, device)
    stated = model_error(FieldModel(disk, "dipole"), nearest)
    assert 0.1 * stated < relative_error(dipole, exact).max() <= stated


@pytest.mark.parametrize("gradient", [False, True])
@pytest.mark.parametrize("device", DEVICES)
@pytest.mark.parametrize("dtype", TYPES)
@pytest.mark.parametrize("order", [1, 7, 9, 25])
def test_tensors_and_arrays_agree_to_rounding(device, dtype, order, gradient):
    model = FieldModel(DISKS[0], "multipole", order)
    points, centres, axes = random_presses(np.random.default_rng(13))
    given = tensors(dtype, device, points, centres, axes)
    given[0].requires_grad_(gradient)
    found = batched_field(*given, model).detach()
    assert (found.dtype, found.device.type) == (dtype, device)
    one_by_one = [
        total_field(p, c, a, model) for p, c, a in zip(points, centres, axes, strict=True)
    ]
    scale = np.abs(one_by_one).max()
    assert_allclose(found.cpu().numpy(), one_by_one, rtol=0, atol=10 * TYPES[dtype] * scale)


@pytest.mark.parametrize("gradient", [False, True])
@pytest.mark.parametrize("chunk_pairs", [1, 3, 8, 21, 60, 10**6])
def test_pieces_and_gradients_do_not_change_the_result(chunk_pairs, gradient):
    model = FieldModel(DISKS[0], "multipole", 7)
    points, centres, axes = random_presses(np.random.default_rng(14))
    given = tensors(torch.float64, "cpu", points, centres, axes)
    one_by_one = [
        total_field(p, c, a, model) for p, c, a in zip(points, centres, axes, strict=True)
    ]
    given[1].requires_grad_(gradient)
    pieces = batched_field(*given, model, chunk_pairs=chunk_pairs)
    assert pieces.requires_grad is gradient
    assert_allclose(pieces.detach(), one_by_one, rtol=1e-12, atol=1e-18)


@pytest.mark.parametrize("shared", [(0,), (1,), (2,), (0, 1), (1, 2), (0, 2)])
def test_what_all_presses_share_is_given_once(shared):
    given = tensors(torch.float64, "cpu", *random_presses(np.random.default_rng(15)))
    once = [t[:1] if i in shared else t for i, t in enumerate(given)]
    repeated = [t.expand(7, -1, -1) for t in once]
    model = FieldModel(DISKS[0], "multipole", 9)
    for chunk_pairs in (None, 11):
        found = batched_field(*once, model, chunk_pairs=chunk_pairs)
        assert_allclose(found, batched_field(*repeated, model), rtol=1e-12, atol=1e-18)


def test_a_single_press_with_many_points_is_a_map():
    rng = np.random.default_rng(16)
    points = np.array([20.0, 5.0, 1.0]) + rng.uniform(-3, 3, (900, 3))
    centres, axes = rng.uniform(-2, 2, (3, 3)), Rotation.random(3, rng=rng).apply([0, 0, 1])
    model = field_model(DISKS[0], 10.0)
    given = tensors(torch.float64, "cpu", points[None], centres[None], axes[None])
    found = batched_field(*given, model, chunk_pairs=500)[0]
    assert_allclose(found, total_field(points, centres, axes, model), rtol=1e-11, atol=1e-18)


@pytest.mark.parametrize("device", DEVICES)
@pytest.mark.parametrize("order", [1, 7])
@pytest.mark.parametrize("chunk_pairs", [4, None])
def test_gradients_in_points_centres_and_axes_by_finite_differences(device, order, chunk_pairs):
    model = FieldModel(DiskMagnet(6.0, 1.0, 1.43e4), "multipole", order)
    arrays = random_presses(np.random.default_rng(17), presses=3, points=2, magnets=2)
    given = [t.requires_grad_() for t in tensors(torch.float64, device, *arrays)]
    assert torch.autograd.gradcheck(
        lambda p, c, a: batched_field(p, c, a, model, chunk_pairs), given, atol=1e-6, rtol=1e-6
    )


def gradients_of_one_magnet(disk, point, centre, axis):
    """∂B/∂point, ∂B/∂centre and ∂B/∂axis (3 × 3 each) from autograd."""
    model = field_model(disk, 8.0, tolerance=1e-5)
    given = tensors(torch.float64, "cpu", point[None, None], centre[None, None], axis[None, None])
    jacobians = torch.autograd.functional.jacobian(
        lambda p, c, a: batched_field(p, c, a, model)[0, 0], tuple(given)
    )
    return [jacobian[:, 0, 0].numpy() for jacobian in jacobians]


def test_gradients_match_differences_of_magpylib():
    disk, step = DISKS[0], 1e-3
    point, centre = np.array([1.0, -2.0, 3.0]), np.array([4.0, 3.5, -3.0])
    turn = Rotation.from_rotvec([0.4, -0.7, 0.2])

    def exact(point, centre, turn):
        return magpylib_field(disk, [turn], [centre], [point])[0]

    by_point, by_centre, by_axis = gradients_of_one_magnet(
        disk, point, centre, turn.apply([0, 0, 1])
    )
    for axis, shift in enumerate(step * np.eye(3)):
        change = exact(point + shift, centre, turn) - exact(point - shift, centre, turn)
        scale = np.abs(by_point).max()
        assert_allclose(by_point[:, axis], change / (2 * step), rtol=0, atol=1e-4 * scale)
        assert_allclose(by_centre[:, axis], -change / (2 * step), rtol=0, atol=1e-4 * scale)
        tilt = Rotation.from_rotvec(shift)
        change = exact(point, centre, tilt * turn) - exact(point, centre, tilt.inv() * turn)
        turned = by_axis @ np.cross(shift / step, turn.apply([0, 0, 1]))
        scale = np.abs(by_axis).max()
        assert_allclose(turned, change / (2 * step), rtol=0, atol=1e-4 * scale)
        assert abs(turned + change / (2 * step)).max() > 1e-2 * scale


def test_descent_on_the_gradient_finds_a_displaced_magnet():
    rng = np.random.default_rng(18)
    points, centres, axes = random_presses(rng, presses=1, points=6, magnets=1)
    points, centres, axes = tensors(torch.float64, "cpu", points, centres, axes)
    model = FieldModel(DISKS[0], "multipole", 7)
    measured = batched_field(points, centres, axes, model)
    guess = (centres + torch.tensor([0.3, -0.2, 0.25])).double().requires_grad_()
    optimizer = torch.optim.LBFGS([guess], max_iter=60, line_search_fn="strong_wolfe")

    def loss():
        optimizer.zero_grad()
        error = (1e3 * (batched_field(points, guess, axes, model) - measured)).square().sum()
        error.backward()
        return error

    optimizer.step(loss)
    assert_allclose(guess.detach(), centres, atol=1e-3)


def test_what_cannot_be_computed_is_refused():
    given = tensors(torch.float64, "cpu", *random_presses(np.random.default_rng(19)))
    model = FieldModel(DISKS[0], "multipole", 7)
    with pytest.raises(InputError, match="disk of Ø6 × 1 mm has no torch form"):
        batched_field(*given, FieldModel(DISKS[0], "exact"))
    with pytest.raises(InputError, match=r"share one type.*torch.float32 on cpu, torch.float64"):
        batched_field(given[0].float(), given[1], given[2], model)
    with pytest.raises(InputError, match="must not be empty"):
        batched_field(given[0][:, :0], given[1], given[2], model)


@pytest.mark.parametrize("gradient", [True, False])
def test_magnets_of_unlike_strength_add_up(gradient):
    """And the slope in a strength is the field of that magnet alone."""
    disk = DiskMagnet(6.0, 1.0, 1.3)
    model = field_model(disk, 6.0)
    given = tensors(torch.float64, "cpu", *random_presses(np.random.default_rng(4)))
    strength = torch.tensor([1.0, -0.5, 1.2, 0.0], dtype=torch.float64, requires_grad=gradient)
    found = batched_field(*given, model, strength=strength)
    alone = [
        batched_field(given[0], *(part[:, k : k + 1] for part in given[1:]), model)
        for k in range(4)
    ]
    wanted = sum(s * one for s, one in zip(strength.tolist(), alone, strict=True))
    assert_allclose(found.detach(), wanted, rtol=0, atol=1e-15)
    if gradient:
        found[2, 1, 0].backward()
        assert_allclose(strength.grad, [float(one[2, 1, 0]) for one in alone], rtol=1e-12)
