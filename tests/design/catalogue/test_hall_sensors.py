"""Named magnets and sensors, and what a specification takes from them."""

import pytest
from numpy.testing import assert_allclose

from design.catalogue.hall_sensors import HALL_PARTS
from design.catalogue.magnets import GRADES
from design.errors import InputError
from design.spec.object import SensorSpec
from design.spec_io import parse_spec


def parsed(**parts):
    return parse_spec({"name": "cube", **parts}, "test")


def test_grades_grow_and_their_typical_value_lies_midway():
    grades = list(GRADES.values())
    for grade in grades:
        middle = (grade.remanence_min_t + grade.remanence_max_t) / 2
        assert_allclose(grade.remanence_t, middle, atol=0.0051)
        assert grade.name[1:].isdigit()
        # (BH)max of a linear demagnetisation curve, J²/(4 μ0 μr), μr = 1.05, in MGOe
        product = grade.remanence_t**2 / (4 * 1.05 * 4e-7 * 3.14159265) / 7957.7
        assert_allclose(product, int(grade.name[1:]), rtol=0.06)
    assert [g.remanence_t for g in grades] == sorted(g.remanence_t for g in grades)


@pytest.mark.parametrize(
    ("given", "range_mt", "counts_per_mt", "noise_counts"),
    [
        ({"averaging": 1}, 40, 820, (88, 88, 44)),
        ({"averaging": 32}, 40, 820, (15.5563, 15.5563, 7.77817)),
        ({"range_mt": 80}, 80, 410, (11, 11, 5.5)),
        ({"range_mt": 30}, 30, 820, (22, 22, 11)),
        ({"part": "TMAG5273A2", "averaging": 1}, 133, 250, (36.75, 36.75, 22.25)),
        ({"part": "TMAG5273A2", "range_mt": 200}, 200, 125, (4.59375, 4.59375, 2.78125)),
        ({"part": "TMAG5273A2", "counts_per_mt": 100}, 133, 100, (3.675, 3.675, 2.225)),
        ({"part": "MLX90393", "range_mt": 24, "noise_counts": (5, 6, 7)}, 24, 1331.56, (5, 6, 7)),
        ({"range_mt": 100, "counts_per_mt": 300}, 100, 300, (22 * 300 / 820,) * 2 + (11 * 300 / 820,)),
        (
            {"part": "generic", "range_mt": 12, "counts_per_mt": 70, "noise_counts": (1, 2, 3)},
            12,
            70,
            (1, 2, 3),
        ),
    ],
)  # fmt: skip
def test_a_part_fills_in_what_is_left_out(given, range_mt, counts_per_mt, noise_counts):
    sensors = parsed(sensors=given).sensors
    found = (sensors.range_mt, sensors.counts_per_mt, *sensors.noise_counts)
    assert_allclose(found, (range_mt, counts_per_mt, *noise_counts), rtol=1e-5)
    assert SensorSpec.model_validate(sensors.model_dump()) == sensors


def test_every_range_of_a_part_fills_the_same_counts():
    for part in HALL_PARTS.values():
        full = [each.range_mt * each.counts_per_mt for each in part.ranges]
        assert_allclose(full, full[:1] * len(full), rtol=0.01)


def test_measured_noise_is_near_the_datasheets():
    part = HALL_PARTS["TMAG5273A1"]
    assert part.noise is part.measured_noise
    sheet_counts = [noise * 0.82 / 4 for noise in part.datasheet_noise_ut]
    assert_allclose(part.noise.counts, sheet_counts, rtol=0.25)


@pytest.mark.parametrize(
    ("given", "message"),
    [
        (
            {"part": "TMAG9999"},
            r"'TMAG9999' is not in the catalogue.*TMAG5273A1, TMAG5273A2, MLX90393",
        ),
        ({"range_mt": 81}, r"81 is beyond the ranges of TMAG5273A1 \(±40, ±80 mT\)"),
        ({"part": "MLX90393"}, r"no figure in the catalogue for sensors\.noise_counts"),
        (
            {"part": "generic", "noise_counts": (1, 1, 1)},
            r"for sensors\.range_mt, sensors\.counts_per_mt\. Give",
        ),
        ({"averaging": [16]}, r"sensors\.averaging: .*got \[16\]"),
        ({"averaging": 3}, r"sensors\.averaging: .*got 3"),
        ({"averaging": 0}, r"sensors\.averaging: .*got 0"),
        ({"averaging": "many"}, r"sensors\.averaging: .*got 'many'"),
        ({"part": 5273}, r"sensors\.part: .*got 5273"),
        ({"range_mt": "wide"}, r"sensors\.range_mt: .*got 'wide'"),
        (
            {"counts_per_mt": -820},
            r"sensors\.counts_per_mt: .*greater than or equal to 0.1 and .*got -820",
        ),
        ({"noise_counts": (1, 2)}, r"noise_counts"),
    ],
)
def test_wrong_sensor_figures_give_one_clear_error(given, message):
    with pytest.raises(InputError, match=message):
        parsed(sensors=given)
