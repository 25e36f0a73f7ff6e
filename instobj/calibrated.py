"""Training on a data set together with presses of the object's calibrated twin."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from design.errors import InputError
from design.spec import ObjectSpec
from instobj.chain import Chain
from instobj.stage import Step, write_json

if TYPE_CHECKING:
    from estimator.calibrated_twin import CalibratedTwin
    from estimator.dataset import FrameSet
    from estimator.pressed_places import PressedPlaces
    from fem.results import MagnetMotions, PressForces

_TRUSTED_PERCENT = 10.0
_EXACT_PERCENT = 3.0
"""What meshes of one design differ by: nothing is to be gained on a design that leaves less."""
Parts = tuple["FrameSet", "FrameSet"]


@dataclass
class TwinOfData:
    """The specification of a data set's object, its simulated presses, and what was calibrated.

    `key` names the presses in the store; `rows` gets one row a calibrated face.
    """

    spec: ObjectSpec
    presses: tuple[PressForces, MagnetMotions]
    key: str
    rows: list[dict[str, Any]] = field(default_factory=list)

    def extended(self, parts: Parts, face: int, step: Step) -> Parts:
        """Training and validation frames with presses at every place of the face added.

        The twin sees training frames alone; how well it predicts is judged on training places left
        out in turn.

        Raises
        ------
        InputError
            Another object than the specification's, or too few places pressed one by one.
        """
        from estimator.calibrated_twin import calibrate, places_left_out
        from estimator.collection import joined
        from estimator.pressed_places import pressed_places
        from estimator.pretraining import calibrated_frames, split_twins

        require_same_object(self.spec, parts[0])
        seen = pressed_places(self.spec, parts[0], face)
        step(f"face {face}: calibrating the twin on {len(seen)} places")
        twin = calibrate(self.spec, *self.presses, seen)
        left = places_left_out(
            self.spec, *self.presses, seen, lambda text: step(f"face {face}: {text}")
        )
        self.rows.append(_row(twin, seen, *left))
        simulated = calibrated_frames(
            twin, self.spec.training.twins, lambda text: step(f"face {face}: {text}")
        )
        split = split_twins(simulated)
        train, validation = (simulated.select(part) for part in (split.train, split.validation))
        return joined([parts[0], train]), joined([parts[1], validation])

    def write(self, folder: Path) -> None:
        """`calibration.json` and a picture of what is left at places left out."""
        from instobj.report.calibration_figure import draw_calibration

        write_json({"object": self.spec.name, "faces": self.rows}, folder / "calibration.json")
        draw_calibration(self.spec, self.rows, folder / "calibration.png")


def twin_of_data(path: Path) -> TwinOfData:
    """Simulated presses of a specification, from the store or made."""
    from design.spec_io import load_spec
    from fem.results import load_presses

    spec = load_spec(path, [])
    result = Chain(spec).require("presses")
    return TwinOfData(spec, load_presses(result.folder / "presses.nc"), result.key)


def require_same_object(spec: ObjectSpec, frames: FrameSet) -> None:
    """The data set has the specification's contact grid and sensors.

    Raises
    ------
    InputError
        It has others.
    """
    from design.layouts import contact_grid

    grid = contact_grid(spec)
    wanted = (grid.x_mm, grid.y_mm, np.array(spec.body.sensed))
    got = (frames.grid_x_mm, frames.grid_y_mm, frames.faces)
    sensors = frames.signal_counts.shape[2]
    pairs = zip(wanted, got, strict=True)
    alike = all(a.shape == b.shape and np.allclose(a, b, atol=1e-6) for a, b in pairs)
    if not alike or sensors != spec.sensors.count_per_face:
        raise InputError(
            f"the data set has {len(got[0])} × {len(got[1])} contact places on faces "
            f"{got[2].tolist()} and {sensors} sensors a face; {spec.name} has {len(wanted[0])} × "
            f"{len(wanted[1])} on faces {wanted[2].tolist()} and {spec.sensors.count_per_face}. Give "
            "the specification of the object that was recorded"
        )


def verdict(left_percent: float, design_percent: float, strained: int) -> str:
    """Whether presses of the twin help: less than half is left of what the design leaves, and at most
    10 % of the signals, with no number at its limit; or the design itself leaves next to nothing.
    """
    if strained:
        return (
            f"no: {strained} numbers at their limits; is it this object, are its tolerances true?"
        )
    if left_percent > min(_TRUSTED_PERCENT, design_percent / 2) and design_percent > _EXACT_PERCENT:
        return "no: train without --twin, or press more places"
    return "yes"


def _row(
    twin: CalibratedTwin, seen: PressedPlaces, calibrated: np.ndarray, planned: np.ndarray
) -> dict[str, Any]:
    """What was found, and what is left of the signals of places left out in turn."""
    found = twin.unknowns
    correction = found.correction(twin.numbers)
    left, by_design = (round(100 * float(np.median(one)), 2) for one in (calibrated, planned))
    strained = int(np.sum(abs(twin.numbers) >= found.limits - 1e-6))
    return {
        "face": found.face,
        "places": len(seen),
        "signals left %, places left out": left,
        "signals left %, design": by_design,
        "helps": verdict(left, by_design, strained),
        "modulus over design": round(found.assembly(twin.numbers).modulus_ratio, 4),
        "large deformation": [
            round(value, 4)
            for value in (*correction.force, *correction.shift, *correction.rotation)
        ],
        "largest number (σ)": round(float(abs(twin.numbers).max()), 2),
        "left over: size, length mm": [
            twin.discrepancy.prior.size,
            twin.discrepancy.prior.length_mm,
        ],
        "places mm": np.round(seen.xy_mm, 4).tolist(),
        "left %": np.round(100 * calibrated, 2).tolist(),
        "left by design %": np.round(100 * planned, 2).tolist(),
    }
