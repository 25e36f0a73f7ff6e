"""Error of `instobj.sim.HallObject` against joint contact mechanics, by the distance of contacts.

    python benchmarks/simulated_errors.py [SPEC] [--pairs N]

Tips of the specification's indenter on its faces (default: the paper's cube), 0.6 to 2.4 mm deep, each
at two depths. Mechanics with the exact field give the forces and the counts; the simulated object gets
the places and the forces. The error is the root mean square of the difference of both counts over that
of the change. Mechanics and presses come from the store, or are made first.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable
from pathlib import Path

import numpy as np

from design.layout.body import face_frame
from design.spec.object import ObjectSpec
from design.spec_io import load_spec
from fem.presses.joint import Tip, press_path, refined_faces
from instobj.sim import HallObject
from instobj.stages.run import Run
from instobj.store.readers import RESPONSE
from tests.support.mechanics.joint_counts import share_of_error, simulated_changes, solved_changes

PAPER_CUBE = Path(__file__).parents[1] / "examples" / "paper_cube.toml"
DISTANCES_MM = (10.5, 12.5, 15.0, 20.0, 25.0)
DEPTH_MM = (0.6, 2.4)
_PART_OF_PATCH = 0.5
"""Part of a curved patch that is pressed: joint contact refuses presses that leave the patch."""

Draw = Callable[[np.random.Generator], list[Tip]]
"""Function that places the tips of one press."""


def main(path: Path, pairs: int) -> None:
    """Print one line for one contact, two on a face by their distance, and two on two faces."""
    spec = load_spec(path)
    response, hall = Run(spec).read(RESPONSE), HallObject(path, seed=None)
    faces = refined_faces(spec, response)
    drawn = {"one": _anywhere(spec, 1)}
    drawn |= {f"two on a face, {apart:g} mm": _beside(spec, apart) for apart in DISTANCES_MM}
    if len(spec.body.sensed) > 1:
        drawn["two on two faces"] = _anywhere(spec, 2)
    print(f"{spec.name}: states, forces N, error % median, 95 %, largest")
    for name, tips in drawn.items():
        rng, errors, forces = np.random.default_rng(0), [], []
        for _ in range(pairs):
            placed = tips(rng)
            depths = rng.uniform(*DEPTH_MM, (2, len(placed)))
            presses = press_path(spec, response, placed, depths, faces)
            solved = solved_changes(spec, np.array([press.motion for press in presses]))
            for press, change in zip(presses, solved, strict=True):
                errors.append(100 * share_of_error(simulated_changes(hall, press), change))
                forces += press.force_n.tolist()
        middle, high, most = np.percentile(errors, [50, 95, 100])
        print(
            f"{name:22s} {len(errors):4d}  {min(forces):.1f}-{max(forces):.1f}  "
            f"{middle:.2f} {high:.2f} {most:.2f}",
            flush=True,
        )


def _anywhere(spec: ObjectSpec, number: int) -> Draw:
    """Tips on as many different faces."""

    def draw(rng: np.random.Generator) -> list[Tip]:
        faces = rng.choice(spec.body.sensed, number, replace=False)
        return [_tip(face, rng.uniform(-1, 1, 2) * _half_mm(spec, face)) for face in faces]

    return draw


def _beside(spec: ObjectSpec, apart_mm: float) -> Draw:
    """Two tips on one face, so far apart in any direction."""

    def draw(rng: np.random.Generator) -> list[Tip]:
        face, turn = rng.choice(spec.body.sensed), rng.uniform(0, 2 * np.pi)
        half = apart_mm / 2 * np.array([np.cos(turn), np.sin(turn)])
        middle = rng.uniform(-1, 1, 2) * (_half_mm(spec, face) - abs(half))
        return [_tip(face, middle + half), _tip(face, middle - half)]

    return draw


def _half_mm(spec: ObjectSpec, face: int) -> np.ndarray:
    frame = face_frame(spec, int(face))
    return np.array(frame.half_lengths_mm) * (1.0 if frame.flat else _PART_OF_PATCH)


def _tip(face: int, xy_mm: np.ndarray) -> Tip:
    return Tip(int(face), *xy_mm.tolist())


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description="errors of the simulated object")
    parser.add_argument("spec", type=Path, nargs="?", default=PAPER_CUBE)
    parser.add_argument(
        "--pairs", type=int, default=100, help="placements of a line, two states each"
    )
    options = parser.parse_args()
    main(options.spec, options.pairs)
