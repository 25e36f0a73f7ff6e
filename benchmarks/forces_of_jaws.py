"""Forces and magnets' motions under jaws, pads, cylinders and fingertips, by NGSolve beside `fem`.

    python benchmarks/forces_of_jaws.py reference --edge 1.6 --save jaws.json
    python benchmarks/forces_of_jaws.py compare benchmarks/references/jaws.json
    python benchmarks/forces_of_jaws.py draw docs/presses_jaws.png

The reference: shells of the paper's cube and of a box with magnets at three depths, half of each (y ≥ 0);
Taylor–Hood elements, magnets 3000 times as stiff. Hat functions of pressure on the face under the indenter
are condensed, and contact is solved by non-negative least squares. A pad is an elastic block of its own, on
its own mesh, bonded to a rigid back; its sides are free. Nothing is shared with `fem`. Needs `pip install
ngsolve scipy`; 2 to 5 min a case. `compare` needs instobj instead, and takes 3 min on meshes of its own.
"""

from __future__ import annotations

import argparse
import json
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np
from scipy.optimize import nnls

E_MPA, NU, SHELL_MM, LOW_MM, CORE_END_MM = 0.414, 0.4999, 8.0, 42.0, 34.0
"""The core ends at 34 mm: below it the cavity's walls are free."""
BULK_MM, RIM_MM, FAR_MM = 4.0, 1.2, 60.0
DEPTHS_MM = (0.5, 1.0, 2.0)
AROUND = ((10, 10), (-10, 10), (-10, -10), (10, -10))
HALF_MM = {"cube": (21.0, 21.0), "box": (30.0, 23.0)}
JAW = {"kind": "cuboid", "size_mm": (60.0, 60.0)}
SMALL = {"size_mm": (24.0, 24.0)}
CASES: dict[str, tuple[dict[str, Any], float]] = {
    "jaw over the whole face": (JAW, 0.0),
    "jaw hanging over by half": (JAW, 30.0),
    "jaw 24 mm wide inside the face": (JAW | SMALL, 0.0),
    "jaw tilted by 2°": (JAW | {"turn_deg": (0.0, 0.0, 2.0)}, 0.0),
    "pad, ν 0.3": (JAW | {"pad": (3.0, 1.0, 0.3)}, 0.0),
    "pad, ν 0.45": (JAW | {"pad": (3.0, 1.0, 0.45)}, 0.0),
    "pad, ν 0.495": (JAW | {"pad": (3.0, 1.0, 0.495)}, 0.0),
    "pad 24 mm wide, ν 0.3": (JAW | SMALL | {"pad": (3.0, 1.0, 0.3)}, 0.0),
    "pad 24 mm wide, ν 0.45": (JAW | SMALL | {"pad": (3.0, 1.0, 0.45)}, 0.0),
    "cylinder across": (
        {"kind": "cylinder", "radius_mm": 8.0, "size_mm": (80.0, 10.0), "turn_deg": (90.0, 0.0, 0.0)}, 0.0
    ),
    "cylinder along, over the border": (
        {"kind": "cylinder", "radius_mm": 8.0, "size_mm": (40.0, 10.0)}, 15.0
    ),
    "fingertip": ({"kind": "ellipsoid", "size_mm": (24.0, 16.0), "radius_mm": 8.0}, 3.0),
}  # fmt: skip
"""Indenter, and x of the place pressed on face 1 (y = 0)."""


def box_mm(half_mm: tuple[float, float], low_mm: float, high_mm: float) -> Any:
    """The part y ≥ 0 of a box."""
    occ: Any = import_module("netgen.occ")
    return occ.Box(occ.Pnt(-half_mm[0], 0, low_mm), occ.Pnt(half_mm[0], half_mm[1], high_mm))


