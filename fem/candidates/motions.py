"""Motions of all places where a magnet could sit, under presses of the magnet-free shell.

A layout search moves magnets thousands of times: it needs what each press does at any point of the
silicone, without mechanics. A candidate moves as one rigid magnet there would in the field of the
silicone without it (`fem.candidates.rigid_body`); pressures are those of the magnet-free shell. What the
others round it add is given by the strain that each of them resists (`fem.candidates.influence`).
"""

from __future__ import annotations

from dataclasses import dataclass, fields
from pathlib import Path

import numpy as np
from jaxtyping import Bool, Float, Float32, Int

from design.errors import InputError
from design.files import atomic_path
from design.layout.body import face_frame, face_frames
from design.layout.places.contact_grid import PlaceGrid
from design.layout.pockets import shell_bodies
from design.spec.object import ObjectSpec
from fem.candidates.cubic_convolution import axis_weights

MOTIONS_FILE = "candidate_motions.npy"
MM_PER_RAD = 4.0
"""Weight of rotations compared with displacements: both then change a magnet's field about alike."""
_TABLE_FILE = "candidates.npz"
_PITCH_MM = 2.0
"""Largest distance of candidates along a face."""
_DEPTH_STEP_MM = 1.0
"""Largest distance of candidates in depth."""
_MARGIN_MM = 1.5
"""Silicone between the candidates and either skin of the shell."""
_RIM_POINTS = 24
"""Points on a magnet's rim at which it may stand out of a curved face."""


@dataclass(frozen=True)
class FaceCandidates:
    """Candidate places of one face: x, y along it and depth below it, regular in each.

    As contact locations, x and y are lengths along the surface from the face's middle
    (`FaceFrame.to_plane`); on flat faces those in its frame. Candidate (ix, iy, iz) of the face has
    index (ix · ny + iy) · nz + iz.
    """

    face: int
    x_mm: Float[np.ndarray, "nx"]
    y_mm: Float[np.ndarray, "ny"]
    depth_mm: Float[np.ndarray, "nz"]

    @property
    def shape(self) -> tuple[int, int, int]:
        return len(self.x_mm), len(self.y_mm), len(self.depth_mm)

    @property
    def xyd_mm(self) -> Float[np.ndarray, "candidate 3"]:
        """(x, y, depth) of every candidate."""
        mesh = np.meshgrid(self.x_mm, self.y_mm, self.depth_mm, indexing="ij")
        return np.stack(mesh, axis=-1).reshape(-1, 3)

    def __len__(self) -> int:
        return int(np.prod(self.shape))


@dataclass(frozen=True)
class Influence:
    """Motion (c, ω) of a magnet, mm and rad, for each strain round another (`STRAINS` of
    `fem.candidates.rigid_body`), in a frame whose x points from that one to it along the face and whose z
    is the face's normal.

    `values` by depth of the other and of its own, both at `depth_mm`, and by their distance along the face,
    `first_mm` and then in steps of `step_mm`; none at the last and beyond.
    """

    depth_mm: Float[np.ndarray, "depth"]
    first_mm: float
    step_mm: float
    values: Float32[np.ndarray, "depth depth distance 6 5"]


@dataclass(frozen=True)
class CandidateMotions:
    """Motions under every press at every candidate of every face.

    `by_candidate` (candidate, face, mode, 6): displacement (mm) and rotation (rad) in the object's frame, for
    each mode of the pressed face; candidates run face by face as in `candidates`; memory-mapped where it
    was loaded. A layout gathers few candidates of all presses, hence the order. `presses`: what each press
    has of the modes; their number does not grow with that of presses. Steps are presses to
    `force_n` (N), at `depth_mm`, of places in `places`, the lattice of presses: two for each judged force;
    NaN, and motions 0, at places that a face has not. `deepest_n`: force of the deepest simulated press
    of the shell without magnets. `strain`: round candidates in their own frames, for each mode of the face
    that they lie under; others near them are moved by it (`influence`).
    """

    faces: Int[np.ndarray, "face"]
    places: PlaceGrid
    force_n: Float[np.ndarray, "face place step"]
    depth_mm: Float[np.ndarray, "face place step"]
    deepest_n: Float[np.ndarray, "face place"]
    candidates: tuple[FaceCandidates, ...]
    by_candidate: Float32[np.ndarray, "candidate face mode 6"]
    presses: Float32[np.ndarray, "face place step mode"]
    jeffery_parameter: float
    """Share of strain that turns magnets: `RigidBody.jeffery_parameter`."""
    strain: Float32[np.ndarray, "candidate mode 5"]
    influence: Influence

    def steps_around(self, force_n: float) -> list[int]:
        """The pair of steps of the judged force nearest to `force_n`; one force has all steps.

        A place that cannot be loaded so far counts with the places that can.
        """
        if self.force_n.shape[2] < 4:
            return [0, self.force_n.shape[2] - 1]
        middle = np.nanmax(self.force_n, axis=(0, 1)).reshape(-1, 2).mean(axis=1)
        nearest = int(abs(middle - force_n).argmin())
        return [2 * nearest, 2 * nearest + 1]

    def weights(
        self, face: int, xyd_mm: Float[np.ndarray, "magnet 3"]
    ) -> tuple[Int[np.ndarray, "magnet 64"], Float[np.ndarray, "magnet 64"]]:
        """Rows of `by_candidate` and their weights: tricubic convolution, once differentiable.

        Raises
        ------
        InputError
            A place outside the candidates of the face, or a face without any.
        """
        numbers = [lattice.face for lattice in self.candidates]
        if face not in numbers:
            raise InputError(f"face {face} has no candidates. Choose one of {numbers}")
        faces_before = self.candidates[: numbers.index(face)]
        lattice = self.candidates[numbers.index(face)]
        return _tricubic(lattice, xyd_mm, sum(len(face_lattice) for face_lattice in faces_before))


