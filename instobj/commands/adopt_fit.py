"""The part of `instobj adopt` that knows a specification: arrangement, order and axes of chips, magnets."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from design.errors import InputError, SpecError
from design.spec.object import ObjectSpec
from design.spec_io import parse_spec
from design.tables import toml_text
from instobj.stages.run import Run
from instobj.store.progress import ProgressLine
from instobj.store.readers import PRESSES

if TYPE_CHECKING:
    from estimator.adoption.findings import Finding
    from estimator.adoption.fit import ObjectFit, Pressed
    from estimator.adoption.identify import Identified, Known
    from estimator.calibration.known_travel.agreement import TravelAgreement

UNKNOWN = {
    "travel": "how much of the machine's travel the shell takes: contact height, play, the stand",
    "strength": "the magnets' strength against counts per mT and their height over the chips",
}
"""Numbers of a fit that stand for several causes."""
_FAR = 0.15
"""Change of a factor that is named as what limits the fit."""


def why_not_fitted(identified: Identified, answers: Known) -> str:
    """Say why a log cannot be held against a specification; nothing where it can."""
    if not identified.all_presses.labelled:
        return "the specification is not fitted: no column says which face and place was pressed"
    if identified.kind not in ("level", "travel"):
        return (
            "the specification is not fitted: the label is no travel. Validate recordings of forces with "
            "`instobj validate`"
        )
    if not identified.orders:
        return "the specification is not fitted: no order of places was found"
    if answers.pitch_mm is None or (identified.kind == "level" and answers.step_mm is None):
        return "the specification is not fitted before the questions above are answered"
    return ""


def boards_of_logs(identified: Identified, spec: ObjectSpec) -> list[tuple[str, Finding]]:
    """Find which board is which face's in logs of grasps: several faces held at once, by force."""
    from estimator.adoption.boards import boards_of_faces

    findings = []
    for path, presses in zip(identified.paths, identified.presses, strict=True):
        boards = boards_of_faces(spec, presses, spec.seed)
        findings += [(path.name, item) for item in boards.findings(_axes_text(boards.turn))]
    return findings


def pressed_readings(
    identified: Identified, answers: Known, spec: ObjectSpec
) -> dict[int, Pressed]:
    """Return face of the log → its presses in mm and mT, of the log with most places of it.

    Raises
    ------
    InputError
        A face with another number of chips than the specification's.
    """
    from estimator.adoption.fit import Pressed

    pitch, step = answers.pitch_mm or (1.0, 1.0), answers.step_mm or 1.0
    readings = {}
    for (log, face), order in sorted(
        identified.orders.items(), key=lambda item: len(item[1].place)
    ):
        chips = identified.chips_of_face[face]
        if len(chips) != spec.sensors.count_per_face:
            raise InputError(
                f"{len(chips)} chips answer under face {face}; {spec.name} has "
                f"{spec.sensors.count_per_face} on its face. Give the specification of this object"
            )
        presses = identified.presses[log]
        face_presses = presses.select(np.flatnonzero(presses.face[:, 0] == face))
        grid = (order.grid - order.grid.mean(axis=0)) * np.array(pitch)
        place_index = np.searchsorted(order.place, face_presses.place[:, 0])
        scale = spec.sensors.counts_per_mt
        readings[face] = Pressed(
            grid[place_index], face_presses.label[:, 0] * step, face_presses.place[:, 0],
            face_presses.change[:, chips] / scale, face_presses.resting[chips] / scale,
        )  # fmt: skip
    return readings


