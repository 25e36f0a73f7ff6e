"""Figures that builders published of their magnetic objects, compared with those predicted.

The specifications lie in `studies/published`; each states which sizes are published and which assumed.
Predictions are medians over the contact locations, freshly zeroed. A mean absolute error is compared
with the force bound times sqrt(2/π), which that of an unbiased normal error is.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from design.spec.object import ObjectSpec
from design.spec_io import load_spec
from estimator.information.scores import PlaceScores
from instobj.stages.run import Run
from instobj.store.readers import SCORES
from studies.registry import Study, StudyResult

HERE = Path(__file__).parent
_MEAN_OF_NORMAL = float(np.sqrt(2 / np.pi))
"""Mean absolute deviation of a normal error over its standard deviation."""


@dataclass(frozen=True)
class Published:
    """A published object: its specification, the figure of its builders (None: none), and what makes the
    prediction differ."""

    path: str
    what: str
    value: float | None
    why: str
    quick: tuple[str, ...] = ()


OBJECTS = (
    Published(
        "published/uskin_element.toml",
        "least force N",
        0.01,
        "magnet, its height and silicone are assumed; five sigma of one reading are asked for, not a mean",
    ),
    Published(
        "published/pyramid.toml",
        "mean absolute error N",
        0.0117,
        "noise alone is predicted; hysteresis and the fit's error come on top; all sizes are assumed",
    ),
    Published(
        "published/qmcube.toml",
        "chips",
        96.0,
        "only faces and chips are published; bounds hold for the placeholder of one magnet a chip",
        ("body.sensed_faces=[1]",),
    ),
)
NOT_SCORED = (
    "AnySkin (arXiv 2409.08276, github.com/raunaqbhirangi/anyskin) is no row: its builders report slip and "
    "policies learned from raw readings of five chips, and no error of force or place. Its magnets are "
    "particles magnetised over the whole skin; a specification has single magnets",
    "InstrumentedCube is no row: its builders published levels of travel and no force. What "
    "studies/instrumented_cube.toml predicts at equal travel stands in docs/measured/adopt.md",
)


def run_published(spec: ObjectSpec, folder: Path, quick: bool) -> StudyResult:
    """Score the published objects; the given specification is the row that they are compared with."""
    rows = [_row(spec, Published("", "–", None, "for comparison"))]
    for item in OBJECTS:
        # One face is alike the others: a quick run meshes for no more.
        rows.append(_row(load_spec(HERE / item.path, list(item.quick) if quick else []), item))
    return StudyResult(rows, NOT_SCORED)


def _row(spec: ObjectSpec, item: Published) -> dict[str, object]:
    scores = Run(spec).read(SCORES)
    least_n = _median(scores, scores.detectable_force_n)
    error_n = _median(scores, _MEAN_OF_NORMAL * scores.force_bound_n)
    predicted = {
        "least force N": least_n,
        "mean absolute error N": error_n,
    }
    return {
        "object": spec.name,
        "published": item.what,
        "value": item.value,
        "predicted": predicted.get(item.what),
        "least force N": least_n,
        "mean absolute error N": error_n,
        "place mm": _median(scores, scores.position_bound_mm),
        "at N": spec.score.force_n,
        "why": item.why,
    }


def _median(scores: PlaceScores, values: np.ndarray) -> float | None:
    """Median over the locations that are judged; None where it is infinite or none is."""
    judged = values[scores.judged]
    middle = float(np.median(judged)) if judged.size else np.inf
    return middle if np.isfinite(middle) else None


STUDIES = (
    Study(
        "published-objects",
        "Figures that builders of other objects published, beside what is predicted for them.",
        run_published,
    ),
)
