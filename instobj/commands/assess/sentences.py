"""Sentences of an assessment: what decides something, and what cannot be said."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from estimator.grasps.measures import Conditions, MeasuredGrasp
from estimator.grasps.ranking import LEVEL, Difference, median_interval
from estimator.grasps.verdict import Judged, Verdict, force_half_width, verdict_of
from estimator.inversion.condition import DISTRUST_FROM
from instobj.commands.assess.groups import Group, cell_rows, measure_of, missed_share, with_ends
from instobj.commands.assess.tracks import MOST_UNEXPLAINED
from instobj.report.cells import shown

_FEW = 6
"""Grasps below which an interval of their median is too narrow."""
_REMEDY = {
    "inversion": "Calibrate it on labelled presses of this object (`instobj train DATA --twin SPEC`), and "
    "take magnets and steel away",
    "networks": "Train it on presses with such contacts, or read with contacts.nc of the object's "
    "specification (`instobj train SPEC`)",
}
"""Advice where an estimator, by its method, does not explain the frames."""


def verdict_text(group: Group, conditions: Conditions) -> str:
    """Return one plain sentence: good, not good, or cannot be said, and why."""
    if not group.grasps:
        return (
            f"{group.name}: cannot be said, because no grasp was found. Begin recordings at rest, and check "
            "that the estimator is of this object."
        )
    grasps, method = [grasp for _, grasp in group.grasps], group.recordings[0].read.method
    text = answer_text(group.name, grasps, group.unexplained, method, conditions)
    if group.trusted and not conditions.limits and verdict_of(grasps, conditions).answer == "good":
        text += " Damage is not judged: no limit is given (--limit)."
    return text


def answer_text(
    name: str,
    grasps: Sequence[MeasuredGrasp],
    unexplained: float,
    method: str,
    conditions: Conditions,
) -> str:
    """Return the sentence of `verdict_text` but for its options, for grasps of which `unexplained` is the
    share of pressed frames that the estimator does not explain; `method` reads them, inversion or
    networks."""
    if unexplained > MOST_UNEXPLAINED:
        return (
            f"{name}: cannot be said, because the estimator does not explain {100 * unexplained:.0f} % of "
            f"the pressed frames. Its figures are withheld. {_REMEDY[method]}."
        )
    verdict = verdict_of(grasps, conditions)
    chosen = verdict.named({"good": True, "not good": False}.get(verdict.answer))
    reasons = "; ".join(_reason(judged) for judged in chosen)
    if not verdict.balanced:
        reasons = _out_of_balance(grasps, verdict)
    count = "one grasp" if len(grasps) == 1 else f"{len(grasps)} grasps, in the median"
    joint = ": " if verdict.answer == "good" else ", because "
    half_width = force_half_width(grasps)
    width = f" Forces are known to ± {100 * half_width:.0f} %." if np.isfinite(half_width) else ""
    return f"{name}: {verdict.answer} ({count}){joint}{reasons}.{width}"


def _out_of_balance(grasps: Sequence[MeasuredGrasp], verdict: Verdict) -> str:
    if all(len(grasp.faces) == 1 for grasp in grasps):
        return (
            "contacts were read on one face only: what holds the object against them, such as a table, "
            "suction or a face without sensors, was not felt"
        )
    return (
        "the contacts that were read do not balance (chance of equilibrium at most "
        f"{shown(verdict.balance.high)}): one was not felt, or forces are wrong"
    )


def _reason(judged: Judged) -> str:
    measure, median = measure_of(judged.name), judged.median
    unit = "" if measure.unit == "1" else f" {measure.unit}"
    relation = {True: "at most", False: "more than", None: "perhaps more than"}[judged.good]
    if np.isnan(median.value):
        return f"{measure.title} is not known"
    if judged.name.startswith("damage_"):
        low, value, high = (f"{100 * p:.0f}" for p in (median.low, median.value, median.high))
        return (
            f"{measure.title} {value} % ({low} to {high} %), {relation} {100 * judged.most:.0f} %"
        )
    return f"{measure.title} {with_ends(median)}{unit}, {relation} {shown(judged.most)}"


def sentences(groups: list[Group], differences: dict[str, list[Difference]]) -> list[str]:
    """Return what decides something, ready for a paper."""
    texts = []
    for name, pairs in differences.items():
        title = measure_of(name).title
        texts += [f"{group.name}: {title} {median_text(group, name)}." for group in groups]
        texts += [difference_text(pair, name) for pair in pairs]
    if "peak_n" in differences:
        texts.append(
            "Peak force is the sum over all jaws: of two equal ones each presses with half of it."
        )
    return texts


def median_text(group: Group, measure: str) -> str:
    values = group.values(measure)
    median, low, high = median_interval(values)
    unit = "" if measure_of(measure).unit == "1" else f" {measure_of(measure).unit}"
    count = int(np.isfinite(values).sum())
    interval = "" if np.isnan(low) else f", 95 % interval {shown(low)} to {shown(high)}"
    whole = "one grasp" if count == 1 else f"median of {count} grasps"
    return f"{shown(median)}{unit} ({whole}{interval})"


def difference_text(difference: Difference, headline: str) -> str:
    measure = measure_of(headline)
    test = "Wilcoxon, pairs" if difference.paired else "Mann–Whitney"
    unit = "" if measure.unit == "1" else f" {measure.unit}"
    names = difference.first, difference.second
    if not difference.sure:
        further = (
            "more grasps will hardly tell"
            if difference.more_grasps is None
            else f"about {difference.more_grasps} more grasps of each would, if the difference is as large "
            "as it looks"
        )
        return (
            f"{names[0]} and {names[1]} cannot be ranked by {measure.title} (p = {difference.p_value:.2g}, "
            f"{test}): {further}."
        )
    less, more = names if difference.shift > 0 else names[::-1]
    better, worse = (less, more) if measure.better == "lower" else (more, less)
    sign = 1 if difference.shift > 0 else -1
    ends = sorted((sign * difference.low, sign * difference.high))
    relation = "lower" if measure.better == "lower" else "higher"
    return (
        f"{better} has a {relation} {measure.title} than {worse}: by {shown(abs(difference.shift))}{unit} in "
        f"the median (95 % interval {shown(ends[0])} to {shown(ends[1])}; p = {difference.p_value:.1g}, "
        f"{test})."
    )


def warnings_of(groups: list[Group], conditions: Conditions) -> list[str]:
    """Return what cannot be said, and why."""
    tracks = [recording.read for group in groups for recording in group.recordings]
    texts = list(dict.fromkeys(text for read in tracks for text in read.texts))
    # where figures are withheld, the verdict says why
    trusted = [group for group in groups if group.trusted]
    tracks = [recording.read for group in trusted for recording in group.recordings]
    for group in trusted:
        if len(group.grasps) < _FEW:
            texts.append(
                f"{group.name}: few grasps ({len(group.grasps)}); the interval of the median is too narrow."
            )
        if group.unexplained > DISTRUST_FROM:
            texts.append(
                f"{group.name}: the estimator does not explain {100 * group.unexplained:.0f} % of the "
                "pressed frames; grasps may be missed, and figures wrong by more than their intervals."
            )
    if tracks and not any(read.track.has_tangential for read in tracks):
        texts.append(
            "Tangential forces are not read by this estimator: friction used, and the part of the "
            f"balance across the jaws, are unknown within a friction of {conditions.friction:g}."
        )
    if any(read.method == "networks" for read in tracks):
        texts.append(
            "Networks read one whole force and its centre a face: tips of one jaw are not told apart."
        )
    if tracks and not conditions.weight_n:
        texts.append(
            "The weight is not given (--weight): balance is judged as if the object weighed nothing."
        )
    if tracks:
        texts += [
            f"Limit of {limit.name}: {limit.note}" for limit in conditions.limits if limit.note
        ]
    return [*texts, *filter(None, (unplaced_text(groups, conditions), balance_text(trusted)))]


def unplaced_text(groups: list[Group], conditions: Conditions) -> str:
    """Return how many grasps the places most at risk leave out."""
    believed = [group.trusted and grasp.placed for group in groups for _, grasp in group.grasps]
    if not conditions.limits or all(believed):
        return ""
    return (
        f"Places most at risk leave out {len(believed) - sum(believed)} of {len(believed)} grasps, of which "
        "no contact explains the peak or most frames."
    )


def balance_text(groups: list[Group]) -> str:
    values = np.concatenate([np.zeros(0), *(group.values("equilibrium_p") for group in groups)])
    chances = values[np.isfinite(values)]
    if not len(chances):
        return ""
    balanced = int(np.sum(chances >= LEVEL))
    text = f"Contacts balance within their uncertainty in {balanced} of {len(chances)} grasps"
    rows = cell_rows(groups)
    if rows:
        inside = sum(row["inside"] for row in rows)
        text += (
            f"; load cells lie in the 90 % interval of their face in {inside} of {len(rows)} cases, and "
            f"{100 * missed_share(groups):.0f} % of the frames that they show pressed lie in no grasp"
        )
    return f"{text}."
