"""Sets of contact locations that several tips press at once."""

from __future__ import annotations

from itertools import combinations

import numpy as np
from jaxtyping import Bool, Int

from design.errors import InputError
from design.layout.places.contact_grid import contact_grid
from design.layout.places.contact_places import contact_places, grid_count
from design.spec.object import ObjectSpec

_PLACES_AN_AXIS = 5
"""Places along each axis of a face from which sets are made."""


def spread_places(spec: ObjectSpec) -> Int[np.ndarray, "place"]:
    """Contact locations spread evenly over what all faces have in common, five an axis at most."""
    shared = np.asarray(contact_places(spec).all(axis=0)).reshape(grid_count(spec))
    chosen = []
    for across in (1, 0):
        used = np.flatnonzero(shared.any(axis=across))
        some = np.unique(np.linspace(0, len(used) - 1, _PLACES_AN_AXIS).round()).astype(int)
        chosen.append(np.isin(np.arange(shared.shape[1 - across]), used[some] if len(used) else []))
    return np.flatnonzero(np.outer(*chosen) & shared)


def contact_sets(
    spec: ObjectSpec, places: Int[np.ndarray, "place"], contacts: int
) -> Int[np.ndarray, "set contact"]:
    """All sets of k of the places (as rows into `places`) whose tips do not touch.

    Raises
    ------
    InputError
        The grid is too small for them.
    """
    apart = _apart(spec, places)
    sets = [c for c in combinations(range(len(places)), contacts) if _all_apart(apart, c)]
    if not sets:
        raise InputError(
            f"{contacts} tips of radius {spec.indenter.radius_mm:g} mm do not fit on the contact "
            "grid. Take fewer contacts, a smaller indenter or a larger grid"
        )
    return np.array(sets)


def _apart(spec: ObjectSpec, places: Int[np.ndarray, "place"]) -> Bool[np.ndarray, "place place"]:
    xy = contact_grid(spec).xy_mm[places]
    return np.linalg.norm(xy[:, None] - xy, axis=2) >= 2 * spec.indenter.radius_mm


def _all_apart(apart: np.ndarray, some: tuple[int, ...]) -> bool:
    return all(apart[a, b] for a, b in combinations(some, 2))
