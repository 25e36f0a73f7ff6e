"""What the report says of the core."""

import json

import pytest

import instobj.commands.slip
from design.spec.object import ObjectSpec
from instobj.report.core_section import core_section


def test_a_bonded_core_in_its_place_is_not_mentioned(tmp_path):
    assert core_section(ObjectSpec(name="cube"), tmp_path, tmp_path) == ""


def test_tension_at_a_sliding_core_is_told(tmp_path):
    tension = {"largest_tension_kpa_per_n": 3.21, "x_mm": 13.0, "y_mm": -2.5, "z_mm": 4.0}
    tension |= {"press_face": 2, "press_x_mm": 7.5, "press_y_mm": -1.5}
    tension |= {"force_drop_where_it_lifts_off": 0.123}
    (tmp_path / "core_tension.json").write_text(json.dumps(tension))
    text = core_section(ObjectSpec(name="cube"), tmp_path, tmp_path)
    assert "3.21 kPa per newton" in text
    assert "(13, -2.5, 4) mm" in text
    assert "a press on face 2 at (7.5, -1.5) mm" in text
    assert "12.3 % less force" in text


@pytest.mark.parametrize("model", ["fem", "sensors-only"])
def test_a_slip_shows_the_error_of_moving_the_sensors_alone(tmp_path, monkeypatch, model):
    """With made-up costs: the real ones are tested with the command."""
    slip = {"shift_mm": (1.0, 0.0, -0.5), "model": model}
    spec = ObjectSpec.model_validate({"name": "cube", "mechanics": {"slip": slip}})
    figures = dict.fromkeys(instobj.commands.slip.FIGURES, 2.0)
    monkeypatch.setattr(
        instobj.commands.slip, "slip_costs", lambda *_: (None, {"fem": 1, "sensors-only": 2})
    )
    monkeypatch.setattr(
        instobj.commands.slip,
        "summary",
        lambda cost: {name: value * cost for name, value in figures.items()},
    )
    monkeypatch.setattr(
        instobj.commands.slip,
        "draw_slip",
        lambda spec, costs, path, title: path.write_bytes(b"figure"),
    )
    text = core_section(spec, tmp_path, tmp_path)
    assert "shift (1, 0, -0.5) mm" in text
    assert f"model '{model}'" in text
    assert text.count("<td>2</td><td>4</td><td>2</td>") == len(instobj.commands.slip.FIGURES)
