"""Places of magnets on their faces: whether one can be judged there, and the nearest that works."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from itertools import islice
from typing import TYPE_CHECKING

import numpy as np

from design.layout.body import face_frames
from design.layout.mould.closure import flange_corners_mm
from design.layout.mould.frame import mould_style
from design.layout.mould.pins import Pin, least_rim_mm, pin_of, rim_below_clips_mm
from design.layout.places.positions import cover_mm, shell_covers_mm
from design.layout.pockets import Pocket, shell_pockets

if TYPE_CHECKING:
    from manifold3d import Manifold

    from design.body.surface_chart import FaceFrame
    from design.spec.object import ObjectSpec

Placed = tuple["FaceFrame", Pocket]
MEETING_MM3 = 1e-3
MOST_TOLD = 20
"""Pairs of pockets, or magnets, of one kind of problem: nobody reads on."""
_STEPS = 101
"""Number of places between a magnet and the middle of its face."""


def placed_pockets(spec: ObjectSpec) -> list[Placed]:
    """Every pocket of the shell with the frame of its face."""
    faces = zip(face_frames(spec), shell_pockets(spec), strict=True)
    return [(frame, pocket) for frame, pockets in faces for pocket in pockets]


def lies_on_patch(frame: FaceFrame, pocket: Pocket, cover_mm: float) -> bool:
    """Return whether a face covers a pocket, and the silicone over what lies in it is known (not NaN)."""
    return bool(np.isfinite(cover_mm)) and bool(frame.covers(pocket.reach_mm))


def pockets_off_patches(spec: ObjectSpec) -> dict[str, list[Placed]]:
    """Pockets that do not lie on their patches, by what the specification calls their magnets: one of a
    list that faces share is one there."""
    pockets: dict[str, list[Placed]] = {}
    covers = np.concatenate(shell_covers_mm(spec)).tolist()
    for (frame, pocket), cover in zip(placed_pockets(spec), covers, strict=True):
        if not lies_on_patch(frame, pocket, cover):
            pockets.setdefault(pocket.body.label, []).append((frame, pocket))
    return pockets


def place_on_patches(spec: ObjectSpec, placed: Sequence[Placed]) -> str:
    """Return where one magnet of these faces would lie on the patches of all, its pin clear of the flange."""
    closing = flange_solids(spec) if _is_split(spec) else []

    def known(frame: FaceFrame, pocket: Pocket) -> bool:
        return lies_on_patch(frame, pocket, cover_mm(frame, pocket.body))

    def covered(frame: FaceFrame, pocket: Pocket) -> bool:
        return known(frame, pocket) and cover_mm(frame, pocket.body) > 0

    def clear(frame: FaceFrame, pocket: Pocket) -> bool:
        return covered(frame, pocket) and head_is_clear(spec, closing, frame, pocket)

    for works in (clear, covered, known):
        place = nearest_inwards(placed, works)
        if place is not None:
            return f"Move it inwards, as to ({place[0]:.4g}, {place[1]:.4g})"
    return "It does not fit in the middle either: take a smaller magnet, or a larger body"


def nearest_inwards(
    placed: Sequence[Placed], works: Callable[[FaceFrame, Pocket], bool]
) -> tuple[float, float] | None:
    """The first place on a magnet's way to the middle of its face that works on all the faces given."""
    for share in np.linspace(1, 0, _STEPS)[1:]:
        moved = [(frame, _moved_to_share(pocket, float(share))) for frame, pocket in placed]
        if all(works(frame, pocket) for frame, pocket in moved):
            x, y, _ = moved[0][1].body.centre_mm
            return float(x) + 0.0, float(y) + 0.0
    return None


def _moved_to_share(pocket: Pocket, share: float) -> Pocket:
    x, y, height = pocket.body.centre_mm
    return replace(
        pocket, body=replace(pocket.body, centre_mm=np.array([share * x, share * y, height]))
    )


def moved_pin(spec: ObjectSpec, frame: FaceFrame, pocket: Pocket) -> Pin | None:
    """A pocket's pin, its rim narrowed to stay below clips; None where less is left than is printed."""
    pin = pin_of(spec, frame.tangent(pocket.body.centre_mm[:2]), pocket)
    rim = rim_below_clips_mm(spec, [pin])
    return replace(pin, rim_mm=rim) if rim >= least_rim_mm(spec) else None


def head_is_clear(
    spec: ObjectSpec, flange: Sequence[Manifold], frame: FaceFrame, pocket: Pocket
) -> bool:
    """Return whether a pocket's pin keeps the least rim of its head below the clips, and out of the
    flange."""
    pin = moved_pin(spec, frame, pocket)
    return pin is not None and not (flange and common_mm3(pin.head(), flange) > MEETING_MM3)


def flange_solids(spec: ObjectSpec) -> list[Manifold]:
    """Boxes that hold the flange by which a rod or a plug hangs; none where nothing does."""
    from manifold3d import Manifold

    return [
        Manifold.cube(tuple(high - low)).translate(tuple(low))
        for low, high in flange_corners_mm(spec)
    ]


def common_mm3(solid: Manifold, others: Sequence[Manifold]) -> float:
    """Largest volume that a solid has in common with one of others."""
    return max(float((solid ^ other_solid).volume()) for other_solid in others)


def _is_split(spec: ObjectSpec) -> bool:
    return mould_style(spec) == "split" and spec.silicone.cure != "none"


def patch_problems(spec: ObjectSpec, ways: bool = True) -> Iterator[str]:
    """Magnets whose pockets do not lie on their patches, one line for each, with a place that works on
    every face; without it, which takes a while, unless `ways`."""
    for label, placed in islice(pockets_off_patches(spec).items(), MOST_TOLD):
        half = np.min([frame.half_extents_mm for frame, _ in placed], axis=0)
        numbers = [frame.number for frame, _ in placed]
        faces = f"face{'s' * (len(numbers) > 1)} {', '.join(map(str, numbers))}"
        over = all(frame.covers(pocket.reach_mm) for frame, pocket in placed)
        unknown = "reaches so near the rim that the silicone over it is not known, on"
        what = unknown if over else "puts its pocket outside"
        way = place_on_patches(spec, placed) if ways else ""
        yield f"{label} {what} {faces} (±{half[0]:.4g}, ±{half[1]:.4g} mm). {way}"
