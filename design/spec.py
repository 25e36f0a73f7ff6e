"""The specification of an instrumented object: frozen, validated, with units in the field names.

Every later stage is a function of an `ObjectSpec`. Lengths are in mm, stresses in MPa, flux
densities in T (fields of sensors in mT), forces in N. Defaults are the paper's cube
(Knopke et al., RA-L 2024); docs/units.md gives the source of each figure.
"""

from __future__ import annotations

from itertools import combinations
from typing import Annotated, Any, Literal, get_args

from pydantic import BaseModel, ConfigDict, Field, model_validator

from design.catalogue import (
    REFERENCE_TEMPERATURE_C,
    hall_part,
    magnet_grade,
    remanence_at_temperature_t,
)

Positive = Annotated[float, Field(gt=0, allow_inf_nan=False)]
NonNegative = Annotated[float, Field(ge=0, allow_inf_nan=False)]
Finite = Annotated[float, Field(allow_inf_nan=False)]
Count = Annotated[int, Field(ge=1)]
Averaging = Literal[1, 2, 4, 8, 16, 32]

SENSED_FACES = (1, 2, 3, 4, 5)
"""Faces that carry magnets and sensors; face 6 (−z) is open, the wires leave there."""


class _Part(BaseModel):
    model_config = ConfigDict(frozen=True, extra="forbid")


class BodySpec(_Part):
    """Outer shape of the silicone shell."""

    kind: Literal["box"] = "box"
    size_mm: tuple[Positive, Positive, Positive] = (42.0, 42.0, 42.0)


class ShellSpec(_Part):
    """Silicone walls and the moulded pockets that take the magnets."""

    thickness_mm: Positive = 8.0
    pocket_diameter_mm: Positive = 6.0
    pocket_depth_mm: Positive = 3.0


class SiliconeSpec(_Part):
    """Linear elastic constants and density of the cured silicone.

    0.414 MPa is Gent's (1958) relation at Shore A10; the public recordings fit 0.23 to 0.28 MPa.
    """

    name: str = "Platsil Gel-10"
    youngs_modulus_mpa: Positive = 0.414
    poisson_ratio: Annotated[float, Field(ge=0, le=0.5)] = 0.4999
    density_g_per_cm3: Positive = 1.07


class MagnetSpec(_Part):
    """Axially magnetised disks, one layout repeated on every sensed face, north outward.

    `remanence_t` is that at 20 °C; left out, it is the typical one of `grade`.
    """

    diameter_mm: Positive = 6.0
    height_mm: Positive = 1.0
    grade: str | None = None
    remanence_t: Positive = 1.43
    temperature_c: Annotated[float, Field(ge=-40, le=150)] = REFERENCE_TEMPERATURE_C
    positions_mm: Annotated[tuple[tuple[Finite, Finite], ...], Field(min_length=1)] = (
        (0.0, 0.0),
        (10.0, 10.0),
        (-10.0, 10.0),
        (-10.0, -10.0),
        (10.0, -10.0),
    )

    @property
    def working_remanence_t(self) -> float:
        """Remanence at `temperature_c`."""
        return remanence_at_temperature_t(self.remanence_t, self.temperature_c)

    @model_validator(mode="before")
    @classmethod
    def _remanence_of_the_grade(cls, given: Any) -> Any:
        if not isinstance(given, dict) or not isinstance(given.get("grade"), str):
            return given
        return {"remanence_t": magnet_grade(given["grade"]).remanence_t, **given}

    @model_validator(mode="after")
    def _grade_agrees(self) -> MagnetSpec:
        if self.grade is None:
            return self
        grade = magnet_grade(self.grade)
        if not grade.admits(self.remanence_t):
            raise ValueError(
                f"magnets.remanence_t = {self.remanence_t:g} lies outside grade {grade.name} "
                f"({grade.remanence_min_t:g} to {grade.remanence_max_t:g} T). Leave remanence_t out "
                f"to take the typical {grade.remanence_t:g} T, or leave magnets.grade out"
            )
        if self.temperature_c > grade.max_temperature_c:
            raise ValueError(
                f"magnets.temperature_c = {self.temperature_c:g} exceeds the "
                f"{grade.max_temperature_c:g} °C at which grade {grade.name} begins to lose "
                "magnetisation for good. Lower it, or leave magnets.grade out for a hotter grade"
            )
        return self


