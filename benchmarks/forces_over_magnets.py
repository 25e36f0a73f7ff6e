"""Forces of a sphere over and beside magnets by an independent code: NGSolve and Netgen's own geometry.

    python benchmarks/forces_over_magnets.py cube 0 0 --edge 0.45 --order 3

Bodies of the examples, and a box with magnets at three depths; cut at y = 0 where magnets are alike on
both sides. The sphere of R 5 mm lands at (x, y) of a face; round bodies count x along the surface.
Taylor–Hood elements, curved; magnets are 3000 times as stiff as silicone. Pressure is P1 on the surface,
not negative, without friction, and gaps are weak: one factorization, then non-negative least squares.
Nothing is shared with `fem`. Needs `pip install ngsolve scipy`; 10 s to 10 min, by edge and order.
`tests/fem/contact/test_forces_over_magnets.py` holds what it gave.
"""

from __future__ import annotations

import argparse
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np
from scipy.interpolate import RBFInterpolator, RectBivariateSpline
from scipy.optimize import nnls

E_MPA, NU, TIP_MM, SHELL_MM = 0.414, 0.4999, 5.0, 8.0
REACH_MM, STIFFER = 4.6, 3e3
BULK_MM, RIM_MM = 3.0, 0.45
RADIUS_MM, HALF_LENGTH_MM = {"ball": 25.0, "capsule": 22.0}, 16.0
"""Radii of the round bodies; half the straight part of the capsule."""
PEAR = Path(__file__).parents[1] / "examples" / "bodies" / "pear.stl"
MID_MM = 2.5
"""Depth of magnets' mid-planes."""
AZIMUTHS = np.radians(np.linspace(-89, 89, 60))
ELEVATIONS = np.radians(np.linspace(-86, 86, 58))
"""Grid of the pear's splines."""
TOUCHING_MM = 0.1
BORE_MM = 10.0
"""Places of the capsule, along it at +x; 12 mm away from a place it already takes 6 % of the force."""


@dataclass(frozen=True)
class Disc:
    """A magnet: place on the face, depth of its mid-plane, rotation vector about x and y (degrees)."""

    x_mm: float
    y_mm: float
    depth_mm: float = MID_MM
    tilt_deg: tuple[float, float] = (0.0, 0.0)


@dataclass(frozen=True)
class Flat:
    """A flat face: half its edges, its magnets, their diameter and height."""

    half_mm: tuple[float, float]
    discs: tuple[Disc, ...]
    diameter_mm: float = 6.0
    height_mm: float = 1.0
    whole: bool = False


SIDE_MM = (21.0, 21.0)
FLAT = {
    "cube": Flat(SIDE_MM, tuple(Disc(x, y) for x, y in [(0, 0), (10, 10), (-10, 10)])),
    "deep": Flat(SIDE_MM, tuple(Disc(x, y, 4.5) for x, y in [(0, 0), (10, 10), (-10, 10)])),
    "box": Flat((30.0, 23.0), (Disc(0, 0, 2.0), Disc(14, 0, 2.5), Disc(-14, 0, 3.5)), 5.0, 2.0),
    "better_cube": Flat(
        SIDE_MM,
        (
            Disc(8.71, 8.81, 1.61, (1.3, -0.9)),
            Disc(-6.85, -8.86, 4.99, (-4.5, -6.9)),
            Disc(-5.83, -0.41, 5.11, (6.3, 7.1)),
            Disc(-5.58, 10.94, 4.4, (14.7, -4.5)),
            Disc(10.25, -6.52, 4.7, (-2.2, -18.6)),
        ),
        whole=True,
    ),
}
PLACES_MM = {
    "cube": ((0, 0), (3, 0), (5, 0)),
    "deep": ((0, 0), (3, 0), (5, 0)),
    "ball": ((0, 0), (3, 0), (4.5, 0)),
    "capsule": ((0, 0), (3, 0), (5, 0)),
    "box": tuple((x, 0) for x in (0, 2.5, 6, 14, 16.5, 20, -14, -16.5, -20)),
    "better_cube": ((8.71, 8.81), (5.71, 8.81), (3.7, 8.81), (-5.58, 10.94)),
    "pear": ((0, 0), (3, 0), (4.5, 0)),
}


@dataclass(frozen=True)
class Body:
    """Silicone and magnets with the place pressed at the origin, z outward; a point's distances from the
    outer and the core's surface (negative inside); heights of the surface by (x, y) where they are not z."""

    shell: Any
    magnets: list[Any]
    outside_mm: Any
    core_mm: Any
    height_mm: Any = None


