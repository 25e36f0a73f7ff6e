"""Boards and magnets on curved faces: what is flat stays within what is round."""

from pathlib import Path

import numpy as np
import pytest

from design.errors import InputError
from design.layout.boards import mounted_sensors
from design.layout.body import body_of, face_frames
from design.layout.places.positions import board_sinks_mm, cover_mm, rims_of_stack, sensor_layout
from design.layout.pockets import Body, Outline, magnet_bodies, tilted_frame
from design.solids.core import make_core
from design.solids.primitives import block_solid
from design.spec.object import ObjectSpec
from design.spec_io import load_spec
from tests.support.objects.worked_objects import worked

EXAMPLES = Path(__file__).parents[3] / "examples"
CURVED = ("ball", "egg", "handle", "pear", "capsule")
SIGNS = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])


def highest_mm(spec):
    """How far the highest corner of any board or chip stands out of the core."""
    blocks = [block for one in mounted_sensors(spec) for block in (one.board, one.chip)]
    corners = [block.centre_mm + (SIGNS * block.half_mm) @ block.axes.T for block in blocks]
    return float(body_of(spec).core_distance_mm(np.concatenate(corners)).max())


@pytest.mark.parametrize("name", CURVED)
def test_the_highest_corner_is_flush_with_the_core(name):
    spec = load_spec(EXAMPLES / f"{name}.toml")
    assert abs(highest_mm(spec)) < 1e-3


def test_boards_on_flat_faces_stay_where_they_are():
    assert not np.any(board_sinks_mm(load_spec(EXAMPLES / "paper_cube.toml")))
    handle = load_spec(EXAMPLES / "handle.toml")
    ends, *sides = board_sinks_mm(handle)
    assert not any(ends)
    assert all(min(side) > 0.3 for side in sides)


def test_chips_go_down_with_their_boards():
    ball = load_spec(EXAMPLES / "ball.toml")
    depth = -body_of(ball).core_distance_mm(sensor_layout(ball).position_mm)
    sinks = np.concatenate(board_sinks_mm(ball))
    np.testing.assert_allclose(depth, ball.sensors.depth_below_core_face_mm + sinks, atol=1e-6)


def test_the_recess_takes_the_whole_board():
    ball = load_spec(EXAMPLES / "ball.toml")
    core = make_core(ball)
    for sensor in mounted_sensors(ball)[:2]:
        for block in (sensor.board, sensor.chip):
            inside = block_solid(block).intersect(core)
            assert inside.Volume() < 1e-6


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        (["core.wall_mm=3.5"], r"4\.044 mm deep.*core\.wall_mm is 3\.5 mm"),
        (["core.recess_outer_radius_mm=1e-9"], "recess_inner_radius_mm < recess_outer_radius_mm"),
        (["core.recess_inner_radius_mm=380"], "Move the recess inwards"),
    ],
)
def test_recesses_that_the_core_cannot_hold_are_refused(changes, said):
    with pytest.raises(InputError, match=said):
        load_spec(EXAMPLES / "ball.toml", changes)


def test_silicone_over_a_magnet_is_thinnest_over_its_rim():
    ball = load_spec(EXAMPLES / "ball.toml")
    radius, magnets = ball.body.size_mm[0] / 2, ball.magnets
    for frame, bodies in zip(face_frames(ball), magnet_bodies(ball), strict=True):
        for body in bodies:
            top = radius + body.centre_mm[2] + magnets.height_mm / 2
            rim = np.hypot(top, magnets.diameter_mm / 2)
            assert cover_mm(frame, body) == pytest.approx(radius - rim, abs=1e-6)
            assert cover_mm(frame, body) < radius - top - 0.1, "on the axis there is more"


@pytest.mark.parametrize("towards_deg", range(0, 360, 30))
def test_a_leaning_magnet_is_nearest_to_a_flat_surface_at_the_rim_that_rises(towards_deg):
    """A disk of R 3 mm and 1 mm, 4 mm deep, whose top leans 10° away from where its rim rises."""
    tilt = np.deg2rad(10) * np.array(
        [-np.sin(np.deg2rad(towards_deg)), np.cos(np.deg2rad(towards_deg))]
    )
    magnets = {"positions_mm": [[1.0, -2.0]], "tilt_deg": [(-np.rad2deg(tilt)).tolist()]}
    spec = ObjectSpec.model_validate({"name": "leaning", "magnets": magnets})
    (body,) = magnet_bodies(spec)[0]
    height, radius = body.height_mm / 2, spec.magnets.diameter_mm / 2
    top = body.centre_mm[2] + height * np.cos(np.deg2rad(10)) + radius * np.sin(np.deg2rad(10))
    within = np.cos(np.pi / 48)  # of the nearest of 48 points round the rim
    found = -cover_mm(face_frames(spec)[0], body)
    assert top - (1 - within) * radius * np.sin(np.deg2rad(10)) - 1e-9 <= found <= top + 1e-9


