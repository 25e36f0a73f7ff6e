"""Presses of the indenter over the lattice of every face, answered by the response operator."""

from __future__ import annotations

import functools
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
import scipy.sparse as sp
from jaxtyping import Float
from skfem.quadrature import get_quadrature
from skfem.refdom import RefTri

from design.errors import InputError
from design.layout.places.contact_grid import press_lattice
from design.layout.places.contact_places import pressed_nodes
from design.layout.tips import footprint_mm, landing_mm, path_mm
from design.processes import one_blas_thread
from design.spec.mechanics import IndenterSpec
from design.spec.object import ObjectSpec
from fem.contact.complementarity import Contact, contact
from fem.contact.indenter import Border, TipCells, hemisphere_profile_mm, moved, tip_cells
from fem.contact.refined import (
    RefinedFace,
    Spread,
    near_compliance,
    place_compliance,
    refined_face,
    spread_cells,
    triangle_areas_mm2,
)
from fem.linear.core_slip import RestingShell, slipped_response, superposed
from fem.linear.response import FaceSurface, ResponseOperator
from fem.presses.results import MagnetMotions, PressForces

_QUADRATURE_ORDER = 8
"""Degree that the quadrature over a triangle integrates exactly: a tip's profile is curved."""
_BORDER_MM = 1e-3
"""Rounding by which a tip may lie beyond the face."""
_ALIKE_DIGITS = 6
"""Decimals (mm) to which distances from the border are the same."""
_NEVER_MM = 1e3
"""Gap of vertices beyond the face, far more than any depth: they never touch."""
Progress = Callable[[str], None]


def simulate_lattice(
    spec: ObjectSpec,
    response: ResponseOperator,
    progress: Progress | None = None,
    rest: RestingShell | None = None,
    depths_mm: Sequence[float] = (),
) -> tuple[PressForces, MagnetMotions]:
    """Press every lattice place of every face to every depth, by default `spec.press.depths_mm`.

    Results are NaN at places of the lattice that a face has not (`contact_places.pressed_nodes`).

    On a core that has slipped (`rest`) places are those of the laboratory, where the core stands:
    the shell lies shifted under the indenter. Depth counts from the first touch.

    On an oblique path the place is where the indenter first touches. The force scatters between
    places, by where the mesh's vertices fall, by 0.7 % (standard deviation) at 0.25 mm depth, 0.4 %
    at 0.5 mm and 0.3 % at 1 and 2 mm: R 5 mm sphere, 40 places of the paper's cube without magnets,
    surface edges of 1.2 mm. Its mean changes by at most 0.2 % from there to edges of 0.85 mm. The
    cells themselves cost 0.4 % (Hertz), and 0.3 % for a sharp flat punch of R 3 mm, whose pressure
    is infinite at its edge.

    Raises
    ------
    InputError
        An indenter that hangs over a face's border or sticks to the silicone.
    """
    if spec.indenter.friction != "none":
        raise InputError(
            f"the table of presses is frictionless; got indenter.friction = "
            f"{spec.indenter.friction!r}. Set it to 'none', or press single places with "
            "`instobj press --material linear`"
        )
    lattice = press_lattice(spec)
    depths = np.asarray(depths_mm or spec.press.depths_mm)
    if rest is not None:
        response = slipped_response(spec, response, rest)
    shape = (len(response.surfaces), len(lattice), len(depths))
    force, area = np.full(shape, np.nan), np.full(shape, np.nan)
    magnets = (len(response.compliance) - response.magnet_loads.start) // 6
    motion, pressed = np.full((*shape, magnets, 6), np.nan), pressed_nodes(spec)
    for index, (surface, here) in enumerate(zip(response.surfaces, pressed, strict=True)):
        presses = press_face(spec, response, index, lattice.xy_mm[here], depths)
        force[index, here], area[index, here] = presses.force_n, presses.contact_area_mm2
        rows = response.compliance[response.magnet_loads, response.face_loads(index)]
        moved = presses.vertex_mpa @ rows.T
        motion[index, here] = moved.reshape(*presses.force_n.shape, magnets, 6)
        if progress:
            progress(f"face {surface.number}: {here.sum()} places × {len(depths)} depths")
    faces = np.array([surface.number for surface in response.surfaces])
    at_rest = None
    if rest is not None:
        at_rest = rest.magnet_motion
        motion[pressed] = superposed(at_rest, motion[pressed])
    return (
        PressForces(faces, lattice, depths, force, area),
        MagnetMotions(faces, lattice, depths, motion, at_rest),
    )


@dataclass(frozen=True)
class FacePresses:
    """Presses of one face: force, area of the cells in contact, and the hats' pressures (MPa) that
    stand for the cells' beyond the contact itself, of the same force."""

    force_n: Float[np.ndarray, "place step"]
    contact_area_mm2: Float[np.ndarray, "place step"]
    vertex_mpa: Float[np.ndarray, "place step vertex"]


