"""Go or no-go: the object's weakest figures against the specification's limits."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from design.layout.body import face_frames
from design.layout.places.coverage import cell_areas_mm2, covered_share
from design.spec.learning import SATURATION_MARGIN, LimitsSpec
from design.spec.object import ObjectSpec
from estimator.information.scores import PlaceScores, weakest_place
from estimator.information.weak_areas import bound_of_most
from estimator.tolerances.saturation import KEPT_BY, Saturation
from instobj.report.cells import percent_text

if TYPE_CHECKING:
    from design.body.surface_chart import FaceFrame

ENOUGH_COVERED = 0.8
"""Share of the surface from which little of it is left out."""
LEAST_REACHED = 0.5
"""Share of the contact locations that reach `score.force_n`, below which bounds at that force say little of
the object."""


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
    def failed(self) -> list[Check]:
        """Return the checks that do not pass."""
        return [check for check in self.checks if not check.passed]

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
    spec: ObjectSpec,
    scores: PlaceScores,
    saturation_margin: float,
    objects: Saturation | None = None,
) -> Verdict:
    """Judge an object from its scores, the share of the sensors' range that stays free in the design, and
    its virtual objects' chips; by the design alone where those are not known."""
    checks = (
        _position(spec, scores),
        _detection(spec, scores),
        _saturation(spec, saturation_margin, objects),
        _reach(spec, scores),
    )
    tightest = max(checks, key=lambda check: check.ratio)
    place = tightest.where.split(". ", 1)[0]  # sentences about other locations stand in the table
    reason = f"{tightest.what}: {tightest.value} ({place}), limit {tightest.limit}"
    others = [short_text(check) for check in checks if not check.passed and check is not tightest]
    if others:
        reason += f". Also beyond its limit: {'; '.join(others)}"
    area = cell_areas_mm2(spec)  # of every location, face by face
    judged = float(area[scores.judged[scores.places]].sum() / area.sum())
    return Verdict(checks, reason, judged * covered_share(spec))


def short_text(check: Check) -> str:
    """Return what is judged in two words, its value and its limit."""
    return f"{check.what.split(':')[0].lower()}: {check.value}, limit {check.limit}"


SCORES_TITLE = "scores over the contact locations"
_ROWS = {
    "position_bound_mm": "position bound, mm",
    "position_bound_drifted_mm": "after 15 min of drift, mm",
    "position_error_mm": "error of maximum likelihood, mm",
    "force_bound_n": "force bound, N",
    "detectable_force_n": "lightest touch felt, N",
}
"""Scores of the table; all with a fresh baseline but for the second."""


def score_rows(scores: PlaceScores) -> list[dict[str, Any]]:
    """Return median, 95th percentile and worst of each score, and where the worst is, as tables show it."""
    rows = []
    for name, title in _ROWS.items():
        values = getattr(scores, name)
        # bounds hold at one force, which some locations do not reach; a touch is felt or not everywhere
        judged = scores.places if name == "detectable_force_n" else scores.judged
        worst = np.argmax(np.where(judged, values, -np.inf))
        face, place = np.unravel_index(worst, values.shape)
        x, y = scores.grid.xy_mm[place]
        rows.append(
            {
                "score": title,
                "median": _or_infinite(float(np.median(values[judged]))),
                "95 % below": _or_infinite(bound_of_most(values[judged])),
                "worst": _or_infinite(float(values[face, place])),
                "on face": int(scores.faces[face]),
                "at x, y mm": f"{x:g}, {y:g}",
            }
        )
    return rows


def _or_infinite(value: float) -> float | str:
    """Return a figure as JSON and tables show it: no number where a location is blind."""
    return value if np.isfinite(value) else "∞"


def located_text(spec: ObjectSpec, scores: PlaceScores) -> str:
    """Say within what presses are located, where worst, and how many locations keep the limit."""
    bound, weakest = scores.position_bound_mm[scores.judged], weakest_place(scores)
    limit = spec.limits.position_bound_mm
    median, most, worst = (
        _shown(value, limit, "mm", "not at all")
        for value in (float(np.median(bound)), bound_of_most(bound), weakest.position_bound_mm)
    )
    judged = "" if len(bound) == scores.places.sum() else "judged "
    return (
        f"a press of {spec.score.force_n:g} N is located within {median} (one standard deviation) at half of "
        f"the {judged}contact locations, {most} at 95 % of them, and {worst} at the worst, which is "
        f"{place_text(spec, weakest.face, (weakest.x_mm, weakest.y_mm))}. "
        f"{percent_text(float(np.mean(bound <= limit)))} of the {judged}locations keep the limit of "
        f"{limit:g} mm{_reading_text(scores)}"
    )


_NOTABLE = 0.1
"""Share of the judged locations that are read worse than their bound, from which the head says so; ours."""