def magnets_of(body: str) -> list[tuple[np.ndarray, Any]]:
    """Centre and solid of every magnet, of which y ≥ 0 is kept."""
    occ: Any = import_module("netgen.occ")
    half = occ.Box(occ.Pnt(-FAR_MM, 0, -FAR_MM), occ.Pnt(FAR_MM, FAR_MM, FAR_MM))
    if body == "box":
        placed = [(np.array([x, 0.0, -d]), occ.Z) for x, d in ((0, 2.0), (14, 2.5), (-14, 3.5))]
        radius, height = 2.5, 2.0
    else:
        radius, height, middle = 3.0, 1.0, 18.5
        cross = [(0, 0), *AROUND]
        placed = [(np.array([x, y, -2.5]), occ.Z) for x, y in cross]
        placed += [
            (np.array([side * middle, y, z - 21.0]), occ.X) for side in (-1, 1) for y, z in cross
        ]
        placed += [(np.array([x, middle, z - 21.0]), occ.Y) for x, z in cross]
    magnets = []
    for centre, axis in placed:
        if centre[1] < 0:
            continue
        way = np.array([axis.x, axis.y, axis.z])
        low = occ.Pnt(*(centre - height / 2 * way).tolist())
        magnets.append((centre, occ.Cylinder(low, axis, radius, height) * half))
    return magnets


def mesh_of(body: str, indenter: dict[str, Any], x_mm: float, edge_mm: float) -> Any:
    """Half a shell, the face split along the outline of a jaw; its boundary "jaw" is what may touch."""
    occ, netgen = import_module("netgen.occ"), import_module("netgen.meshing")
    half = HALF_MM[body]
    inner = (half[0] - SHELL_MM, half[1] - SHELL_MM)
    shell = box_mm(half, -LOW_MM, 0) - box_mm(inner, -LOW_MM, -SHELL_MM)
    magnets = magnets_of(body)
    for index, (_, magnet) in enumerate(magnets):
        shell = shell - magnet
        magnet.mat(f"magnet{index}")
        for rim in magnet.edges:
            rim.maxh = RIM_MM
    low, high, across = pressed_mm(body, indenter, x_mm)
    column = occ.Box(occ.Pnt(low, 0, -SHELL_MM / 2), occ.Pnt(high, across, 1))
    foot = box_mm((FAR_MM, FAR_MM), -LOW_MM, -CORE_END_MM)
    parts = [shell - column - foot, shell * column, shell * foot]
    for part in parts:
        part.mat("silicone")
    wanted = netgen.MeshingParameters(maxh=BULK_MM, grading=0.35)
    for x in np.arange(low, high + 1e-6, edge_mm / 2):
        for y in np.arange(0, across + 1e-6, edge_mm / 2):
            wanted.RestrictH(x=x, y=y, z=-0.01, h=edge_mm)
    whole = occ.Glue([*parts, *(magnet for _, magnet in magnets)])
    mesh = occ.OCCGeometry(whole).GenerateMesh(wanted)
    points = np.array([p.p for p in mesh.Points()])
    vertices: dict[int, list[int]] = {}
    for element in mesh.Elements2D():
        vertices.setdefault(element.index, []).extend(v.nr - 1 for v in element.vertices)
    for index, own in vertices.items():
        mesh.SetBCName(index - 1, _name(points[own], inner, (low, high, across)))
    return import_module("ngsolve").Mesh(mesh)


def pressed_mm(body: str, indenter: dict[str, Any], x_mm: float) -> tuple[float, float, float]:
    """Lowest and highest x and highest y of the face under an indenter."""
    half = HALF_MM[body]
    wide = {"cuboid": np.array(indenter.get("size_mm", (0, 0))) / 2}.get(indenter["kind"])
    if wide is None:  # what is deeper than 2.2 mm below a round one
        radius, reach = indenter["radius_mm"], 2.6
        section = np.sqrt(1 - (1 - reach / radius) ** 2)
        if indenter["kind"] == "ellipsoid":
            wide = np.array(indenter["size_mm"]) / 2 * section
        else:
            wide = np.array([indenter["size_mm"][0] / 2, radius * section])
            wide = wide[::-1] if indenter.get("turn_deg", (0.0,))[0] else wide
    ends = np.clip([x_mm - wide[0], x_mm + wide[0]], -half[0], half[0])
    return float(ends[0]), float(ends[1]), float(min(wide[1], half[1]))


