"""Resting signals for the self-test: from a recording, or from a plain table of frames at rest."""

from __future__ import annotations

import csv
import re
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float

from design.errors import InputError
from design.spec.object import ObjectSpec
from estimator.recordings.formats.text import csv_rows, naming, numbers, read_bytes
from estimator.signals.hall import full_scale_counts

if TYPE_CHECKING:
    from estimator.recordings.travel_labels import TravelForces

_CHANNEL = re.compile(r"F([1-6])-([XYZ])(\d+)")
_DEAD_KINDS = ("dead channel", "noisy channel")


@dataclass(frozen=True)
class Resting:
    """Mean counts at rest (channel,), NaN where a channel is silent, and what is wrong with those."""

    counts: Float[np.ndarray, "channel"]
    frames: int
    silent: dict[str, str]


def read_resting(path: Path, spec: ObjectSpec, mechanics: TravelForces | None = None) -> Resting:
    """Read a recording (its rest before each press), or a CSV with one column per channel.

    The plain table's header names the channels F1-X1 (face, axis, number of the sensor), in any
    order; its rows are frames at rest. Channels without a reading, stuck at one value over three or
    more frames, at full scale, or marked dead in `as_built`, are silent. A recording labelled
    by travel needs `mechanics`.

    Raises
    ------
    InputError
        A missing or damaged file, unknown or missing channels, or no frame.
    """
    if not path.is_file():
        raise InputError(f"no resting signals at {path}. Give a recording or a table of frames")
    with path.open(newline="", encoding="utf-8-sig", errors="replace") as file:
        header = [cell.strip() for cell in next(csv.reader(file), [])]
    if not header or not _CHANNEL.fullmatch(header[0]):
        return _recording_counts(path, spec, mechanics)
    return _table_counts(path, spec, header)


def channel_names(spec: ObjectSpec) -> list[str]:
    """F1-X1, F1-Y1, …: flat channels in this package's order."""
    sensors = range(1, spec.sensors.count_per_face + 1)
    return [f"F{face}-{axis}{k}" for face in spec.body.sensed for k in sensors for axis in "XYZ"]


def _recording_counts(path: Path, spec: ObjectSpec, mechanics: TravelForces | None) -> Resting:
    from estimator.calibration.recorded_presses import with_all_sensors
    from estimator.recordings.reading import read_recording

    (recording,) = with_all_sensors(spec, [read_recording(path, mechanics=mechanics)])
    if recording.rest_counts.shape[2] != spec.sensors.count_per_face:
        raise InputError(
            f"{path} holds {recording.rest_counts.shape[2]} sensors per face; {spec.name} has "
            f"{spec.sensors.count_per_face}. Give a recording of this object"
        )
    names = channel_names(spec)
    silent = {
        fault.where: f"{fault.kind}: {fault.detail}"
        for fault in recording.report.faults
        if fault.kind in _DEAD_KINDS and fault.where in names
    }
    level = np.median(recording.rest_counts, axis=0)
    unread = np.full(level.shape[1:], np.nan)
    held = recording.frames.faces.tolist()
    counts = np.array([level[held.index(n)] if n in held else unread for n in spec.body.sensed])
    return _with_silent(spec, counts.ravel(), recording.report.rest_frames, silent)


def _table_counts(path: Path, spec: ObjectSpec, header: list[str]) -> Resting:
    names = channel_names(spec)
    unknown = [name for name in header if name not in names]
    missing = [name for name in names if name not in header]
    if unknown or missing or len(set(header)) < len(header):
        raise InputError(
            f"{path} must have one column for each channel of {spec.name}; unknown: "
            f"{', '.join(unknown[:5]) or 'none'}; missing: {', '.join(missing[:5]) or 'none'}. Name "
            "the columns F1-X1 and so on, each once"
        )
    with naming(path):
        rows, _ = csv_rows(read_bytes(path))
        values = numbers(rows[1:], header, first_line=2)
    values = values[:, [header.index(name) for name in names]]
    has_value = np.isfinite(values)
    silent = {names[c]: "no reading" for c in np.flatnonzero(~has_value.any(axis=0))}
    low = np.min(values, axis=0, where=has_value, initial=np.inf)
    high = np.max(values, axis=0, where=has_value, initial=-np.inf)
    if len(values) >= 3:
        silent |= {names[c]: f"stuck at {low[c]:g}" for c in np.flatnonzero(low == high)}
    counts = np.where(has_value, values, 0.0).sum(axis=0) / np.maximum(has_value.sum(axis=0), 1)
    return _with_silent(spec, counts, len(values), silent)


def _with_silent(
    spec: ObjectSpec, counts: Float[np.ndarray, "channel"], frames: int, silent: dict[str, str]
) -> Resting:
    from design.layout.places.positions import live_channels

    names, counts = channel_names(spec), counts.copy()
    silent = dict(silent)
    for channel in np.flatnonzero(~live_channels(spec).ravel()):
        silent.setdefault(names[channel], "dead in as_built")
    with np.errstate(invalid="ignore"):
        for channel in np.flatnonzero(abs(counts) >= full_scale_counts(spec.sensors)):
            silent.setdefault(names[channel], "at full scale")
    counts[[names.index(name) for name in silent]] = np.nan
    for channel in np.flatnonzero(np.isnan(counts)):
        silent.setdefault(names[channel], "no reading")
    return Resting(counts, frames, silent)