class CoreSpec(_Part):
    """Rigid printed core that fills the shell's cavity down to the core's own height."""

    wall_mm: Positive = 4.5
    recess_width_mm: Positive = 7.0
    recess_inner_radius_mm: Positive = 4.5
    recess_outer_radius_mm: Positive = 11.0
    recess_depth_mm: Positive = 3.0
    hub_radius_mm: Positive = 2.0
    hub_depth_mm: Positive = 0.5
    wire_hole_top_diameter_mm: Positive = 2.0
    wire_hole_side_diameter_mm: Positive = 4.0


class SensorSpec(_Part):
    """Three-axis Hall sensors on the core, the same ring on every sensed face.

    Chip axes: X = −tangential, Y = radial outward, Z = the face's outward normal. `range_mt`,
    `counts_per_mt` and `noise_counts` are those of `part` where they are left out; the default
    part's noise, gain and drift were measured on the recordings (16× averaging, ±40 mT).
    `averaging` is the number of conversions in a reading; it enters the part's noise alone.
    """

    part: str = "TMAG5273A1"
    averaging: Averaging = 16
    count_per_face: Annotated[int, Field(ge=1, le=12)] = 3
    radius_mm: Positive = 8.585
    depth_below_core_face_mm: NonNegative = 2.3
    first_azimuth_deg: tuple[Finite, Finite, Finite, Finite, Finite] = (240, 180, 240, 60, 300)
    counts_per_mt: Positive = 820.0
    range_mt: Positive = 40.0
    noise_counts: tuple[Positive, Positive, Positive] = (22.0, 22.0, 11.0)
    zeroing_counts: NonNegative = 10.0
    drift_counts: NonNegative = 60.0
    frame_rate_hz: Positive = 10.5

    @model_validator(mode="before")
    @classmethod
    def _figures_of_the_part(cls, given: Any) -> Any:
        return {**_part_figures(given), **given} if isinstance(given, dict) else given


def _part_figures(given: dict[str, Any]) -> dict[str, Any]:
    """The part's range, gain and noise where `given` has none; values of other types are left."""
    name, averaging = given.get("part", "TMAG5273A1"), given.get("averaging", 16)
    range_mt, counts_per_mt = given.get("range_mt"), given.get("counts_per_mt")
    numbers = all(isinstance(n, int | float | None) for n in (range_mt, counts_per_mt))
    if not (isinstance(name, str) and averaging in get_args(Averaging) and numbers):
        return {}
    part = hall_part(name)
    if range_mt is None and part.ranges:
        range_mt = part.ranges[0].range_mt
    if counts_per_mt is None and range_mt is not None and part.ranges:
        counts_per_mt = part.range_covering(float(range_mt)).counts_per_mt
    noise_counts = given.get("noise_counts")
    if noise_counts is None and counts_per_mt is not None and part.noise is not None:
        noise_counts = part.noise.at(float(counts_per_mt), int(averaging))
    figures = {"range_mt": range_mt, "counts_per_mt": counts_per_mt, "noise_counts": noise_counts}
    missing = [f"sensors.{key}" for key, value in figures.items() if value is None]
    if missing:
        raise ValueError(
            f"sensors.part = {name!r} has no figure in the catalogue for {', '.join(missing)}. Give "
            "what was measured or what the datasheet says for your settings"
        )
    return figures


class ContactGridSpec(_Part):
    """Contact places on each face, centred on it; place = X·count_y + Y, counted from 0."""

    count: tuple[Annotated[int, Field(ge=2, le=100)], Annotated[int, Field(ge=2, le=100)]] = (
        10,
        10,
    )
    pitch_mm: Positive = 3.0


class IndenterSpec(_Part):
    """Rigid, frictionless indenter pressed along the face's inward normal."""

    kind: Literal["hemisphere"] = "hemisphere"
    radius_mm: Positive = 5.0


class PressSpec(_Part):
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


class MeshSpec(_Part):
    """Target edge lengths: `edge_mm` in the bulk, `surface_edge_mm` under the pressed faces."""

    edge_mm: Positive = 4.0
    surface_edge_mm: Positive = 1.2
    envelope_mm: Positive = 0.03
    magnet_sides: Annotated[int, Field(ge=6, le=64)] = 8


class MechanicsSpec(_Part):
    """Finite element and the model of the magnets in the silicone."""

    element: Literal["taylor-hood"] = "taylor-hood"
    magnets: Literal["rigid", "points"] = "rigid"


class ScoreSpec(_Part):
    """At which force places are judged, and on how many frames the convex hull stands."""

    force_n: Positive = 8.0
    hull_frames: Annotated[int, Field(ge=12)] = 1000


