"""Objects of other builders: their specifications, and the table of published and predicted figures."""

import pytest

from design.catalogue.bus_parts import PICO
from design.spec_io import load_spec
from design.wiring.bus_plan import choose_plan
from studies.published_objects import HERE, OBJECTS
from studies.registry import studies


@pytest.mark.parametrize("item", OBJECTS, ids=lambda item: item.path)
def test_a_specification_states_what_is_published_and_what_assumed(item):
    path = HERE / item.path
    head = path.read_text().split("\nname = ")[0]
    assert "Published: " in head
    assert "ssumed: " in head
    assert load_spec(path).name == path.stem


def test_the_qmcube_has_six_faces_of_sixteen_chips_and_a_board_that_reads_them():
    spec = load_spec(HERE / "published" / "qmcube.toml")
    assert spec.body.sensed == (1, 2, 3, 4, 5, 6)
    plan, _ = choose_plan(spec, PICO)
    assert len(plan.chips) == 6 * 16


@pytest.mark.slow
def test_the_table_stands_in_the_order_of_magnitude_of_what_was_published(tmp_path):
    spec = load_spec(HERE / "published" / "pyramid.toml")
    found = studies()["published-objects"].run(spec, tmp_path, True)
    rows = {row["object"]: row for row in found.rows[1:]}
    assert list(rows) == ["uskin_element", "pyramid", "qmcube"]
    pyramid = rows["pyramid"]
    assert 1 / 3 < pyramid["predicted"] / pyramid["value"] < 3
    assert any("AnySkin" in text for text in found.texts)
