"""What the report tries next: valid where magnets have a grade or sensors have places."""

import tomllib
from pathlib import Path

import numpy as np
import pytest

from design.errors import InputError
from design.spec_io import load_spec, parse_spec
from estimator.information.scores import place_bounds
from instobj.stages.makers.alternatives import (
    alternatives,
    changes_of,
    settings_of,
    with_forces,
    with_more_sensors,
)
from instobj.stages.run import Run
from instobj.store.readers import ALTERNATIVES, PRESSES, SIGNALS
from tests.support.objects.tiny_cube import lend_mechanics, tiny_cube

EXAMPLES = Path(__file__).parents[3] / "examples"
CUBE = parse_spec({"name": "cube"}, "test")


@pytest.mark.parametrize("change", changes_of(CUBE))
def test_changes_of_a_graded_magnet_are_valid_specifications(change):
    spec = parse_spec({"name": "cube", "magnets": {"grade": "N42"}}, "test")
    other = parse_spec(changes_of(spec)[change](spec).model_dump(mode="json"), change)
    assert other != spec
    if "magnets" in change:
        assert other.magnets.remanence_t == 1.45


def test_magnets_of_several_grades_get_the_strongest():
    (change,) = (name for name in changes_of(CUBE) if "magnets" in name)
    magnets = {"positions_mm": [[0, 0], [9, 8]], "grade": ["N35", "N52"]}
    spec = parse_spec({"name": "cube", "magnets": magnets}, "test")
    stronger = parse_spec(changes_of(spec)[change](spec).model_dump(mode="json"), change).magnets
    assert stronger.remanences_t == (1.45, 1.45)
    assert stronger.strengths == (1.0, 1.0)


@pytest.mark.parametrize("remanence", [1.40, 1.43, 1.45, 1.5])
def test_no_magnet_is_proposed_that_nobody_sells(remanence):
    """For N50 a remanence of 1.72 T was the change that turned a no-go into a go."""
    (change,) = (name for name in changes_of(CUBE) if "magnets" in name)
    spec = parse_spec({"name": "cube", "magnets": {"remanence_t": remanence}}, "test")
    with pytest.raises(InputError, match="no grade is 5% stronger"):
        changes_of(spec)[change](spec)


def test_reading_all_channels_is_no_change_as_every_object_is_judged_so():
    spec = parse_spec({"name": "cube"}, "test")
    assert spec.score.channels == "all"
    weaker = parse_spec({"name": "cube", "magnets": {"grade": "N42"}}, "test")
    assert all(change(weaker).score == spec.score for change in changes_of(weaker).values())


@pytest.mark.parametrize("count", [1, 3])
def test_one_more_sensor_finds_places_where_each_has_one(count):
    ring = 7.0 * np.exp(2j * np.pi * (np.arange(count) / count + 0.25))
    places = [[0.0, 0.0]] if count == 1 else np.column_stack([ring.real, ring.imag]).tolist()
    sensors = {"count_per_face": count, "positions_mm": places, "radius_mm": 7.0}
    body = {"sensed_faces": [1, 3, 5]}
    spec = parse_spec({"name": "cube", "body": body, "sensors": sensors}, "test")
    more = changes_of(CUBE)["one more sensor on every face"](spec).sensors.positions_mm
    assert more is not None
    assert [len(face) for face in more] == [count + 1] * 3
    if count == 3:
        assert np.hypot(*np.array(more[0]).T) == pytest.approx(7.0)


@pytest.mark.parametrize(("example", "added"), [("pear", 2), ("paper_cube", 4)])
def test_more_sensors_on_a_ring_without_room_are_refused(example, added):
    """Boards met: the lines that `new` gave to copy were refused."""
    spec = load_spec(EXAMPLES / f"{example}.toml", [])
    assert spec.sensors.positions_mm is None
    with pytest.raises(InputError, match="board"):
        with_more_sensors(added, spec)


@pytest.mark.parametrize("limit_mm", [100.0, 0.001])
def test_no_option_is_forecast_for_a_go(limit_mm, tmp_path):
    """Nothing has to change, so none is shown."""
    lend_mechanics(tmp_path)
    spec = tiny_cube()
    limits = {"position_bound_mm": limit_mm, "detectable_force_n": 100.0}
    run = Run(spec.changed(limits=spec.limits.changed(**limits)), root=tmp_path)
    content = ALTERNATIVES.read(run.require("alternatives").folder)
    assert (content["next_options"] == []) == (limit_mm > 1)