def candidate_lattices(
    spec: ObjectSpec,
    pitch_mm: float = _PITCH_MM,
    depth_step_mm: float = _DEPTH_STEP_MM,
    margin_mm: float = _MARGIN_MM,
) -> tuple[FaceCandidates, ...]:
    """Regular places up to a pocket's radius, or half a board, from the borders, `margin_mm` off both skins.

    `pitch_mm` and `depth_step_mm` are the largest distances wanted. The paper's cube: 19 × 19
    places, depths 1.5 to 6.5 mm, on each of five faces. What of a lattice's corners lies beyond a
    round patch says `known_places`.

    Raises
    ------
    InputError
        A shell too thin, or a face too small, for the margins; or so curved a face that a magnet
        would stand out of it.
    """
    deepest = spec.shell.thickness_mm - margin_mm
    widest = max(spec.shell.pocket_diameter_mm / 2, *shell_bodies(spec)[0][0].outline.half_mm)
    lattices = []
    for frame in face_frames(spec):
        reach = np.array(frame.half_extents_mm) - widest
        if min(*reach, deepest - margin_mm) <= 0:
            raise InputError(
                f"face {frame.number} has no room for candidates: reach {min(reach):g} mm, depths "
                f"{margin_mm:g} to {deepest:g} mm. Use a smaller margin_mm than {margin_mm:g}, or a "
                "larger body"
            )
        ends = frame.from_plane(np.stack([-reach, reach]))
        x, y = (_regular(float(ends[0, k]), float(ends[1, k]), pitch_mm) for k in (0, 1))
        lattice = FaceCandidates(frame.number, x, y, _regular(margin_mm, deepest, depth_step_mm))
        require_below_the_surface(spec, lattice)
        lattices.append(lattice)
    return tuple(lattices)


def known_places(spec: ObjectSpec, lattice: FaceCandidates) -> Bool[np.ndarray, "nx ny"]:
    """Candidates whose magnet lies under its patch: all but those in the corners of a round one."""
    frame = face_frame(spec, lattice.face)
    places = np.stack(np.meshgrid(lattice.x_mm, lattice.y_mm, indexing="ij"), axis=-1)
    beside = shell_bodies(spec)[0][0].outline.radius_mm
    return frame.covers(abs(frame.to_plane(places)) + beside)


def middle_of(
    spec: ObjectSpec, lattice: FaceCandidates
) -> tuple[Float[np.ndarray, "2"], Float[np.ndarray, "3 3"]]:
    """Place in the face's plane of the candidate nearest to its middle, and its axes as columns."""
    frame, is_known = face_frame(spec, lattice.face), known_places(spec, lattice)
    away = np.hypot(*np.meshgrid(lattice.x_mm, lattice.y_mm, indexing="ij"))
    ix, iy = np.unravel_index(int(np.where(is_known, away, np.inf).argmin()), is_known.shape)
    plane = frame.to_plane(np.array([[lattice.x_mm[ix], lattice.y_mm[iy]]]))
    return plane[0], frame.axes if frame.flat else frame.axes_at(plane)[0]