def _name(
    points: np.ndarray, inner: tuple[float, float], pressed: tuple[float, float, float]
) -> str:
    x, y, z = points.T
    if abs(y).max() < 1e-6:
        return "cut"
    if abs(z).max() < 1e-6:
        inside = x.min() > pressed[0] - 1e-6 and x.max() < pressed[1] + 1e-6
        return "jaw" if inside and y.max() < pressed[2] + 1e-6 else "free"
    core = np.maximum(np.maximum(abs(x) - inner[0], y - inner[1]), z + SHELL_MM)
    beside_core = abs(core).max() < 0.1 and z.min() > -CORE_END_MM - 1e-6
    return "held" if beside_core else "free"


class Condensed:
    """Compliance of hats of pressure on a boundary, motions of magnets, and moments of the hats."""

    def __init__(
        self, mesh: Any, boundary: str, way: float, elastic: tuple[float, float], magnets: int
    ):
        from ngsolve_shell import shell_system

        ng: Any = import_module("ngsolve")
        space, v, inverse, means = shell_system(mesh, magnets, *elastic, "cut")
        self.mesh, self.hats = mesh, ng.H1(mesh, order=1, definedon=mesh.Boundaries(boundary))
        free = self.hats.FreeDofs()
        self.vertices = np.array([k for k in range(mesh.nv) if free[k]])
        self.xy_mm = np.array([mesh.vertices[k].point[:2] for k in self.vertices.tolist()])
        trial, _ = self.hats.TnT()
        load = ng.BilinearForm(trialspace=self.hats, testspace=space)
        load += way * trial * v[2] * ng.ds(boundary)
        load = load.Assemble().mat
        self.boundary = boundary
        unit, given, moved = (
            ng.GridFunction(self.hats).vec,
            *(ng.GridFunction(space).vec for _ in "ab"),
        )
        work, compliance, motion = ng.GridFunction(self.hats).vec, [], []
        for vertex in self.vertices.tolist():
            unit[:] = 0
            unit[vertex] = 1.0
            given.data = load * unit
            moved.data = inverse * given
            work.data = load.T * moved
            compliance.append(work.FV().NumPy()[self.vertices].copy())
            motion.append(np.array(means) @ moved.FV().NumPy() if means else np.zeros(0))
        matrix = np.array(compliance)
        self.compliance, self.motion = (matrix + matrix.T) / 2, np.array(motion).T

    def moments(self, value: Any) -> np.ndarray:
        """∫ hat · value over the boundary."""
        ng: Any = import_module("ngsolve")
        form = ng.LinearForm(self.hats)
        form += value * self.hats.TestFunction() * ng.ds(self.boundary, bonus_intorder=6)
        return form.Assemble().vec.FV().NumPy()[self.vertices].copy()

    def weights_at(self, xy_mm: np.ndarray) -> np.ndarray:
        """Values of all hats at points of the boundary (point, hat)."""
        mesh, where = self.mesh, {v: k for k, v in enumerate(self.vertices.tolist())}
        ng: Any = import_module("ngsolve")
        corners = np.array(
            [
                [where[v.nr] for v in element.vertices]
                for element in mesh.Boundaries(self.boundary).Elements()
            ]
        )
        assert ng is not None
        a, b, c = (self.xy_mm[corners[:, k]] for k in range(3))
        turn = (b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]
        values = np.zeros((len(xy_mm), len(self.vertices)))
        for row, point in enumerate(xy_mm):
            d = point - a
            second = (d[:, 0] * (c - a)[:, 1] - d[:, 1] * (c - a)[:, 0]) / turn
            third = ((b - a)[:, 0] * d[:, 1] - (b - a)[:, 1] * d[:, 0]) / turn
            share = np.column_stack([1 - second - third, second, third])
            best = int(share.min(axis=1).argmax())
            values[row, corners[best]] = share[best]
        return values