def flat_body(face: Flat, x_mm: float, y_mm: float) -> Body:
    """Upper part of a box's shell; it ends 20 mm below its face, free."""
    occ: Any = import_module("netgen.occ")
    point, z = occ.Pnt, occ.Z
    (a, b), far = face.half_mm, 60.0
    inner_a, inner_b = a - SHELL_MM, b - SHELL_MM
    shell = occ.Box(point(-a, -b, -20), point(a, b, 0))
    shell -= occ.Box(point(-inner_a, -inner_b, -20), point(inner_a, inner_b, -SHELL_MM))
    magnets = []
    for one in face.discs:
        disc = occ.Cylinder(
            point(0, 0, -face.height_mm / 2), z, face.diameter_mm / 2, face.height_mm
        )
        angle = float(np.hypot(*one.tilt_deg))
        if angle:
            axis = occ.Axis(point(0, 0, 0), occ.Vec(*one.tilt_deg, 0))
            disc = disc.Rotate(axis, angle)
        magnets.append(disc.Move(occ.Vec(one.x_mm, one.y_mm, -one.depth_mm)))
    if not face.whole:
        half = occ.Box(point(-far, 0, -far), point(far, far, far))
        shell, magnets = shell * half, [m * half for m in magnets]
    move = occ.Vec(-x_mm, -y_mm, 0)

    def core(x: Any, y: Any, z: Any) -> Any:
        beside = np.maximum(abs(x + x_mm) - inner_a, abs(y + y_mm) - inner_b)
        return np.maximum(beside, z + SHELL_MM)

    return Body(shell.Move(move), [m.Move(move) for m in magnets], lambda x, y, z: z, core)


def round_body(kind: str, x_mm: float) -> Body:
    """Half of an example's shell, cut at y = 0; a place beyond a capsule's straight part is on its end."""
    occ: Any = import_module("netgen.occ")
    point, radius = occ.Pnt, RADIUS_MM[kind]
    half = occ.Box(point(-60, 0, -radius - 2 if kind == "ball" else -60), point(60, 60, 60))
    disc = occ.Cylinder(point(0, 0, -3), occ.Z, 3, 1)
    ball = kind == "ball"
    length = 0.0 if ball else HALF_LENGTH_MM
    straight = min(x_mm, length)
    lean = (x_mm - straight) / radius

    def outside(x: Any, y: Any, z: Any) -> Any:
        along, up = x, z + radius
        if not ball:  # turned back by the lean, along the capsule
            along, up = np.cos(lean) * x + np.sin(lean) * up, np.cos(lean) * up - np.sin(lean) * x
            along = along - np.clip(along, -length - straight, length - straight)
        return np.sqrt(along**2 + y**2 + up**2) - radius

    def core(x: Any, y: Any, z: Any) -> Any:
        return outside(x, y, z) + SHELL_MM

    if ball:
        centre = point(0, 0, -radius)
        middle = occ.Axis(centre, occ.Y)
        # magnets' places are told in the face's plane, 9 mm beside its middle
        turns = np.degrees([0.0, np.arcsin(9 / radius), -np.arcsin(9 / radius)])
        shell = occ.Sphere(centre, radius) * half - occ.Sphere(centre, radius - SHELL_MM)
        place = -float(np.degrees(x_mm / radius))
        discs = [(disc.Rotate(middle, t) * half).Rotate(middle, place) for t in turns.tolist()]
        return Body(shell.Rotate(middle, place), discs, outside, core)

    def capsule(r: float) -> Any:
        ends = [point(s * length, 0, -radius) for s in (-1, 1)]
        side = occ.Cylinder(ends[0], occ.X, r, 2 * length)
        return side + occ.Sphere(ends[0], r) + occ.Sphere(ends[1], r)

    axis, degrees = occ.Axis(point(0, 0, -radius), occ.Y), -float(np.degrees(lean))

    def placed(part: Any) -> Any:
        return part.Move(occ.Vec(-straight, 0, 0)).Rotate(axis, degrees)

    bore = occ.Cylinder(point(length, 0, -radius), occ.X, BORE_MM / 2, 2 * radius)
    shell = capsule(radius) * half - capsule(radius - SHELL_MM) - bore
    magnets = [placed(disc.Move(occ.Vec(x, 0, 0)) * half) for x in (0, 10, -10)]
    return Body(placed(shell), magnets, outside, core)


