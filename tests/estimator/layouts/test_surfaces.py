"""Places of magnets and chips under curved surfaces, in batches: beside the whole chain's layout."""

import numpy as np
import pytest
import torch
from numpy.testing import assert_allclose

from design.layout.places.positions import (
    board_sinks_mm,
    magnet_layout,
    sensor_layout,
    sinks_of_boards_mm,
)
from design.layout.pockets import magnet_bodies, sensor_places
from estimator.layouts.batch import Layouts
from estimator.layouts.surfaces import (
    clamp_to_patch_mm,
    pointwise,
    surfaces,
    to_object,
    turned_to_object,
)
from tests.support.objects.body_cases import body_spec

BODIES = ("capsule", "ellipsoid", "cylinder", "dome_on_core")


@pytest.fixture(scope="module", params=BODIES)
def spec(request):
    return body_spec(request.param)


def laid(spec, face, surface):
    """Magnets' centres and normals, chips' points and axes, of the specification's own layout."""
    index = spec.body.sensed.index(face)
    xyd = np.array([body.centre_mm * [1, 1, -1] for body in magnet_bodies(spec)[index]])
    xy = np.array(sensor_places(spec)[index])[:, :2]
    return placed(surface, torch.tensor(xyd), torch.tensor(xy))


def placed(surface, xyd, xy):
    """The same of any places, in the object's frame."""
    layouts = of_places(xyd, xy)
    (centre, axes), (point, chips) = surface.magnets(layouts), surface.chips(layouts)
    rows = turned_to_object(surface.chip_frame, chips.transpose(-1, -2))
    found = (
        to_object(surface.frame, centre),
        turned_to_object(surface.frame, axes[..., 2]),
        to_object(surface.chip_frame, point),
        rows,
    )
    return [part[0] for part in found]


def of_places(xyd, xy):
    flat = torch.zeros_like(xyd[None, :, :2])
    return Layouts(xyd[None], flat, torch.ones_like(flat[..., 0]), xy[None])


def whole_chain(spec, face):
    magnets, sensors = magnet_layout(spec), sensor_layout(spec)
    here, there = magnets.face == face, sensors.face == face
    return (
        magnets.centre_mm[here],
        magnets.axis[here],
        sensors.position_mm[there],
        sensors.axes[there],
    )


def test_a_layout_lies_where_the_whole_chain_has_it(spec):
    for face, surface in surfaces(spec).items():
        for found, wanted in zip(laid(spec, face, surface), whole_chain(spec, face), strict=True):
            assert_allclose(found, wanted, rtol=0, atol=1e-9)


def test_gradients_are_those_of_the_surface():
    surface = surfaces(body_spec("ellipsoid"))[3]
    xyd = torch.tensor(
        [[4.0, -5.0, 2.5], [-9.0, 3.0, 4.0]], dtype=torch.float64, requires_grad=True
    )
    xy = torch.tensor([[3.0, -4.0], [-5.0, 2.0]], dtype=torch.float64, requires_grad=True)

    def magnets(places):
        return surface.magnets(of_places(places, xy))

    def chips(places):
        return surface.chips(of_places(xyd, places))

    assert torch.autograd.gradcheck(magnets, (xyd,), eps=1e-3, atol=1e-5)
    assert torch.autograd.gradcheck(surface.lengths_mm, (xy,), eps=1e-3, atol=1e-5)
    assert torch.autograd.gradcheck(chips, (xy,), eps=1e-3, atol=1e-4)
    depth = torch.autograd.grad(magnets(xyd)[0].sum(), xyd)[0][:, 2]
    assert_allclose(depth, -magnets(xyd)[1][0, ..., 2].detach().sum(dim=1), atol=1e-7)


def test_a_function_of_points_has_the_slopes_of_its_arguments():
    at = torch.tensor([[[1.0, 2.0]], [[3.0, -1.0]]], dtype=torch.float64, requires_grad=True)
    found = pointwise(lambda p: np.column_stack([p[:, 0] * p[:, 1], p[:, 0] ** 2, p[:, 1]]), at)
    assert found.shape == (2, 1, 3)
    (slopes,) = torch.autograd.grad(found, at, torch.tensor([1.0, 10.0, 100.0]).expand_as(found))
    assert_allclose(slopes, [[[22.0, 101.0]], [[59.0, 103.0]]], rtol=1e-9)