def gap_of(indenter: dict[str, Any], x_mm: float, low_mm: float) -> Any:
    """Height of an indenter above what is lowest over the face; `low_mm` is the lowest x under it."""
    ng: Any = import_module("ngsolve")
    x, y, kind = ng.x - x_mm, ng.y, indenter["kind"]
    if kind == "cuboid":
        angle = np.radians(indenter.get("turn_deg", (0.0, 0.0, 0.0))[2])
        far = x_mm + indenter["size_mm"][0] / 2 * np.cos(angle)
        first = min(far, HALF_NOW[0])  # positive tilts take +x down
        return (first - ng.x) * float(np.tan(angle))
    radius = indenter["radius_mm"]
    if kind == "cylinder":
        across = x if indenter.get("turn_deg", (0.0,))[0] else y
        square = 1 - across**2 / radius**2
    else:
        a, b = (edge / 2 for edge in indenter["size_mm"])
        square = 1 - x**2 / a**2 - y**2 / b**2
    return radius * (1 - ng.sqrt(ng.IfPos(square, square, 0)))


HALF_NOW = [0.0, 0.0]


def reference(body: str, name: str, edge_mm: float, known: dict[Any, Any]) -> dict[str, Any]:
    """Forces (N) and magnets' motions (mm) at each depth of one case."""
    indenter, x_mm = CASES[name]
    HALF_NOW[:] = HALF_MM[body]
    pressed = pressed_mm(body, indenter, x_mm)
    magnets = magnets_of(body)
    if (body, pressed) not in known:
        mesh = mesh_of(body, indenter, x_mm, edge_mm)
        known[body, pressed] = Condensed(mesh, "jaw", -1.0, (E_MPA, NU), len(magnets))
    face = known[body, pressed]
    compliance = face.compliance
    if "pad" in indenter:
        compliance = compliance + _pad(face, indenter, x_mm, edge_mm)
    gap, area = face.moments(gap_of(indenter, x_mm, pressed[0])), face.moments(1.0)
    lower = np.linalg.cholesky(compliance)
    forces, motions, touched = [], [], []
    for depth in DEPTHS_MM:
        right = np.linalg.solve(lower, depth * area - gap)
        pressure = nnls(lower.T, right, maxiter=50000)[0]
        forces.append(2 * float(pressure @ area))
        touched.append(2 * float(area[pressure > 0].sum()))
        motions.append((face.motion @ pressure).reshape(-1, 3).round(6).tolist())
    return {
        "indenter": indenter,
        "x_mm": x_mm,
        "force_n": forces,
        "contact_mm2": touched,
        "centre_mm": [centre.tolist() for centre, _ in magnets],
        "motion_mm": motions,
        "hats": len(area),
    }


