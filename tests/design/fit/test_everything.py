"""All that does not fit is told together, and the values that errors name as working do work."""

import re

import pytest

from design.errors import SpecError
from design.fit.everything import problems_of
from design.spec.object import ObjectSpec
from design.spec_io import parse_spec

FAULTS = {
    "magnets": {"positions_mm": [[0, 0], [18, 0]]},
    "core": {"recess_depth_mm": 4.5, "wire_hole_top_diameter_mm": 30.0},
    "press": {"depths_mm": [1.0, 4.9]},
    "contact_grid": {"count": [20, 10]},
    "shell": {"slits": {"depth_mm": 12.0}},
}
NAMED = {
    "magnets": r"magnets\.positions_mm\[1\]",
    "core": r"core\.recess_depth_mm must be below .* got 4\.5",
    "press": r"press\.depths_mm must stay below",
    "contact_grid": r"contact_grid\.count\[0\]",
    "shell": r"shell\.slits\.depth_mm = 12",
}
BALL = {"body": {"kind": "sphere", "size_mm": [50, 50, 50]}, "contact_grid": {"count": [3, 3]}}


def test_five_faults_in_five_tables_are_told_together():
    with pytest.raises(SpecError) as told:
        parse_spec({"name": "cube", **FAULTS}, "cube.toml")
    for table, pattern in NAMED.items():
        assert re.search(pattern, str(told.value)), f"nothing of [{table}] in\n{told.value}"
    assert "core.wire_hole_" in str(told.value), "one fault of [core] hid the other"
    assert all(line.startswith("  - ") for line in str(told.value).splitlines()[1:])


@pytest.mark.parametrize("table", FAULTS)
def test_a_fault_alone_is_told_alone(table):
    """What is told beside the others is no consequence of them; of slits also what would fit."""
    found = problems_of(ObjectSpec.model_validate({"name": "cube", table: FAULTS[table]}))
    assert len(found) == (2 if table in ("core", "magnets", "shell") else 1), found


def test_a_magnet_that_is_moved_where_the_error_says_fits():
    spec = ObjectSpec.model_validate({"name": "cube", "magnets": {"positions_mm": [[19.0, 2.0]]}})
    limits = [re.findall(r"\|x\| below ([\d.]+)", text) for text in problems_of(spec)]
    nearest = min(float(found[0]) for found in limits if found)
    for x, fits in ((nearest - 1e-3, True), (nearest + 1e-3, False)):
        moved = spec.changed(magnets=spec.magnets.changed(positions_mm=((x, 2.0),)))
        assert (problems_of(moved) == []) is fits, x


def test_a_magnet_on_a_ball_that_is_moved_where_the_error_says_fits():
    magnets = {"positions_mm": [[20.0, 12.0]]}
    spec = ObjectSpec.model_validate({"name": "ball", **BALL, "magnets": magnets})
    text = next(text for text in problems_of(spec) if "outside faces 1, 2" in text)
    x, y = (float(number) for number in re.findall(r"as to \(([\d.]+), ([\d.]+)\)", text)[0])
    moved = spec.changed(magnets=spec.magnets.changed(positions_mm=((x, y),)))
    assert not any("outside face" in text for text in problems_of(moved))


def test_without_room_for_a_core_nothing_else_is_judged():
    body = {"size_mm": [20, 20, 20]}
    found = problems_of(ObjectSpec.model_validate({"name": "cube", "body": body}))
    assert len(found) == 1
    needed = float(re.findall(r"larger than ([\d.]+) mm", found[0])[0])
    for edge, judged in ((needed - 0.01, False), (needed + 0.01, True)):
        body = {"size_mm": [edge] * 3}
        texts = problems_of(ObjectSpec.model_validate({"name": "cube", "body": body}))
        assert (not any("larger than two core walls" in text for text in texts)) is judged


@pytest.mark.parametrize("body", [{}, {"body": {"kind": "dome", "size_mm": [60, 60, 36]}}])
def test_a_pocket_narrower_than_its_magnet_is_refused(body):
    """Magnets of 6 mm in pockets of 5.62 mm shared 3.43 mm³ each with the shell of a dome."""
    for diameter_mm, refused in ((5.99, True), (6.0, False)):
        shell = {"shell": {"pocket_diameter_mm": diameter_mm}}
        texts = problems_of(ObjectSpec.model_validate({"name": "x", **body, **shell}))
        assert any("narrower than the magnets" in text for text in texts) is refused
