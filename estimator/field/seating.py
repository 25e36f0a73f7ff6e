"""Hold of magnets in open pockets, while an object is assembled, against what pulls them out.

A mould's pins leave open pockets. Magnets are set into them on films of silicone that cure under a plug,
face by face and one pole after the other (the assembly sheet says so); walls of a soft pocket count
nothing. Silicone that cured against a magnet touches all of its base, which comes off as a flat punch
comes off rubber: at F = √(8π E* W a³) (Kendall, J. Phys. D 4 (1971) 1186). A reversible contact has
the least W: in tests of studs that were cast on silicone, losses as the rubber gives
way add most of the force (Kohl and Singer, Prog. Org. Coat. 36 (1999) 15). `MARGIN` is
for films that do not reach the rim: of 0.86 of the base's radius.

The pull is a bound for any order of assembly: of the others only those count that pull outwards, at
their seats, and in addition the one that pulls most on its way into its own pocket. Magnets that are
glued into a rigid core need no such hold.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from jaxtyping import Float

from design.errors import InputError
from design.layout.places.positions import magnet_layout, shell_body_layout
from design.layout.pockets import shell_pockets
from design.spec.assembly import AsBuiltSpec
from design.spec.cached_geometry import cached_geometry
from design.spec.object import ObjectSpec
from estimator.field.forces import loads_by_each

ADHESION_N_PER_MM = 4.4e-5
"""Work of adhesion W of silicone, 44 mJ/m² (Chaudhury and Whitesides, Langmuir 7 (1991) 1013): twice its
surface energy, that of two silicones. Nickel's energy is higher, and so is W on a magnet."""
MARGIN = 1.25
"""Hold over the largest pull that is allowed."""
_HEIGHTS = (0.25, 0.5, 1.0)
"""Places of a magnet on its way in, as shares of the way from its seat to where it leaves the pocket."""
_MOST_TRIED = 100
"""Magnets of an object for which other poles and places are tried; more take minutes."""
_FARTHEST_MM = 12
"""Distance by which two magnets are moved apart at most, in steps of 1 mm."""


@dataclass(frozen=True)
class Seats:
    """Largest pull out of its open pocket on each magnet, and what holds it (N).

    `by_each_n` is the part of every other magnet in the pull.
    """

    by_each_n: Float[np.ndarray, "magnet source"]
    hold_n: Float[np.ndarray, "magnet"]

    @property
    def pull_n(self) -> Float[np.ndarray, "magnet"]:
        return self.by_each_n.sum(axis=1)

    @property
    def excess(self) -> Float[np.ndarray, "magnet"]:
        """Pull over the largest one that is allowed."""
        return MARGIN * self.pull_n / self.hold_n


@cached_geometry
def seats(spec: ObjectSpec) -> Seats:
    """Return pull and hold of every magnet of the shell, as designed."""
    area = np.array([body.outline.area_mm2 for body in shell_body_layout(spec).bodies])
    modulus = spec.silicone.youngs_modulus_mpa / (1 - spec.silicone.poisson_ratio**2)
    # Kendall's flat punch: a³ of the circle of the base's area
    hold = np.sqrt(8 * np.pi * modulus * ADHESION_N_PER_MM * (area / np.pi) ** 1.5)
    design = spec.changed(as_built=AsBuiltSpec())
    magnets, outward = magnet_layout(design), shell_body_layout(spec).frame[:, :, 2]
    pockets = [pocket for face in shell_pockets(spec) for pocket in face]
    # From its seat to where its lower side is in the pocket's mouth
    way = np.array([pocket.mouth_mm + pocket.body.height_mm / 2 for pocket in pockets])

    def outward_n(share: float) -> Float[np.ndarray, "magnet source"]:
        """Pull on each magnet at its seat by each one at a share of its way."""
        raised = magnets.centre_mm + share * way[:, None] * outward
        sources = replace(magnets, centre_mm=raised)
        each = loads_by_each(magnets, sources, spec.magnets)[..., :3]
        # t magnet at its seat, s the other one, k coordinate; none pulls itself
        normal_n = np.einsum("tsk,tk->ts", each, outward)
        return np.maximum(normal_n * ~np.eye(len(way), dtype=bool), 0.0)

    pulls = outward_n(0.0)
    extra = np.max([outward_n(share) for share in _HEIGHTS], axis=0) - pulls
    row, inserted = np.arange(len(way)), extra.argmax(axis=1)
    pulls[row, inserted] += np.maximum(extra[row, inserted], 0.0)
    return Seats(pulls, hold)


