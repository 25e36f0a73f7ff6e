"""Contact locations to press, as given on the command line: read, and checked one by one."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from design.errors import InputError
from design.spec.object import ObjectSpec

if TYPE_CHECKING:
    from fem.presses.joint import Tip

_DEPTH_MM = 2.0
"""Depth of a press that names none, mm: that of the paper's collection."""
_EXAMPLE = "Example: --at 3:5,-4 or, with its own depth, --at 3:5,-4,1.5"


@dataclass(frozen=True)
class Place:
    """A contact location on a face (mm, along the surface) and the depth of its press."""

    face: int
    x_mm: float
    y_mm: float
    depth_mm: float

    @property
    def tip(self) -> Tip:
        """The indenter there."""
        from fem.presses.joint import Tip

        return Tip(self.face, self.x_mm, self.y_mm)

    def __str__(self) -> str:
        return f"face {self.face} at ({self.x_mm:g}, {self.y_mm:g}) mm"


@dataclass(frozen=True)
class CheckedPlaces:
    """Places that can be pressed, and what is wrong with the others."""

    good: tuple[Place, ...]
    refused: tuple[dict[str, Any], ...]


def places_given(coordinate: Sequence[str]) -> list[Place]:
    """Places of every `--at FACE:X,Y[,DEPTH]`; without a depth they are pressed 2 mm deep.

    Raises
    ------
    InputError
        None is given, or one cannot be read.
    """
    if not coordinate:
        raise InputError(f"no contact location to press. Give --at. {_EXAMPLE}")
    return [_place_at(text, _DEPTH_MM) for text in coordinate]


def jaw_given(text: str) -> list[Place]:
    """Places of one jaw, `FACE:X,Y[;X,Y]`.

    Raises
    ------
    InputError
        It cannot be read.
    """
    face, colon, rest = text.partition(":")
    if not colon:
        raise InputError(f"--jaw {text!r} is not FACE:X,Y[;X,Y]. Example: --jaw '3:-7.5,0;7.5,0'")
    places = [_place_at(f"{face}:{part}", 0.0) for part in rest.split(";")]
    return places


def check_places(
    spec: ObjectSpec, places: list[Place], to_depth: bool, over_edges: bool = False
) -> CheckedPlaces:
    """Separate places that can be pressed from the others; `over_edges`: the tip may roll over a border.

    Raises
    ------
    InputError
        Not one can be pressed.
    """
    good, refused = [], []
    for place in places:
        try:
            _require_place(spec, place, to_depth, over_edges)
        except InputError as error:
            refused.append({"press": str(place), "error": str(error)})
        else:
            good.append(place)
    if not good:
        raise InputError(refused[0]["error"])
    return CheckedPlaces(tuple(good), tuple(refused))


def _place_at(text: str, depth_mm: float) -> Place:
    try:
        face, _, rest = text.partition(":")
        numbers = [float(part) for part in rest.split(",")]
        x, y, depth = (*numbers, depth_mm)[:3] if len(numbers) in (2, 3) else (math.nan,) * 3
        if not all(map(math.isfinite, (x, y, depth))):
            raise ValueError
        return Place(int(face), x, y, depth)
    except ValueError:
        raise InputError(f"{text!r} is no contact location FACE:X,Y in mm. {_EXAMPLE}") from None


def _require_place(spec: ObjectSpec, place: Place, to_depth: bool, over_edges: bool) -> None:
    from design.layout.body import face_frames
    from design.layout.tips import footprint_mm, landing_mm, path_mm, tip_shape

    frames = {frame.number: frame for frame in face_frames(spec)}
    if place.face not in frames:
        raise InputError(f"face {place.face} is not sensed. Choose one of {sorted(frames)}")
    deepest = min(tip_shape(spec.indenter).height_mm, spec.shell.thickness_mm)
    if to_depth and not 0 < place.depth_mm < deepest:
        raise InputError(
            f"a press to {place.depth_mm:g} mm on {place}: the depth must be above 0 and below the "
            f"indenter's height and the shell's thickness ({deepest:g} mm). Press less deep"
        )
    if over_edges and lies_over_edge(spec, place):
        return
    frame = frames[place.face]
    whole = spec.indenter.friction == "sticking" or spec.shell.slits.depth_mm > 0
    hangs = np.array(frame.ends) & (not whole)
    half, at_place = np.array(frame.half_lengths_mm), np.array([place.x_mm, place.y_mm])
    landing = landing_mm(spec.indenter, at_place, -half, half)
    reach = np.where(hangs, landing, footprint_mm(spec.indenter))
    size = np.ptp(reach, axis=0)
    if size[0] > 2 * half[0] or size[1] > 2 * half[1]:
        raise InputError(
            f"the {spec.indenter.kind} covers {size[0]:.4g} × {size[1]:.4g} mm, more than face "
            f"{place.face} ({2 * half[0]:.4g} × {2 * half[1]:.4g} mm). Use a smaller indenter"
        )
    at_the_end = path_mm(spec.indenter, [place.depth_mm])[0] if to_depth else (0.0, 0.0)
    for axis, (name, coordinate) in enumerate((("x", place.x_mm), ("y", place.y_mm))):
        ends = [coordinate + side + way for side in reach[:, axis] for way in (0, at_the_end[axis])]
        if max(map(abs, ends)) > half[axis] + 1e-9:
            does = "lands at" if hangs[axis] else "reaches"
            raise InputError(
                f"the {spec.indenter.kind} pressed on {place} {does} {name} = "
                f"{max(ends, key=abs):.4g} mm, beyond the border of face {place.face} "
                f"(±{half[axis]:.4g} mm): it misses the body. Move the press inwards or use a "
                "smaller indenter"
            )
    if not frame.flat:
        _require_on_lattice(spec, place)


def lies_over_edge(spec: ObjectSpec, place: Place) -> bool:
    """Return whether a place lies over an edge.

    Raises
    ------
    InputError
        It lies further than the tip rolls, or this indenter cannot.
    """
    from fem.presses.over_edge import edge_place

    return edge_place(spec, place.tip) is not None


def _require_on_lattice(spec: ObjectSpec, place: Place) -> None:
    """Refuse a press on a curved patch where the table of presses is not known."""
    from design.layout.places.contact_grid import press_lattice
    from design.layout.places.contact_places import pressed_nodes
    from estimator.signals.interpolation import among_pressed

    lattice = press_lattice(spec)
    pressed = pressed_nodes(spec)[spec.body.sensed.index(place.face)]
    x, y = np.array([[place.x_mm], [place.y_mm]])
    if not among_pressed(lattice, pressed, x, y).all():
        raise InputError(
            f"{place} lies beside the contact locations that the face has, and half a pitch round them. "
            "Move the press inwards"
        )