class ProtocolSpec(_Part):
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


class TrainingSpec(_Part):
    """Contact estimator: one compact network per face."""

    hidden_units: Annotated[tuple[Count, ...], Field(min_length=1)] = (256, 256, 256)
    epochs: Count = 40
    batch_size: Count = 512
    learning_rate: Positive = 3e-3
    patience_epochs: Count = 15


class LimitsSpec(_Part):
    """Go or no-go limits of the report."""

    position_bound_mm: Positive = 1.5
    detectable_force_n: Positive = 1.0
    saturation_margin: Annotated[float, Field(gt=0, lt=1)] = 0.1


class ObjectSpec(_Part):
    """A whole instrumented object with everything that its simulation needs."""

    name: Annotated[str, Field(pattern=r"^[A-Za-z0-9][A-Za-z0-9_.-]*$", max_length=80)]
    seed: Annotated[int, Field(ge=0)] = 1
    body: BodySpec = BodySpec()
    shell: ShellSpec = ShellSpec()
    silicone: SiliconeSpec = SiliconeSpec()
    magnets: MagnetSpec = MagnetSpec()
    core: CoreSpec = CoreSpec()
    sensors: SensorSpec = SensorSpec()
    contact_grid: ContactGridSpec = ContactGridSpec()
    indenter: IndenterSpec = IndenterSpec()
    press: PressSpec = PressSpec()
    mesh: MeshSpec = MeshSpec()
    mechanics: MechanicsSpec = MechanicsSpec()
    score: ScoreSpec = ScoreSpec()
    protocol: ProtocolSpec = ProtocolSpec()
    training: TrainingSpec = TrainingSpec()
    limits: LimitsSpec = LimitsSpec()

    @property
    def core_size_mm(self) -> tuple[float, float, float]:
        """Edges of the core: the body less one shell thickness on every side."""
        x, y, z = self.body.size_mm
        t = 2 * self.shell.thickness_mm
        return (x - t, y - t, z - t)

    @property
    def magnet_depth_mm(self) -> float:
        """Depth of the magnets' mid-plane below the outer face (seated on the pocket floor)."""
        return self.shell.pocket_depth_mm - self.magnets.height_mm / 2

    @model_validator(mode="after")
    def _everything_fits(self) -> ObjectSpec:
        _check_core(self)
        _check_pockets(self)
        _check_sensors(self)
        _check_presses(self)
        return self


def smallest_half_extents_mm(spec: ObjectSpec) -> tuple[float, float]:
    """Half extents (x, y) that every sensed face of the body offers, in the face's own axes."""
    sx, sy, sz = (edge / 2 for edge in spec.body.size_mm)
    return min(sx, sz), min(sx, sy)


def _check_core(spec: ObjectSpec) -> None:
    smallest = min(spec.core_size_mm)
    if smallest <= 2 * spec.core.wall_mm:
        raise ValueError(
            f"the core must be larger than two core walls ({2 * spec.core.wall_mm:g} mm); got a core "
            f"of {smallest:g} mm. Make the body larger, or shell.thickness_mm or core.wall_mm smaller"
        )
    if spec.core.recess_depth_mm >= spec.core.wall_mm:
        raise ValueError(
            f"core.recess_depth_mm must be below core.wall_mm = {spec.core.wall_mm:g}; got "
            f"{spec.core.recess_depth_mm:g}. Make the recess shallower or the wall thicker"
        )
    if not spec.core.recess_inner_radius_mm < spec.core.recess_outer_radius_mm < smallest / 2:
        raise ValueError(
            "core recesses must satisfy recess_inner_radius_mm < recess_outer_radius_mm < half the "
            f"core ({smallest / 2:g} mm); got {spec.core.recess_inner_radius_mm:g} and "
            f"{spec.core.recess_outer_radius_mm:g}. Move the recess inwards"
        )


