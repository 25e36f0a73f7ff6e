"""What a specification asks of simulated recordings on the scale of the paper's."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, model_validator

from design.spec.base import Count, NonNegative, Positive, SpecPart

Coordinate = Annotated[float, Field(ge=-500, le=500)]
ProbePose = tuple[Coordinate, Coordinate, Annotated[float, Field(ge=-360, le=360)]]
"""Centre of a probe in the face's frame (x, y in mm) and its turn about the normal (degrees)."""
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
    """Simulated recordings, `instobj frames`.

    "paper": on each of `faces` every contact place, the probes of two and three tips at
    `dual_poses` and `triple_poses`, and `non_contact_cases`; `frames_per_case` frames each, at one
    periodic travel for all (Knopke et al., RA-L 2024). The poses spread rows and columns near the
    borders and in the middle. "grasp": probes of one, two and three tips on both of `grasp_faces`,
    squeezed periodically to `grasp_force_n`. "continuous": `presses` short presses of `contacts`
    tips at once anywhere on `faces`, with peaks and rest frames as `protocol` has them; with
    `tangential_share` above 0 each is also pulled sideways, by up to that share of its force.
    `hysteresis` is the loop's width at half force over the peak, without rate.
    """

    kind: Literal["paper", "grasp", "continuous"] = "paper"
    faces: Annotated[tuple[SensedFace, ...], Field(min_length=1)] = (1, 2, 3, 4, 5)
    frames_per_case: Annotated[int, Field(ge=4)] = 1000
    non_contact_cases: Annotated[int, Field(ge=1)] = 3
    dual_poses: tuple[ProbePose, ...] = _ROWS + _COLUMNS
    triple_poses: tuple[ProbePose, ...] = _TRIANGLES + tuple(
        (-x, -y, 180.0) for x, y, _ in _TRIANGLES
    )
    grasp_faces: tuple[SensedFace, SensedFace] = (3, 5)
    grasp_force_n: Positive = 17.0
    presses: Count = 2000
    contacts: Annotated[int, Field(ge=1, le=5)] = 1
    tangential_share: Annotated[float, Field(ge=0, le=2)] = 0.0
    hysteresis: Annotated[NonNegative, Field(lt=0.5)] = 0.0

    @model_validator(mode="after")
    def _faces_differ(self) -> CollectionSpec:
        for name, faces in (("faces", self.faces), ("grasp_faces", self.grasp_faces)):
            if len(set(faces)) != len(faces):
                raise ValueError(
                    f"collection.{name} names a face twice; got {list(faces)}. Name each once"
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
