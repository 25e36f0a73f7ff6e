"""Remedies for a no-go: changes and sets of them against the limits, with their price.

Price covers magnets and sensors, build time that of setting and wiring them by hand:
what the changes differ in.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from math import isfinite
from operator import mul
from typing import Any

from design.body.surface_chart import FACE_AXES
from design.spec.object import ObjectSpec
from estimator.information.scores import PlaceScores, weakest_place
from instobj.report.cells import GO, NO_GO, percent_text
from instobj.report.uncertainty import coarse_mesh_text
from instobj.report.verdict import (
    LEAST_REACHED,
    judge,
    located_text,
    objects_text,
    place_text,
    short_text,
    shown_against_limit,
    sides_of,
    worst_ratio,
)
from instobj.report.weak_areas import are_weak, edge_text
from instobj.store.content import StoredResult
from instobj.store.readers import (
    ALTERNATIVES,
    DISCRETISATION,
    PRESS_CURVES,
    ROBUSTNESS,
    SCORES,
    WEAK_AREAS,
)

PRICES_EUR, MINUTES = (0.2, 3.0), (2.0, 15.0)
"""Price and time by hand of a magnet and of a sensor on its board. A magnet's pole is found and it is
pressed in; a sensor gets five wires and is tested and glued. Estimates, to compare changes by."""
_BEST = 7
"""Remedies in the table."""


@dataclass(frozen=True)
class Remedy:
    """Changes, the largest figure over its limit after them (1 and below is a go), and what they add.

    `bound_mm` is the weakest position bound after them; `unreached` the share of the locations where no
    press has `force_n` any more; `settings` are their lines `key = value`.
    """

    changes: tuple[str, ...]
    ratio: float
    bound_mm: float
    price: float
    minutes: float
    unreached: float = 0.0
    force_n: float = 0.0
    settings: tuple[str, ...] = ()

    @property
    def turns(self) -> bool:
        return self.ratio <= 1

    @property
    def text(self) -> str:
        """Changes with their price and build time, and what they no longer reach."""
        more = f"+{self.price:.0f} € for magnets and sensors, +{self.minutes:.0f} min by hand"
        more = more if self.price else "no more magnets or sensors"
        if self.unreached:
            more += (
                f"; at {percent_text(self.unreached)} of the locations the deepest press is then below "
                f"{self.force_n:g} N"
            )
        return f"{_joined(self.changes)} ({more})"


def remedies(spec: ObjectSpec, rows: list[dict[str, Any]]) -> list[Remedy]:
    """Every change and set of them of the stage `alternatives`; first the ones that turn it, cheapest first,
    then the nearest: by the weakest position bound where locations stay blind.

    A set that holds a change which is enough by itself is left out, and what makes the object no better, or
    no longer carries the force at most of the locations: smaller presses are judged there.
    """
    specified, *changed = (_remedy(spec, rows[0], row) for row in rows)
    candidates = [
        remedy
        for remedy in changed
        if _distance(remedy) < _distance(specified) and remedy.unreached <= 1 - LEAST_REACHED
    ]
    enough = {
        remedy.changes[0] for remedy in candidates if remedy.turns and len(remedy.changes) == 1
    }
    candidates = [
        remedy
        for remedy in candidates
        if len(remedy.changes) == 1 or not enough & {*remedy.changes}
    ]
    return sorted(candidates, key=_order)


def _distance(remedy: Remedy) -> tuple[float, float]:
    """Return how far from the limits it is: 1 % is no difference, and is worth no price."""
    bound = 0.0 if isfinite(remedy.ratio) else remedy.bound_mm
    return round(max(remedy.ratio, 1), 2), bound


def _order(remedy: Remedy) -> tuple[float, ...]:
    return *_distance(remedy), remedy.price, remedy.minutes, remedy.ratio


def remedies_section(spec: ObjectSpec, content: dict[str, Any], go: bool) -> dict[str, Any]:
    """Return the change that helps most, its lines to copy and a table of the best, for the page."""
    rows = content["alternatives"]
    candidates = remedies(spec, rows)
    figures = {tuple(row["changes"]): _figures(spec, row) for row in rows}
    price, minutes = price_and_minutes(rows[0]["magnets"], rows[0]["sensors"])
    table = [["as specified", *figures[()], f"{price:.0f}", f"{minutes:.0f}", ""]]
    for remedy in candidates[:_BEST]:
        more = [
            f"+{remedy.price:.0f}",
            f"+{remedy.minutes:.0f}",
            "pass" if remedy.turns else "FAIL",
        ]
        table.append([_joined(remedy.changes), *figures[remedy.changes], *more])
    first = None if go else first_change(candidates)
    further: tuple[str, ...] = ()
    if not (go or (first and first.turns)):
        further = _further_sentences(spec, rows, content.get("next_options", ()))
    return {
        "decision": (decision(candidates, go), *further),
        "settings": first.settings if first else (),
        "alternatives": table,
    }


_HALF = 0.5
"""Share of their bound that weak edges are to come down to."""


def edges_text(spec: ObjectSpec, content: dict[str, Any], rows: list[dict[str, Any]]) -> str:
    """Return whether edges are weak and, of weak ones, the cheapest change that halves their bound, else
    the one that makes it smallest."""
    text, (specified, *changed) = edge_text(content), rows
    now = specified["edge_bound_mm"]
    if not are_weak(content) or now is None or not isfinite(now):
        return text
    after = {_remedy(spec, specified, row): row["edge_bound_mm"] for row in changed}
    better = {
        remedy: bound
        for remedy, bound in after.items()
        if bound < now and remedy.unreached <= 1 - LEAST_REACHED
    }
    if not better:
        return f"{text}; none of the changes tried makes them better"
    # by the figures as shown, so that they do not contradict the sentence
    shown = {remedy: float(f"{bound:.2g}") for remedy, bound in better.items()}
    halving = [remedy for remedy in better if shown[remedy] <= _HALF * float(f"{now:.2g}")]
    cheapest = min(halving, key=lambda remedy: (remedy.price, remedy.minutes), default=None)
    best = cheapest or min(better, key=lambda remedy: better[remedy])
    effect = "This halves it" if cheapest else "No change tried halves it; the best"
    return f"{text}. {effect}: {_joined(best.changes)} (edges then {better[best]:.2g} mm)"


def worst_edge_text(spec: ObjectSpec, scores: PlaceScores, content: dict[str, Any]) -> str:
    """Return where the worst location is, as a clause, where it is at an edge though edges are not weak."""
    worst = weakest_place(scores)
    xy_mm = worst.x_mm, worst.y_mm
    if are_weak(content) or not (sides := sides_of(spec, worst.face, xy_mm)):
        return ""
    text = f"; but the worst location lies {place_text(spec, worst.face, xy_mm)}"
    # the side of an edge faces along that axis of its face
    _, *axes = FACE_AXES[worst.face]
    outwards = [
        tuple((1 if side[0] == "+" else -1) * part for part in axes["xy".index(side[1])])
        for side in sides
    ]
    opened = [face for face in spec.body.opened if FACE_AXES[face][0] in outwards]
    return f"{text}, next to the open side {opened[0]}" if opened else text


DESIGN_STAGES = ("scores", "weak_areas", "press_curves")
"""Stages that a verdict by the design alone is read from."""


def verdict_summary(spec: ObjectSpec, results: dict[str, StoredResult]) -> dict[str, str]:
    """Return what the report's first lines say; of the design alone where no virtual object was judged."""
    margin = PRESS_CURVES.read(results["press_curves"].folder)["saturation_margin"]
    scores, objects = SCORES.read(results["scores"].folder), None
    if "robustness" in results:
        objects = ROBUSTNESS.read(results["robustness"].folder).saturation
    verdict = judge(spec, scores, margin, objects)
    built = "of the design alone, tolerances by `instobj run`"
    if objects is not None:
        built = objects_text(objects)
    good = "good enough" if verdict.go else "not good enough"
    failed = "" if verdict.go else f" ({'; '.join(map(short_text, verdict.failed))})"
    lines = {
        GO if verdict.go else NO_GO: (
            f"{good} for the use {spec.limits.use!r}{failed}; {located_text(spec, scores)}"
        ),
        "judged on": (
            f"{verdict.covered:.0%} of the sensed surface, by {tip_text(spec)} (pads and jaws: instobj docs "
            f"start); {built}"
        ),
        **_mesh_line(spec, results),
        "limited by": verdict.limited_by,
        "edges": edge_text(edges := WEAK_AREAS.read(results["weak_areas"].folder)),
    }
    if "alternatives" in results:
        content = ALTERNATIVES.read(results["alternatives"].folder)
        rows = content["alternatives"]
        lines["edges"] = edges_text(spec, edges, rows)
        lines["what to change"] = decision(
            remedies(spec, rows), verdict.go, further_text(spec, rows, content["next_options"])
        )
    lines["edges"] += worst_edge_text(spec, scores, edges)
    return lines


