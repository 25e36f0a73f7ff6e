"""Learning in a specification: scores, simulated presses and recordings, training, limits."""

from __future__ import annotations

from typing import Annotated, Any, Literal

from pydantic import Field, model_validator

from design.spec.base import Angle, Coordinate, Force, SpecPart

ProbePose = tuple[Coordinate, Coordinate, Angle]
"""Centre of a probe in the face's frame (x, y in mm) and its turn about the normal (degrees)."""
CollectionKind = Literal["paper", "grasp", "handling", "continuous"]
SensedFace = Annotated[int, Field(ge=1, le=6)]

_ROWS: tuple[ProbePose, ...] = (
    *((float(x), y, 0.0) for y in (-10.5, 10.5) for x in (-6, -3, 0, 3, 6)),
    *((float(x), -1.5, 0.0) for x in (-6, 0, 6)),
)
_COLUMNS: tuple[ProbePose, ...] = tuple((y, x, 90.0) for x, y, _ in _ROWS)
_TRIANGLES: tuple[ProbePose, ...] = (
    *((float(x), float(y), 0.0) for y in (-6, 0) for x in (-3, 0, 3)),
    (0.0, -3.0, 0.0),
)


class CollectionSpec(SpecPart):
    """Simulated recordings, `instobj run --to frames`.

    "paper": on each of `faces` every contact location, the probes of two and three tips at
    their `poses`, and `non_contact_cases`; `frames_per_case` frames each, at one
    periodic depth for all (Knopke et al., RA-L 2024). The poses spread rows and columns near the
    borders and in the middle. "grasp": probes of one, two and three tips on both of `grasp_faces`,
    squeezed periodically to `grasp_force_n`, at ten poses or, of each number of tips, at
    `random_grasps` poses drawn by `seed`. "handling": as "grasp", each pose taken once in
    `frames_per_case` frames: free, closed on, held with a shake, released; peaks spread between 80 and
    100 % of `grasp_force_n`, as a gripper repeats. Two `poses` lists as long as each other then place both
    jaws, each in its own face's frame, so that they may miss each other; a cuboid `indenter` with a tilt in
    `turn_deg` makes jaws that are not parallel. Instead of two jaws, `grasp_faces` = [3, 5, 5] are
    a thumb and two fingers, and a single face is a pad that presses from one side, as a suction cup's lip
    does; nothing pulls on the skin within the lip.
    "continuous": `presses` short presses of `contacts`
    tips at once anywhere on `faces`, with peaks and rest frames as `protocol` has them; with
    `tangential_share` above 0 each is also pulled sideways, by up to that share of its force.
    """

    kind: CollectionKind = "paper"
    faces: Annotated[tuple[SensedFace, ...], Field(min_length=1)] = (1, 2, 3, 4, 5, 6)
    frames_per_case: Annotated[int, Field(ge=4, le=100_000_000)] = 1000
    non_contact_cases: Annotated[int, Field(ge=1, le=100_000)] = 3
    poses: tuple[tuple[ProbePose, ...], tuple[ProbePose, ...]] = (
        _ROWS + _COLUMNS,
        _TRIANGLES + tuple((-x, -y, 180.0) for x, y, _ in _TRIANGLES),
    )
    grasp_faces: Annotated[tuple[SensedFace, ...], Field(min_length=1, max_length=3)] = (3, 5)
    grasp_force_n: Force = 17.0
    random_grasps: Annotated[int, Field(ge=0, le=100_000)] = 0
    presses: Annotated[int, Field(ge=1, le=1_000_000_000)] = 2000
    contacts: Annotated[int, Field(ge=1, le=5)] = 1
    tangential_share: Annotated[float, Field(ge=0, le=2)] = 0.0

    @model_validator(mode="after")
    def _faces_differ(self) -> CollectionSpec:
        # two fingers share a face against the thumb's
        jaws = self.grasp_faces[:2] if self.grasp_faces[1:2] == self.grasp_faces[2:] else ()
        for name, faces in (("faces", self.faces), ("grasp_faces", jaws or self.grasp_faces)):
            if len(set(faces)) != len(faces):
                raise ValueError(
                    f"collection.{name} names a face twice; got {list(faces)}. Name each once"
                )
        return self

    @model_validator(mode="after")
    def _fingers_share_a_face(self) -> CollectionSpec:
        thumb, *fingers = self.grasp_faces
        if len(set(fingers)) > 1:
            raise ValueError(
                f"collection.grasp_faces = {list(self.grasp_faces)} has fingers on different faces. Give "
                f"two jaws, such as [3, 5], or two fingers on one face, such as [{thumb}, {fingers[0]}, "
                f"{fingers[0]}]"
            )
        return self

    @model_validator(mode="after")
    def _sideways_is_single(self) -> CollectionSpec:
        if self.tangential_share and (self.kind != "continuous" or self.contacts > 1):
            raise ValueError(
                "collection.tangential_share works with kind = 'continuous' and contacts = 1; got "
                f"{self.kind!r} and {self.contacts}. Set them so, or tangential_share = 0"
            )
        return self


class ScoreSpec(SpecPart):
    """At which force places are judged, and from whose channels.

    Borders of a face reach less force than its middle: at 5 N nine of ten locations of the paper's cube
    are judged, at 8 N seven.

    `channels` says whose sensors the bounds read: those of all faces, as a good estimator does, or the
    pressed face's own, as the paper's.
    """

    force_n: Force = 5.0
    channels: Literal["own", "all"] = "all"


