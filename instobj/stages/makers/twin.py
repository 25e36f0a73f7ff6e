"""Training on a data set together with presses of the object's calibrated twin."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from design.errors import InputError
from design.spec.object import ObjectSpec, TrainingSpec
from instobj.store.readers import CALIBRATION, CALIBRATION_PICTURE
from instobj.store.stage import Step, write_json

if TYPE_CHECKING:
    from estimator.calibration.twin.digital_twin import CalibratedTwin
    from estimator.calibration.twin.pressed_places import PressedPlaces
    from estimator.frames.dataset import FrameSet
    from estimator.information.shear import ShearSignals
    from estimator.inversion.inversion import Inversion
    from fem.presses.results import MagnetMotions, PressForces

TRUSTED_PERCENT = 10.0
"""Share of the signals, left by a prediction that is used."""
_EXACT_PERCENT = 4.0
"""Twice what meshes of one design differ by in the mean."""
_NO_GAIN = 0.8
"""Share of what the design leaves: a twin that leaves more has nothing to calibrate but noise."""
_SHARE = 0.8
Parts = tuple["FrameSet", "FrameSet"]


@dataclass
class TwinOfData:
    """The specification of a data set's object, its simulated presses, and what was calibrated.

    `key` names the presses in the store; `draws` objects are drawn from what is left possible; `rows`
    gets one row per face. `shear` is what tangential forces add, where the inversion is to read them.
    """

    spec: ObjectSpec
    presses: tuple[PressForces, MagnetMotions]
    key: str
    draws: int
    shear: ShearSignals | None = None
    rows: list[dict[str, Any]] = field(default_factory=list)

    @property
    def inputs(self) -> list[Any]:
        """Return what results made with it depend on, JSON-able."""
        return [self.key, self.spec.model_dump(mode="json")]

    def extended(self, parts: Parts, face: int, step: Step) -> Parts:
        """Training frames with presses at every place of the face added; validation frames as given.

        The twin sees training frames alone; how well it predicts is judged on training places left
        out in turn. A face with too few places stays as it is, and its row says so.
        """
        from estimator.calibration.twin.added_presses import calibrated_frames, with_presses_of_twin

        calibrated = self.calibrated(parts[0], face, step)
        if calibrated is None:
            return parts
        simulated = calibrated_frames(
            calibrated[0], self.draws, lambda text: step(f"face {face}: {text}")
        )
        return with_presses_of_twin(parts, simulated), parts[1]

    def inverted(self, frames: FrameSet, step: Step) -> Inversion:
        """The estimator that inverts the twins of all faces with enough single places in these frames.

        Raises
        ------
        InputError
            No face has, or `inversion.probes` is "flat".
        """
        from estimator.calibration.twin.inverted_twin import inverted_twin
        from estimator.calibration.twin.pressed_places import recorded_noise_counts
        from estimator.frames.heatmap import faces_pressed

        if self.spec.inversion.probes == "flat":
            raise InputError(
                'inversion.probes = "flat" is not known to a digital twin. Set it to "free", or invert the '
                "design: instobj train SPEC"
            )

        calibrated_by_face = {
            face: self.calibrated(frames, face, step) for face in faces_pressed(frames)
        }
        usable = {
            face: calibrated
            for face, calibrated in calibrated_by_face.items()
            if calibrated is not None
        }
        if not usable:
            reasons = [row["helps"].removeprefix("not used: ") for row in self.rows]
            raise InputError((reasons or ["no frame presses a face. Press places one by one"])[0])
        twins = {face: twin for face, (twin, _) in usable.items()}
        left_shares = {face: share for face, (_, share) in usable.items()}
        step("tables of presses")
        noise = recorded_noise_counts(self.spec, frames)
        return inverted_twin(self.spec, *self.presses, twins, left_shares, self.shear, noise)

    def calibrated(
        self, frames: FrameSet, face: int, step: Step
    ) -> tuple[CalibratedTwin, float] | None:
        """A face's twin, and what it leaves of the signals at places left out in turn (rms share, at
        least what meshes of one design differ by); None, and a row that says so, with too few places."""
        from estimator.calibration.twin.digital_twin import calibrate, places_left_out
        from estimator.calibration.twin.pressed_places import (
            invalidate_hard_presses,
            pressed_places,
        )

        try:
            places = pressed_places(
                self.spec, invalidate_hard_presses(frames, self.presses[0], face), face
            )
        except InputError as error:
            self.rows.append({"face": face, "places": 0, "helps": f"not used: {error}"})
            return None
        step(f"face {face}: calibrating the twin on {len(places)} locations")
        twin = calibrate(self.spec, *self.presses, places)
        held_out_shares = places_left_out(
            self.spec, *self.presses, places, lambda text: step(f"face {face}: {text}")
        )
        self.rows.append(_row(twin, places, *held_out_shares))
        return twin, float(max(np.sqrt(np.mean(held_out_shares[0] ** 2)), _EXACT_PERCENT / 200))

    def write(self, folder: Path) -> None:
        """`calibration.json` and a picture of the residuals at held-out locations."""
        from instobj.figures.calibration import draw_calibration

        write_json({"object": self.spec.name, "faces": self.rows}, CALIBRATION.path(folder))
        judged = [row for row in self.rows if row.get("places")]
        draw_calibration(self.spec, judged, CALIBRATION_PICTURE.path(folder))


def require_settings(training: TrainingSpec) -> None:
    """Draws of a twin are single frames of the face's own channels and of normal force.

    Raises
    ------
    InputError
        Settings that need more.
    """
    from estimator.networks.defaults import PLAIN

    wanted = {"model": "compact"} | PLAIN._asdict()
    refused = {
        name: getattr(training, name)
        for name, value in wanted.items()
        if getattr(training, name) not in (value, None)
        and (name != "model" or training.model == "whole-object")
    }
    if refused:
        texts = ", ".join(f"training.{name} = {value!r}" for name, value in refused.items())
        raise InputError(
            f"--twin serves estimators that read single frames of the face's own sensors, "
            f"one network each with nothing beside it; got {texts}. Leave these settings or --twin out"
        )


def require_some_face(spec: ObjectSpec, frames: FrameSet) -> None:
    """A face of the data set has enough places pressed one by one.

    Raises
    ------
    InputError
        No face has.
    """
    from estimator.calibration.twin.pressed_places import pressed_places
    from estimator.frames.heatmap import faces_pressed

    errors = []
    for face in faces_pressed(frames):
        try:
            pressed_places(spec, frames, face)
            return
        except InputError as error:
            errors.append(error)
    if errors:
        raise errors[0]


def require_same_object(spec: ObjectSpec, frames: FrameSet) -> None:
    """The data set has the specification's contact grid and sensors.

    Raises
    ------
    InputError
        It has others.
    """
    from design.layout.places.contact_grid import contact_grid
    from estimator.frames.same_object import same_grid

    grid = contact_grid(spec)
    wanted = (grid.x_mm, grid.y_mm), spec.body.sensed, spec.sensors.count_per_face
    sensors = frames.signal_counts.shape[2]
    got = (frames.grid_x_mm, frames.grid_y_mm), tuple(frames.faces.tolist()), sensors
    if wanted[1:] != got[1:] or not same_grid(wanted[0], got[0]):
        raise InputError(
            f"the data set has {_described(*got)}; {spec.name} has {_described(*wanted)}. Give the "
            "specification of the object that was recorded, also to `instobj recordings --spec`"
        )


def _described(grid_mm: tuple[np.ndarray, np.ndarray], faces: tuple[int, ...], sensors: int) -> str:
    x_mm, y_mm = grid_mm
    return (
        f"{len(x_mm)} × {len(y_mm)} contact locations from ({x_mm[0]:g}, {y_mm[0]:g}) to ({x_mm[-1]:g}, "
        f"{y_mm[-1]:g}) mm on faces {list(faces)} and {sensors} sensors per face"
    )


def verdict(left_percent: float, design_percent: float, strained: int) -> str:
    """Return whether presses of the twin help, from what it and the design leave of signals at four of five
    places at most.

    They do where it leaves no more than meshes of one design differ by, or less than half of what
    the design leaves and at most 10 %, with no number at its limit. They do, too, where the design
    leaves at most 10 % and the twin hardly less: then there is nothing to calibrate.
    """
    if strained:
        return (
            f"no: {strained} numbers at their limits; is it this object, are its tolerances true?"
        )
    most = max(left_percent, design_percent)
    if most <= TRUSTED_PERCENT and left_percent >= _NO_GAIN * design_percent:
        design_percent, left_percent = (
            max(percent, _EXACT_PERCENT / 2) for percent in (design_percent, left_percent)
        )
        return (
            f"yes: the object is as drawn within {design_percent:.2g} % of its signals (calibrated "
            f"within {left_percent:.2g} %)"
        )
    if left_percent > max(_EXACT_PERCENT, min(TRUSTED_PERCENT, design_percent / 2)):
        return "no: train without --twin, or press more locations"
    return "yes"


def _row(
    twin: CalibratedTwin, places: PressedPlaces, calibrated: np.ndarray, planned: np.ndarray
) -> dict[str, Any]:
    """Return what was found, and residual signals at held-out locations."""
    from estimator.calibration.twin.unknowns import count_at_limits

    unknowns = twin.unknowns
    correction = unknowns.correction(twin.numbers)
    left_percent, by_design = (
        round(100 * float(np.median(shares)), 2) for shares in (calibrated, planned)
    )
    most, most_by_design = (
        100 * float(np.quantile(shares, _SHARE)) for shares in (calibrated, planned)
    )
    strained = count_at_limits(twin.numbers)
    return {
        "face": places.face,
        "places": len(places),
        "signals left %, places left out": left_percent,
        "signals left %, design": by_design,
        "helps": verdict(most, most_by_design, strained),
        "modulus over design": round(unknowns.assembly(twin.numbers).modulus_ratio, 4),
        "large deformation": [
            round(value, 4)
            for value in (*correction.force, *correction.shift, *correction.rotation)
        ],
        "largest number (σ)": round(float(abs(twin.numbers).max()), 2),
        "left over: size, length mm": [
            twin.discrepancy.prior.size,
            twin.discrepancy.prior.length_mm,
        ],
        "places mm": np.round(places.xy_mm, 4).tolist(),
        "left %": np.round(100 * calibrated, 2).tolist(),
        "left by design %": np.round(100 * planned, 2).tolist(),
    }