def _mesh_line(spec: ObjectSpec, results: dict[str, StoredResult]) -> dict[str, str]:
    error = None
    if "discretisation" in results:
        error = DISCRETISATION.read(results["discretisation"].folder)
    text = coarse_mesh_text(spec, error)
    return {"mesh": text} if text else {}


def tip_text(spec: ObjectSpec) -> str:
    """Return what presses, in words."""
    tip = spec.indenter
    ball = f"a round tip of {tip.radius_mm:g} mm radius"
    return ball if tip.kind == "hemisphere" else f"the indenter ({tip.kind})"


def _above(ratio: float) -> str:
    """Return by how much a figure is above its limit, rounded so that it is never nothing."""
    if ratio >= 1.1:
        return f"{ratio:.3g} times"
    return f"{100 * (ratio - 1):.2g} % above"


def first_change(candidates: list[Remedy]) -> Remedy | None:
    """Return the cheapest remedy that is enough, else the single change that helps most."""
    singles = [remedy for remedy in candidates if remedy.turns or len(remedy.changes) == 1]
    return min(singles, key=_order, default=None)


def decision(candidates: list[Remedy], go: bool, further: str = "") -> str:
    """Return what to do, in a few sentences; candidates come in the order of `remedies`, and `further` says
    what was not tried (`further_text`)."""
    if go:
        return "Every limit is kept; nothing has to change"
    first = first_change(candidates)
    if first is None:
        return f"None of the changes tried here fits and makes it better{further}"
    if first.turns:
        return f"Turns it into a go: {first.text}"
    helps, nearest = f"Helps most alone: {first.text}", candidates[0]
    if isfinite(first.ratio):
        helps += f"; the worst figure is then still {_above(first.ratio)} its limit"
        if _distance(nearest) < _distance(first):
            # what a change does in brackets was said of the first one
            names = tuple(name.split(" (")[0] for name in nearest.changes)
            helps += f" ({_above(nearest.ratio)} with {_joined(names)})"
    else:
        helps += (
            f"; the weakest position bound is then {first.bound_mm:.2g} mm, and "
            "some locations feel nothing up to the deepest press"
        )
    return f"None of the changes tried is enough, alone or with others. {helps}{further}"