def require_seated(spec: ObjectSpec) -> None:
    """Refuse magnets that others pull out of their pockets while the object is assembled.

    Raises
    ------
    InputError
        What `why_unseated` says.
    """
    why = why_unseated(spec)
    if why:
        raise InputError(why)


def why_unseated(spec: ObjectSpec) -> str:
    """Return which magnet is pulled most for its hold, by which, and what would do; "" where all stay."""
    if spec.arrangement == "sensors-in-shell":
        return ""
    seated = seats(spec)
    worst = int(seated.excess.argmax())
    if seated.excess[worst] <= 1:
        return ""
    neighbour, more = int(seated.by_each_n[worst].argmax()), int((seated.excess > 1).sum()) - 1
    return (
        f"magnets pull each other out of their pockets while they are set: {_name(spec, worst)} is drawn "
        f"out with {seated.pull_n[worst]:.2g} N, most of it by {_name(spec, neighbour)}. A film of cured "
        f"silicone below holds {seated.hold_n[worst]:.2g} N, of which {seated.hold_n[worst] / MARGIN:.2g} N "
        f"may be used{f' ({more} more magnets are drawn out too)' * bool(more)}. "
        f"To mend it, {'; or '.join(_remedies(spec, worst, neighbour, float(seated.excess[worst])))}"
    )


def _remedies(spec: ObjectSpec, worst: int, neighbour: int, excess: float) -> Iterator[str]:
    """Yield what would do: the other pole, other places, a remanence."""
    # Forces go with the square of all polarizations.
    share = np.floor(1e2 / excess**0.5) / 1e2
    weaker = f"take magnets of {share:g} times the strength or less (magnets.remanence_t)"
    if len(spec.body.sensed) * spec.magnets.count > _MOST_TRIED:
        yield weaker
        return
    turned = list(spec.magnets.north or ["outward"] * spec.magnets.count)
    number = neighbour % spec.magnets.count
    turned[number] = "inward" if turned[number] == "outward" else "outward"
    if all_stay(spec, north=turned):
        yield f"turn magnet {number + 1} of every face over (magnets.north)"
    if len(spec.magnets.lists) == 1:
        yield from _places(spec, worst, neighbour)
    yield weaker


def _places(spec: ObjectSpec, worst: int, neighbour: int) -> Iterator[str]:
    """Yield how far apart two magnets of a face must be, or magnets of two faces from their border."""
    places, count = np.array(spec.magnets.lists[0]), spec.magnets.count
    number, second = worst % count, neighbour % count
    if worst // count != neighbour // count:
        for percent in range(95, 0, -5):
            if all_stay(spec, positions_mm=(percent / 100 * places).tolist()):
                yield f"draw all magnets in to {percent / 100:g} times their magnets.positions_mm"
                return
        return
    apart = places[second] - places[number]
    now_mm = float(np.hypot(*apart))
    for distance_mm in np.ceil(now_mm) + np.arange(_FARTHEST_MM):
        moved = places.copy()
        moved[second] = places[number] + distance_mm / now_mm * apart
        if all_stay(spec, positions_mm=moved.tolist()):
            yield f"set these two {distance_mm:g} mm apart or more (magnets.positions_mm)"
            return


def all_stay(spec: ObjectSpec, **changes: Any) -> bool:
    """Return whether no magnet is pulled out while it is set, with these changes of `[magnets]`; those on
    a core are glued."""
    if spec.arrangement == "sensors-in-shell":
        return True
    tried = spec.changed(magnets=spec.magnets.changed(**changes)) if changes else spec
    # beyond a curved patch there is no surface: fields of such places would never converge
    if not np.isfinite(magnet_layout(tried).centre_mm).all():
        return False
    return bool(seats(tried).excess.max() <= 1)


def gap_that_holds_mm(spec: ObjectSpec) -> float:
    """Return the gap of pockets (mm) at which the pair that pulls most would stay, about; 0 where all stay.

    Forces of magnets go with the fourth power of their distance.
    """
    seated, layout = seats(spec), magnet_layout(spec)
    worst = int(seated.excess.argmax())
    if seated.excess[worst] <= 1:
        return 0.0
    neighbour = int(seated.by_each_n[worst].argmax())
    apart_mm = float(np.linalg.norm(layout.centre_mm[worst] - layout.centre_mm[neighbour]))
    return apart_mm * float(seated.excess[worst]) ** 0.25 - spec.shell.pocket_diameter_mm


def _name(spec: ObjectSpec, magnet: int) -> str:
    face, number = divmod(magnet, spec.magnets.count)
    return f"magnet {number + 1} of face {spec.body.sensed[face]}"