def _check_pockets(spec: ObjectSpec) -> None:
    shell, magnets = spec.shell, spec.magnets
    if shell.pocket_depth_mm >= shell.thickness_mm:
        raise ValueError(
            f"shell.pocket_depth_mm must be below shell.thickness_mm = {shell.thickness_mm:g}; got "
            f"{shell.pocket_depth_mm:g}. Make the pocket shallower or the shell thicker"
        )
    if magnets.height_mm >= shell.pocket_depth_mm or magnets.diameter_mm > shell.pocket_diameter_mm:
        raise ValueError(
            f"a magnet of {magnets.diameter_mm:g} × {magnets.height_mm:g} mm must fit below the seal in "
            f"a pocket of {shell.pocket_diameter_mm:g} × {shell.pocket_depth_mm:g} mm; it does not. "
            "Choose a smaller magnet or a larger pocket"
        )
    radius = shell.pocket_diameter_mm / 2
    half_x, half_y = smallest_half_extents_mm(spec)
    for index, (x, y) in enumerate(magnets.positions_mm):
        if abs(x) + radius >= half_x or abs(y) + radius >= half_y:
            raise ValueError(
                f"magnets.positions_mm[{index}] = ({x:g}, {y:g}) puts a pocket of radius {radius:g} mm "
                f"outside the shell's face (±{half_x:g}, ±{half_y:g} mm). Move the magnet inwards"
            )
    for (i, a), (j, b) in combinations(enumerate(magnets.positions_mm), 2):
        distance = ((a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2) ** 0.5
        if distance < 2 * radius:
            raise ValueError(
                f"the pockets of magnets {i} and {j} overlap: centres {distance:.3g} mm apart, at "
                f"least {2 * radius:g} mm needed. Move one of magnets.positions_mm"
            )
    _check_pockets_across_edges(spec)


def _check_pockets_across_edges(spec: ObjectSpec) -> None:
    """Pockets of neighbouring faces are Ø×depth cylinders whose boxes must not meet at an edge."""
    radius, depth = spec.shell.pocket_diameter_mm / 2, spec.shell.pocket_depth_mm
    half_x, half_y = smallest_half_extents_mm(spec)
    for index, (x, y) in enumerate(spec.magnets.positions_mm):
        if abs(x) + radius > half_x - depth or abs(y) + radius > half_y - depth:
            raise ValueError(
                f"magnets.positions_mm[{index}] = ({x:g}, {y:g}) reaches into the {depth:g} mm zone of "
                "the neighbouring face's pockets: pockets of two faces could overlap. Move the magnet "
                f"to within ±{half_x - depth - radius:g}, ±{half_y - depth - radius:g} mm"
            )


def _check_sensors(spec: ObjectSpec) -> None:
    sensors, core = spec.sensors, spec.core
    half = min(spec.core_size_mm) / 2
    if sensors.radius_mm >= half:
        raise ValueError(
            f"sensors.radius_mm puts the sensors outside the core: it must be below {half:g} (half "
            f"the core's edge); got {sensors.radius_mm:g}. Choose a smaller radius"
        )
    if sensors.depth_below_core_face_mm > core.recess_depth_mm:
        raise ValueError(
            f"sensors.depth_below_core_face_mm must not exceed core.recess_depth_mm = "
            f"{core.recess_depth_mm:g}; got {sensors.depth_below_core_face_mm:g}. Deepen the recess"
        )
    if not core.recess_inner_radius_mm <= sensors.radius_mm <= core.recess_outer_radius_mm:
        raise ValueError(
            f"sensors.radius_mm must lie in the core's recess ({core.recess_inner_radius_mm:g} to "
            f"{core.recess_outer_radius_mm:g} mm); got {sensors.radius_mm:g}. Move the sensor or the recess"
        )


def _check_presses(spec: ObjectSpec) -> None:
    grid = spec.contact_grid
    half = smallest_half_extents_mm(spec)
    for axis, (count, limit) in enumerate(zip(grid.count, half, strict=True)):
        reach = count * grid.pitch_mm / 2 + spec.indenter.radius_mm
        if reach > limit:
            raise ValueError(
                f"contact_grid.count[{axis}] × pitch_mm, half a pitch of margin and the indenter need "
                f"{2 * reach:g} mm on a face of {2 * limit:g} mm. Use fewer places, a smaller pitch or "
                "a smaller indenter.radius_mm"
            )
    deepest = spec.press.depths_mm[-1]
    if deepest > 0.6 * spec.shell.thickness_mm:
        raise ValueError(
            f"press.depths_mm must stay below 60 % of shell.thickness_mm (linear mechanics); got "
            f"{deepest:g} of {spec.shell.thickness_mm:g} mm. Press less deep or thicken the shell"
        )
    if deepest >= spec.indenter.radius_mm:
        raise ValueError(
            f"press.depths_mm must stay below indenter.radius_mm = {spec.indenter.radius_mm:g}; got "
            f"{deepest:g}. Press less deep or use a larger hemisphere"
        )