def further_text(spec: ObjectSpec, rows: list[dict[str, Any]], options: Iterable[str] = ()) -> str:
    """Return why a softer silicone is left out, and what to try next: other places, then `options` of
    `instobj check` (`next_options`)."""
    return "".join(f". {sentence}" for sentence in _further_sentences(spec, rows, options))


def _further_sentences(
    spec: ObjectSpec, rows: list[dict[str, Any]], options: Iterable[str]
) -> tuple[str, ...]:
    text = " or ".join(options)
    then = f", then {text} (by a forecast: confirm by instobj score)" if text else ""
    next_text = f"Next to try: other places (instobj optimize){then}"
    return tuple(filter(None, (_softer_text(spec, rows), next_text)))


def softer_label(name: str) -> str:
    """Return the name of the change to a softer silicone, as users read it."""
    return f"{name} as the silicone (softer: deeper presses)"


def _softer_text(spec: ObjectSpec, rows: list[dict[str, Any]]) -> str:
    """Return why softer silicones are no remedy, as a sentence; nothing where one is."""
    surely, perhaps = spec.silicone.softer()
    reasons = list[str]()
    if surely:
        change = (softer_label(surely[0].name),)
        row = next((row for row in rows if tuple(row["changes"]) == change), None)
        if row is None:
            reasons.append(f"{surely[0].name} does not fit the other keys")
        elif row["unreached"] > 1 - LEAST_REACHED:
            reasons.append(
                f"with {surely[0].name} presses reach {spec.score.force_n:g} N at only "
                f"{percent_text(1 - row['unreached'])} of the locations"
            )
        else:
            return ""
    if perhaps:
        reasons.append(
            f"{perhaps[0].name} ({_range_text(*perhaps[0].modulus.range_mpa)}) is not surely softer than "
            f"this one ({_range_text(*spec.silicone.modulus_interval_mpa)})"
        )
    why = "; ".join(reasons) or "the catalogue has none"
    return f"Softer silicone is left out: {why}"


def _range_text(low_mpa: float, high_mpa: float) -> str:
    return f"{low_mpa:g} to {high_mpa:g} MPa" if low_mpa < high_mpa else f"{low_mpa:g} MPa"


def _joined(changes: tuple[str, ...]) -> str:
    *others, last = changes
    return f"{', '.join(others)} and {last}" if others else last


def price_and_minutes(magnets: int, sensors: int) -> tuple[float, float]:
    """Return price and time by hand of numbers of magnets and sensors."""
    parts = (magnets, sensors)
    return sum(map(mul, PRICES_EUR, parts)), sum(map(mul, MINUTES, parts))


def _remedy(spec: ObjectSpec, start: dict[str, Any], row: dict[str, Any]) -> Remedy:
    ratio = worst_ratio(
        spec.limits,
        row["weakest_bound_mm"],
        row["worst_detectable_n"],
        row["saturation_margin"],
        row["objects_margin"],
    )
    added = (row[part] - start[part] for part in ("magnets", "sensors"))
    bound = row["weakest_bound_mm"]
    return Remedy(
        tuple(row["changes"]),
        ratio,
        bound,
        *price_and_minutes(*added),
        row["unreached"],
        spec.score.force_n,
        tuple(row["settings"]),
    )


def _figures(spec: ObjectSpec, row: dict[str, Any]) -> list[str]:
    limits = {
        "weakest_bound_mm": spec.limits.position_bound_mm,
        "median_bound_mm": spec.limits.position_bound_mm,
        "worst_detectable_n": spec.limits.detectable_force_n,
    }
    shown = (
        shown_against_limit(row[name], limit) if isfinite(row[name]) else "∞"
        for name, limit in limits.items()
    )
    return [*shown, f"{100 * row['saturation_margin']:.0f} %"]