RestFrames = Annotated[int, Field(ge=2, le=1_000_000)]
PressFrames = Annotated[int, Field(ge=4, le=1_000_000)]


class ProtocolSpec(SpecPart):
    """Simulated calibration presses: periodic indentation depth, disturbances of each press.

    `frames_per_press` are those at rest, then those of the press.
    """

    presses_per_place: Annotated[int, Field(ge=3, le=1_000_000)] = 6
    frames_per_press: tuple[RestFrames, PressFrames] = (8, 40)
    peak_force_n: tuple[Force, Force] = (10.0, 20.0)
    lateral_jitter_mm: Annotated[float, Field(ge=0, le=20)] = 0.3
    force_noise_n: Annotated[float, Field(ge=0, le=20)] = 0.12

    @model_validator(mode="after")
    def _peak_range(self) -> ProtocolSpec:
        low, high = self.peak_force_n
        if low > high:
            raise ValueError(
                f"protocol.peak_force_n must be [lowest, highest]; got [{low:g}, {high:g}]. Swap them"
            )
        return self


class InversionSpec(SpecPart):
    """Contacts read by inverting the forward model (`training.model = "inversion"`, the default).

    Up to `contacts` at once anywhere on the sensed faces.
    `probes`: "free" contacts stand and bear anyhow; "known" are the paper's probes, at most one a
    face, of one tip, two 15 mm or three 20 mm apart (farther for tips of more than 5 mm radius), which
    bear alike within 30 %; "flat" ones are rigid rectangles, such as fingers of a gripper, on flat
    faces (frames with a chip that lies, or a magnet near by, are read as free tips).
    `jaws`: two of them press two faces alike (within 30 %), with as many tips
    each. `model_error` is the error of the forward model relative to the signals; left out, it is what
    `[tolerances]` make of the design, or what a calibrated twin leaves over.
    Contacts may pull sideways by up to `tangential_share` of their normal force (twice the standard
    deviation that is believed along each axis), which is then read too; 0 takes them for frictionless.
    """

    contacts: Annotated[int, Field(ge=1, le=8)] = 6
    probes: Literal["free", "known", "flat"] = "free"
    jaws: bool = False
    model_error: Annotated[float, Field(ge=0, lt=1)] | None = None
    tangential_share: Annotated[float, Field(ge=0, le=2)] = 0.0


class TrainingSpec(SpecPart):
    """Contact estimator that `instobj train` makes.

    `model`: "inversion" is no network but the most probable contacts of the forward model
    (`[inversion]`), for which nothing else here counts. Two are networks, one per face: "compact" reads
    the face's own sensors, "whole-object" those of every face, so that it copes with presses on
    other faces. A data set by itself says nothing of the design: its default is "compact". With
    `history_frames` a network also reads the change over that number of frames, which separates
    loading from unloading (hysteresis of the silicone). `ensemble`: networks that are averaged, each
    stopped and calibrated by its own fold of the presses. `trees`: extremely randomised trees
    with each network, whose answers are weighed in. `process`: a Gaussian process answers where
    a frame is novel. Left out, these four follow from the data (`estimator.networks.defaults`).
    """

    model: Literal["inversion", "compact", "whole-object"] = "inversion"
    history_frames: Annotated[int, Field(ge=0, le=100)] | None = None
    hidden_units: Annotated[
        tuple[Annotated[int, Field(ge=1, le=10_000_000)], ...], Field(min_length=1, max_length=20)
    ] = (256, 256, 256)
    epochs: Annotated[int, Field(ge=1, le=100_000)] = 40
    ensemble: Annotated[int, Field(ge=1, le=20)] | None = None
    trees: Annotated[int, Field(ge=0, le=500)] | None = None
    process: bool | None = None


Use = Literal["grasp", "touch", "presence", "bench"]
LIMITS_OF_USE: dict[str, dict[str, float]] = {
    "grasp": {"position_bound_mm": 1.5, "detectable_force_n": 5.0},
    "touch": {"position_bound_mm": 1.0, "detectable_force_n": 1.0},
    "presence": {"position_bound_mm": 5.0, "detectable_force_n": 5.0},
    "bench": {"position_bound_mm": 1.5, "detectable_force_n": 5.0},
}


SATURATION_MARGIN = 0.1
"""Share of the sensors' range that stays free in the deepest press: magnets come 5 % stronger."""


class LimitsSpec(SpecPart):
    """Go or no-go limits of the report; those left out are the `use`'s.

    A grasp: where each finger of a hand presses and how hard. A touch: light ones too, placed within
    a millimetre. Presence: whether the object is held, and about where. In these three the object is
    turned and warms up after its zero, by what `tolerances` say. Bench: it stands still as zeroed.
    """

    use: Use = "grasp"
    position_bound_mm: Annotated[float, Field(ge=0.001, le=100)] = 1.5
    detectable_force_n: Force = 5.0

    @model_validator(mode="before")
    @classmethod
    def _figures_left_out(cls, given: Any) -> Any:
        if not isinstance(given, dict):
            return given
        return {**LIMITS_OF_USE.get(str(given.get("use", "grasp")), {}), **given}
