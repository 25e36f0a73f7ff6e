"""Feasibility of a search: whether its bounds and limits leave any layout, before anything is solved."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import combinations

import numpy as np
import torch
from jaxtyping import Float
from torch import Tensor

from design.errors import InputError
from design.layout.body import face_frames
from design.layout.places.contact_grid import contact_grid
from design.layout.places.contact_places import contact_places
from design.layout.pockets import shell_bodies
from design.search.faces import layout_groups
from design.search.space import (
    SearchSpace,
    params_at,
    search_space,
    start_params,
    structure_of,
    unit_of,
    with_freedom,
)
from design.search.structure import with_structure
from design.spec.object import ObjectSpec
from estimator.layouts.limits.rules import RULES, constraint_violations_mm
from estimator.layouts.polish import descend
from estimator.layouts.scorer import require_scorable
from estimator.layouts.vectors import layout_space, layouts_at
from fem.candidates.motions import candidate_lattices
from instobj.search.lowest_fidelity import misfit_of

_FEWEST_IN_A_ROW = 4
"""Fewest contact locations in a row of a cubic spline."""
_FEWEST_OF_A_FACE = 10
"""Fewest contact locations of a face of an r⁵ spline with parabolas, and some more."""
_UNKNOWNS = 6
"""Unknowns of two contacts: place and force of each."""
_STARTS = 24
_STEPS, WALKS = 30, 5
_STRUCTURES = 24
"""Drawn at random; a search of more sizes and counts than that has some that fit."""


@dataclass(frozen=True)
class _Nearest:
    """The layout that comes nearest to the limits: variables, what is broken and which rule most."""

    params: dict[str, object]
    broken_mm: float
    rule: str


def require_possible(spec: ObjectSpec) -> SearchSpace:
    """The search space, if it holds a layout within all limits.

    Raises
    ------
    InputError
        Of `search_space`; what may not vary on this body; an objective or limited score that this
        object has none of; mechanics that a fidelity level lacks; or no layout within the limits,
        with the one that is most in the way.
    """
    spec = with_freedom(spec)
    _require_known_on(spec)
    if len(spec.magnets.lists) > 1 and len(layout_groups(spec)) == 1:
        raise InputError(
            "a layout search moves one layout that all faces of a size repeat; magnets.positions_mm holds "
            'a list for each face. Give one list, or set search.vary.layouts = "per face"'
        )
    require_scorable(spec)
    _require_mechanics(spec)
    _require_scores(spec)
    space = search_space(spec)
    return _possible(space)


def _require_known_on(spec: ObjectSpec) -> None:
    """Refuse what may not vary on a body of this kind."""
    vary, kind = spec.search.vary, spec.body.kind
    if vary.magnet_depth_mm is not None and spec.arrangement == "sensors-in-shell":
        raise InputError(
            "search.vary.magnet_depth_mm is that of magnets in the shell; with arrangement = "
            "'sensors-in-shell' they lie in the core, at magnets.depth_below_core_face_mm. Leave it out"
        )
    if vary.magnet_tilt_deg is not None and not all(frame.flat for frame in face_frames(spec)):
        raise InputError(
            "search.vary.magnet_tilt_deg is known on flat faces only: under a curved one magnets stand "
            f"along its normals; got body.kind = {kind!r}. Leave it out"
        )


def _require_mechanics(spec: ObjectSpec) -> None:
    """Refuse what the fidelity levels cannot press, said before the minutes that the lower ones take."""
    fewest = min(contact_grid(spec).shape)
    if fewest < _FEWEST_IN_A_ROW:
        raise InputError(
            f"a layout search takes {_FEWEST_IN_A_ROW} contact locations in a row, for slopes along the "
            f"face; got {fewest}. Raise contact_grid.count, or lower contact_grid.pitch_mm"
        )
    face_places = contact_places(spec).sum(axis=1)
    if face_places.min() < _FEWEST_OF_A_FACE:
        raise InputError(
            f"a layout search takes {_FEWEST_OF_A_FACE} contact locations on a face, for slopes along it; "
            f"face {spec.body.sensed[int(face_places.argmin())]} has {face_places.min()}. "
            "Lower contact_grid.pitch_mm, or "
            "leave the face out with body.sensed_faces"
        )
    if spec.mechanics.interface == "frictionless":
        raise InputError(
            "a layout search takes a bonded core, which the second fidelity level needs; got "
            'mechanics.interface = "frictionless". Compare such layouts by `instobj score A.toml B.toml`'
        )
    if spec.indenter.friction != "none":
        raise InputError(
            "a layout search presses without friction; got indenter.friction = "
            f'{spec.indenter.friction!r}. Set it to "none"'
        )


def _require_scores(spec: ObjectSpec) -> None:
    for name, lacking in _lacking(spec).items():
        if name in spec.search.named:
            raise InputError(
                f"the search names {name}, which this object cannot be scored by: {lacking}. Leave it "
                "out of search.objectives and search.limits.times_start, or change that"
            )


def _lacking(spec: ObjectSpec) -> dict[str, str]:
    """Scores that do not exist for the specification, and why."""
    frames = face_frames(spec)
    if any(a.normal @ b.normal > -0.5 for a, b in combinations(frames, 2)):
        return {}
    lacking = f"body.sensed_faces = {list(spec.body.sensed)} has no two adjacent faces"
    return dict.fromkeys(("median_false_force_n", "percentile_95_false_force_n"), lacking)


def _possible(space: SearchSpace) -> SearchSpace:
    reasons: Counter[str] = Counter()
    for structured, nearest in _nearest_of_structures(space):
        _require_candidates(structured)
        if nearest.broken_mm > 0:
            reasons[nearest.rule] += 1
            continue
        misfit = misfit_of(space.spec, nearest.params)
        if not misfit:
            return space
        reasons[misfit.splitlines()[-1].strip(" -")] += 1
    (rule, _), *_ = reasons.most_common()
    raise InputError(
        f"no layout within the bounds keeps every limit. Most in the way: {rule}. Widen [search.vary] "
        "or loosen [search.limits]"
    )


def _nearest_of_structures(space: SearchSpace) -> Iterator[tuple[ObjectSpec, _Nearest]]:
    """The start's structure, then others drawn at random, each with the layout that comes nearest to
    its limits: from random layouts, the start among them."""
    rng, drawn, start = np.random.default_rng(space.spec.seed), set(), start_params(space)
    for number in range(_STRUCTURES):
        units = rng.random((_STARTS, len(space.variables)))
        if number == 0 and start is not None:
            units[0] = unit_of(space, start)
        params = params_at(space, units[0])
        structure = structure_of(space, params)
        if structure in drawn:
            continue
        drawn.add(structure)
        structured = with_structure(space.spec, params)
        yield structured, _nearest(space, structured, params, units)


def _nearest(
    space: SearchSpace,
    structured: ObjectSpec,
    params: dict[str, object],
    units: Float[np.ndarray, "layout variable"],
) -> _Nearest:
    """Walk random layouts of one structure towards the limits."""
    tensors = layout_space(space, structured)
    flags = np.array([not v.choices for v in space.variables])
    poles = torch.ones(len(units), structured.magnets.count)

    def broken(point: Tensor) -> Tensor:
        face = structured.body.sensed[0]
        return constraint_violations_mm(tensors, layouts_at(tensors, point, poles, face), face)

    point = torch.as_tensor(units[:, flags], dtype=torch.float32)
    rules = broken(point)
    for _ in range(WALKS if flags.any() else 0):
        if (rules.sum(dim=1) == 0).any():
            break
        point = descend(lambda u: broken(u).sum(dim=1), point, _STEPS)
        rules = broken(point)
    best = int(rules.sum(dim=1).argmin())
    unit = unit_of(space, params)
    unit[flags] = point[best].numpy()
    worst = int(rules[best].argmax())
    rule = f"{RULES[worst]}, by {float(rules[best, worst]):.3g} mm of all parts together"
    return _Nearest(params | params_at(space, unit), float(rules[best].sum()), rule)


def _require_candidates(structured: ObjectSpec) -> None:
    """Depths must lie where magnets' motions are known."""
    depths_mm = candidate_lattices(structured)[0].depth_mm
    lie = [-float(body.centre_mm[2]) for body in shell_bodies(structured)[0]]
    low, high = structured.search.vary.magnet_depth_mm or (min(lie), max(lie))
    what = "magnets" if structured.arrangement == "sensors-in-core" else "sensor boards"
    if low < depths_mm[0] - 1e-9 or high > depths_mm[-1] + 1e-9:
        raise InputError(
            f"a search takes {what} whose mid-planes lie {depths_mm[0]:g} to "
            f"{depths_mm[-1]:g} mm deep, 1.5 mm "
            f"from both skins of the shell; got {low:g} to {high:g} mm. Narrow "
            f"search.vary.magnet_depth_mm, or move the {what}"
        )
