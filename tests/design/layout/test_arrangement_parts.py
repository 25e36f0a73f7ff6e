"""Blocks, rings and sensor boards in shell and core; places and turns of sensors; refusals."""

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.spatial.transform import Rotation

from design.catalogue.magnets import MAGNET_PARTS
from design.errors import InputError
from design.layout.boards import board_blocks
from design.layout.body import face_frames
from design.layout.places.positions import magnet_layout, sensor_layout, shell_body_layout
from design.layout.pockets import core_pockets
from design.solids.core import make_core
from design.solids.shell import make_shell
from design.spec.sensors import fastest_frame_rate_hz
from design.spec_io import parse_spec, spec_hash
from tests.support.objects.shell_volume import cast_cavity, shell_volume_mm3

IN_CORE = {"positions_mm": [[8, 8], [-8, 8], [-8, -8], [8, -8]]}


def parsed(**parts):
    return parse_spec({"name": "cube", **parts}, "test")


REVERSE = parsed(arrangement="sensors-in-shell", magnets=IN_CORE)
BLOCKS = parsed(
    magnets={
        "shape": "block",
        "size_mm": [6.0, 3.0],
        "positions_mm": [[2.0, -1.0], [-9.0, 5.0]],
        "tilt_deg": [[0, 0], [12, -8]],
        "depth_mm": 3.2,
    }
)


@pytest.mark.parametrize("spec", [REVERSE, BLOCKS], ids=["boards", "blocks"])
def test_shell_and_casting_have_the_closed_form_volume(spec):
    volume = shell_volume_mm3(spec)
    assert_allclose(make_shell(spec).Volume(), volume, rtol=1e-9)
    assert_allclose(cast_cavity(spec).Volume(), volume, rtol=1e-9)


def test_board_pockets_are_as_large_as_their_boards():
    assert_allclose(
        shell_volume_mm3(REVERSE), 42**3 - 26 * 26 * 34 - 15 * 6.6 * 6.2 * 3.0, rtol=1e-12
    )


def test_a_reversed_core_has_magnet_pockets_in_place_of_recesses():
    wired = parsed(
        arrangement="sensors-in-shell", magnets={"positions_mm": [[0, 8]], "height_mm": 1.5}
    )
    bare = parsed(
        arrangement="sensors-in-shell", magnets={"positions_mm": [[0, 8]], "height_mm": 1}
    )
    difference = make_core(bare).Volume() - make_core(wired).Volume()
    assert_allclose(difference, 5 * np.pi * 9 * 0.5, rtol=1e-6)
    assert make_core(wired).Volume() > make_core(parsed()).Volume()
    (pocket,) = core_pockets(wired)[0]
    assert_allclose([pocket.lowest_mm, pocket.body.centre_mm[2]], [-1.5, -0.75])
    assert core_pockets(parsed()) == ((),) * 5


def test_magnets_in_the_core_lie_below_its_faces():
    sunk = parsed(
        arrangement="sensors-in-shell", magnets={**IN_CORE, "depth_below_core_face_mm": 0.4}
    )
    layout = magnet_layout(sunk)
    heights = np.array(
        [
            frame.normal @ centre
            for frame in face_frames(sunk)
            for centre in layout.centre_mm[layout.face == frame.number]
        ]
    )
    assert_allclose(heights, 13 - 0.4 - 0.5)
    normals = {frame.number: frame.normal for frame in face_frames(sunk)}
    assert_allclose(layout.axis, [normals[face] for face in layout.face.tolist()])


def test_sides_of_blocks_follow_the_faces_x_and_their_tilt():
    layout, frames = magnet_layout(BLOCKS), face_frames(BLOCKS)
    assert_allclose(layout.side[::2], [frame.x for frame in frames], atol=1e-12)
    assert_allclose(np.einsum("mi,mi->m", layout.side, layout.axis), 0, atol=1e-12)
    tilted = layout.side[1] @ frames[0].x
    assert 0.98 < tilted < 0.9999
    assert_allclose(shell_body_layout(BLOCKS).frame[:, :, 0], layout.side, atol=1e-12)


