"""`SPEC.as_built.toml` of what a bring-up found; what else stands in the file stays."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from design.files import atomic_path
from design.layout.body import core_frames
from design.layout.places.positions import sensor_layout
from design.spec.assembly import AsBuiltSpec
from design.spec.object import ObjectSpec
from design.tables import toml_value
from instobj.bench.bringup.diagnosis.chip_findings import is_turned
from instobj.bench.bringup.diagnosis.findings import ChipFound
from instobj.bench.bringup.diagnosis.poles import ABSENT
from instobj.bench.bringup.verdict import Verdict

_SENSOR_KEYS = ("position_mm", "rotation_deg", "dead")


def merge_as_built(spec: ObjectSpec, verdict: Verdict, earlier: AsBuiltSpec) -> AsBuiltSpec:
    """Return what was measured before, with what this bring-up found in its place.

    Of chips it says turns beyond tolerance, exchanges within one face and dead axes; of magnets which
    are flipped. Chips that are mirrored or sit on another face than their channels' name have no
    place in this format: they must be put right.
    """
    magnets = {(m.face, m.magnet): m.model_dump(exclude_unset=True) for m in earlier.magnets}
    for magnet in verdict.magnets:
        face, number = _place(magnet.expected_pocket, spec.magnets.count, spec)
        entry = magnets.setdefault((face, number), {"face": face, "magnet": number})
        entry["flipped"] = magnet.strength < -ABSENT
    sensors = {(s.face, s.sensor): s.model_dump(exclude_unset=True) for s in earlier.sensors}
    for index, chip in enumerate(verdict.chips or ()):
        face, number = _place(index, spec.sensors.count_per_face, spec)
        entry = sensors.setdefault((face, number), {"face": face, "sensor": number})
        for key in _SENSOR_KEYS:
            entry.pop(key, None)
        entry |= _chip_entry(spec, index, chip)
    return AsBuiltSpec.model_validate(
        {
            "magnets": [magnets[key] for key in sorted(magnets) if _says_more(magnets[key])],
            "sensors": [sensors[key] for key in sorted(sensors) if len(sensors[key]) > 2],
        }
    )


def _says_more(entry: dict[str, Any]) -> bool:
    if not entry.get("flipped"):
        entry.pop("flipped", None)
    return len(entry) > 2


def _place(index: int, per_face: int, spec: ObjectSpec) -> tuple[int, int]:
    """Face and number there, both as the file counts them."""
    return spec.body.sensed[index // per_face], index % per_face + 1


def _chip_entry(spec: ObjectSpec, index: int, chip: ChipFound) -> dict[str, Any]:
    layout = sensor_layout(spec)
    dead = [axis for axis, is_dead in zip("XYZ", chip.dead, strict=True) if is_dead]
    entry: dict[str, Any] = {"dead": dead} if dead else {}
    if chip.mirrored or layout.face[chip.site] != layout.face[index]:
        return entry
    if chip.site == index and not is_turned(spec, chip):
        return entry
    frame = {f.number: f for f in core_frames(spec)}[int(layout.face[index])]
    turn = layout.axes[chip.site].T @ chip.turn.T @ layout.axes[index]
    turned_deg = np.rad2deg(frame.axes.T @ Rotation.from_matrix(turn).as_rotvec())
    entry["rotation_deg"] = _rounded(turned_deg)
    if chip.site != index:
        entry["position_mm"] = _rounded(frame.from_object(layout.position_mm[chip.site]))
    return entry


def _rounded(values: Sequence[float] | np.ndarray) -> list[float]:
    return [round(float(value), 3) + 0.0 for value in values]


def write_as_built(as_built: AsBuiltSpec, path: Path, remarks: Sequence[str]) -> Path:
    """The file, with remarks on what it cannot say."""
    lines = ["# Written by `instobj bench bringup`: measured deviations of one built object"]
    lines += [f"# {remark}" for remark in remarks]
    for table, entries in (("magnets", as_built.magnets), ("sensors", as_built.sensors)):
        for entry in entries:
            lines += ["", f"[[{table}]]"]
            lines += [
                f"{k} = {toml_value(v)}" for k, v in entry.model_dump(exclude_unset=True).items()
            ]
    with atomic_path(path) as temporary:
        temporary.write_text("\n".join([*lines, ""]), encoding="utf-8")
    return path
