"""What was measured on the built object changes layouts, and nothing else."""

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from design.errors import InputError
from design.layout.body import face_frames
from design.layout.places.positions import (
    live_channels,
    magnet_layout,
    sensor_layout,
    shell_body_layout,
)
from design.spec_io import load_spec, parse_spec

FOUND = """
[[magnets]]
face = 3
magnet = 2
centre_mm = [10.3, 9.8, -2.6]
axis = [0.0, 0.06, 2.0]
flipped = true
remanence_t = 1.3
[[sensors]]
face = 2
sensor = 3
position_mm = [1.0, -8.0, -2.2]
rotation_deg = [0.0, 0.0, 90.0]
dead = ["Z"]
"""


@pytest.fixture
def files(tmp_path):
    (tmp_path / "cube.toml").write_text('name = "cube"\n')
    (tmp_path / "cube.as_built.toml").write_text(FOUND)
    return tmp_path


def test_the_file_beside_the_specification_is_read(files):
    assert load_spec(files / "cube.toml").as_built.magnets[0].flipped
    (files / "cube.as_built.toml").rename(files / "other.toml")
    assert not load_spec(files / "cube.toml").as_built.magnets
    named = load_spec(files / "cube.toml", ['as_built="other.toml"'])
    assert named.as_built.sensors[0].dead == ("Z",)


def test_magnets_are_where_they_were_found(files):
    spec = load_spec(files / "cube.toml")
    plain, found = magnet_layout(parse_spec({"name": "cube"}, "")), magnet_layout(spec)
    frame, row = face_frames(spec)[2], 2 * 5 + 1
    others = np.arange(len(plain.face)) != row
    for name in ("centre_mm", "axis", "side", "strength"):
        assert_array_equal(getattr(found, name)[others], getattr(plain, name)[others])
    assert_allclose(frame.from_object(found.centre_mm[row]), [10.3, 9.8, -2.6], atol=1e-12)
    north = -np.array([0.0, 0.06, 2.0]) / np.hypot(0.06, 2.0)
    assert_allclose(found.axis[row] @ frame.axes, north, atol=1e-12)
    assert_allclose(found.side[row] @ found.axis[row], 0, atol=1e-12)
    assert_allclose(found.strength[row], 1.3 / 1.43)
    assert_array_equal(shell_body_layout(spec).centre_mm, plain.centre_mm)


def test_sensors_are_where_and_as_they_were_found(files):
    spec = load_spec(files / "cube.toml")
    plain, found = sensor_layout(parse_spec({"name": "cube"}, "")), sensor_layout(spec)
    row, normal = 3 + 2, face_frames(spec)[1].normal
    assert_array_equal(np.delete(found.axes, row, 0), np.delete(plain.axes, row, 0))
    # a quarter turn about the outward normal takes X to Y: X = −tangential, Y = radial
    assert_allclose(found.axes[row, 0], np.cross(normal, plain.axes[row, 0]), atol=1e-12)
    assert_allclose(found.axes[row, 2], normal, atol=1e-12)
    assert_array_equal(np.argwhere(~live_channels(spec)), [[row, 2]])


@pytest.mark.parametrize(
    ("content", "words"),
    [
        ("[[magnets]]\nface = 3\nmagnet = 6\n", ("magnet 6 of face 3", "has 5")),
        ("[[sensors]]\nface = 1\nsensor = 4\n", ("sensor 4 of face 1", "has 3")),
        ("[[sensors]]\nface = 7\nsensor = 1\n", ("as_built.sensors", "7")),
        ("[[magnets]]\nface = 1\nmagnet = 1\n" * 2, ("more than once",)),
        ("[[magnets]]\nface = 1\nmagnet = 1\naxis = [0, 0, 0]\n", ("no direction",)),
        ('[[sensors]]\nface = 1\nsensor = 1\ndead = ["W"]\n', ("dead", "W")),
        ("[[magnet]]\nface = 1\n", ("magnet", "magnets")),
        ("[[magnets\n", ("not valid TOML",)),
    ],
)
def test_bad_files_are_refused(files, content, words):
    (files / "cube.as_built.toml").write_text(content)
    with pytest.raises(InputError) as error:
        load_spec(files / "cube.toml")
    assert all(word in str(error.value) for word in words), error.value


def test_a_named_file_that_is_missing_is_refused(files):
    with pytest.raises(InputError, match="no as-built file"):
        load_spec(files / "cube.toml", ['as_built="none.toml"'])