def test_a_part_fills_in_shape_size_and_grade():
    magnets = parsed(
        magnets={"part": "MPL 10x5x1.5 / N38", **IN_CORE}, shell={"pocket_depth_mm": 3}
    ).magnets
    assert (magnets.shape, magnets.size_mm, magnets.height_mm) == ("block", (10.0, 5.0), 1.5)
    assert (magnets.grade, magnets.remanence_t) == ("N38", 1.24)
    ring = parsed(magnets={"part": "R6x2x2"}).magnets
    assert (ring.shape, ring.diameter_mm, ring.inner_diameter_mm) == ("ring", 6.0, 2.0)
    again = parse_spec(parsed(magnets={"part": "R6x2x2"}).model_dump(mode="json"), "again")
    assert spec_hash(again) == spec_hash(parsed(magnets={"part": "R6x2x2"}))
    assert all(part.source and name == part.name for name, part in MAGNET_PARTS.items())


def test_sensors_stand_where_explicit_places_put_them():
    places = [[0.0, 8.0], [-6.0, -4.0]]
    spec = parsed(sensors={"positions_mm": places})
    assert spec.sensors.count_per_face == 2
    layout = sensor_layout(spec)
    for frame in face_frames(spec):
        local = frame.from_object(layout.position_mm[layout.face == frame.number])
        assert_allclose(local[:, :2], places, atol=1e-12)
        assert_allclose(local[:, 2], -8 - 2.3)
        radial = layout.axes[layout.face == frame.number][:, 1] @ frame.axes
        assert_allclose(radial, [[0, 1, 0], np.array([-6, -4, 0]) / np.hypot(6, 4)], atol=1e-12)
    per_face = [[[k, 8.0], [-6.0, -4.0]] for k in range(5)]
    moved = sensor_layout(parsed(sensors={"positions_mm": per_face}))
    shift = moved.position_mm[8] - layout.position_mm[8]
    assert_allclose(shift, 4 * face_frames(spec)[4].x, atol=1e-12)
    assert make_core(spec).isValid()


def test_explicit_ring_places_are_the_ring():
    ring = parsed()
    places = [[[x, y] for x, y, _ in face] for face in ring.sensors.places]
    same = sensor_layout(parsed(sensors={"positions_mm": places}))
    assert_allclose(same.position_mm, sensor_layout(ring).position_mm, atol=1e-12)
    assert_allclose(same.axes, sensor_layout(ring).axes, atol=1e-12)


def test_chips_that_face_outward_are_turned_about_their_own_y():
    """Rows: the turned X, Y, Z in terms of the nominal X, Y, Z."""
    nominal, outward = (sensor_layout(parsed(sensors={"chip": c})) for c in ("inward", "outward"))
    assert_allclose(outward.axes, np.diag([-1, 1, -1]) @ nominal.axes, atol=1e-12)


BOARD = {
    "positions_mm": [[0, 0], [-7, 0], [0, -7]],
    "rotations_deg": [[0, 0, 0], [0, 0, 270], [180, 0, 90]],
    "package_mm": [1.5, 1.5, 1.6],
}


def test_every_chip_of_a_board_turns_from_the_axes_of_its_face():
    """Against rotations by SciPy; the last one lies on its back."""
    spec = parsed(sensors=BOARD, core={"recess_inner_radius_mm": 1.0})
    axes = sensor_layout(spec).axes.reshape(5, 3, 3, 3)
    for frame, chips in zip(face_frames(spec), axes, strict=True):
        for found, vector in zip(chips, BOARD["rotations_deg"], strict=True):
            turned = Rotation.from_rotvec(vector, degrees=True).as_matrix()
            assert_allclose(found.T, frame.axes @ turned, atol=1e-12)


def test_rotations_as_azimuths_would_turn_the_chips_change_nothing():
    ring = parsed()
    turns = [[[0, 0, np.rad2deg(a) - 90] for *_, a in face] for face in ring.sensors.places]
    places = [[[x, y] for x, y, _ in face] for face in ring.sensors.places]
    same = parsed(sensors={"positions_mm": places, "rotations_deg": turns})
    assert_allclose(sensor_layout(same).axes, sensor_layout(ring).axes, atol=1e-12)


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"rotations_deg": [[0, 0, 0]]}, r"each of the 3 sensors of a face; got lists of \[1\]"),
        ({"rotations_deg": [BOARD["rotations_deg"]] * 2}, "holds 2 lists"),
        ({"chip": "outward"}, "Give rotations_deg alone"),
    ],
)
def test_rotations_that_do_not_fit_are_refused(wrong, message):
    with pytest.raises(InputError, match=message):
        parsed(sensors={**BOARD, **wrong})