class Star:
    """Distance from the origin over azimuth and elevation, as a spline through points of a surface."""

    def __init__(self, points_mm: np.ndarray):
        distance = np.linalg.norm(points_mm, axis=1)
        scattered = RBFInterpolator(points_mm / distance[:, None], distance, neighbors=40)
        self.grid = np.meshgrid(AZIMUTHS, ELEVATIONS, indexing="ij")
        found = scattered(directions(*self.grid).reshape(-1, 3)).reshape(self.grid[0].shape)
        self.distance_mm = RectBivariateSpline(AZIMUTHS, ELEVATIONS, found)

    def beyond_mm(self, points_mm: np.ndarray) -> np.ndarray:
        """Return how much farther from the origin points lie than the surface."""
        x, y, z = points_mm.T
        radius = np.linalg.norm(points_mm, axis=1)
        return radius - self.distance_mm.ev(np.arctan2(y, x), np.arcsin(z / radius))

    def points_and_normals(self, azimuth: np.ndarray, elevation: np.ndarray) -> tuple[Any, Any]:
        """Points of the surface and outward normals, by differences."""

        def points(azimuth: np.ndarray, elevation: np.ndarray) -> np.ndarray:
            distance = self.distance_mm.ev(azimuth, elevation)
            return distance[..., None] * directions(azimuth, elevation)

        step = 1e-5
        along = points(azimuth + step, elevation) - points(azimuth - step, elevation)
        up = points(azimuth, elevation + step) - points(azimuth, elevation - step)
        normal = np.cross(along, up)
        normal /= np.linalg.norm(normal, axis=-1, keepdims=True)
        return points(azimuth, elevation), normal

    def solid(self) -> Any:
        """Return what lies inside the surface on the side +x."""
        occ: Any = import_module("netgen.occ")
        face = occ.SplineSurfaceInterpolation(self.points_and_normals(*self.grid)[0])
        return face.Extrude(occ.Vec(-60, 0, 0))


def directions(azimuth: np.ndarray, elevation: np.ndarray) -> np.ndarray:
    """Unit vectors."""
    flat = np.cos(elevation)
    return np.stack([flat * np.cos(azimuth), flat * np.sin(azimuth), np.sin(elevation)], axis=-1)


def pear_body(x_mm: float) -> Body:
    """Half of the pear's side +x, cut at y = 0; its core lies 8 mm below the surface.

    Elastic on the smooth surface, pressed on the file's triangles, up to 0.03 mm below it.
    """
    occ: Any = import_module("netgen.occ")
    content = np.frombuffer(
        PEAR.read_bytes()[84:], np.dtype([("n", "<3f4"), ("v", "<9f4"), ("a", "<u2")])
    )
    corners = content["v"].reshape(-1, 3).astype(float)
    corners -= (corners.min(axis=0) + corners.max(axis=0)) / 2
    outer = Star(np.unique(corners.round(6), axis=0))
    points, normals = (found.reshape(-1, 3) for found in outer.points_and_normals(*outer.grid))
    core = Star(points - SHELL_MM * normals)
    half = occ.Box(occ.Pnt(3, 0, -60), occ.Pnt(60, 60, 60))
    shell = outer.solid() * half - core.solid()
    elevations = np.linspace(-0.7, 0.7, 4001)
    profile, leans = outer.points_and_normals(np.zeros(4001), elevations)

    def on_profile(z: float) -> tuple[Any, Any]:
        at = int(np.argmin(abs(profile[:, 2] - z)))
        return profile[at], leans[at]

    # the face's x is -z; lengths along the profile count from z = 0
    length = np.append(0, np.cumsum(np.linalg.norm(np.diff(profile, axis=0), axis=1)))
    middle = float(np.interp(0.0, profile[:, 2], length))
    place, normal = on_profile(float(np.interp(middle - x_mm, length, profile[:, 2])))
    magnets = []
    for x in (0.0, 8.5, -8.5):
        point, axis = on_profile(-x)
        low = occ.Pnt(*(point - (MID_MM + 0.5) * axis).tolist())
        magnets.append(occ.Cylinder(low, occ.Vec(*axis.tolist()), 3, 1) * half)
    turn = occ.Axis(occ.Pnt(0, 0, 0), occ.Y)
    # the place's normal becomes z: a turn about y by minus its angle from z
    angle = -float(np.degrees(np.arctan2(normal[0], normal[2])))
    back = np.array([np.cross([0.0, 1, 0], normal), [0.0, 1, 0], normal])

    def object_mm(x: Any, y: Any, z: Any) -> Any:
        return place + np.column_stack([x, y, z]) @ back

    triangles = ((corners - place) @ back.T).reshape(-1, 3, 3)
    triangles = triangles[
        (abs(triangles[..., :2]) < 2 * TIP_MM).all((1, 2)) & (triangles[..., 2] > -TIP_MM).all(1)
    ]

    def height_mm(x: np.ndarray, y: np.ndarray) -> np.ndarray:
        return heights_mm(triangles, x, y) - heights_mm(triangles, np.zeros(1), np.zeros(1))

    def moved(shape: Any) -> Any:
        return shape.Move(occ.Vec(*(-place).tolist())).Rotate(turn, angle)

    return Body(
        moved(shell),
        [moved(m) for m in magnets],
        lambda x, y, z: outer.beyond_mm(object_mm(x, y, z)),
        lambda x, y, z: core.beyond_mm(object_mm(x, y, z)),
        height_mm,
    )


