"""The table of all presses, by phases and against slower ways to the same numbers."""

from __future__ import annotations

import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
import scipy.sparse as sp
from harness import peak_memory_gb

from design.layout.places.contact_grid import contact_grid
from design.layout.places.positions import magnet_layout
from design.spec.object import MeshSpec, ObjectSpec
from fem.linear.factorization import Factorization
from fem.linear.response import (
    ElasticSystem,
    ResponseOperator,
    build_response,
    elastic_system,
    face_pressure_loads,
    load_response,
    save_response,
)
from fem.linear.sparse import shape_of
from fem.mesh.tetrahedra import TetMesh, tetrahedralize
from fem.presses.table import press_face

DEPTHS_MM = np.linspace(0.2, 4.0, 20)
STENCIL_EDGES = 3
"""Vertices beyond the tip whose hat functions stand for its cells: rings of the surface mesh."""
QUICK_MESH = MeshSpec(edge_mm=6.0, surface_edge_mm=2.4)


def table(quick: bool) -> dict[str, Any]:
    """Phases from specification to finished table, then the slower ways, extrapolated.

    All three ways press the same places with the same tip on the same mesh, with the same contact
    iteration; the slower two do a few presses, and their time for the table is that of one press
    times the number of presses.
    """
    spec = ObjectSpec(name="cube", mesh=QUICK_MESH if quick else MeshSpec())
    seconds: dict[str, float] = {}
    with _phase(seconds, "mesh"):
        mesh = tetrahedralize(spec)
    with _phase(seconds, "assemble"):
        system = elastic_system(mesh, spec)
    with _phase(seconds, "assemble, factor, condense"):
        response = build_response(mesh, spec)
    seconds["factor, condense"] = seconds.pop("assemble, factor, condense") - seconds["assemble"]
    with _phase(seconds, "contact at 5 × 100 places × 20 depths"):
        force, motion = _table_by_operator(spec, response)
    with tempfile.TemporaryDirectory() as folder:
        with _phase(seconds, "write the operator"):
            save_response(response, Path(folder))
        start = time.perf_counter()
        _table_by_operator(spec, load_response(Path(folder)), places=slice(0, 1))
        stored = time.perf_counter() - start
    peak = peak_memory_gb()
    ways = _slower_ways(spec, mesh, system, force, motion, 1 if quick else 3)
    total = sum(seconds.values())
    presses = force.size
    return {
        "nodes": int(system.space.node_count),
        "unknowns": int(response.unknowns),
        "loads": len(response.compliance),
        "presses": presses,
        "phases_s": seconds,
        "total_s": total,
        "one_press_of_each_face_from_store_s": stored,
        "peak_gb": peak,
        "ways": {
            name: {
                **way,
                "table_s": way["press_s"] * presses,
                "ratio": way["press_s"] * presses / total,
            }
            for name, way in ways.items()
        },
    }


@contextmanager
def _phase(seconds: dict[str, float], name: str) -> Iterator[None]:
    start = time.perf_counter()
    yield
    seconds[name] = time.perf_counter() - start


def _table_by_operator(
    spec: ObjectSpec, response: ResponseOperator, places: slice = slice(None)
) -> tuple[np.ndarray, np.ndarray]:
    """Force (face, place, step) and motions (face, place, step, 6·magnet)."""
    xy = contact_grid(spec).xy_mm[places]
    force, motion = [], []
    for index in range(len(response.surfaces)):
        pressed = press_face(spec, response, index, xy, DEPTHS_MM)
        rows = response.compliance[response.magnet_loads, response.face_loads(index)]
        force.append(pressed.force_n)
        motion.append(pressed.vertex_mpa @ rows.T)
    return np.array(force), np.array(motion)


def _slower_ways(
    spec: ObjectSpec,
    mesh: TetMesh,
    system: ElasticSystem,
    force: np.ndarray,
    motion: np.ndarray,
    presses: int,
) -> dict[str, dict[str, float]]:
    """Seconds a press (one place, one depth), and agreement with the table, of both other ways."""
    independent = [
        _press_alone(spec, mesh, place, step, force, motion)
        for place, step in [(0, 19), (44, 9), (57, 4)][:presses]
    ]
    places = range(0, 100, 25 if presses == 1 else 10)
    with Factorization(system.matrix) as factor:
        start = time.perf_counter()
        differences = [
            _press_with(factor, spec, system, place, DEPTHS_MM, force, motion) for place in places
        ]
        forward = (time.perf_counter() - start) / (len(places) * len(DEPTHS_MM))
    return {
        "one independent solve per press": {
            "press_s": float(np.median([seconds for seconds, _ in independent])),
            "measured_presses": len(independent),
            "largest_difference": max(difference for _, difference in independent),
        },
        "one factorization, forward solves": {
            "press_s": forward,
            "measured_presses": len(places) * len(DEPTHS_MM),
            "largest_difference": max(differences),
        },
    }


def _press_alone(
    spec: ObjectSpec, mesh: TetMesh, place: int, step: int, force: np.ndarray, motion: np.ndarray
) -> tuple[float, float]:
    """Assemble, factor, solve for the vertices near the tip, find the contact at one depth."""
    start = time.perf_counter()
    system = elastic_system(mesh, spec)
    with Factorization(system.matrix) as factor:
        depth = DEPTHS_MM[step : step + 1]
        at = force[:, :, step : step + 1], motion[:, :, step : step + 1]
        difference = _press_with(factor, spec, system, place, depth, *at)
    return time.perf_counter() - start, difference


def _press_with(
    factor: Factorization,
    spec: ObjectSpec,
    system: ElasticSystem,
    place: int,
    depths_mm: np.ndarray,
    force: np.ndarray,
    motion: np.ndarray,
) -> float:
    """One place of face 1 through forward solves; the largest relative difference to the table."""
    surfaces, tractions = face_pressure_loads(system.space, spec)
    centre = contact_grid(spec).xy_mm[place : place + 1]
    surface, magnets = surfaces[0], 6 * len(magnet_layout(spec).face)
    reach = spec.indenter.radius_mm + STENCIL_EDGES * spec.mesh.surface_edge_mm
    near = np.flatnonzero(np.linalg.norm(surface.xy_mm - centre, axis=1) < reach)
    loads = (system.motion_basis.T @ sp.csc_matrix(tractions)[:, near]).toarray()
    padded = np.zeros((shape_of(system.matrix)[0], len(near)))
    padded[: len(loads)] = loads
    motions = factor.solve(padded)[: len(loads)]
    vertices = len(surface.xy_mm)
    compliance = np.zeros((vertices + magnets, vertices + magnets))
    compliance[np.ix_(near, near)] = loads.T @ motions
    face = ResponseOperator((surface,), compliance, len(padded), -1)
    pressed = press_face(spec, face, 0, centre, depths_mm)
    moved = pressed.vertex_mpa[0][:, near] @ motions[-magnets:].T
    off_force = abs(pressed.force_n[0] - force[0, place]).max() / force[0, place].max()
    off_motion = abs(moved - motion[0, place]).max() / abs(motion[0, place]).max()
    return float(max(off_force, off_motion))