def _pad(face: Condensed, indenter: dict[str, Any], x_mm: float, edge_mm: float) -> np.ndarray:
    """Compliance of the pad to the face's hats: pressures are handed on at the pad's own vertices."""
    occ, netgen = import_module("netgen.occ"), import_module("netgen.meshing")
    (thickness, *elastic), half = indenter["pad"], np.array(indenter["size_mm"]) / 2
    low, high, across = face.xy_mm[:, 0].min(), face.xy_mm[:, 0].max(), face.xy_mm[:, 1].max()
    whole = occ.Box(occ.Pnt(x_mm - half[0], 0, 0), occ.Pnt(x_mm + half[0], half[1], thickness))
    column = occ.Box(occ.Pnt(low, 0, 0), occ.Pnt(high, across, thickness))
    beside = whole - column
    solids = [whole * column, *([beside] if beside.mass > 1e-9 else [])]
    edge = min(edge_mm, thickness / 2)
    wanted = netgen.MeshingParameters(maxh=edge, grading=0.35)
    mesh = occ.OCCGeometry(occ.Glue(solids)).GenerateMesh(wanted)
    points = np.array([p.p for p in mesh.Points()])
    vertices: dict[int, list[int]] = {}
    for element in mesh.Elements2D():
        vertices.setdefault(element.index, []).extend(v.nr - 1 for v in element.vertices)
    for index, own in vertices.items():
        x, y, z = points[own].T
        name = "cut" if abs(y).max() < 1e-6 else "free"
        name = "held" if abs(z - thickness).max() < 1e-6 else name
        under = abs(z).max() < 1e-6 and x.min() > low - 1e-6 and x.max() < high + 1e-6
        name = "jaw" if under and y.max() < across + 1e-6 else name
        mesh.SetBCName(index - 1, name)
    pad = Condensed(import_module("ngsolve").Mesh(mesh), "jaw", 1.0, tuple(elastic), 0)
    handed = face.weights_at(pad.xy_mm)
    return handed.T @ pad.compliance @ handed


def compare(wanted: dict[str, Any]) -> dict[str, Any]:
    """Errors of `fem` on its default mesh against a reference: force, and motions over the largest."""
    from design.spec.object import IndenterSpec, ObjectSpec
    from fem.linear.response import build_response
    from fem.mesh.tetrahedra import tetrahedralize
    from tests.support.objects.magnet_box import BOX

    specs = {"cube": ObjectSpec(name="cube"), "box": BOX}
    errors: dict[str, Any] = {}
    for body, spec in specs.items():
        response = build_response(tetrahedralize(spec), spec)
        for name, cases in wanted.get(body, {}).items():
            indenter, x_mm = CASES[name]
            pressed = spec.changed(indenter=IndenterSpec(**indenter))
            errors.setdefault(body, {})[name] = case_errors(pressed, response, x_mm, cases)
            print(body, name, errors[body][name], flush=True)
    return errors


def case_errors(spec: Any, response: Any, x_mm: float, wanted: dict[str, Any]) -> dict[str, Any]:
    """Relative errors of force and of motions at each depth, in per cent."""
    from design.layout.places.positions import shell_body_layout
    from fem.presses.joint import Tip, press_path

    ours = shell_body_layout(spec).centre_mm - [0, 0, 21.0]
    # rows of the reference's magnets among ours
    away = np.linalg.norm(ours[:, None] - np.array(wanted["centre_mm"]), axis=2)
    rows = away.argmin(axis=0)
    assert away.min(axis=0).max() < 0.01
    presses = press_path(spec, response, [Tip(1, x_mm, 0.0)], np.array(DEPTHS_MM)[:, None])
    force, motion = [], []
    for press, force_n, there in zip(presses, wanted["force_n"], wanted["motion_mm"], strict=True):
        force.append(round(100 * (float(press.force_n[0]) / force_n - 1), 2))
        off = np.linalg.norm(press.motion[rows, :3] - there, axis=1).max()
        motion.append(round(100 * off / np.linalg.norm(there, axis=1).max(), 2))
    return {"force_percent": force, "motion_percent": motion}


DRAWN: dict[str, tuple[dict[str, Any], float]] = {
    "jaw of 60 mm": (JAW, 0.0),
    "tilted by 2°": (JAW | {"turn_deg": (0.0, 0.0, 2.0)}, 0.0),
    "half over the border": (JAW, 30.0),
    "pad of 3 mm, 1 MPa": (JAW | {"pad": (3.0, 1.0, 0.3)}, 0.0),
    "cylinder, R 8 mm": CASES["cylinder along, over the border"],
    "fingertip with a skin": (CASES["fingertip"][0] | {"pad": (2.0, 0.3, 0.48)}, 5.0),
}


