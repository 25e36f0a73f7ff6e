"""The questions of a bring-up, in order: names, frames and poses of the small object."""

import pytest

from design.errors import InputError
from instobj.bench.bringup.asking.asked import (
    POSES,
    asked_of,
    magnet_names,
    require_bringup,
)
from tests.support.new_objects import SMALL

RATE_HZ = SMALL.sensors.frame_rate_hz
CHIPS = [f"F{face}-S{number}" for face in range(1, 6) for number in (1, 2)]


def test_a_bring_up_asks_for_the_bare_core_first_and_every_magnet_in_its_turn():
    asked = asked_of(SMALL)
    magnets = [name.replace("-S", "-M") for name in CHIPS]
    assert magnet_names(SMALL) == magnets
    assert [one.name for one in asked] == [
        "still",
        *(f"held {name}" for name in CHIPS),
        "still again",
        *(f"earth {number}" for number in range(1, 8)),
        "closed",
        *(f"magnet {name}" for name in magnets),
        "rest",
    ]
    steps = ["still", *["held"] * 10, "still", *["earth"] * 7, "closed", *["magnet"] * 10, "rest"]
    assert [one.step for one in asked] == steps
    parts = [0, *range(10), 1, *range(7), 0, *range(10), 0]
    assert [one.part for one in asked] == parts


def test_recordings_last_as_long_as_their_step_needs_and_ten_frames_at_least():
    seconds = {
        "still": 10.0,
        "held": 4.0,
        "earth": 20.0,
        "closed": 2.0,
        "magnet": 2.0,
        "rest": 10.0,
    }
    for one in asked_of(SMALL):
        assert one.frames == round(seconds[one.step] * RATE_HZ)
    slow = SMALL.changed(sensors=SMALL.sensors.changed(frame_rate_hz=2.0))
    assert [one.frames for one in asked_of(slow)[:2]] == [20, 10]


def test_questions_name_places_and_poses():
    asked = {one.name: one.question for one in asked_of(SMALL)}
    assert asked["held F3-S2"].startswith("Hold one magnet about 10 mm above face 3, sensor 2")
    assert asked["magnet F4-M1"] == "Put the magnet into pocket 1 of face 4; then let go"
    assert "with its -z up and its +x pointing away from you;" in asked["earth 2"]
    assert (
        "with its +z up and its +x pointing away from you again, as at first;" in asked["earth 7"]
    )
    assert len(set(POSES)) == 6


def test_objects_that_a_bring_up_does_not_serve_are_refused():
    require_bringup(SMALL)
    for changed in (
        {"arrangement": "sensors-in-shell", "magnets": {"positions_mm": [[8, 8], [-8, 8]]}},
    ):
        with pytest.raises(InputError):
            require_bringup(SMALL.model_validate({"name": "other", **changed}))


def test_a_magnet_of_several_grades_is_asked_for_by_its_grade():
    count = SMALL.magnets.count
    grades = ("N52", *["N35"] * (count - 1))
    remanences = (1.45, *[1.20] * (count - 1))
    magnets = SMALL.magnets.changed(grade=grades, remanence_t=remanences)
    texts = {one.name: one.question for one in asked_of(SMALL.changed(magnets=magnets))}
    assert texts["held F1-S1"].startswith("Hold one N52 magnet about")
    assert "the N52 magnet into pocket 1 of face 3" in texts["magnet F3-M1"]
    assert "the N35 magnet into pocket 2 of face 3" in texts["magnet F3-M2"]
    alike = {one.name: one.question for one in asked_of(SMALL)}
    assert "Put the magnet into pocket 1" in alike["magnet F3-M1"]
