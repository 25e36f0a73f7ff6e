"""What the report says of the core."""

import json

from design.spec.object import ObjectSpec
from instobj.report.core_section import FIGURES, core_section
from tests.support.pictures import save_dot


def test_a_bonded_core_in_its_place_is_not_mentioned(tmp_path):
    assert core_section(ObjectSpec(name="cube"), tmp_path, tmp_path) == ""


def test_tension_at_a_sliding_core_is_told(tmp_path):
    tension = {"largest_tension_kpa_per_n": 3.21, "x_mm": 13.0, "y_mm": -2.5, "z_mm": 4.0}
    tension |= {"press_face": 2, "press_x_mm": 7.5, "press_y_mm": -1.5}
    tension |= {"force_drop_where_it_lifts_off": 0.123}
    (tmp_path / "core_tension.json").write_text(json.dumps(tension))
    text = " ".join(core_section(ObjectSpec(name="cube"), tmp_path, tmp_path).split())
    assert "3.21 kPa per newton" in text
    assert "(13, -2.5, 4) mm" in text
    assert "a press on face 2 at (7.5, -1.5) mm" in text
    assert "12.3 % less force" in text


def test_a_slip_is_told_with_its_cost(tmp_path):
    """From made-up costs: the real ones are tested with the command."""
    slip = {"shift_mm": (1.0, 0.0, -0.5), "rotation_deg": (0.0, 0.0, 0.0), "rim": "free"}
    spec = ObjectSpec.model_validate({"name": "cube", "mechanics": {"slip": slip}})
    figures = dict.fromkeys(FIGURES, 2.0)
    content = {"slip": slip, "figures": figures, "sensors": []}
    (tmp_path / "slip.json").write_text(json.dumps(content))
    save_dot(tmp_path / "slip.png")
    text = " ".join(core_section(spec, tmp_path, tmp_path).split())
    assert "shift (1, 0, -0.5) mm" in text
    assert text.count("<td>2</td>") == len(FIGURES)
