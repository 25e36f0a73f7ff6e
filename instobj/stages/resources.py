"""Memory that a stage will need, and time, estimated from the specification before any work is done.

Estimates are rough: meshes have 0.5 to 2 times the vertices that are estimated here (tested on the
paper's cube and on a small box). They are there to refuse what cannot end, an edge of 0.2 mm or 10⁸
presses, before hours are spent; not to plan the last gigabyte.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from itertools import pairwise
from math import pi, prod, sqrt

from design.errors import InputError
from design.layout.body import face_frames
from design.layout.places.contact_places import contact_places, grid_count, pressed_nodes
from design.layout.places.positions import shell_body_layout
from design.layout.volumes import sealed_volume_mm3
from design.processes import MEMORY_SWITCH, machine_memory_gib
from design.spec.object import ObjectSpec
from estimator.networks.defaults import BATCH_FRAMES
from fem.mesh.edge_lengths import FINE_LAYER_MM

_GIB = 2.0**30
_VERTICES_PER_CELL = 2.2
"""Vertices of fTetWild's mesh in a volume of edge³; measured on the paper's cube."""
_VERTICES_PER_RIM_EDGE = 8
"""About a magnet, for each edge along its outline; they dominate coarse meshes."""
_MESHER_KB = 6.0
"""Within fTetWild, for a vertex; the response needs far more."""
_NODES_PER_VERTEX = {"taylor-hood": 6.8, "p2-p0": 6.8, "p2": 6.8}
_LOADS_PER_CELL = 1.25
"""Face pressures for an area of edge²; measured on the paper's cube."""
_BYTES = 8
_COPIES = 3
"""An array, what it is made from, and a copy on the way to its file."""
_MODES_PER_LOAD, _READ_BY_CANDIDATE = 0.5, 330
"""Modes of a face's presses for each of its loads, and displacements that a candidate's motion is read from:
the paper's cube has 330 modes of 656 loads."""
_ROWS_WHILE_MADE = 4.4
"""Copies of a face's rows in double precision while they are made (600 candidates of a cube)."""
_ADAM_COPIES = 4
"""Weights, gradients and two moments."""
_LARGEST_SHARE = 0.9
_CUBE_NODES = 71_000
_MESH_S, _CURVED_MESH_S = 2e-3, 8e-3
"""A vertex: the paper's cube took 15 to 28 s, the pear 73 s."""
_RESPONSE_S, _SOLVE_S = 35.0, 0.03
"""Seconds of the paper's cube: the response, and one pattern of pressure at all candidates."""
_PATTERNS_PER_LOAD = 0.75
"""Presses to three forces on every place of the cube's lattice are made of 466 to 482 for each face's 660."""


@dataclass(frozen=True)
class Need:
    """Memory of a stage, and the keys that bring it down."""

    gib: float
    keys: str


def require_memory(stage: str, spec: ObjectSpec, available_gib: float | None = None) -> None:
    """Refuse a stage that needs more memory than this machine has.

    Raises
    ------
    InputError
        With the estimate and the keys to change.
    """
    estimate = _ESTIMATES.get(stage)
    have = machine_memory_gib() if available_gib is None else available_gib
    if estimate is None or have is None:
        return
    need = estimate(spec)
    if need.gib > _LARGEST_SHARE * have:
        raise InputError(
            f"the stage {stage} of {spec.name} needs about {need.gib:.3g} GiB of memory; this machine "
            f"has {have:.3g}. Change {need.keys}; or set {MEMORY_SWITCH} to what may be used"
        )


def needed_gib(stage: str, spec: ObjectSpec) -> float:
    """Estimated memory of a stage, 0 where it is small."""
    estimate = _ESTIMATES.get(stage)
    return estimate(spec).gib if estimate else 0.0


def mesh_vertices(spec: ObjectSpec) -> float:
    """Vertices of the mesh: fine under the skin, coarser to mid-shell, coarse below.

    Within a factor of two, but for small bodies with edges about as long as the shell is thick: a dome of
    36 mm with edges of 3 and 7 mm has 880 vertices, 2.6 times as many (with those of its example 1.0 times).
    """
    volume = sealed_volume_mm3(spec)
    fine, coarse = spec.mesh.surface_edge_mm, spec.mesh.edge_mm
    area, ramp = volume / spec.shell.thickness_mm, spec.shell.thickness_mm / 2
    graded = ramp * (fine + coarse) / (2 * fine**2 * coarse**2)  # ∫ dz / h(z)³ of a linear h
    below = max(volume - area * (FINE_LAYER_MM + ramp), 0.0)
    cells = area * (FINE_LAYER_MM / fine**3 + graded) + below / coarse**3
    layout = shell_body_layout(spec)
    outlines_mm = sum(2 * sqrt(pi * body.outline.area_mm2) for body in layout.bodies)
    return (
        _VERTICES_PER_CELL * cells + _VERTICES_PER_RIM_EDGE * outlines_mm / spec.mesh.finest_edge_mm
    )


@dataclass(frozen=True)
class SearchSeconds:
    """Processor time of a layout search's mechanics: `lowest` level from nothing, presses of all places of
    the lattice at two shares of every judged force; `chain`, mesh and response of one layout."""

    lowest: float
    chain: float