@pytest.fixture(scope="module")
def pressed(tmp_path_factory):
    """The small cube, its signals, and the path of its presses."""
    store = tmp_path_factory.mktemp("alternatives")
    lend_mechanics(store)
    run = Run(tiny_cube(), root=store)
    presses = PRESSES.path(run.require("presses").folder)
    return run.spec, SIGNALS.read(run.require("signals").folder), presses


@pytest.mark.parametrize(("limit_mm", "largest"), [(20.0, 2), (0.001, 3)])
def test_larger_sets_are_tried_until_one_keeps_the_limits(pressed, limit_mm, largest):
    """A set holds one or two more sensors, not both. As no magnets are stronger, three changes at most."""
    spec, signals, presses = pressed
    spec = spec.changed(limits=spec.limits.changed(position_bound_mm=limit_mm))
    rows = alternatives(spec, signals, presses, lambda message: None)
    sizes = [len(row.changes) for row in rows]
    assert sizes == sorted(sizes)
    assert max(sizes) == largest
    more = {name for name in changes_of(spec) if "more sensor" in name}
    assert len(more) == 2
    assert not any(more <= {*row.changes} for row in rows)


def test_a_softer_silicone_is_judged_where_the_design_is(pressed):
    """Every location of the design reaches the force, none of the softer one does. Its bounds are those of
    the deepest press, which deforms both alike."""
    spec, signals, presses = pressed
    deepest = place_bounds(spec.changed(score=spec.score.changed(force_n=500.0)), signals)
    force = 0.9 * float(signals.force_n[..., -1].min())
    spec = spec.changed(score=spec.score.changed(force_n=force))
    (change,) = (name for name in changes_of(spec) if "softer" in name)
    softer = changes_of(spec)[change](spec)
    assert with_forces(spec, softer, signals).force_n.max() < force
    rows = {row.changes: row for row in alternatives(spec, signals, presses, print)}
    bounds = deepest.position_bound_mm
    assert rows[(change,)].weakest_bound_mm == pytest.approx(bounds.max(), rel=1e-6)
    assert rows[(change,)].median_bound_mm == pytest.approx(np.median(bounds), rel=1e-6)
    assert rows[()].unreached == 0
    assert rows[(change,)].unreached == 1


def test_the_softer_silicone_is_the_least_soft_that_is_surely_softer():
    """Platsil Gel-10 may have 0.15 to 0.54 MPa, Dragon Skin 10 0.12 to 0.42: which one is softer, nobody
    knows."""

    def softer_than(name):
        spec = parse_spec({"name": "cube", "silicone": {"name": name}}, "test")
        return [change.split(" as ")[0] for change in changes_of(spec) if "softer" in change]

    assert softer_than("Dragon Skin 30") == ["Dragon Skin 10"]
    assert softer_than("Platsil Gel-10") == ["Ecoflex 00-30"]
    assert softer_than("Ecoflex 00-30") == [], "none is softer"
    assert softer_than("TPU 85A") == [], "printed, not cast"


@pytest.mark.parametrize("change", changes_of(CUBE))
def test_the_lines_to_copy_make_the_change(change, tmp_path):
    """To a thousandth, under the names of their tables, in place of the lines that stand there."""
    path = tmp_path / "cube.toml"
    path.write_text('name = "cube"\nmagnets.remanence_t = 1.3\n')
    spec = load_spec(path, [])
    lines = settings_of(spec, changes_of(spec)[change](spec))
    keys = [
        f"{table}.{key}={value}"
        for table, changed in tomllib.loads("\n".join(lines)).items()
        for key, value in changed.items()
    ]
    assert keys
    assert settings_of(spec, load_spec(path, keys)) == lines


def test_another_silicone_takes_one_line_as_its_figures_follow():
    (change,) = (name for name in changes_of(CUBE) if "softer" in name)
    softer = changes_of(CUBE)[change](CUBE)
    assert settings_of(CUBE, softer) == ("[silicone]", f'name = "{softer.silicone.name}"')
    silicone = CUBE.silicone.changed(youngs_modulus_mpa=0.5)
    lines = settings_of(CUBE.changed(silicone=silicone), softer)
    assert "youngs_modulus_mpa = 0.078" in lines
