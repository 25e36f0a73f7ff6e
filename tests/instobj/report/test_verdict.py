"""What the first page says of the locations at the border of a face."""

import pytest

from estimator.information.scores import AREAS, AreaSummary
from instobj.report import verdict


def test_the_verdict_names_areas_that_the_face_has(monkeypatch):
    found = {"corner": 3.04, "edge": 2.5, "mid_edge": 2.0, "centre": 1.0}

    def told(*areas):
        summaries = [
            AreaSummary(area, (1,), {}, {"position_bound_mm": found[area]}) for area in areas
        ]
        monkeypatch.setattr(verdict, "summarize_areas", lambda scores: summaries)
        return verdict._edge_weakness(None)

    assert told(*AREAS) == (
        "The position bound is 2.0 times the centre's at mid-edge locations, in corners 3.0 times"
    )
    assert told("edge", "mid_edge") == (
        "The position bound is 2.5 times the centre's at the outermost locations"
    )
    assert told("corner", "centre") == "The position bound is 3.0 times the centre's in corners"


@pytest.mark.parametrize(
    ("value", "text"),
    [(1.5, "1.50"), (1.504, "1.504"), (1.50001, "1.50001"), (1.496, "1.50"), (1.6, "1.60")],
)
def test_a_figure_that_fails_is_not_shown_as_its_limit(value, text):
    assert verdict.beside_limit(value, 1.5) == text
