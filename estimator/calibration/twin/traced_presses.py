"""Presses of one face of the design at some places, as an object off the design would do them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from jaxtyping import Bool, Float

from design.spec.object import ObjectSpec
from estimator.signals.interpolation import press_traces
from estimator.signals.press_states import ASIDE_MM, SIDES_MM, motions_as_signals, rest_motion
from estimator.tolerances.assembly import Assembly
from fem.large_strain.correction import StrainCorrection, corrected_presses, own_bodies
from fem.presses.results import MagnetMotions, PressForces


@dataclass(frozen=True)
class TracedPresses:
    """Presses at some places, and a little aside for magnets that sit off-centre.

    Attributes
    ----------
    own, normal : the face's bodies, and its outward normal
    rest : (body, 6) motion that is there without a press
    force_n, motion : (side, place, step), (side, place, step, body, 6), rest included
    """

    depth_mm: Float[np.ndarray, "step"]
    on_face: Bool[np.ndarray, "body"]
    normal: Float[np.ndarray, "3"]
    rest: Float[np.ndarray, "body 6"]
    force_n: Float[np.ndarray, "side place step"]
    motion: Float[np.ndarray, "side place step body 6"]

    def assembled(
        self, assembly: Assembly, correction: StrainCorrection
    ) -> tuple[Float[np.ndarray, "place step"], Float[np.ndarray, "place step body 6"]]:
        """Forces and motions of an assembled object with this departure from small strain."""
        forces, motions = corrected_presses(
            correction, self.depth_mm, self.force_n, self.motion, self.on_face, self.normal
        )
        motion = motions[0]
        slopes = (motions[1::2] - motions[2::2])[..., self.on_face, :] / (2 * ASIDE_MM)
        aside = assembly.aside_mm[self.on_face]
        # b body, a direction (x, y), p place, s step, k of 6 motions
        motion[..., self.on_face, :] -= np.einsum("ba,apsbk->psbk", aside, slopes)
        return forces[0] * assembly.modulus_ratio, motion


def traced_presses(
    spec: ObjectSpec,
    forces: PressForces,
    motions: MagnetMotions,
    face: int,
    xy_mm: Float[np.ndarray, "place 2"],
) -> TracedPresses:
    """Presses of a face at any places within the lattice of the table.

    Raises
    ------
    InputError
        A place outside the lattice, or a force that does not grow with depth.
    """
    moving, faces, rest = (
        motions_as_signals(forces, motions),
        np.full(len(xy_mm), face),
        rest_motion(motions),
    )
    traces = [press_traces(moving, faces, *(xy_mm + side).T) for side in SIDES_MM]
    motion = np.real([trace.counts[:, 1:] for trace in traces])
    return TracedPresses(
        forces.depth_mm,
        *own_bodies(spec, face),
        rest,
        np.real([trace.force_n[:, 1:] for trace in traces]),
        rest + motion.reshape(len(SIDES_MM), len(xy_mm), len(forces.depth_mm), *rest.shape),
    )
