"""Uncertainty in words: discretisation error, modulus, depth at a force."""

from design.spec.object import ObjectSpec
from estimator.tolerances.result import BoundRange, Robustness, Spread
from estimator.tolerances.saturation import Saturation
from instobj.report.uncertainty import (
    HEADER,
    coarse_mesh_text,
    error_rows,
    error_text,
    force_spread_text,
    forces_text,
    modulus_text,
    summary_of,
    travel_text,
)

SPEC = ObjectSpec(name="cube")
UNKNOWN = ObjectSpec.model_validate({"name": "cube", "silicone": {"youngs_modulus_mpa": 2.0}})
STEPS = [
    {"depth_mm": 0.5, "force_rms": None, "force_worst": None, "motion_rms": None, "motion_worst": None},
    {"depth_mm": 2.0, "force_rms": 0.0123, "force_worst": 0.03, "motion_rms": 0.008, "motion_worst": 0.02},
    {"depth_mm": 3.8, "force_rms": 0.01, "force_worst": 0.02, "motion_rms": 0.03, "motion_worst": 0.05},
]  # fmt: skip
CONTENT = {
    "steps": STEPS,
    "patch_compliance": 0.0071,
    "share_of_difference": 0.8,
    "presses": 125,
    "unknowns": 200_000,
    "coarse_unknowns": 70_000,
}


def test_the_headline_is_that_of_half_the_deepest_press():
    assert error_text(CONTENT) == "force ±1.2 %, motions ±0.8 % at 2 mm"
    assert summary_of(CONTENT)["estimate"] == error_text(CONTENT)


def test_a_coarser_mesh_than_the_usual_one_says_how_far_motions_may_be_off():
    """A preview's verdict read as that of the usual mesh."""
    assert coarse_mesh_text(SPEC, CONTENT) == ""
    finer = SPEC.changed(mesh={"edge_mm": 3.0})
    assert coarse_mesh_text(finer, CONTENT) == ""
    coarse = SPEC.changed(mesh={"edge_mm": 6.0, "surface_edge_mm": 2.5})
    text = coarse_mesh_text(coarse, CONTENT)
    assert text.startswith("coarse, edges of 6 instead of 4 mm, 2.5 instead of 1.7 mm: ")
    assert "motions up to 5 % off" in text, "the worst over the depths"
    assert "less exact" in coarse_mesh_text(coarse, None)
    assert "less exact" in coarse_mesh_text(coarse, CONTENT | {"steps": STEPS[:1]})


def test_a_missed_contact_is_said_and_shown_as_a_dash():
    assert "not known at 0.5 mm" in error_text(CONTENT | {"steps": STEPS[:1]})
    rows = error_rows(CONTENT)
    assert rows[0] == ["0.5", "–", "–", "–", "–"]
    assert rows[1] == ["2", "1.2 %", "3.0 %", "0.8 %", "2.0 %"]
    assert {len(row) for row in rows} == {len(HEADER)}


def test_the_spread_in_words():
    assert modulus_text(SPEC).startswith("0.414 MPa (0.15 to 0.54; Gent's relation")
    assert force_spread_text(SPEC).startswith("0.36 to 1.30 times what is shown")
    assert modulus_text(UNKNOWN) == "2 MPa (uncertainty not known; given)"
    assert "not known" in force_spread_text(UNKNOWN)


def test_the_depth_at_a_force_in_words():
    travel = {"force_n": 15.0, "nominal_mm": 2.5, "stiffest_mm": 1.917, "softest_mm": None}
    told = travel_text({"travel": travel, "deepest_press_mm": 4.0})
    assert told == "2.50 mm (1.92 mm to more than 4 mm) to 15 N at the median location"
    assert travel_text({"travel": None, "deepest_press_mm": 4.0}) == "not known"


def test_bounds_within_tolerance_name_their_forces():
    """A report had two bounds of one design, 16.6 and 18.3 mm: the second at forces that are less."""
    lone = Spread("all", *[0.0] * 12)
    ranges = [BoundRange(design, 0.5 * design, 2 * design) for design in (1.0, 18.3, 2.0, 3.0)]
    kept = Saturation(200, (0.0,), (0.0,), (0.5,))
    told = forces_text(Robustness((lone,), lone, lone, 200, 8.0, 3, *ranges, kept))
    assert told == "8 N, 3 places at 0.7 of deepest press"
    assert forces_text(Robustness((lone,), lone, lone, 200, 8.0, 0, *ranges, kept)) == "8 N"
    assert len(f"bounds within tolerance, fresh zero, at {told}") <= 80