def search_seconds(spec: ObjectSpec) -> SearchSeconds:
    """Seconds on one core of the machine of docs/measured/benchmarks.md, rough: it took 0.5 to
    0.7 times as long on the paper's cube and a box, with other programs running; no other body was tried."""
    vertices = mesh_vertices(spec)
    nodes = _NODES_PER_VERTEX[spec.mechanics.element] * vertices
    curved = not all(frame.flat for frame in face_frames(spec))
    mesh = (_CURVED_MESH_S if curved else _MESH_S) * vertices
    response = _RESPONSE_S * (nodes / _CUBE_NODES) ** 1.5
    presses = 2 * len(spec.pressed_forces_n) * int(pressed_nodes(spec).sum())
    patterns = min(presses, _PATTERNS_PER_LOAD * _face_loads(spec))
    solves = patterns * _SOLVE_S * (nodes / _CUBE_NODES) ** 1.25
    return SearchSeconds(mesh + 1.5 * response + solves, mesh + response)


def _mesh(spec: ObjectSpec) -> Need:
    return Need(_MESHER_KB * mesh_vertices(spec) * 1e3 / _GIB, _MESH_KEYS)


def _response(spec: ObjectSpec) -> Need:
    nodes = _NODES_PER_VERTEX[spec.mechanics.element] * mesh_vertices(spec)
    factor = 0.37 * (nodes / 9261) ** 1.15  # benchmarks/mechanics.py: 9 000 to 301 000 nodes
    return Need(factor + 2 * _BYTES * _face_loads(spec) ** 2 / _GIB, _MESH_KEYS)


def _candidates(spec: ObjectSpec) -> Need:
    from fem.candidates.motions import candidate_lattices  # loads sparse matrices

    faces, count = len(spec.body.sensed), sum(map(len, candidate_lattices(spec)))
    modes = _MODES_PER_LOAD * _face_loads(spec) / faces
    # six motions of single precision: of all faces' presses, and three copies of one face's
    motions = _BYTES / 2 * 6 * count * modes * (faces + _COPIES)
    # rows of six motions and five strains, in single precision, and their columns
    rows = _BYTES / 2 * (11 + 1) * count * _READ_BY_CANDIDATE
    # before there are motions, rows are made in double precision, face by face
    made = _ROWS_WHILE_MADE * _BYTES * 11 * count / faces * _READ_BY_CANDIDATE
    return Need(_response(spec).gib + (rows + max(motions, made)) / _GIB, _MESH_KEYS)


def _face_loads(spec: ObjectSpec) -> float:
    area = sealed_volume_mm3(spec) / spec.shell.thickness_mm
    return _LOADS_PER_CELL * area / spec.mesh.surface_edge_mm**2


def _signals(spec: ObjectSpec) -> Need:
    places = prod(2 * count + 1 for count in grid_count(spec))
    rows = len(spec.body.sensed) * places * len(spec.press.depths_mm)
    return Need(
        _COPIES * _BYTES * rows * 6 * spec.magnets.count * len(spec.body.sensed) / _GIB,
        "contact_grid.count, contact_grid.pitch_mm or press.depths_mm",
    )


def _frames(spec: ObjectSpec) -> Need:
    protocol = spec.protocol
    each = sum(protocol.frames_per_press)
    presses = int(contact_places(spec).sum()) * protocol.presses_per_place
    keys = "protocol.presses_per_place or protocol.frames_per_press"
    return Need(_frames_gib(spec, presses * each), keys)


def _collection(spec: ObjectSpec) -> Need:
    collection, protocol = spec.collection, spec.protocol
    if collection.kind == "continuous":
        each = sum(protocol.frames_per_press)
        frames, keys = collection.presses * each, "collection.presses or protocol.frames_per_press"
    else:
        poses = sum(map(len, collection.poses)) + collection.non_contact_cases
        cases = len(set(collection.faces) & set(spec.body.sensed)) * (
            prod(grid_count(spec)) + poses
        )
        frames, keys = cases * collection.frames_per_case, "collection.frames_per_case"
    return Need(_frames_gib(spec, frames), keys)


def _frames_gib(spec: ObjectSpec, frames: float) -> float:
    channels = 3 * len(spec.body.sensed) * spec.sensors.count_per_face
    return _COPIES * _BYTES * frames * (channels + 12) / _GIB


def _networks(spec: ObjectSpec) -> Need:
    training = spec.training
    channels = 2 * 3 * spec.sensors.count_per_face * len(spec.body.sensed)
    pixels = prod(grid_count(spec))
    widths = (channels, *training.hidden_units, pixels)
    weights = sum(a * b for a, b in pairwise(widths))
    batch = BATCH_FRAMES * sum(widths)
    gib = _BYTES / 2 * (_ADAM_COPIES * weights + 4 * batch) * (training.ensemble or 1) / _GIB
    return Need(gib, "training.hidden_units or training.ensemble")


_MESH_KEYS = "mesh.surface_edge_mm and mesh.edge_mm (larger), or body.size_mm (smaller)"
_ESTIMATES: dict[str, Callable[[ObjectSpec], Need]] = {
    **dict.fromkeys(("mesh", "plain_mesh", "large_strain"), _mesh),
    **dict.fromkeys(("response", "plain_response", "second_fidelity"), _response),
    "candidates": _candidates,
    **dict.fromkeys(("presses", "signals"), _signals),
    **dict.fromkeys(("collection", "pulled_collection"), _collection),
    "frames": _frames,
    "networks": _networks,
}
