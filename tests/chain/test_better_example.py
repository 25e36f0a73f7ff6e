"""The better cube of the examples: the paper's parts, room for all of them, and better."""

from pathlib import Path

import numpy as np
import pytest

from design.fabrication.layout import failures, layout_findings
from design.spec_io import load_spec
from estimator.field.models import exact_model
from estimator.layouts.fidelity import regressed_share
from estimator.signals.field_setup import zero_motion
from estimator.signals.hall import full_scale_counts
from estimator.tolerances.assembly import counts_of, designed, draw
from estimator.tolerances.saturation import KEPT_BY
from instobj.commands.run import check_specifications
from instobj.search.fidelity import chain_score
from studies.layouts import changed

EXAMPLES = Path(__file__).parents[2] / "examples"
BETTER, PAPER = EXAMPLES / "better_cube.toml", EXAMPLES / "paper_cube.toml"
COARSE = {
    "mesh.surface_edge_mm": 3.0,
    "search.forces_n": [2.0, 8.0],
    "mesh.rim_edge_ratio": 1.0,
    "mesh.edge_mm": 7.0,
    "contact_grid.count": [7, 7],
    "contact_grid.pitch_mm": 4.5,
    "press.depths_mm": [1.0, 2.0, 3.0],
}


def test_it_has_the_papers_parts_shell_and_silicone():
    better, paper = load_spec(BETTER, []), load_spec(PAPER, [])
    for name in ("body", "shell", "silicone", "core", "score", "tolerances"):
        assert getattr(better, name) == getattr(paper, name)
    for name in ("shape", "diameter_mm", "height_mm", "remanence_t"):
        assert getattr(better.magnets, name) == getattr(paper.magnets, name)
    assert len(better.magnets.positions_mm) == len(paper.magnets.positions_mm)
    for name in ("part", "count_per_face", "range_mt", "noise_counts"):
        assert getattr(better.sensors, name) == getattr(paper.sensors, name)


def test_it_can_be_made_and_its_sensors_have_a_margin_at_rest():
    assert not failures(layout_findings(load_spec(BETTER, [])))
    row = check_specifications([BETTER], [])["specifications"][0]
    assert row["largest_field_at_rest_mt"] < 0.6 * row["range_mt"]


def test_its_chips_stay_in_their_range_at_rest_within_its_tolerances():
    """In at least 95 % of 200 drawn objects (measured 100 %), by exact fields."""
    spec = load_spec(BETTER, [])
    rng, design, model = np.random.default_rng(11), designed(spec), exact_model(spec.magnets)
    rest = zero_motion(design.scene)
    drawn = (draw(spec, design, rng).scene for _ in range(200))
    largest = [abs(counts_of(spec, one, rest, model)).max() for one in drawn]
    assert np.mean(np.array(largest) <= full_scale_counts(spec.sensors)) >= KEPT_BY


@pytest.mark.slow
def test_it_is_better_on_a_coarse_mesh_too(tmp_path, monkeypatch):
    monkeypatch.setenv("INSTOBJ_STORE", str(tmp_path))
    paper, better = (chain_score(changed(load_spec(path, []), COARSE)) for path in (PAPER, BETTER))
    assert better.objects_margin > -0.02
    assert paper.worst_position_bound_mm > 2 * better.worst_position_bound_mm
    assert paper.percentile_99_position_bound_mm > 2 * better.percentile_99_position_bound_mm
    assert paper.median_position_bound_mm > 1.8 * better.median_position_bound_mm
    assert paper.worst_force_bound_n > 2 * better.worst_force_bound_n
    assert paper.median_false_force_n > 2 * better.median_false_force_n
    assert regressed_share(paper, better) <= 0.02