def stands_out_mm(spec: ObjectSpec, lattice: FaceCandidates) -> float:
    """Return how far the mid-plane of a magnet at the least depth stands out of its face where it does most;
    below 0 for the silicone over it."""
    frame = face_frame(spec, lattice.face)
    if frame.flat:
        return -float(lattice.depth_mm[0])
    first = shell_bodies(spec)[0][0]
    x, y = np.meshgrid(lattice.x_mm, lattice.y_mm, indexing="ij")
    plane = frame.to_plane(np.stack([x, y], axis=-1)[known_places(spec, lattice)])
    turn = np.linspace(0, 2 * np.pi, _RIM_POINTS, endpoint=False)
    rim = first.outline.radius_mm * np.stack([np.cos(turn), np.sin(turn), 0 * turn], axis=-1)
    centre = frame.to_object(np.column_stack([plane, np.full(len(plane), -lattice.depth_mm[0])]))
    # p place, r point of the rim, j own axis (columns), i object coordinate
    points = centre[:, None] + np.einsum("pij,rj->pri", frame.axes_at(plane), rim)
    return float(np.nanmax(frame.from_object(points)[..., 2]))


def require_below_the_surface(spec: ObjectSpec, lattice: FaceCandidates) -> None:
    out = stands_out_mm(spec, lattice)
    if out > 0:
        raise InputError(
            f"face {lattice.face} is so curved that a magnet {lattice.depth_mm[0]:g} mm deep stands "
            f"{out:.2g} mm out of it somewhere. Take smaller magnets, or leave the face out with "
            "body.sensed_faces"
        )


def save_candidates(motions: CandidateMotions, folder: Path | str) -> None:
    """Write all but `MOTIONS_FILE`, which `simulate_candidates` fills itself."""
    arrays: dict[str, np.ndarray] = {
        "faces": motions.faces,
        "place_x_mm": motions.places.x_mm,
        "place_y_mm": motions.places.y_mm,
        "force_n": motions.force_n,
        "depth_mm": motions.depth_mm,
        "deepest_n": motions.deepest_n,
        "presses": motions.presses,
        "candidate_faces": np.array([lattice.face for lattice in motions.candidates]),
        "turns_with_plane": np.array(motions.jeffery_parameter),
        "strain": motions.strain,
    }
    arrays |= {f"influence_{f.name}": getattr(motions.influence, f.name) for f in fields(Influence)}
    for lattice in motions.candidates:
        for name in ("x_mm", "y_mm", "depth_mm"):
            arrays[f"candidate_{name}_{lattice.face}"] = getattr(lattice, name)
    with atomic_path(Path(folder) / _TABLE_FILE) as temporary, temporary.open("wb") as stream:
        np.savez(stream, **arrays)  # pyright: ignore[reportArgumentType]


def load_candidates(folder: Path | str) -> CandidateMotions:
    """Read what `simulate_candidates` left in a folder; the motions are memory-mapped."""
    folder = Path(folder)
    by_candidate = np.load(folder / MOTIONS_FILE, mmap_mode="r", allow_pickle=False)
    with np.load(folder / _TABLE_FILE, allow_pickle=False) as data:
        lattices = tuple(
            FaceCandidates(
                int(face),
                *(data[f"candidate_{name}_{face}"] for name in ("x_mm", "y_mm", "depth_mm")),
            )
            for face in data["candidate_faces"]
        )
        return CandidateMotions(
            data["faces"],
            PlaceGrid(data["place_x_mm"], data["place_y_mm"]),
            data["force_n"],
            data["depth_mm"],
            data["deepest_n"],
            lattices,
            by_candidate,
            data["presses"],
            float(data["turns_with_plane"]),
            data["strain"],
            Influence(
                data["influence_depth_mm"],
                float(data["influence_first_mm"]),
                float(data["influence_step_mm"]),
                data["influence_values"],
            ),
        )


def _regular(first: float, last: float, step: float) -> np.ndarray:
    """Equal steps of at most `step`, three of them at least."""
    return np.linspace(first, last, max(3, int(np.ceil((last - first) / step - 1e-9))) + 1)


def _tricubic(
    lattice: FaceCandidates, xyd_mm: np.ndarray, first: int
) -> tuple[np.ndarray, np.ndarray]:
    axes = (lattice.x_mm, lattice.y_mm, lattice.depth_mm)
    (ix, wx), (iy, wy), (iz, wz) = (
        axis_weights(nodes, xyd_mm[:, k]) for k, nodes in enumerate(axes)
    )
    _, ny, nz = lattice.shape
    index = (ix[:, :, None, None] * ny + iy[:, None, :, None]) * nz + iz[:, None, None, :]
    weight = wx[:, :, None, None] * wy[:, None, :, None] * wz[:, None, None, :]
    return first + index.reshape(len(index), -1), weight.reshape(len(weight), -1)
