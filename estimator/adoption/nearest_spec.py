"""The fitted object as a specification: magnets and chips written where the log found them."""

from __future__ import annotations

from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from design.layout.body import face_frames
from design.spec.object import ObjectSpec
from estimator.adoption.fit import ObjectFit

_DIGITS = 3


def fitted_content(content: dict[str, Any], spec: ObjectSpec, fit: ObjectFit) -> dict[str, Any]:
    """Return a parsed specification with what a fit to its one sensed face changes.

    Chips stand in the order of the log and with the axes that they have there; magnets with the place and
    the strength found. Everything else is kept.
    """
    changed = {key: dict(v) if isinstance(v, dict) else v for key, v in content.items()}
    changed["name"] = f"{spec.name}_adopted"
    changed["sensors"] = {**changed.get("sensors", {}), **_chips(spec, fit)}
    changed["magnets"] = {**changed.get("magnets", {}), **_magnets(spec, fit)}
    for key in ("count_per_face", "first_azimuth_deg", "radius_mm", "chip", "mount_rotation_deg"):
        changed["sensors"].pop(key, None)
    changed["magnets"].pop("grade", None)
    return changed


def _chips(spec: ObjectSpec, fit: ObjectFit) -> dict[str, Any]:
    frame, sensors = face_frames(spec)[0], fit.thing.scene.sensors
    handed = np.sign(np.linalg.det(fit.convention.turn))
    rank = np.argsort(fit.convention.order)
    places = frame.from_object(sensors.position_mm[rank])[:, :2]
    turns = []
    for designed in rank.tolist():
        # recorded axes = turn @ designed axes; a mirrored turn is that of reversed poles
        axes = handed * fit.convention.turn @ sensors.axes[designed]
        local = frame.axes.T @ axes.T
        turns.append(np.rad2deg(Rotation.from_matrix(local).as_rotvec()))
    return {
        "positions_mm": [[round(float(v), _DIGITS) for v in place] for place in places],
        "rotations_deg": [[round(float(v), _DIGITS) for v in turn] for turn in turns],
    }


def _magnets(spec: ObjectSpec, fit: ObjectFit) -> dict[str, Any]:
    magnets, frame = spec.magnets, face_frames(spec)[0]
    centre_mm = fit.thing.scene.magnets.centre_mm + fit.magnet_shift_mm
    places = frame.from_object(centre_mm)
    keys: dict[str, Any] = {
        "positions_mm": [[round(float(v), _DIGITS) for v in place[:2]] for place in places],
        "remanence_t": [round(float(r * fit.strength), 4) for r in magnets.remanences_t],
    }
    if len(set(keys["remanence_t"])) == 1:
        keys["remanence_t"] = keys["remanence_t"][0]
    if np.linalg.det(fit.convention.turn) < 0:
        opposite = {1: "inward", -1: "outward"}
        keys["north"] = [opposite[pole] for pole in magnets.polarities]
    if spec.arrangement == "sensors-in-shell":
        outwards = float(frame.axes[:, 2] @ fit.magnet_shift_mm)
        depth = max(0.0, magnets.depth_below_core_face_mm - outwards)
        keys["depth_below_core_face_mm"] = round(depth, _DIGITS)
    else:
        keys["depth_mm"] = [round(-float(z), _DIGITS) for z in places[:, 2]]
    return keys