def press_places(
    spec: ObjectSpec,
    response: ResponseOperator,
    face_index: int,
    xy_mm: Float[np.ndarray, "place 2"],
    depths_mm: Float[np.ndarray, "step"],
) -> Float[np.ndarray, "place step vertex"]:
    """Pressures (MPa) at the face's vertices that stand for those of `press_face`.

    Raises
    ------
    InputError
        An indenter that would hang over the face's border.
    """
    return press_face(spec, response, face_index, xy_mm, depths_mm).vertex_mpa


def press_face(
    spec: ObjectSpec,
    response: ResponseOperator,
    face_index: int,
    xy_mm: Float[np.ndarray, "place 2"],
    depths_mm: Float[np.ndarray, "step"],
) -> FacePresses:
    """Press the indenter at every place on its own, without friction.

    On a curved face places are given by lengths along the surface (`FaceFrame.to_plane`).

    On one BLAS thread: with two, these many small dense systems cost fifteen times the work in
    waiting for each other.

    Raises
    ------
    InputError
        An indenter that would hang over the face's border.
    """
    with one_blas_thread():
        return _press_each(spec, response, face_index, xy_mm, depths_mm)


@dataclass(frozen=True)
class _Kept:
    """Cells that many places share, their own compliance, and the last contact of each step."""

    cells: TipCells
    compliance: Float[np.ndarray, "cell cell"]
    nearby: dict[int, Contact]


def _press_each(
    spec: ObjectSpec,
    response: ResponseOperator,
    face_index: int,
    xy_mm: np.ndarray,
    depths_mm: np.ndarray,
) -> FacePresses:
    face, tip = refined_face(response, face_index, spec), tip_cells(spec.indenter)
    sideways = path_mm(spec.indenter, depths_mm)
    require_landing(face, spec, np.concatenate([xy_mm + sideways[-1], xy_mm]))
    shape, kept = (len(xy_mm), len(depths_mm)), dict[int, _Kept]()
    force, touched = np.zeros(shape), np.zeros(shape)
    vertex = np.zeros((*shape, len(face.surface.xy_mm)))
    together = [np.arange(len(depths_mm))] if not sideways.any() else np.arange(shape[1])[:, None]
    for place, centre in enumerate(face.frame.to_plane(xy_mm)):
        for steps in together:
            cut = cells_over(face, spec.indenter, tip, centre + sideways[steps[0]])
            if id(cut) not in kept:
                kept[id(cut)] = _Kept(cut, near_compliance(cut.patches, spec), {})
            near, nearby = kept[id(cut)].compliance, kept[id(cut)].nearby
            spread = spread_cells(face, moved(cut.patches, centre + sideways[steps[0]]), centre)
            require_on_patch(cut, spread, float(depths_mm[steps[-1]]))
            solved = nearby[steps[0]] = contact(
                place_compliance(spread, near),
                resting_gap_mm(cut, spread) * cut.patches.area_mm2,
                cut.patches.area_mm2,
                np.asarray(depths_mm)[steps],
                nearby.get(steps[0]),
            )
            pressure = solved.pressure_mpa
            force[place, steps] = pressure @ cut.patches.area_mm2
            touched[place, steps] = (pressure > 0) @ spread.patches.area_mm2
            vertex[place, steps[:, None], spread.rows] = pressure @ spread.matrix.T
    return FacePresses(force, touched, vertex)


def cells_over(
    face: RefinedFace, indenter: IndenterSpec, whole: TipCells, xy_mm: Float[np.ndarray, "2"]
) -> TipCells:
    """Cells of an indenter at a place that lie over the face; `whole` where all of them do.

    Places as far from the border share them.
    """
    border = face.border
    if border is None:
        return whole
    outline = footprint_mm(indenter)
    corners = np.stack(np.meshgrid(*(xy_mm + outline).T), axis=-1)
    if (border.signed_distance_mm(corners) <= _BORDER_MM).all():
        return whole
    ends = np.array([border.low_mm, border.high_mm]) - xy_mm
    if not border.round:  # a side that the tip does not reach cuts nothing
        ends = np.array([np.maximum(ends[0], outline[0]), np.minimum(ends[1], outline[1])])
    low, high = map(tuple, ends.round(_ALIKE_DIGITS).tolist())
    return _cut_cells(indenter, low, high, border.round)  # pyright: ignore[reportArgumentType]


@functools.lru_cache(maxsize=256)
def _cut_cells(
    indenter: IndenterSpec, low_mm: tuple[float, ...], high_mm: tuple[float, ...], is_round: bool
) -> TipCells:
    return tip_cells(indenter, Border(np.array(low_mm), np.array(high_mm), is_round))


def resting_gap_mm(tip: TipCells, spread: Spread) -> Float[np.ndarray, "cell"]:
    """Gap between every cell of the face and an indenter that just touches it.

    Along the touching plane's normal; cells off a curved patch never touch.
    """
    gap = tip.height_mm - spread.height_mm
    gap = gap - (np.nanmin(gap) - tip.height_mm.min())
    return np.nan_to_num(gap, nan=_NEVER_MM)


def surface_weights_mm2(surface: FaceSurface) -> Float[np.ndarray, "vertex"]:
    """∫ φ_i dA of every vertex: force per unit pressure."""
    weights = np.zeros(len(surface.xy_mm))
    np.add.at(weights, surface.triangles, triangle_areas_mm2(surface)[:, None] / 3)
    return weights