def test_the_bus_and_the_averaging_limit_the_frame_rate():
    sensors = parsed().sensors
    assert_allclose(1 / fastest_frame_rate_hz(sensors), 15 * 84 / 400e3, rtol=1e-12)
    parsed(sensors={"frame_rate_hz": 310})
    with pytest.raises(InputError, match=r"frame_rate_hz = 330 is beyond the 317.5 Hz"):
        parsed(sensors={"frame_rate_hz": 330})
    slow = {"part": "TMAG5273A1", "averaging": 32, "count_per_face": 2}
    with pytest.raises(InputError, match=r"is beyond the 310.1 Hz"):  # 25 µs + 32 · 100 µs
        parsed(sensors={**slow, "frame_rate_hz": 330})


@pytest.mark.parametrize(
    ("parts", "message"),
    [
        ({"magnets": {"part": "X99"}}, r"'X99' is not in the catalogue. Choose one of D3x1"),
        ({"magnets": {"part": "D6x1", "diameter_mm": 5}}, "contradicts magnets.part = 'D6x1'"),
        ({"magnets": {"shape": "ring"}}, "needs magnets.inner_diameter_mm above 0"),
        (
            {"magnets": {"shape": "ring", "inner_diameter_mm": 6}},
            "must be below magnets.diameter_mm",
        ),
        ({"magnets": {"inner_diameter_mm": 2}}, "belongs to a ring"),
        (
            {"magnets": {"shape": "block", "size_mm": [17, 3], "positions_mm": [[10, 0]]}},
            "reaches into the 3 mm zone",
        ),
        (
            {"arrangement": "sensors-in-shell"},
            r"positions_mm\[0\] = \(0, 0\) meets the wire hole",
        ),
        (
            {"arrangement": "sensors-in-shell", "magnets": {**IN_CORE, "height_mm": 5}},
            "needs a pocket 5 mm deep in a core wall of core.wall_mm = 4.5",
        ),
        (
            {"arrangement": "sensors-in-shell", "magnets": {"positions_mm": [[9.5, 0], [0, 9.5]]}},
            "neighbouring face's pockets in the core",
        ),
        (
            {"arrangement": "sensors-in-shell", "magnets": {**IN_CORE, "depth_mm": 2.5}},
            "Give magnets.depth_below_core_face_mm instead",
        ),
        (
            {
                "arrangement": "sensors-in-shell",
                "magnets": IN_CORE,
                "sensors": {"package_mm": [6, 6, 3]},
            },
            "a sensor board of 6 × 3 mm must fit below the seal",
        ),
        (
            {"arrangement": "sensors-in-shell", "magnets": IN_CORE, "sensors": {"radius_mm": 3.0}},
            "touch or overlap",
        ),
        (
            {"sensors": {"positions_mm": [[12, 0]]}},
            "sensor 1 of face 1 at .* outside the core's face",
        ),
        ({"sensors": {"positions_mm": [[0, 8]], "count_per_face": 2}}, "Leave count_per_face out"),
        ({"sensors": {"positions_mm": [[0, "a"]]}}, r"sensors\.positions_mm"),
    ],
)
def test_what_does_not_fit_is_refused(parts, message):
    with pytest.raises(InputError, match=message):
        parsed(**parts)


def test_a_magnet_may_close_a_hole_that_carries_no_wires_wholly_but_not_in_part():
    """A disk of Ø9 covers wire holes of Ø1, and the hub as wide as they are, up to 4 mm from the middle."""
    core = {"wire_hole_top_diameter_mm": 1, "wire_hole_side_diameter_mm": 1}
    given = {"arrangement": "sensors-in-shell", "core": core}
    wide = {"diameter_mm": 9, "height_mm": 2}
    for place in (0.0, 3.9):
        parsed(**given, magnets={**wide, "positions_mm": [[place, 0]]})
    wider = core | {"wire_hole_side_diameter_mm": 1.2}
    for holes, place in ((core, 4.1), (wider, 0.0)):
        with pytest.raises(InputError, match="meets the wire hole"):
            parsed(**given | {"core": holes}, magnets={**wide, "positions_mm": [[place, 0]]})


def test_boards_in_the_shell_are_blocks_of_their_own_size_where_they_are_seated():
    blocks, layout = board_blocks(REVERSE), shell_body_layout(REVERSE)
    assert len(blocks) == len(layout.face)
    for block, centre, frame in zip(blocks, layout.centre_mm, layout.frame, strict=True):
        assert_allclose(2 * block.half_mm, REVERSE.sensors.package_mm)
        assert_allclose(block.centre_mm, centre)
        assert_allclose(block.axes, frame)