def fit_specification(
    identified: Identified, answers: Known, path: Path, spec: ObjectSpec, progress: ProgressLine
) -> tuple[list[Finding], dict[str, Any], str]:
    """Fit a specification to every face pressed.

    Returns
    -------
    tuple
        Findings, figures by face for JSON, and the fitted specification as TOML (of the first face).

    Raises
    ------
    InputError
        An object whose presses cannot be simulated at known travel, or of other chips.
    """
    from estimator.adoption.arrangement import told_arrangement
    from estimator.adoption.fit import (
        Moving,
        fit_both_hands,
        fit_object,
        halves_of_places,
        judged,
    )
    from estimator.calibration.known_travel.model import require_comparable, travel_model

    require_comparable(spec)
    readings = pressed_readings(identified, answers, spec)
    run = Run(spec, progress)
    model = travel_model(spec, run.read(PRESSES)[1])
    thing = Moving.from_table(model)
    faces, figures, fitted = sorted(readings.items()), {}, ""
    with progress.stage("arrangement"):
        presses_of_faces = [pressed for _, pressed in faces]
        findings = [told_arrangement(spec, presses_of_faces, spec.seed).finding]
    for face, pressed in faces:
        with progress.stage(f"face {face}: chips, magnets"):
            live = pressed.complete
            half = halves_of_places(live, spec.seed)
            fit = fit_object(thing, live.select(half))
            figures[str(face)] = judged(fit, live.select(~half), seed=spec.seed)
            whole, mirror = fit_both_hands(thing, live)
        chips = identified.chips_of_face[face]
        findings += _fit_findings(face, whole, mirror, figures[str(face)], chips)
        if not fitted:
            fitted = fitted_text(path, spec, whole)
    return findings, {face: agreement.summary() for face, agreement in figures.items()}, fitted


def _fit_findings(
    face: int,
    fit: ObjectFit,
    mirror: ObjectFit | None,
    figures: TravelAgreement,
    chips: list[int],
) -> list[Finding]:
    from estimator.adoption.findings import Finding, share_as_high

    beyond, null = figures.beyond, [item.cosine for item in figures.places_exchanged]
    order = f"designed chips are columns' chips {_convention_text(fit, chips)}"
    if mirror is not None:
        order += f". Its mirror image fits as well: chips {_convention_text(mirror, chips)}"
    orders = 1 + len(figures.chips_permuted)
    limits = [
        f"{words} (fitted: × {value:.2f})"
        for words, value in (
            (UNKNOWN["travel"], fit.travel_scale),
            (UNKNOWN["strength"], fit.strength),
        )
        if abs(np.log(value)) > _FAR
    ]
    return [
        Finding(
            f"changes from travel alone, face {face}",
            f"cosine {beyond.cosine:.2f}, {100 * beyond.explained:.0f} % explained beyond 1 mm",
            f"{beyond.presses} presses at places that the fit has not seen",
            f"cosine {np.median(null):.2f}",
            share_as_high(null, figures.all.cosine),
        ),
        Finding(
            f"order and axes of chips, face {face}",
            order,
            f"this order is number {figures.order_of_chips} of {orders} at those places",
            f"cosine {np.median([item.cosine for item in figures.chips_permuted]):.2f}",
        ),
        Finding(
            f"what limits the fit, face {face}",
            "; ".join(limits) or "no number lies far from the specification",
            f"magnets off by {np.linalg.norm(fit.magnet_shift_mm):.1f} mm, contact "
            f"{fit.pose.contact_mm:.1f} mm above the zero of travel",
        ),
    ]


def _convention_text(fit: ObjectFit, chips: list[int]) -> str:
    order = ", ".join(str(chips[k] + 1) for k in fit.convention.order.tolist())
    return f"{order}; {_axes_text(fit.convention.turn)}"


def _axes_text(turn: np.ndarray) -> str:
    """Return how the log's axes stand to the design's, and the poles."""
    names = []
    for row in turn:
        axis = int(np.argmax(np.abs(row)))
        names.append(("-" if row[axis] < 0 else "") + "XYZ"[axis])
    poles = "" if np.linalg.det(turn) > 0 else ", poles reversed"
    return f"their x, y, z are the design's {', '.join(names)}{poles}"


def fitted_text(path: Path, spec: ObjectSpec, fit: ObjectFit) -> str:
    """Return the fitted specification as TOML."""
    from estimator.adoption.nearest_spec import fitted_content

    content = tomllib.loads(path.read_text(encoding="utf-8"))
    return toml_text(fitted_content(content, spec, fit))


def complaint_about(text: str, source: Path) -> str:
    """Return what keeps `instobj check` from accepting a specification, nothing where it does."""
    try:
        parse_spec(tomllib.loads(text), str(source))
    except SpecError as error:
        return str(error)
    return ""