def draw(path: Path) -> None:
    """Pressure on face 1 of the paper's cube, 1 mm deep, and centres of pressure."""
    from matplotlib.collections import PatchCollection
    from matplotlib.figure import Figure
    from matplotlib.patches import Rectangle

    from design.spec.object import IndenterSpec, ObjectSpec
    from fem.contact.complementarity import contact_pressures
    from fem.linear.response import build_response
    from fem.mesh.tetrahedra import tetrahedralize
    from fem.presses.joint import Tip, joint_cells, press_tips

    spec = ObjectSpec(name="cube")
    response, depth = build_response(tetrahedralize(spec), spec), np.ones(1)
    figure = Figure(figsize=(10, 6.6), layout="constrained")
    for axes, (name, (indenter, x_mm)) in zip(
        figure.subplots(2, 3).flat, DRAWN.items(), strict=True
    ):
        pressed, tip = spec.changed(indenter=IndenterSpec(**indenter)), Tip(1, x_mm, 0.0)
        cells = joint_cells(pressed, response, [tip], depth, None)
        moments, area = cells.gap_mm * cells.area_mm2, cells.area_mm2
        pressure = contact_pressures(cells.compliance, moments, area, depth)[0]
        touched = np.flatnonzero(pressure > 0)
        # cells as squares of their own area; an edge of their colour closes hairlines between them
        squares = PatchCollection(
            [
                Rectangle(centre - edge / 2, edge, edge)
                for centre, edge in zip(
                    cells.spreads[0].in_plane.centre_mm[touched],
                    np.sqrt(area[touched]),
                    strict=True,
                )
            ],
            cmap="viridis",
            edgecolor="face",
            linewidth=0.6,
        )
        squares.set_array(1e3 * pressure[touched])
        squares.set_clim(0, 1e3 * float(np.quantile(pressure[touched], 0.98)))
        marks = axes.add_collection(squares)
        press = press_tips(pressed, response, [tip], depth)
        assert press.centre_mm is not None
        centre = press.centre_mm[0] + [x_mm, 0.0]
        axes.plot(*centre, "x", color="#d1495b", ms=9, mew=2)
        axes.add_patch(Rectangle((-21, -21), 42, 42, fill=False, color="#555555", lw=1))
        axes.set(xlim=(-23, 23), ylim=(-23, 23), aspect="equal")
        axes.set_title(f"{name}: {press.force_n[0]:.3g} N", fontsize=10)
        figure.colorbar(marks, ax=axes, label="pressure (kPa)", shrink=0.85)
    figure.supxlabel("x on face 1 (mm)")
    figure.supylabel("y (mm)")
    figure.savefig(path, dpi=110)


def main() -> None:
    """Command line."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("what", choices=("reference", "compare", "draw"))
    parser.add_argument(
        "file", type=Path, nargs="?", help="reference to compare, or picture to draw"
    )
    parser.add_argument("--edge", type=float, default=1.6, help="under the indenter, mm")
    parser.add_argument("--body", choices=tuple(HALF_MM))
    parser.add_argument("--case", choices=tuple(CASES), action="append")
    parser.add_argument("--save", type=Path)
    options = parser.parse_args()
    if options.what == "draw":
        return draw(options.file)
    if options.what == "compare":
        result = compare(json.loads(options.file.read_text()))
    else:
        import_module("ngsolve").SetNumThreads(1)
        result, known = {}, {}
        for body in [options.body] if options.body else HALF_MM:
            for name in options.case or CASES:
                case = reference(body, name, options.edge, known)
                print(body, name, case["hats"], case["force_n"], case["contact_mm2"], flush=True)
                result.setdefault(body, {})[name] = case
                if options.save:
                    options.save.write_text(json.dumps(result, indent=1) + "\n")
    if options.save:
        options.save.write_text(json.dumps(result, indent=1) + "\n")


if __name__ == "__main__":
    main()