def profile_moments_mm3(surface: FaceSurface, xy_mm: np.ndarray, radius_mm: float) -> np.ndarray:
    """∫ φ_i gap dA for every place and vertex, mm³: the gap to a tip that just touches the face.

    On a flat face the gap is the profile at |x − centre|.
    """
    local, weight = get_quadrature(RefTri, _QUADRATURE_ORDER)
    hats = np.stack([1 - local.sum(axis=0), *local])  # (3, q)
    corner = surface.xy_mm[surface.triangles]  # (t, 3, 2)
    # k corner, q quadrature point, t triangle, d coordinate. 2 · weight: scikit-fem's weights sum
    # to
    # the reference triangle's area, 1/2.
    points = np.einsum("kq,tkd->tqd", hats, corner).reshape(-1, 2)
    values = np.einsum("kq,q,t->tqk", hats, 2 * weight, triangle_areas_mm2(surface))
    rows = np.repeat(surface.triangles[:, None, :], len(weight), axis=1)
    columns = np.repeat(np.arange(len(points)), 3)
    integral = sp.csr_matrix(
        (values.ravel(), (rows.ravel(), columns)), shape=(len(surface.xy_mm), len(points))
    )
    height = 0.0
    if surface.height_mm is not None:
        height = np.einsum("kq,tk->tq", hats, surface.height_mm[surface.triangles]).ravel()
    moments = np.empty((len(xy_mm), len(surface.xy_mm)))
    for place, centre in enumerate(xy_mm):
        profile = hemisphere_profile_mm(np.linalg.norm(points - centre, axis=1), radius_mm)
        touch = np.min(profile - height) - np.min(profile)
        moments[place] = integral @ (profile - height - touch)
    return moments


def require_landing(
    face: RefinedFace, spec: ObjectSpec, xy_mm: Float[np.ndarray, "place 2"]
) -> None:
    """Raise InputError for a press that misses a flat face: a round tip's lowest point, all of another.

    Where slits cut the edges the whole indenter must stay on the face.
    """
    if spec.shell.slits.depth_mm > 0:
        return require_on_face(face, spec.indenter, xy_mm)
    if face.border is None:
        return None
    ends = landing_mm(spec.indenter, xy_mm, face.border.low_mm, face.border.high_mm)
    misses = (face.border.signed_distance_mm(xy_mm + ends) > _BORDER_MM).all(axis=0)
    if np.any(misses):
        x, y = xy_mm[misses][0]
        half = face.frame.half_extents_mm
        raise InputError(
            f"a press at ({x:g}, {y:g}) mm misses face {face.frame.number} (±{half[0]:.4g}, "
            f"±{half[1]:.4g} mm). Move it inwards"
        )
    return None


def require_on_face(
    face: RefinedFace, indenter: IndenterSpec, xy_mm: Float[np.ndarray, "place 2"]
) -> None:
    """Raise InputError for an indenter whose outline reaches beyond a flat face's border.

    On a slipped shell it may hang over on one side by as much as the slip. An indenter on a curved
    face covers more than it touches: `require_on_patch` looks at that.
    """
    if not face.frame.flat:
        return
    high = abs(face.surface.xy_mm).max(axis=0)
    low, number = -high, face.frame.number
    footprint = footprint_mm(indenter)
    size = np.ptp(footprint, axis=0)
    if (size > high - low + _BORDER_MM).any():
        raise InputError(
            f"the indenter covers {size[0]:.4g} × {size[1]:.4g} mm, more than face {number} "
            f"({high[0] - low[0]:.3g} × {high[1] - low[1]:.3g} mm). Use a smaller indenter"
        )
    beyond = (xy_mm + footprint[0] < low - _BORDER_MM) | (xy_mm + footprint[1] > high + _BORDER_MM)
    over = beyond.any(axis=1)
    if face.frame.round:
        reach = np.linalg.norm(footprint, axis=1).max() / np.sqrt(2)
        over |= np.linalg.norm(xy_mm, axis=1) + reach > high.max() + _BORDER_MM
    if over.any():
        x, y = xy_mm[over][0]
        raise InputError(
            f"the {indenter.kind} pressed at ({x:g}, {y:g}) mm hangs over the border of face "
            f"{number} (±{high[0]:.3g}, ±{high[1]:.3g} mm). Move the press inwards, or use "
            "fewer contact locations or a smaller indenter"
        )


def require_on_patch(tip: TipCells, spread: Spread, depth_mm: float) -> None:
    """Raise InputError where a press to a depth might touch a curved body off the patch."""
    if np.any(np.isnan(spread.height_mm) & (tip.height_mm < depth_mm)):
        frame = spread.face.frame
        half = frame.half_lengths_mm
        raise InputError(
            f"a press {depth_mm:g} mm deep leaves the patch of face {frame.number} (±"
            f"{half[0]:.4g}, ±{half[1]:.4g} mm along the surface, up to 60° steep) and "
            "touches where the surface is too steep. Press nearer to its centre or less deep, or use a "
            "smaller indenter"
        )
