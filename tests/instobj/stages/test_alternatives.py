"""What the report tries next: valid where magnets have a grade or sensors have places."""

import numpy as np
import pytest

from design.errors import InputError
from design.spec_io import load_spec, parse_spec
from instobj.stages.makers import alternatives
from instobj.stages.makers.alternatives import CHANGES, Alternative, settings_of


@pytest.mark.parametrize("change", CHANGES)
def test_changes_of_a_graded_magnet_are_valid_specifications(change):
    spec = parse_spec({"name": "cube", "magnets": {"grade": "N42"}}, "test")
    other = parse_spec(CHANGES[change](spec).model_dump(mode="json"), change)
    assert other != spec
    if "magnets" in change:
        assert other.magnets.remanence_t == 1.45


def test_magnets_of_several_grades_get_the_strongest():
    (change,) = (name for name in CHANGES if "magnets" in name)
    magnets = {"positions_mm": [[0, 0], [9, 8]], "grade": ["N35", "N52"]}
    spec = parse_spec({"name": "cube", "magnets": magnets}, "test")
    stronger = parse_spec(CHANGES[change](spec).model_dump(mode="json"), change).magnets
    assert stronger.remanences_t == (1.45, 1.45)
    assert stronger.strengths == (1.0, 1.0)


@pytest.mark.parametrize("remanence", [1.40, 1.43, 1.45, 1.5])
def test_no_magnet_is_proposed_that_nobody_sells(remanence):
    """For N50 a remanence of 1.72 T was the change that turned a no-go into a go."""
    (change,) = (name for name in CHANGES if "magnets" in name)
    spec = parse_spec({"name": "cube", "magnets": {"remanence_t": remanence}}, "test")
    with pytest.raises(InputError, match="no grade is 5% stronger"):
        CHANGES[change](spec)


def test_reading_all_channels_is_no_change_as_every_object_is_judged_so():
    spec = parse_spec({"name": "cube"}, "test")
    assert spec.score.channels == "all"
    weaker = parse_spec({"name": "cube", "magnets": {"grade": "N42"}}, "test")
    assert all(change(weaker).score == spec.score for change in CHANGES.values())


@pytest.mark.parametrize("count", [1, 3])
def test_one_more_sensor_finds_places_where_each_has_one(count):
    ring = 7.0 * np.exp(2j * np.pi * (np.arange(count) / count + 0.25))
    places = [[0.0, 0.0]] if count == 1 else np.column_stack([ring.real, ring.imag]).tolist()
    sensors = {"count_per_face": count, "positions_mm": places, "radius_mm": 7.0}
    body = {"sensed_faces": [1, 3, 5]}
    spec = parse_spec({"name": "cube", "body": body, "sensors": sensors}, "test")
    more = CHANGES["one more sensor on every face"](spec).sensors.positions_mm
    assert more is not None
    assert [len(face) for face in more] == [count + 1] * 3
    if count == 3:
        assert np.hypot(*np.array(more[0]).T) == pytest.approx(7.0)


@pytest.mark.parametrize(("needed", "largest"), [(1, 2), (2, 2), (4, 4), (9, 4)])
def test_larger_sets_are_tried_until_one_keeps_the_limits(needed, largest, monkeypatch):
    """Figures fall with every change; a set holds one or two more sensors, not both."""

    def row(changes, spec, signals, objects_margin):
        bound = 1.0 if len(changes) >= needed else 2.0
        return Alternative(changes, bound, 0.5, 1.0, 0.5, objects_margin, 5, 3)

    monkeypatch.setattr(alternatives, "least_objects_margin", lambda spec, signals, presses: 0.2)
    monkeypatch.setattr(alternatives, "alternative_of", row)
    spec = parse_spec({"name": "cube"}, "test")
    monkeypatch.setattr(alternatives, "changed_spec", lambda spec, changes: spec)
    monkeypatch.setattr(alternatives, "with_forces", lambda spec, other, signals: signals)
    rows = alternatives.alternatives(spec, None, None, lambda message: None)
    sizes = [len(row.changes) for row in rows]
    assert sizes == sorted(sizes)
    assert max(sizes) == largest
    more = {name for name in CHANGES if "more sensor" in name}
    assert len(more) == 2
    assert not any(more <= {*row.changes} for row in rows)


@pytest.mark.parametrize("change", CHANGES)
def test_the_lines_to_copy_make_the_change(change, tmp_path):
    """To a thousandth. Lines about keys to leave out are comments, and stand where a key goes."""
    path = tmp_path / "cube.toml"
    path.write_text('name = "cube"\nmagnets.remanence_t = 1.3\n')
    spec = load_spec(path, [])
    lines = settings_of(spec, CHANGES[change](spec))
    keys = [line for line in lines if not line.startswith("#")]
    assert keys
    assert [*settings_of(spec, load_spec(path, keys))] == keys
    assert {*lines} - {*keys} <= {"# leave out silicone.youngs_modulus_range_mpa"}
