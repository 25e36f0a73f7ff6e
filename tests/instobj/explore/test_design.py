"""Designs of the page: what they change, what check says of them, and how they are saved."""

import pytest

from design.catalogue.hall_sensors import HALL_PARTS
from design.errors import InputError
from design.spec_io import check, load_spec
from instobj.explore.design import (
    broken_limits,
    design_of,
    save_design,
    shown_places,
    with_design,
)

CUBE = """# my own cube
name = "mine"   # a name

[magnets]       # N35
positions_mm = [[0.0, 0.0], [9.0, 9.0]]   # two of them
# north = ["outward"]

[shell]
thickness_mm = 9.0
"""


@pytest.fixture
def cube(tmp_path):
    (tmp_path / "mine.toml").write_text(CUBE)
    return tmp_path / "mine.toml"


def changed(spec, table, **values):
    design = design_of(spec)
    return with_design(spec, design | {table: design[table] | values})


def test_a_design_that_is_not_changed_is_the_specification(cube):
    spec = load_spec(cube)
    assert with_design(spec, design_of(spec)) == spec


def test_a_magnet_more_changes_the_places_alone(cube):
    spec = load_spec(cube)
    more = changed(
        spec,
        "magnets",
        positions_mm=[[0.0, 0.0], [9.0, 9.0], [-9.0, 9.0]],
        north=["outward"] * 3,
        tilt_deg=[[0, 0]] * 3,
    )
    places = ((0.0, 0.0), (9.0, 9.0), (-9.0, 9.0))
    assert more == spec.changed(magnets=spec.magnets.changed(positions_mm=places))


def test_places_of_sensors_as_shown_are_those_of_the_ring(cube):
    spec = load_spec(cube)
    placed = changed(spec, "sensors", positions_mm=shown_places(spec)["sensors_mm"])
    assert placed.sensors.positions_mm is not None
    for before, after in zip(spec.sensors.places, placed.sensors.places, strict=True):
        assert [p[:2] for p in after] == [pytest.approx(p[:2], abs=1e-3) for p in before]


def test_another_range_has_its_gain_and_the_same_noise_in_mt(cube):
    spec = load_spec(cube)
    wide = changed(spec, "sensors", range_mt=80.0).sensors
    assert wide.counts_per_mt == 410.0
    assert wide.noise_counts == pytest.approx([0.5 * one for one in spec.sensors.noise_counts])


def test_another_chip_has_its_range_gain_and_noise(cube):
    spec = load_spec(cube)
    other = changed(spec, "sensors", part="TMAG5273A2").sensors
    part = HALL_PARTS.named("TMAG5273A2")
    assert (other.range_mt, other.counts_per_mt) == (133.0, 250.0)
    assert other.noise_counts == pytest.approx(part.noise.scaled(250.0, spec.sensors.averaging))
    with pytest.raises(InputError, match=r"the catalogue has no noise of MLX90393\. Choose"):
        changed(spec, "sensors", part="MLX90393")
    with pytest.raises(InputError, match="Hall"):
        changed(spec, "sensors", part="Hall")


def test_another_grade_brings_its_remanence(cube):
    spec = load_spec(cube)
    assert changed(spec, "magnets", grade="N52").magnets.remanence_t == 1.45
    mixed = changed(spec, "magnets", grade=["N35", "N52"]).magnets
    assert (mixed.grades, mixed.remanences_t) == (("N35", "N52"), (1.2, 1.45))
    assert changed(load_spec(cube, ["magnets.grade=N35"]), "magnets").magnets.remanence_t == 1.2


def test_keys_that_the_page_does_not_change_are_refused(cube):
    spec = load_spec(cube)
    for design in ({"magnets": {"shape": "ring"}}, {"body": {"kind": "sphere"}}):
        with pytest.raises(InputError, match="a design has no"):
            with_design(spec, design)
    with pytest.raises(InputError, match=r"magnets\.north needs one entry"):
        changed(spec, "magnets", north=["inward"])


def test_broken_limits_are_checks_sentences_with_the_parts_that_they_name(cube):
    close = changed(load_spec(cube), "magnets", positions_mm=[[0.0, 0.0], [2.0, 0.0]])
    (limit,) = broken_limits(close)
    assert (limit["magnets"], limit["sensors"], limit["faces"]) == ([0, 1], [], [])
    with pytest.raises(InputError) as error:
        check(close)
    assert limit["text"] == str(error.value)
    assert broken_limits(load_spec(cube)) == []


def test_sensors_that_meet_are_named(cube):
    spec = load_spec(cube)
    apart = [[6.0, 0.0], [-6.0, -4.0], [-6.0, 6.0]]
    places = [apart, [[3.0, 0.0], [0.0, 0.0], [-6.0, 6.0]], *[apart] * 3]
    limits = broken_limits(changed(spec, "sensors", positions_mm=places))
    assert {0, 1} <= {number for limit in limits for number in limit["sensors"]}
    assert [limit["faces"] for limit in limits if limit["sensors"] == [0, 1]] == [[2]]


def test_a_saved_design_is_read_back_the_same_with_its_comments(cube):
    spec = load_spec(cube, ["seed=7"])
    design = changed(
        spec, "magnets", positions_mm=[[1.0, 0.0], [9.0, 8.0]], north=["inward", "outward"]
    )
    path, kept = save_design(design, cube)
    assert (path.name, kept) == ("mine_explored_1.toml", True)
    assert load_spec(path) == design.changed(name="mine_explored_1")
    text = path.read_text()
    for comment in ("# my own cube", "# a name", "# N35", "# two of them"):
        assert comment in text
    assert cube.read_text() == CUBE
    assert save_design(design, path)[0].name == "mine_explored_2.toml"


def test_tables_that_lines_do_not_follow_are_written_whole(cube):
    cube.write_text('name = "mine"   # a name\nmagnets = { positions_mm = [[0, 0], [9, 9]] }\n')
    spec = load_spec(cube)
    design = changed(spec, "magnets", positions_mm=[[1.0, 0.0], [9.0, 9.0]])
    path, kept = save_design(design, cube)
    assert not kept
    assert load_spec(path).magnets == design.magnets


def test_a_design_that_breaks_a_limit_is_not_saved(cube):
    close = changed(load_spec(cube), "magnets", positions_mm=[[0.0, 0.0], [2.0, 0.0]])
    with pytest.raises(InputError, match=r"(?s)not saved.*touch or overlap"):
        save_design(close, cube)
    assert [path.name for path in cube.parent.iterdir()] == ["mine.toml"]