@pytest.mark.parametrize(
    ("azimuth_deg", "radial"), [(0.0, (1, 0)), (90.0, (0, 1)), (180.0, (-1, 0))]
)
def test_points_round_board_and_chip_lie_about_their_own_middles(azimuth_deg, radial):
    """A recess from 2.5 to 6.5 mm has its board's middle at 4.5, 0.3 mm inwards of a chip at 4.8."""
    spec = worked("box")
    place = np.array([[4.8 * radial[0], 4.8 * radial[1], np.deg2rad(azimuth_deg)]])
    points, tops = rims_of_stack(spec, place)
    along, across = points[0] @ radial, points[0] @ [-radial[1], radial[0]]
    board, chip = slice(0, len(tops) // 2), slice(len(tops) // 2, None)
    for part, low, high, wide in ((board, -2.1, 1.5, 1.9), (chip, -0.85, 0.85, 0.95)):
        ends = [along[part].min(), along[part].max(), across[part].min(), across[part].max()]
        np.testing.assert_allclose(ends, [low, high, -wide, wide], atol=1e-9)


def test_a_magnet_that_stands_out_of_a_curved_face_is_refused():
    wide = ["magnets.diameter_mm=12", "shell.pocket_diameter_mm=12", "shell.pocket_depth_mm=1.5"]
    with pytest.raises(InputError, match=r"stands 0\.36 mm out of the curved face 2"):
        load_spec(EXAMPLES / "handle.toml", wide)


@pytest.mark.parametrize("package_mm", [(6.0, 4.0, 1.0), (8.0, 6.0, 1.0)])
def test_a_board_sinks_until_its_corners_are_flush_with_a_small_ball(package_mm):
    """R − √(R² − d²/4) by hand; single steps by what stands out gain half of it each on the steep one."""
    radius, corner = 5.8, np.hypot(*package_mm[:2]) / 2
    content = {
        "body": {"kind": "sphere", "size_mm": [2 * radius + 12] * 3, "sensed_faces": [1]},
        "shell": {"thickness_mm": 6.0},
        "core": {"recess_inner_radius_mm": 0.25, "recess_outer_radius_mm": 6.75},
        "sensors": {
            "radius_mm": 3.5,
            "positions_mm": [[0, 0]],
            "count_per_face": 1,
            "package_mm": package_mm,
        },
    }
    ((sink,),) = board_sinks_mm(ObjectSpec.model_validate({"name": "ball", **content}))
    assert sink == pytest.approx(radius - np.sqrt(radius**2 - corner**2), abs=1e-5)


def test_silicone_is_thinnest_over_the_rim_that_is_highest():
    """A disk of Ø6 × 2 mm, 4 mm deep: leaning on a flat face whichever way; across a cylinder, whose
    axis is as far from the rim as Pythagoras says."""
    disk = Outline((3.0, 3.0), True)

    def cover(frame, tilt=(0.0, 0.0), xy=(0.0, 0.0)):
        body = Body(np.array([*xy, -4.0]), tilted_frame(*tilt), disk, 2.0, "a magnet")
        return cover_mm(frame, body)

    flat = face_frames(worked("closed box"))[2]
    lean = np.deg2rad(20)
    leaning = 4 - 3 * np.sin(lean) - np.cos(lean)
    for tilt in ((20.0, 0.0), (-20.0, 0.0), (0.0, 20.0), (0.0, -20.0)):
        assert cover(flat, tilt, (2.0, -1.0)) == pytest.approx(leaning)
    assert cover(flat, (12.0, -16.0)) == pytest.approx(leaning, abs=3e-3)
    handle = load_spec(EXAMPLES / "handle.toml")
    round_ = [frame for frame in face_frames(handle) if not frame.flat]
    radius = np.hypot(*round_[0].centre_mm[:2])
    across = radius - np.hypot(radius - 3, 3.0)
    for frame in round_:
        assert cover(frame) == pytest.approx(across, abs=1e-3)