def test_beside_its_patch_a_part_lies_at_the_border(spec):
    for surface in surfaces(spec).values():
        for far in ([[90.0, 40.0]], [[-3.0, -80.0]]):
            xy = np.array(far)
            near = clamp_to_patch_mm(surface.frame, xy)
            assert surface.frame.covers(near).all()
            assert not surface.frame.covers(1.001 * near).any()
            assert_allclose(near[0, 0] * xy[0, 1], near[0, 1] * xy[0, 0], atol=1e-9)
            found = placed(surface, torch.tensor([[*far[0], 2.5]]), torch.tensor(far))
            assert all(torch.isfinite(values).all() for values in found)


@pytest.mark.parametrize("sensed", [(1, 2, 3, 4, 5), (1, 2, 3)], ids=str)
def test_faces_that_are_turned_copies_share_places_and_the_others_do_not(sensed):
    """A cylinder's sides are alike, and its end is not."""
    known = surfaces(body_spec("cylinder", body={"sensed_faces": list(sensed)}))
    assert len({surface.shape for surface in known.values()}) == 2
    assert known[2].shape == known[3].shape != known[1].shape


def test_boards_sink_as_far_as_their_corners_need():
    """Of a board 6 mm wide over the middle of a cylinder's side: R − √(R² − 3²)."""
    spec = body_spec(
        "cylinder", sensors={"positions_mm": [[0.0, 0.0]], "package_mm": [6.0, 2.8, 1.0]}
    )
    surface = surfaces(spec)[2]
    radius = spec.core_size_mm[0] / 2
    along_x = surface.sinks_mm(np.array([[1e-9, 0.0]]))
    assert_allclose(along_x, radius - np.sqrt(radius**2 - 9), rtol=0, atol=1e-6)
    assert_allclose(board_sinks_mm(spec)[1], along_x, rtol=0, atol=1e-6)


def test_a_board_finds_room_up_to_where_its_corner_leaves_the_core_s_patch():
    surface = surfaces(body_spec("capsule"))[2]
    rng = np.random.default_rng(3)
    turn = rng.uniform(-np.pi, np.pi, 20)
    way = np.stack([np.cos(turn), np.sin(turn)], axis=-1)
    reach = surface.reach_mm(way)
    assert surface.core.covers(0.95 * reach[:, None] * way).all()
    assert (reach > 4.0).all()
    assert (reach <= 1.001 * max(surface.core.half_extents_mm)).all()


def test_a_board_finds_as_much_room_on_either_side_of_the_first_direction():
    """A capsule's side is alike to its left and right, and its patch ends farthest along its length."""
    surface = surfaces(body_spec("capsule"))[2]
    turn = np.array([0.01, 0.05, 0.09])

    def reach(azimuth):
        return surface.reach_mm(np.column_stack([np.cos(azimuth), np.sin(azimuth)]))

    assert (np.diff(reach(turn)) < -0.05).all()
    assert_allclose(reach(-turn), reach(turn), rtol=1e-9)
    assert_allclose(reach(np.pi - turn), reach(turn), rtol=1e-3)


def test_boards_sink_at_their_own_places_and_beyond_their_reach_as_just_within_it():
    """On a capsule's side, whose ends curve more than its middle."""
    spec = body_spec("capsule")
    surface = surfaces(spec)[2]
    turn = np.linspace(0.1, 6.0, 9)
    way = np.column_stack([np.cos(turn), np.sin(turn)])
    reach = surface.reach_mm(way)[:, None]

    def own(places):
        azimuth = np.arctan2(places[:, 1], places[:, 0])
        return sinks_of_boards_mm(spec, surface.core, np.column_stack([places, azimuth]))

    for share in (0.3, 0.6, 0.9):
        assert_allclose(surface.sinks_mm(share * reach * way), own(share * reach * way))
    just = own(0.98 * reach * way)
    assert np.ptp(just) > 0.05
    for share in (1.2, 3.0):
        assert_allclose(surface.sinks_mm(share * reach * way), just, atol=1e-9)
