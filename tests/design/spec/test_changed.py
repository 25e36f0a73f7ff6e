"""Changes of a specification: validated, and checked for fit where that is asked for."""

import pytest

from design.errors import SpecError
from design.spec.object import ObjectSpec
from design.spec.search import OVER_LIMIT
from design.spec_io import check, load_spec, parse_spec

CUBE = ObjectSpec(name="cube")


def test_a_change_is_validated_like_a_new_specification():
    with pytest.raises(
        SpecError, match=r"thickness_mm: Input should be .* equal to 0\.3 and .*200; got -1"
    ):
        CUBE.shell.changed(thickness_mm=-1.0)
    rubber, element = (
        CUBE.silicone.changed(poisson_ratio=0.5),
        CUBE.mechanics.changed(element="p2-p0"),
    )
    with pytest.raises(SpecError, match=r"takes silicone.poisson_ratio up to 0\.4999; got 0\.5"):
        CUBE.changed(silicone=rubber, mechanics=element)
    with pytest.raises(SpecError, match="no_such_field is not a key"):
        CUBE.changed(no_such_field=1)


def test_a_copy_cannot_go_past_validation():
    with pytest.raises(SpecError, match="thickness_mm"):
        CUBE.shell.model_copy(update={"thickness_mm": "thick"})
    assert CUBE.model_copy(update={"seed": 7}) == CUBE.changed(seed=7)
    assert CUBE.changed(seed=7).seed == 7 != CUBE.seed


def test_a_change_keeps_what_was_given_and_what_was_left_out():
    assert CUBE.changed(seed=7).model_fields_set == {"name", "seed"}
    assert CUBE.sensors.changed(noise_counts=(1.0, 2.0, 3.0)).counts_per_mt == 820.0


def test_whether_everything_fits_is_asked_for_by_name():
    thin = CUBE.changed(shell=CUBE.shell.changed(thickness_mm=2.0))  # pockets are 3 mm deep
    reason = r"pocket_depth_mm must be below shell.thickness_mm = 2; got 3"
    with pytest.raises(SpecError, match=reason):
        check(thin)
    with pytest.raises(
        SpecError, match="made up is not a valid specification:\n  - shell." + reason
    ):
        parse_spec({"name": "cube", "shell": {"thickness_mm": 2.0}}, "made up")
    assert check(CUBE) is CUBE


def test_single_presses_need_not_fit_at_every_contact_location():
    wide = CUBE.changed(contact_grid=CUBE.contact_grid.changed(count=(10, 10), pitch_mm=4.5))
    with pytest.raises(SpecError, match="fewer places"):
        check(wide)
    assert check(wide, table=False) is wide


def test_a_part_with_a_field_named_keys_is_changed_too():
    """`dict(part)` would call that field."""
    core = parse_spec({"name": "cube"}, "test").core
    assert core.changed(wall_mm=4.7).wall_mm == 4.7
    assert core.changed(wall_mm=4.7).keys == core.keys


def test_tables_of_parts_that_are_left_out_are_each_specification_s_own():
    """A frozen part keeps no one from writing into a table in it."""
    ball = ObjectSpec(name="ball")
    ball.search.limits.times_start["worst_position_bound_mm"] = 0.5
    assert CUBE.search.limits.times_start == {OVER_LIMIT: 1.0}
    assert ObjectSpec(name="egg").search.limits.times_start == {OVER_LIMIT: 1.0}
    assert CUBE.search != CUBE.search.changed(forces_n=(1.0,))


def test_a_table_that_stands_twice_is_named_with_its_line(tmp_path):
    path = tmp_path / "twice.toml"
    path.write_text('name = "x"\n[search.vary]\nmagnet_tilt_deg = 3.0\n[search.vary]\n')
    with pytest.raises(SpecError, match=r"the table \[search.vary\] stands twice \(at line 4"):
        load_spec(path)
