"""Page of a bring-up: what to put right, where it is, and everything that was measured."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from typing import Any

import numpy as np

from design.layout.body import face_frames
from design.layout.places.positions import sensor_layout
from design.layout.pockets import magnet_places, sensor_places
from design.spec.object import ObjectSpec
from estimator.tolerances.selftest import sensor_names
from instobj.bench.bringup.asking.asked import (
    STEPS,
    Question,
    Recordings,
    asked_of,
    magnet_names,
)
from instobj.bench.bringup.diagnosis.earth import EarthFound
from instobj.bench.bringup.diagnosis.findings import ChipFound, Finding
from instobj.bench.bringup.diagnosis.health import Health, health_of
from instobj.bench.bringup.verdict import Verdict
from instobj.report.pages import render

_CHIP_MM = 4.0
"""Edge of a chip as it is drawn."""
_BORDER_MM = 2.0
"""Border round a drawn face."""


def bringup_page(
    spec: ObjectSpec,
    recordings: Recordings,
    skipped: Collection[str],
    verdict: Verdict,
    open_questions: Sequence[Question],
) -> str:
    """Return the page as a single HTML file."""
    health = health_of(recordings["still"]) if "still" in recordings else None
    rows = [[f.kind, f.where, f.measured, f.remedy] for f in verdict.findings]
    return render(
        "bringup.html.j2",
        name=spec.name,
        findings=rows,
        left=[question.name for question in open_questions],
        skipped=sorted(skipped),
        steps=_steps(spec, recordings, skipped),
        line=None if health is None else _line(spec, health),
        faces=_faces(spec, verdict),
        chips=_chips(spec, verdict, health),
        field=None if verdict.earth is None else _field(verdict.earth),
        magnets=_magnets(spec, verdict),
        levels=verdict.levels,
    )


def _steps(spec: ObjectSpec, recordings: Recordings, skipped: Collection[str]) -> list[list[str]]:
    rows = []
    for step, title in STEPS.items():
        names = [question.name for question in asked_of(spec) if question.step == step]
        done, over = (sum(name in given for name in names) for given in (recordings, skipped))
        rows.append([title, f"{done} of {len(names)}", f"{over} skipped" if over else ""])
    return rows


def _line(spec: ObjectSpec, health: Health) -> str:
    bus = "not told" if health.bus_errors is None else str(health.bus_errors)
    return (
        f"{health.rate_hz:.1f} frames per second ({spec.sensors.frame_rate_hz:g} asked for), "
        f"{health.lost_share:.1%} lost, {health.damaged_lines} damaged lines, bus errors: {bus}"
    )


def _faces(spec: ObjectSpec, verdict: Verdict) -> list[dict[str, Any]]:
    """Faces from outside, x to the right and y up; what is out of order stands out."""
    faces = []
    for index, frame in enumerate(face_frames(spec)):
        half_x, half_y = (half + _BORDER_MM for half in frame.half_extents_mm)
        chips = [
            {"x": x, "y": y, "name": name, "wrong": _is_wrong(name, verdict.findings)}
            for name, (x, y, _) in zip(
                _names_of(frame.number, "S", spec.sensors.count_per_face),
                sensor_places(spec)[index],
                strict=True,
            )
        ]
        magnets = [
            {
                "x": x,
                "y": y,
                "name": name,
                "wrong": _is_wrong(name, verdict.findings),
                "radius_mm": size.half_mm[0],
            }
            for name, (x, y), size in zip(
                _names_of(frame.number, "M", spec.magnets.count),
                magnet_places(spec)[index],
                spec.magnets.sizes,
                strict=True,
            )
        ]
        faces.append(
            {
                "number": frame.number,
                "half_x": half_x - _BORDER_MM,
                "half_y": half_y - _BORDER_MM,
                "view": f"{-half_x:g} {-half_y:g} {2 * half_x:g} {2 * half_y:g}",
                "chips": chips,
                "magnets": magnets,
                "chip_mm": _CHIP_MM,
            }
        )
    return faces


def _names_of(face: int, letter: str, count: int) -> list[str]:
    return [f"F{face}-{letter}{k + 1}" for k in range(count)]


def _is_wrong(name: str, findings: Sequence[Finding]) -> bool:
    """Return whether a finding names this chip, one of its channels, or this magnet."""
    face, part = name.split("-")
    names = {name} | ({f"{face}-{axis}{part[1:]}" for axis in "XYZ"} if part[0] == "S" else set())
    return any(names & set(finding.where.split(" and ")) for finding in findings)


def _chips(spec: ObjectSpec, verdict: Verdict, health: Health | None) -> list[list[str]]:
    names, rows = sensor_names(sensor_layout(spec).face), []
    for index, name in enumerate(names):
        noise = "–" if health is None else _numbers(health.noise_counts[index], "{:.0f}")
        chip = None if verdict.chips is None else verdict.chips[index]
        rows.append([name, *_place(chip, names), noise, *_earth_cells(verdict.earth, index)])
    return rows


def _place(chip: ChipFound | None, names: list[str]) -> list[str]:
    if chip is None:
        return ["–", "–", "–"]
    turned = "mirrored" if chip.mirrored else f"{chip.angle_deg:.1f}°"
    return [names[chip.site], turned, _with_interval(chip.gain, chip.gain_interval, "{:.3f}")]


def _earth_cells(earth: EarthFound | None, index: int) -> list[str]:
    if earth is None:
        return ["–", "–"]
    gains = _with_interval(earth.gain[index], earth.gain_interval[index], "{:.2f}")
    return [gains, _with_interval(earth.offset[index], earth.offset_interval[index], "{:.0f}")]


def _numbers(values: np.ndarray, form: str) -> str:
    return ", ".join("–" if np.isnan(value) else form.format(value) for value in values)


def _with_interval(values: np.ndarray, intervals: np.ndarray, form: str) -> str:
    """X, Y and Z with the largest of their intervals."""
    if np.isnan(values).all():
        return "–"
    return f"{_numbers(values, form)} (± {form.format(np.nanmax(intervals))})"


def _field(earth: EarthFound) -> str:
    return f"{earth.field_ut:.1f} ± {earth.field_interval_ut:.1f} µT"


def _magnets(spec: ObjectSpec, verdict: Verdict) -> list[list[str]]:
    names = magnet_names(spec)
    return [
        [names[m.expected_pocket], names[m.pocket], f"{m.strength:+.2f}"] for m in verdict.magnets
    ]