def _reading_text(scores: PlaceScores) -> str:
    """Say how far maximum likelihood errs where it is worse than the bound at many locations."""
    count, judged = int(scores.misread.sum()), int(scores.judged.sum())
    if count < _NOTABLE * judged:
        return ""
    error_mm = bound_of_most(scores.position_error_mm[scores.judged])
    error = f"{error_mm:.2g} mm" if np.isfinite(error_mm) else "not at all"
    reading = f"{error} at 95 % of all, by maximum likelihood"
    return f". {count} of {judged} are read worse than the bound: {reading}"


_MIDDLE, _OUTER = 1 / 3, 2 / 3
"""Shares of a face's half extent below which a location is in its middle, and above which at its edge."""


def sides_of(spec: ObjectSpec, face: int, xy_mm: tuple[float, float]) -> list[str]:
    """Return the edges of a face that a location is near, as "+x"; none in its inner part."""
    frame = next(frame for frame in face_frames(spec) if frame.number == face)
    shares = np.divide(xy_mm, frame.half_extents_mm)
    return [
        f"{'+' if share > 0 else '−'}{axis}"
        for axis, share in zip("xy", shares, strict=True)
        if abs(share) >= _OUTER
    ]


def place_text(spec: ObjectSpec, face: int, xy_mm: tuple[float, float]) -> str:
    """Say in words where on a face a location is: its middle, an edge or a corner, by the face's x and y; on
    a curved one also towards which end or side of the body."""
    frame = next(frame for frame in face_frames(spec) if frame.number == face)
    shares = np.divide(xy_mm, frame.half_extents_mm)
    sides = sides_of(spec, face, xy_mm)
    coordinates = f"({xy_mm[0]:g}, {xy_mm[1]:g}) mm" + _direction_text(spec, frame, xy_mm)
    if len(sides) == 2:
        return f"near the corner {' '.join(sides)} of face {face}, at {coordinates}"
    if sides:
        middle = "the middle of " if min(abs(shares)) <= _MIDDLE else ""
        return f"near {middle}the edge {sides[0]} of face {face}, at {coordinates}"
    where = "in the middle" if max(abs(shares)) <= _MIDDLE else "between middle and edge"
    return f"{where} of face {face}, at {coordinates}"


_TOWARDS, _LONGER = 0.5, 1.2
"""Share of half the body's length along an axis from which a location lies towards that end; the longest
axis has ends, others have sides, if it is so much longer than the next."""


def _direction_text(spec: ObjectSpec, frame: FaceFrame, xy_mm: tuple[float, float]) -> str:
    """Say towards which ends and sides of a body a location on a curved face lies, the farthest first."""
    if frame.flat:
        return ""
    on_plane = frame.to_plane(np.array([xy_mm]))
    (point,) = frame.to_object(np.pad(on_plane, ((0, 0), (0, 1))))
    shares = 2 * point / spec.body.size_mm
    lengths = sorted(spec.body.size_mm)
    words = [
        f"{'+' if shares[axis] > 0 else '−'}{'xyz'[axis]} "
        + ("end" if spec.body.size_mm[axis] > _LONGER * lengths[1] else "side")
        for axis in np.argsort(-abs(shares))
        if abs(shares[axis]) >= _TOWARDS
    ]
    return f", towards the body's {' and '.join(words)}" if words else ""


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


def _reach(spec: ObjectSpec, scores: PlaceScores) -> Check:
    """Bounds hold for locations that reach the force: an object that gives way too far is judged on few."""
    reached = float(scores.judged.sum() / scores.places.sum())
    deepest = max(spec.press.depths_mm)
    # a firmer silicone locates less well: it is worth that only where most locations do not reach the force
    advice = (
        "press deeper (press.depths_mm) or lower score.force_n" if reached < 1 else "all of them"
    )
    advice += ", or take a firmer silicone" if reached < LEAST_REACHED else ""
    return Check(
        f"Judged: contact locations that reach {spec.score.force_n:g} N by {deepest:g} mm",
        percent_text(reached),
        f"≥ {100 * LEAST_REACHED:g} %",
        LEAST_REACHED / max(reached, 1e-9),
        advice,
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


def _saturation(spec: ObjectSpec, margin: float, objects: Saturation | None) -> Check:
    if objects is None:
        return Check(
            "How strong: sensor range left free in the deepest press, by the design",
            f"{100 * margin:.0f} %",
            f"≥ {100 * SATURATION_MARGIN:g} %",
            # a margin of 1 of the virtual objects decides nothing
            _range_ratio(margin, 1.0),
            f"{spec.sensors.part}, ±{spec.sensors.range_mt:g} mT",
        )
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
    if not np.any(objects.out_share):
        return f"all {objects.objects} virtual objects stay in range"
    shares = dict(zip(objects.depth_mm, objects.out_share, strict=True))
    at_rest, *pressed = (
        f"{100 * share:.1f} % {f'at {depth:g} mm' if depth else 'at rest'}"
        for depth, share in shares.items()
        if depth == int(depth)
    )
    return f"of {objects.objects} virtual objects out of range: {', '.join([at_rest, *pressed])}"
