"""A simulated user and object: what each planted fault changes, and what the board sends."""

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal

from design.errors import InputError
from instobj.bench.bringup.asking.asked import asked_of
from instobj.bench.bringup.simulated import PlantedFault, parse_fault, simulated_object
from tests.support.new_objects import SMALL

SOUND = simulated_object(SMALL, 1)
ASKED = {one.name: one for one in asked_of(SMALL)}


def with_fault(text):
    return simulated_object(SMALL, 1, (parse_fault(text),))


def changed(made, but=()):
    names = ("matrix", "offset", "position_mm", "silent", "dead", "stuck", "flipped")
    return {name for name in names if not np.array_equal(getattr(made, name), getattr(SOUND, name))}


def test_faults_are_parsed_with_their_parts_and_size():
    assert parse_fault("gain=F5-S2=1.2") == PlantedFault("gain", ("F5-S2",), 1.2)
    assert parse_fault("gain=F5-S2") == PlantedFault("gain", ("F5-S2",), 1.1)
    assert parse_fault("swap=F1-S2,F3-S1") == PlantedFault("swap", ("F1-S2", "F3-S1"), 1.1)
    for wrong in ("melt=F1-S1", "gain", "gain=F1-S1=x", "swap=F1-S1"):
        with pytest.raises(InputError):
            with_fault(wrong)


def test_each_fault_changes_its_own_chips_alone():
    """F3-S1 is the fifth chip, F3-S2 the sixth."""
    swapped = with_fault("swap=F1-S2,F3-S1")
    assert changed(swapped) == {"matrix", "position_mm"} | (
        {"offset"} if not np.array_equal(SOUND.offset[1], SOUND.offset[4]) else set()
    )
    assert_array_equal(swapped.matrix[[1, 4]], SOUND.matrix[[4, 1]])
    assert_array_equal(swapped.position_mm[[1, 4]], SOUND.position_mm[[4, 1]])
    others = np.delete(np.arange(10), 5)
    cycle = np.array([[0.0, 1, 0], [0, 0, 1], [1, 0, 0]])
    c, s = np.cos(np.radians(120)), np.sin(np.radians(120))
    for text, turn in (
        ("turn", cycle),
        ("twist", np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])),
        ("mirror", np.diag([-1.0, 1, 1])),
        ("gain", 1.1 * np.eye(3)),
    ):
        made = with_fault(f"{text}=F3-S2")
        assert changed(made) == {"matrix"}
        assert_allclose(made.matrix[5], turn @ SOUND.matrix[5])
        assert_array_equal(made.matrix[others], SOUND.matrix[others])
    one = with_fault("gain=F3-Y2=1.5")
    assert_allclose(one.matrix[5], SOUND.matrix[5] * [[1], [1.5], [1]])
    for text, name in (("dead", "dead"), ("stuck", "stuck")):
        made = with_fault(f"{text}=F3-Y2")
        assert changed(made) == {name}
        assert np.argwhere(getattr(made, name)).tolist() == [[5, 1]]
    silent = with_fault("silent=F3-S2")
    assert changed(silent) == {"silent"}
    assert np.argwhere(silent.silent).tolist() == [[5, 0], [5, 1], [5, 2]]
    flipped = with_fault("flip=F3-M2")
    assert changed(flipped) == {"flipped"}
    assert np.flatnonzero(flipped.flipped).tolist() == [5]
    for wrong in ("dead=F3-S2", "mirror=F3-Y2", "gain=F9-S1", "flip=F3-S2"):
        with pytest.raises(InputError):
            with_fault(wrong)


def quiet():
    """Without drift, noise, tremor of the room's field and offsets."""
    made = simulated_object(SMALL, 2)
    made.slope_per_ms[:], made.offset[:], made.earth_ut[:] = 0.0, 0.0, 0.0
    return made


def test_clock_and_sequence_go_on_from_recording_to_recording():
    made = quiet()
    first, second = (made.recording(ASKED[name]) for name in ("still", "closed"))
    step_ms = 1000 / SMALL.sensors.frame_rate_hz
    assert_array_equal(first.board_ms, np.round(step_ms * np.arange(105)))
    assert_array_equal(first.sequence, np.arange(105))
    assert second.board_ms[0] == first.board_ms[-1] + 5000
    assert second.sequence[0] == first.sequence[-1] + 50
    assert (first.damaged_lines, first.bus_errors, first.name) == (0, 0, "still")
    made.sequence = 65530
    assert made.recording(ASKED["closed"]).sequence.tolist()[:8] == [*range(65530, 65536), 0, 1]


def test_magnets_come_one_by_one_and_all_are_there_at_rest():
    made = quiet()
    assert abs(made.recording(ASKED["closed"]).mean).max() < 30
    means = {}
    for name in ("magnet F1-M1", "magnet F1-M2", "rest"):
        means[name] = made.recording(ASKED[name]).mean
    field = made.assembly.scene
    one = means["magnet F1-M1"]
    assert int(np.argmax(np.linalg.norm(one, axis=1))) in (0, 1)
    assert np.linalg.norm(means["rest"]) > np.linalg.norm(means["magnet F1-M2"]) > 0
    assert made.magnets_in == len(field.magnets.face) == 10
    over = simulated_object(SMALL, 2, (parse_fault("flip=F1-M1"),))
    over.slope_per_ms[:], over.offset[:], over.earth_ut[:] = 0.0, 0.0, 0.0
    assert_allclose(over.recording(ASKED["magnet F1-M1"]).mean, -one, atol=30)


def test_earth_is_between_25_and_65_microtesla_and_turns_with_the_object():
    sizes = [np.linalg.norm(simulated_object(SMALL, seed).earth_ut) for seed in range(12)]
    assert 25 < min(sizes) < 40
    assert 50 < max(sizes) < 65
    made = quiet()
    made.earth_ut[:] = [0.0, 0.0, 5000.0]
    scale = 1e-3 * 5000.0
    up, down = (made.recording(ASKED[name]).mean for name in ("earth 1", "earth 2"))
    field = np.einsum("cba,cb->ca", made.matrix, up) / SMALL.sensors.counts_per_mt**2
    assert_allclose(field[:, 2], scale, rtol=0.1)
    assert_allclose(down, -up, atol=0.25 * scale * SMALL.sensors.counts_per_mt)


def test_a_held_magnet_is_seen_most_by_the_chip_below_it():
    made = quiet()
    for chip in (0, 5):
        name = list(ASKED)[1 + chip]
        recording = made.recording(ASKED[name])
        assert int(np.argmax(np.linalg.norm(recording.mean, axis=1))) == chip
