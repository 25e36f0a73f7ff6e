"""Boards and axes of chips of faces that are held at once.

Jaws press two faces together, so that "who answers when a face is pressed" says nothing. The places do:
a board goes to the face whose predicted presses its chips follow. The null exchanges the places among the
presses and repeats the whole search. Boards of faces that nobody presses stay unknown.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float
from scipy.optimize import linear_sum_assignment

from design.layout.body import face_frames
from design.spec.object import ObjectSpec
from estimator.adoption.arrangement import SPREAD_MM, bell_motion
from estimator.adoption.convention import TURNS
from estimator.adoption.findings import CERTAIN, Finding, numbers_text, share_as_high
from estimator.adoption.presses import ForeignPresses
from estimator.field.models import magnets_model
from estimator.recordings.formats.files import places_mm
from estimator.signals.field_setup import min_distance_mm, scene, sensed_field, zero_motion

EXCHANGES = 99
_DEPTH_MM = 2.0
"""Travel of a jaw: a size that all presses share does not matter."""
_ASIDE, _TILT = 0.3, 1.0
"""Motion aside per radius of the bell, and tilt over the bell's slope."""


@dataclass(frozen=True)
class Boards:
    """Face → chips of its board (counted from 0), turn of their axes, mean cosine and its null."""

    chips_of_face: dict[int, list[int]]
    turn: Float[np.ndarray, "3 3"]
    cosine: float
    null: Float[np.ndarray, "exchange"]

    @property
    def p(self) -> float:
        """Share of exchanges that agree as well."""
        return share_as_high(self.null.tolist(), self.cosine)

    def findings(self, axes: str) -> list[Finding]:
        """Say which board is which face's, if that beats its null."""
        is_certain = self.p <= CERTAIN
        boards = "; ".join(
            f"face {face}: chips {numbers_text([c + 1 for c in chips])}"
            for face, chips in self.chips_of_face.items()
        )
        return [
            Finding(
                "boards of the faces held",
                f"{boards}; {axes}" if is_certain else "cannot be told",
                f"cosine with predicted presses {self.cosine:.2f}",
                f"{np.median(self.null):.2f}",
                self.p,
            )
        ]


def boards_of_faces(spec: ObjectSpec, presses: ForeignPresses, seed: int = 0) -> Boards:
    """Find the boards of the faces pressed, chips of a board next to each other in the designed order."""
    per_board = spec.sensors.count_per_face
    whole = presses.change.shape[1] // per_board * per_board
    recorded = presses.change[:, :whole].reshape(len(presses), -1, per_board, 3)
    tips = presses.place.shape[1] // presses.face.shape[1]
    place = presses.place.reshape(len(presses), -1, tips)
    faces = [int(face) for face in np.unique(presses.face) if face > 0]
    predicted = _predicted(spec, presses.face, place, faces)
    score = _agreement(recorded, predicted)
    boards, turn, cosine = _assigned(score)
    rng = np.random.default_rng((seed, 61))
    null = []
    for _ in range(EXCHANGES):
        order = rng.permutation(len(presses))
        null.append(_assigned(_agreement(recorded, predicted[order]))[2])
    chips = {
        face: list(range(board * per_board, (board + 1) * per_board))
        for face, board in zip(faces, boards, strict=True)
    }
    return Boards(chips, turn, cosine, np.array(null))


def _predicted(
    spec: ObjectSpec, face: np.ndarray, place: np.ndarray, faces: list[int]
) -> Float[np.ndarray, "press face chip 3"]:
    """Changes of the chips of every face pressed, under bells about all tips (T)."""
    design = scene(spec)
    movers = design.sensors.position_mm if design.sensors_move else design.magnets.centre_mm
    motion = np.zeros((len(face), design.bodies, 6))
    xy = places_mm(place)
    for frame in face_frames(spec):
        movers_of_face = np.flatnonzero(design.body_face == frame.number)
        local = frame.from_object(movers[movers_of_face])[:, :2]
        for contact in range(face.shape[1]):
            here = np.flatnonzero(face[:, contact] == frame.number)
            for tip in range(place.shape[2]):
                tip_xy = xy[here, contact, tip]
                travel = np.where(np.isfinite(tip_xy[:, 0]), _DEPTH_MM / place.shape[2], 0.0)
                motion[np.ix_(here, movers_of_face)] += bell_motion(
                    local, frame.axes, np.nan_to_num(tip_xy), travel, SPREAD_MM, _ASIDE, _TILT
                )
    model = magnets_model(spec.magnets, min_distance_mm(design, motion))
    change = sensed_field(design, motion, model) - sensed_field(design, zero_motion(design), model)
    # T along each chip's axes: s sensor, j coordinate, i chip axis, n press
    chip_field = np.einsum("sij,nsj->nsi", design.sensors.axes, change)
    return np.stack([chip_field[:, design.sensors.face == number] for number in faces], axis=1)


def _agreement(
    recorded: Float[np.ndarray, "press board chip 3"],
    predicted: Float[np.ndarray, "press face chip 3"],
) -> Float[np.ndarray, "turn face board"]:
    """Mean cosine over the presses of every board as every face, under every turn of the axes."""
    unit_changes = np.nan_to_num(recorded)
    unit_changes = unit_changes / np.maximum(
        np.linalg.norm(unit_changes, axis=(2, 3), keepdims=True), 1e-12
    )
    size = np.linalg.norm(predicted, axis=(2, 3), keepdims=True)
    wanted = predicted / np.maximum(size, 1e-30)
    # n press, f face, b board, c chip, i recorded axis, j designed axis
    product = np.einsum("nbci,nfcj->fbij", unit_changes, wanted) / len(unit_changes)
    turns = np.array([*TURNS, *(-turn for turn in TURNS)])
    return np.einsum("fbij,tij->tfb", product, turns)


def _assigned(score: Float[np.ndarray, "turn face board"]) -> tuple[list[int], np.ndarray, float]:
    """Return the board of every face and the turn with the largest mean cosine."""
    turns, best = [*TURNS, *(-turn for turn in TURNS)], None
    for turn, table in zip(turns, score, strict=True):
        face, board = linear_sum_assignment(-table)
        cosine = float(table[face, board].mean())
        if best is None or cosine > best[2]:
            best = (board.tolist(), turn, cosine)
    assert best is not None
    return best
