"""Motions of the magnets under tangential forces of the tip: full-slip Coulomb tractions.

A tip that slips exerts a traction along the surface in proportion to its pressure, τ = (Ft/Fn) p.
By reciprocity, one solve per magnet motion gives the motions under every traction on every face.

What is left out: the tangential force does not change where the tip presses (uncoupled contact,
exact for the pressure on an incompressible half-space; Johnson, Contact Mechanics, 1985, section
7.1), and a tip that sticks spreads its traction otherwise, with the same resultant.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np
import scipy.sparse as sp
from jaxtyping import Float

from design.errors import InputError
from design.layout.body import face_frames
from design.layout.places.contact_grid import PlaceGrid, contact_grid
from design.layout.places.contact_places import contact_places
from design.netcdf import FileKind, read_netcdf, write_netcdf
from design.spec.object import ObjectSpec
from fem.linear.factorization import Factorization
from fem.linear.response import ElasticSystem, ResponseOperator, elastic_system, face_pressure_loads
from fem.linear.sparse import columns_of, rows_of, shape_of
from fem.mesh.tetrahedra import TetMesh
from fem.presses.results import ShearMotions
from fem.presses.table import press_places, surface_weights_mm2

_LEAST_FORCE_N = 1e-9
"""Force that stands for 0 where it divides."""
_SHEAR = FileKind(
    "tangential motions",
    {
        "motion_per_n": (
            "face place step tangent magnet component",
            "mm/N mm/N mm/N rad/N rad/N rad/N",
        ),
        "grid_x_mm": ("ix", "mm"),
        "grid_y_mm": ("iy", "mm"),
    },
    coordinates={"face": ("face", ""), "depth_mm": ("step", "mm"), "tangent": ("tangent", "")},
)


def simulate_shear(
    spec: ObjectSpec,
    response: ResponseOperator,
    per_traction: Float[np.ndarray, "vertex 2 component"],
) -> ShearMotions:
    """Tangential forces at the contact locations, at the pressures of frictionless presses.

    `per_traction` comes from `motions_under_traction`.

    Raises
    ------
    InputError
        A core that slides or has slipped (superposition fails there), a curved face, or a tip over
        the border.
    """
    if spec.mechanics.interface != "bonded" or spec.mechanics.slip.slipped:
        raise InputError(
            "tangential forces are simulated on a bonded core that has not slipped. Set "
            "mechanics.interface = 'bonded' and leave mechanics.slip out"
        )
    if not all(frame.flat for frame in face_frames(spec)):
        raise InputError(
            f"tangential forces are simulated on flat faces only; body.kind is {spec.body.kind!r}. "
            "Leave shear out, or choose a body of flat faces"
        )
    grid, depths = contact_grid(spec), np.asarray(spec.press.depths_mm)
    faces = []
    for index, (surface, has_place) in enumerate(
        zip(response.surfaces, contact_places(spec), strict=True)
    ):
        pressures = press_places(spec, response, index, grid.xy_mm[has_place], depths)
        force = pressures @ surface_weights_mm2(surface)
        share = pressures / np.maximum(force, _LEAST_FORCE_N)[..., None]
        here = per_traction[response.face_loads(index)]
        motion = share.reshape(-1, here.shape[0]) @ here.reshape(here.shape[0], -1)
        motion = motion.reshape(len(pressures), len(depths), 2, -1, 6)
        faces.append(np.full((len(grid), *motion.shape[1:]), np.nan))
        faces[-1][has_place] = motion
    numbers = np.array([surface.number for surface in response.surfaces])
    return ShearMotions(numbers, grid, depths, np.stack(faces))


def motions_under_traction(
    mesh: TetMesh, spec: ObjectSpec
) -> Float[np.ndarray, "vertex 2 component"]:
    """Every magnet's motions (mm, rad) per MPa of a unit P1 traction at each face vertex.

    Vertices run face by face as in the response operator; tractions along the face's x, then y.
    """
    system = elastic_system(mesh, spec)
    motions, count = shape_of(system.motion_basis)[1], 6 * mesh.magnets
    loads = system.motion_basis.T @ _tangential_loads(system, spec)
    right_sides = np.zeros((shape_of(system.matrix)[0], count))
    right_sides[:motions] = np.eye(motions, count, count - motions)  # the last motions are theirs
    with Factorization(system.matrix) as factor:
        adjoint = factor.solve(right_sides)[:motions]
    return np.asarray(loads.T @ adjoint).reshape(2, -1, adjoint.shape[1]).swapaxes(0, 1)


def _tangential_loads(system: ElasticSystem, spec: ObjectSpec) -> sp.csr_matrix:
    """Nodal forces of unit P1 tractions along x of every face's vertices, then along y.

    The pressure loads hold ∫ φ_i v dA times −n; dotted with −n they give it back.
    """
    surfaces, inward = face_pressure_loads(system.space, spec)
    nodes, first = shape_of(inward)[0] // 3, 0
    loads_by_axis: dict[str, list[sp.csr_matrix]] = {"x": [], "y": []}
    for frame, surface in zip(face_frames(spec), surfaces, strict=True):
        columns = sp.csc_matrix(inward)[:, first : first + len(surface.xy_mm)]
        first += len(surface.xy_mm)
        moments = sum(-n * columns[a * nodes : (a + 1) * nodes] for a, n in enumerate(frame.normal))
        for name, axis in (("x", frame.x), ("y", frame.y)):
            loads_by_axis[name].append(rows_of([component * moments for component in axis]))
    return columns_of([columns_of(loads_by_axis["x"]), columns_of(loads_by_axis["y"])])


def save_shear(shear: ShearMotions, path: Path | str) -> None:
    """Write as NetCDF with units."""
    values = {
        "motion_per_n": shear.motion_per_n,
        "grid_x_mm": shear.grid.x_mm,
        "grid_y_mm": shear.grid.y_mm,
        "face": shear.faces,
        "depth_mm": shear.depth_mm,
        "tangent": ["x", "y"],
    }
    write_netcdf(_SHEAR, path, values)


def load_shear(path: Path | str) -> ShearMotions:
    """Read what `save_shear` wrote.

    Raises
    ------
    InputError
        No such file.
    StoreError
        Damaged, or of another schema.
    """
    values, _ = read_netcdf(_SHEAR, path)
    grid = PlaceGrid(values["grid_x_mm"], values["grid_y_mm"])
    return ShearMotions(values["face"], grid, values["depth_mm"], values["motion_per_n"])
