"""Go or no-go: the object's weakest figures against the specification's limits."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from design.layout.places.coverage import cell_areas_mm2, covered_share
from design.spec.learning import SATURATION_MARGIN, LimitsSpec
from design.spec.object import ObjectSpec
from estimator.information.scores import PlaceScores, weakest_place
from estimator.tolerances.saturation import KEPT_BY, Saturation

ENOUGH_COVERED = 0.8
"""Share of the surface from which little of it is left out."""


@dataclass(frozen=True)
class Check:
    """One figure against its limit; `ratio` is 1 at the limit and above 1 where it fails."""

    what: str
    value: str
    limit: str
    ratio: float
    where: str

    @property
    def passed(self) -> bool:
        return self.ratio <= 1


@dataclass(frozen=True)
class Verdict:
    """All checks; `go` where every one passes; `limited_by` says what comes first.

    `covered` is the share of the sensed surface that the judged contact locations stand for.
    """

    checks: tuple[Check, ...]
    limited_by: str
    covered: float

    @property
    def go(self) -> bool:
        return all(check.passed for check in self.checks)

    @property
    def says_enough(self) -> bool:
        """Return whether little of the surface is left out."""
        return self.covered >= ENOUGH_COVERED


def worst_ratio(
    limits: LimitsSpec,
    position_bound_mm: float,
    detectable_force_n: float,
    margin: float,
    objects_margin: float,
) -> float:
    """The largest of an object's weakest figures over its limit; 1 and below passes."""
    return max(
        position_bound_mm / limits.position_bound_mm,
        detectable_force_n / limits.detectable_force_n,
        _range_ratio(margin, objects_margin),
    )


def _range_ratio(margin: float, objects_margin: float) -> float:
    return max((1 - margin) / (1 - SATURATION_MARGIN), 1 - objects_margin)


def judge(
    spec: ObjectSpec, scores: PlaceScores, saturation_margin: float, objects: Saturation
) -> Verdict:
    """Judge an object from its scores, the share of the sensors' range that stays free in the design, and
    its virtual objects' chips."""
    checks = (
        _position(spec, scores),
        _detection(spec, scores),
        _saturation(spec, saturation_margin, objects),
    )
    tightest = max(checks, key=lambda check: check.ratio)
    place = tightest.where.split(". ", 1)[0]  # sentences about other locations stand in the table
    reason = f"{tightest.what}: {tightest.value} ({place}), limit {tightest.limit}"
    area = cell_areas_mm2(spec)  # of every location, face by face
    judged = float(area[scores.judged[scores.places]].sum() / area.sum())
    return Verdict(checks, reason, judged * covered_share(spec))


def _position(spec: ObjectSpec, scores: PlaceScores) -> Check:
    weakest = weakest_place(scores)
    limit = spec.limits.position_bound_mm
    return Check(
        f"Where: position bound of a press of {spec.score.force_n:g} N at the weakest contact location, "
        "fresh baseline",
        _shown(weakest.position_bound_mm, limit, "mm", "blind"),
        f"≤ {limit:g} mm",
        weakest.position_bound_mm / limit,
        f"face {weakest.face} at ({weakest.x_mm:g}, {weakest.y_mm:g}) mm, worst along "
        f"{weakest.direction_deg:.0f}° from x"
        + "".join(f". {text}" for text in (scores.exceeds_bound, scores.unreached) if text),
    )


def _detection(spec: ObjectSpec, scores: PlaceScores) -> Check:
    forces = np.where(scores.places, scores.detectable_force_n, -np.inf)
    face, place = np.unravel_index(np.argmax(forces), forces.shape)
    force = forces[scores.places]
    x, y = scores.grid.xy_mm[place]
    limit = spec.limits.detectable_force_n
    return Check(
        "How light: lightest touch that is felt at every contact location (five sigma of the baseline)",
        _shown(float(force.max()), limit, "N", "none; even the deepest press is not felt"),
        f"≤ {limit:g} N",
        float(force.max() / limit),
        f"face {scores.faces[face]} at ({x:g}, {y:g}) mm; median location "
        + _shown(float(np.median(force)), limit, "N", "none"),
    )


def shown_against_limit(value: float, limit: float) -> str:
    """Two decimals, or as many as keep the figure on its side of the limit."""
    for decimals in range(2, 6):
        text = f"{value:.{decimals}f}"
        if (float(text) > limit) == (value > limit):
            return text
    return repr(value)


def _shown(value: float, limit: float, unit: str, unknown: str) -> str:
    return f"{shown_against_limit(value, limit)} {unit}" if np.isfinite(value) else unknown


def _saturation(spec: ObjectSpec, margin: float, objects: Saturation) -> Check:
    return Check(
        "How strong: sensor range left free in the deepest press, by the design; virtual objects whose "
        "chips all stay within it",
        f"{100 * margin:.0f} %; {100 * (1 - objects.out_share[-1]):.1f} %",
        f"≥ {100 * SATURATION_MARGIN:g} %; ≥ {100 * KEPT_BY:g} %",
        _range_ratio(margin, objects.margin[-1]),
        f"{spec.sensors.part}, ±{spec.sensors.range_mt:g} mT; {objects_text(objects)}",
    )


def objects_text(objects: Saturation) -> str:
    """Return how many virtual objects leave the range, at rest and from depth to depth."""
    shares = dict(zip(objects.depth_mm, objects.out_share, strict=True))
    at_rest, *pressed = (
        f"{100 * share:.1f} % {f'at {depth:g} mm' if depth else 'at rest'}"
        for depth, share in shares.items()
        if depth == int(depth)
    )
    return f"of {objects.objects} virtual objects out of range: {', '.join([at_rest, *pressed])}"
