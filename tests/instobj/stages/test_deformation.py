"""Stages of deformation: where presses go, what is written, what the report says of them."""

import json

import numpy as np
import pytest
from numpy.testing import assert_allclose

from design.errors import InputError
from design.layout.places.contact_grid import PlaceGrid
from design.spec.object import ObjectSpec
from design.spec_io import parse_spec
from fem.large_strain.correction import StrainCorrection, corrected_table
from fem.presses.results import MagnetMotions, PressForces
from instobj.report.deformation_section import (
    correction_text,
    deformation_section,
    envelope_text,
)
from instobj.stages.makers import deformation as deformation_stages
from instobj.stages.makers.deformation import (
    correct_table,
    correction_places_mm,
    make_large_strain,
    make_shapes,
)
from instobj.store.stage import Call, StageContext

SPEC = ObjectSpec(name="cube")
PROTOCOL = {"shallowest_peak_mm": 1.0, "deepest_peak_mm": 4.5}
ERROR = {
    "uncorrected_rms": 0.06,
    "uncorrected_largest": 0.16,
    "corrected_rms": 0.04,
    "corrected_largest": 0.08,
}
PRESS = {
    "x_mm": 0.0,
    "y_mm": 13.5,
    "status": "diverged",
    "converged_depth_mm": 2.5,
    "five_percent_mm": 1.25,
    "twenty_percent_mm": None,
    "depth_mm": [1.0, 2.5],
    "force_n": [2.0, 8.0],
    "linear_force_n": [2.1, 9.0],
}
CONTENT = {
    "correction": {
        "thickness_mm": 8.0,
        "force": [0.1, 0.8],
        "shift": [0.0, 0.0],
        "rotation": [0.2],
    },
    "error": {"force": ERROR, "shift": ERROR, "rotation": ERROR},
    "presses": [PRESS],
}


def context(spec, folder):
    return StageContext(spec, {"large_strain": folder, "shapes": folder}, "key", lambda _: None)


def with_correction(**parts):
    mechanics = {"correction": "large-strain"}
    return parse_spec({"name": "cube", "mechanics": mechanics, **parts}, "test")


def test_places_span_the_face_and_its_magnets():
    assert correction_places_mm(SPEC) == [
        (0.0, 0.0), (16.0, 0.0), (16.0, 16.0), (10.0, 10.0), (5.0, 5.0), (6.4, 0.0),
    ]  # fmt: skip
    single = ObjectSpec.model_validate(
        {
            "name": "one",
            "magnets": {"positions_mm": [[0.0, 0.0]]},
            "contact_grid": {"count": [4, 6]},
        }
    )
    assert correction_places_mm(single) == [(0.0, 0.0), (4.5, 0.0), (4.5, 7.5), (1.8, 0.0)]


def test_nothing_is_pressed_without_a_correction(tmp_path):
    make_large_strain(context(SPEC, tmp_path), tmp_path)
    forces, motions = table()
    same_forces, same_motions = correct_table(SPEC, forces, motions, tmp_path)
    assert same_forces is forces
    assert same_motions is motions


def table():
    rng, faces = np.random.default_rng(2), np.arange(1, 6)
    lattice, depths = PlaceGrid(np.array([0.0, 3.0]), np.array([1.0])), np.array([1.0, 3.0])
    force = rng.uniform(1, 2, (5, 2, 2))
    motion = rng.normal(0, 0.1, (5, 2, 2, 25, 6))
    return PressForces(faces, lattice, depths, force, force), MagnetMotions(
        faces, lattice, depths, motion
    )


def test_a_table_is_corrected_by_what_was_fitted(tmp_path):
    (tmp_path / "large_strain.json").write_text(json.dumps(CONTENT))
    forces, motions = correct_table(SPEC, *table(), tmp_path)
    correction = StrainCorrection(8.0, (0.1, 0.8), (0.0, 0.0), (0.2,))
    expected_forces, expected_motions = corrected_table(SPEC, *table(), correction)
    assert_allclose(forces.force_n, expected_forces.force_n, rtol=1e-12)
    assert_allclose(motions.motion, expected_motions.motion, rtol=1e-12)
    assert (forces.force_n > table()[0].force_n).all()


