"""What a specification asks of simulation: presses, mesh, mechanics, scores, training, limits."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, model_validator

from design.spec.base import Count, NonNegative, Positive, SpecPart

Shift = Annotated[float, Field(ge=-3, le=3)]
Turn = Annotated[float, Field(ge=-10, le=10)]


class ContactGridSpec(SpecPart):
    """Contact places on each face, centred on it; place = X·count_y + Y, counted from 0."""

    count: tuple[Annotated[int, Field(ge=2, le=100)], Annotated[int, Field(ge=2, le=100)]] = (
        10,
        10,
    )
    pitch_mm: Positive = 3.0


class PressSpec(SpecPart):
    """Depths below the undeformed face to which every place is pressed."""

    depths_mm: Annotated[tuple[Positive, ...], Field(min_length=2)] = (
        0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0,
    )  # fmt: skip

    @model_validator(mode="after")
    def _depths_increase(self) -> PressSpec:
        if any(b <= a for a, b in zip(self.depths_mm, self.depths_mm[1:], strict=False)):
            raise ValueError(
                f"press.depths_mm must increase strictly; got {list(self.depths_mm)}. Sort the "
                "depths and remove repeats"
            )
        return self


class MeshSpec(SpecPart):
    """Target edge lengths: `edge_mm` in the bulk, `surface_edge_mm` under the pressed faces."""

    edge_mm: Positive = 4.0
    surface_edge_mm: Positive = 1.2
    envelope_mm: Positive = 0.03
    magnet_sides: Annotated[int, Field(ge=6, le=64)] = 8


class SlipSpec(SpecPart):
    """Slip of the core against the bonded shell after casting, seen from the shell.

    The core has turned about the object's origin by the rotation vector `rotation_deg`, then
    shifted by `shift_mm`. "fem" keeps the core still and lets the shell follow its interface;
    "sensors-only" moves the sensors instead and leaves presses as they were, an approximation.
    `rim` "held" clamps the silicone's flat ring round the open face to the mounting plate, in
    every press.
    """

    shift_mm: tuple[Shift, Shift, Shift] = (0.0, 0.0, 0.0)
    rotation_deg: tuple[Turn, Turn, Turn] = (0.0, 0.0, 0.0)
    model: Literal["fem", "sensors-only"] = "fem"
    rim: Literal["free", "held"] = "free"

    @property
    def slipped(self) -> bool:
        """Whether there is any slip."""
        return any(self.shift_mm) or any(self.rotation_deg)


class MechanicsSpec(SpecPart):
    """Finite element, the model of the magnets in the silicone, and its hold on the core.

    "taylor-hood" takes every Poisson ratio up to 0.5; "p2-p0" (symmetric positive definite, a
    little too soft) up to 0.4999; "p1" locks and is for teaching. On a "frictionless" core the
    shell slides but does not lift off. The correction "large-strain" presses a few places with
    large deformation and corrects all presses by a fit to them (minutes, once).
    """

    element: Literal["taylor-hood", "p2-p0", "p1"] = "taylor-hood"
    magnets: Literal["rigid", "points"] = "rigid"
    interface: Literal["bonded", "frictionless"] = "bonded"
    slip: SlipSpec = SlipSpec()
    correction: Literal["none", "large-strain"] = "none"

    @model_validator(mode="after")
    def _correction_knows_the_model(self) -> MechanicsSpec:
        plain = self.element == "taylor-hood" and self.interface == "bonded"
        if self.correction != "none" and not (plain and not self.slip.slipped):
            raise ValueError(
                "mechanics.correction = 'large-strain' needs element = 'taylor-hood', interface = "
                f"'bonded' and no slip; got {self.element!r}, {self.interface!r}, shift "
                f"{list(self.slip.shift_mm)}. Set them so, or correction = 'none'"
            )
        return self

    @model_validator(mode="after")
    def _slip_needs_a_bond(self) -> MechanicsSpec:
        if self.interface == "frictionless" and self.slip.slipped:
            raise ValueError(
                "mechanics.slip moves a bonded interface, but mechanics.interface is 'frictionless': "
                "a shell that slides keeps no slip. Set interface = 'bonded', or leave the slip out"
            )
        return self


HullForm = Literal["covariance", "exact", "monte-carlo"]
LARGEST_EXACT_HULL_FRAMES = 100


class ScoreSpec(SpecPart):
    """At which force places are judged, from whose channels, and how the convex hull is measured.

    `channels` says whose sensors the bounds read: the pressed face's own, or those of all faces.
    `hull_frames` is N of the convex-hull sensitivity δ, which is always that of the own channels.
    """

    force_n: Positive = 8.0
    channels: Literal["own", "all"] = "own"
    hull: HullForm = "covariance"
    hull_frames: Annotated[int, Field(ge=12)] = 1000

    @model_validator(mode="after")
    def _hull_is_feasible(self) -> ScoreSpec:
        if self.hull == "exact" and self.hull_frames > LARGEST_EXACT_HULL_FRAMES:
            raise ValueError(
                f"score.hull = 'exact' takes at most {LARGEST_EXACT_HULL_FRAMES} frames; got "
                f"score.hull_frames = {self.hull_frames}. Lower it (seconds a place at 100), or use "
                "'monte-carlo' or 'covariance'"
            )
        return self


class ProtocolSpec(SpecPart):
    """Simulated calibration presses: travel periodic, each press with its own disturbances."""

    presses_per_place: Annotated[int, Field(ge=3)] = 6
    frames_per_press: Annotated[int, Field(ge=4)] = 40
    rest_frames_per_press: Annotated[int, Field(ge=2)] = 8
    peak_force_n: tuple[Positive, Positive] = (10.0, 20.0)
    peak_force_spread: Annotated[float, Field(ge=0, lt=0.9)] = 0.1
    lateral_jitter_mm: NonNegative = 0.3
    force_noise_n: NonNegative = 0.12

    @model_validator(mode="after")
    def _peak_range(self) -> ProtocolSpec:
        low, high = self.peak_force_n
        if low > high:
            raise ValueError(
                f"protocol.peak_force_n must be [lowest, highest]; got [{low:g}, {high:g}]. Swap them"
            )
        return self


class TrainingSpec(SpecPart):
    """Contact estimator, one a face.

    `model`: "compact" reads the face's own sensors, "whole-object" those of every face, so that it
    copes with presses on other faces; "paper" is the network and recipe of Knopke et al. (RA-L
    2024), for which `hidden_units`, `batch_size` and `learning_rate` are its own; "linear" is ridge
    regression. `output`: a "heatmap" of any number of contacts, or the "position" of one contact,
    which places that training never saw need (compact and whole-object only). `heatmap_axes`: 1
    for the normal force, 3 for Fx, Fy, Fz. With `history_frames` the estimator also reads the change
    over so many frames, which tells loading from unloading (hysteresis of the silicone). `members`:
    networks that are averaged, each stopped and calibrated by its own fold of the presses. Intervals
    cover the share `interval_cover`. `twins`: simulated objects that `instobj pretrain` draws within
    `[tolerances]`, or `--twin` within what labelled presses leave possible.
    """

    model: Literal["compact", "whole-object", "paper", "linear"] = "compact"
    output: Literal["heatmap", "position"] = "heatmap"
    heatmap_axes: Literal[1, 3] = 1
    history_frames: Annotated[int, Field(ge=0, le=100)] = 0
    hidden_units: Annotated[tuple[Count, ...], Field(min_length=1)] = (256, 256, 256)
    epochs: Count = 40
    batch_size: Count = 512
    learning_rate: Positive = 3e-3
    patience_epochs: Count = 15
    members: Annotated[int, Field(ge=1, le=20)] = 1
    interval_cover: Annotated[float, Field(gt=0, lt=1)] = 0.9
    twins: Annotated[int, Field(ge=2, le=1000)] = 10

    @model_validator(mode="after")
    def _output_of_model(self) -> TrainingSpec:
        if self.output == "position" and self.model in ("paper", "linear"):
            raise ValueError(
                f"training.model = {self.model!r} draws heatmaps only; got training.output = "
                "'position'. Use model 'compact' or 'whole-object', or output 'heatmap'"
            )
        return self


class LimitsSpec(SpecPart):
    """Go or no-go limits of the report."""

    position_bound_mm: Positive = 1.5
    detectable_force_n: Positive = 1.0
    saturation_margin: Annotated[float, Field(gt=0, lt=1)] = 0.1