def heights_mm(triangles_mm: np.ndarray, x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Greatest z of triangles (n, corner, 3) at places."""
    a, b, c = (triangles_mm[:, k] for k in range(3))
    turn = (b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]
    dx, dy = x[:, None] - a[:, 0], y[:, None] - a[:, 1]
    second = (dx * (c - a)[:, 1] - dy * (c - a)[:, 0]) / turn
    third = (dy * (b - a)[:, 0] - dx * (b - a)[:, 1]) / turn
    inside = (second > -1e-9) & (third > -1e-9) & (second + third < 1 + 1e-9)
    z = a[:, 2] + second * (b - a)[:, 2] + third * (c - a)[:, 2]
    return np.where(inside, z, -np.inf).max(axis=1)


def mesh_of(kind: str, x_mm: float, y_mm: float, edge_mm: float) -> tuple[Any, Any]:
    """Curved mesh with the place pressed at the origin, boundaries named top, held, cut; its heights."""
    occ: Any = import_module("netgen.occ")
    netgen: Any = import_module("netgen.meshing")
    if kind in FLAT:
        body = flat_body(FLAT[kind], x_mm, y_mm)
    else:
        body = pear_body(x_mm) if kind == "pear" else round_body(kind, x_mm)
    shell = body.shell
    for magnet in body.magnets:
        shell = shell - magnet
        magnet.mat("magnet")
        for rim in magnet.edges:
            rim.maxh = RIM_MM
    shell.mat("silicone")
    wanted = netgen.MeshingParameters(maxh=BULK_MM, grading=0.35)
    around = 2 if is_whole(kind) else 1
    for r in (0.0, 1.2, 2.4, 3.2):
        for angle in np.linspace(0, around * np.pi, around * max(2, int(4 * r) + 2)):
            at = (r * np.cos(angle), r * np.sin(angle), -0.02)
            wanted.RestrictH(x=at[0], y=at[1], z=at[2], h=edge_mm * (1.3 if r > 3 else 1.0))
    mesh = occ.OCCGeometry(occ.Glue([shell, *body.magnets])).GenerateMesh(wanted)
    points = np.array([p.p for p in mesh.Points()])
    of_face: dict[int, list[int]] = {}
    for element in mesh.Elements2D():
        of_face.setdefault(element.index, []).extend(v.nr - 1 for v in element.vertices)
    for index, vertices in of_face.items():
        mesh.SetBCName(index - 1, _name(body, is_whole(kind), points[vertices]))
    curved = import_module("ngsolve").Mesh(mesh)
    curved.Curve(3)
    return curved, body.height_mm


def is_whole(kind: str) -> bool:
    """Return whether the body is not cut at y = 0."""
    return kind in FLAT and FLAT[kind].whole


def _name(body: Body, whole: bool, points: np.ndarray) -> str:
    """By the distance of a face's vertices from the outer and the core's surface."""
    x, y, z = points.T
    if not whole and abs(y).max() < 1e-6:
        return "cut"
    if abs(body.outside_mm(x, y, z)).max() < TOUCHING_MM:
        return "top"
    return "held" if abs(body.core_mm(x, y, z)).max() < TOUCHING_MM else "free"


def forces_n(
    mesh: Any, height_mm: Any, depths_mm: np.ndarray, order: int, halves: int
) -> np.ndarray:
    """Force of the sphere at each depth, of all halves of the body."""
    ng: Any = import_module("ngsolve")
    mu, lam = E_MPA / 2 / (1 + NU), E_MPA * NU / (1 + NU) / (1 - 2 * NU)
    stiff = mesh.MaterialCF({"magnet": STIFFER}, default=1.0)
    space = ng.VectorH1(
        mesh, order=order, dirichlet="held", dirichlety="cut" if halves == 2 else ""
    ) * ng.H1(mesh, order=order - 1)
    (u, p), (v, q) = space.TnT()
    strain = ng.InnerProduct(ng.Sym(ng.Grad(u)), ng.Sym(ng.Grad(v)))
    matrix = ng.BilinearForm(space, symmetric=True)
    matrix += (
        2 * mu * stiff * strain - p * ng.div(v) - q * ng.div(u) - p * q / (lam * stiff)
    ) * ng.dx
    inverse = matrix.Assemble().mat.Inverse(space.FreeDofs(), inverse="sparsecholesky")
    normal, top = ng.specialcf.normal(3), ng.ds("top", bonus_intorder=2)
    hats = ng.H1(mesh, order=1, definedon=mesh.Boundaries("top"))
    pressure, test = hats.TnT()
    load = ng.BilinearForm(trialspace=hats, testspace=space)
    load += -pressure * (v * normal) * top
    load = load.Assemble().mat
    points = np.array([mesh.vertices[k].point for k in range(mesh.nv)])
    on_top = np.array([hats.FreeDofs()[k] for k in range(mesh.nv)])
    near = (np.hypot(*points[:, :2].T) < REACH_MM) & (points[:, 2] > -SHELL_MM / 2)
    (chosen,) = np.nonzero(on_top & near)
    unit, given, moved = ng.GridFunction(hats), *(space_vector(ng, space) for _ in range(2))
    answer, compliance = unit.vec.CreateVector(), np.zeros((len(chosen),) * 2)
    for column, vertex in enumerate(chosen.tolist()):
        unit.vec[:] = 0
        unit.vec[vertex] = 1.0
        given.data = load * unit.vec
        moved.data = inverse * given
        answer.data = load.T * moved
        compliance[:, column] = answer.FV().NumPy()[chosen]

    def moments(value: Any) -> np.ndarray:
        form = ng.LinearForm(hats)
        form += value * test * ng.ds("top", bonus_intorder=6)
        return form.Assemble().vec.FV().NumPy()[chosen].copy()

    surface = ng.z
    if height_mm is not None:
        surface = ng.GridFunction(hats)
        surface.vec.FV().NumPy()[chosen] = height_mm(*points[chosen, :2].T)
    # along the surface's normal a gap along z is shorter by the normal's z
    square = TIP_MM**2 - ng.x**2 - ng.y**2
    gap = TIP_MM - ng.sqrt(ng.IfPos(square, square, 0)) - surface
    upright, lifted = moments(normal[2]), moments(gap * normal[2])
    lower = np.linalg.cholesky((compliance + compliance.T) / 2)
    pressures = [
        nnls(lower.T, np.linalg.solve(lower, depth * upright - lifted), maxiter=20000)[0]
        for depth in depths_mm
    ]
    return np.array([halves * one @ upright for one in pressures])


def space_vector(ng: Any, space: Any) -> Any:
    """A vector of a space's unknowns."""
    return ng.GridFunction(space).vec.CreateVector()


def main() -> None:
    """Command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("kind", choices=tuple(PLACES_MM))
    parser.add_argument("xy_mm", type=float, nargs="*", help="left out: over, on the rim, beside")
    parser.add_argument("--edge", type=float, default=0.35, help="under the tip, mm")
    parser.add_argument("--order", type=int, default=2, help="of displacements")
    options = parser.parse_args()
    try:
        import_module("ngsolve").SetNumThreads(1)
    except ImportError:
        parser.exit(2, "NGSolve is not installed: pip install ngsolve\n")
    depths, halves = np.array([0.5, 1.0, 2.0, 3.0]), 2 - is_whole(options.kind)
    for x, y in [options.xy_mm] if options.xy_mm else PLACES_MM[options.kind]:
        made = mesh_of(options.kind, x, y, options.edge)
        found = forces_n(*made, depths, options.order, halves)
        told = ", ".join(f"{d:g} mm: {f:.3f} N" for d, f in zip(depths, found, strict=True))
        print(f"{options.kind} at ({x:g}, {y:g}) mm: {told}", flush=True)


if __name__ == "__main__":
    main()