@pytest.mark.parametrize(
    "mechanics",
    [{"element": "p2-p0"}, {"interface": "frictionless"}, {"slip": {"shift_mm": [1, 0, 0]}}],
)
def test_models_that_large_deformation_does_not_know_are_refused(mechanics):
    content = {"name": "cube", "mechanics": {"correction": "large-strain", **mechanics}}
    with pytest.raises(InputError, match="'large-strain' needs element = 'taylor-hood'"):
        parse_spec(content, "test")


def test_the_report_says_what_the_presses_showed(tmp_path):
    (tmp_path / "large_strain.json").write_text(json.dumps(CONTENT))
    inputs = {"large_strain": tmp_path, "shapes": tmp_path}
    page = deformation_section(SPEC, inputs, PROTOCOL)
    for words in ("(0, 13.5)", "1.25 mm", "not reached", "2.50 mm, then diverged", "1.12"):
        assert f"<td>{words}</td>" in page
    assert "No section" in page
    text = correction_text(CONTENT)
    assert "force 6.0 % → 4.0 % (largest 16 → 8 %)" in text
    assert "shifts 6.0 % → 4.0 % (largest 16 → 8 %), so left uncorrected" in text


def test_without_presses_the_envelope_is_named_as_orientation():
    text = envelope_text(SPEC, PROTOCOL)
    assert "force by up to 3 %, magnet motions by 11 % at 1.00 mm" in text
    assert "beyond what was measured at 4.50 mm" in text
    assert "5 % off at 1.8 mm" in text
    assert "orientation" in text


@pytest.mark.slow
def test_presses_are_made_and_their_correction_fitted(tmp_path, monkeypatch):
    spec = with_correction(
        mesh={"surface_edge_mm": 2.2, "edge_mm": 6.0, "rim_edge_ratio": 1.0},
        press={"depths_mm": [0.8, 1.2]},
    )
    places = [(0.0, 0.0), (6.0, 3.0), (13.5, 13.5)]
    monkeypatch.setattr(deformation_stages, "correction_places_mm", lambda _: places)
    make_large_strain(context(spec, tmp_path), tmp_path)
    content = json.loads((tmp_path / "large_strain.json").read_text())
    assert [(row["x_mm"], row["y_mm"]) for row in content["presses"]] == places
    for row in content["presses"]:
        assert row["status"] == "converged"
        assert_allclose(row["force_n"], row["linear_force_n"], rtol=0.12)
    assert 0.8 < content["correction"]["shift"][1] < 1.8 or not any(content["correction"]["shift"])
    assert content["error"]["force"]["uncorrected_rms"] < 0.12


class Factor:
    """Of a response operator; tells whether its memory was given back."""

    def __init__(self):
        self.released = False
        self.factor = self

    def release(self):
        self.released = True


def test_shapes_take_the_factor_that_the_call_kept_and_give_it_back(tmp_path, monkeypatch):
    taken = []

    def shapes(*given):
        taken.append(given[-1])
        return [None, None]

    monkeypatch.setattr("fem.presses.shape.table_shapes", shapes)
    monkeypatch.setattr("fem.presses.shape.save_deformed_shape", lambda shape, path: None)
    monkeypatch.setattr("instobj.figures.section.draw_sections", lambda panels, path: None)
    monkeypatch.setattr(StageContext, "read", lambda self, file: OF_NO_CORE)
    kept = Factor()
    within = StageContext(SPEC, {}, "shapes", lambda _: None, Call(factored=kept))
    make_shapes(within, tmp_path)
    make_shapes(within, tmp_path)
    make_shapes(StageContext(SPEC, {}, "shapes", lambda _: None), tmp_path)
    assert taken == [kept, None, None]
    assert kept.released


class OF_NO_CORE:
    core = None
