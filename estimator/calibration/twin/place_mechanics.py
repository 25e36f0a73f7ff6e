"""Presses of one face of the design at labelled places, as an object off the design would do them."""

from __future__ import annotations

import numpy as np
from jaxtyping import Float

from design.errors import InputError
from estimator.calibration.twin.pressed_places import PressedPlaces
from estimator.calibration.twin.unknowns import Unknowns
from estimator.signals.interpolation import press_traces
from estimator.signals.monotone import monotone_cubic
from estimator.signals.press_states import ASIDE_MM, SIDES_MM, motions_as_signals, rest_motion
from estimator.tolerances.assembly import Assembly, counts_of
from estimator.tolerances.virtual_object import twin_model
from fem.large_strain.correction import StrainCorrection, corrected_presses, own_bodies
from fem.presses.results import MagnetMotions, PressForces


class PlaceMechanics:
    """The design's presses at some places within the lattice of its table, and a little aside for magnets
    that sit off-centre.

    Raises
    ------
    InputError
        A place outside the lattice, a force that does not grow with depth, or labelled forces beyond the
        deepest simulated press.
    """

    def __init__(
        self,
        unknowns: Unknowns,
        forces: PressForces,
        motions: MagnetMotions,
        pressed: PressedPlaces,
    ) -> None:
        self.unknowns, self.pressed = unknowns, pressed
        moving, faces = motions_as_signals(forces, motions), np.full(len(pressed), pressed.face)
        traces = [press_traces(moving, faces, *(pressed.xy_mm + side).T) for side in SIDES_MM]
        self.depth_mm, self.rest = forces.depth_mm, rest_motion(motions)
        self.on_face, self.normal = own_bodies(unknowns.spec, pressed.face)
        # (side, place, step), and with (body, 6) behind them, rest included
        self.force_n = np.real([trace.force_n[:, 1:] for trace in traces])
        motion = np.real([trace.counts[:, 1:] for trace in traces])
        self.motion = self.rest + motion.reshape(*self.force_n.shape, *self.rest.shape)
        if (pressed.force_n > self.force_n[0][:, -1:]).any():
            raise InputError(
                f"labelled forces on face {pressed.face} reach {pressed.force_n.max():.3g} N, beyond the "
                "deepest simulated press. Add to press.depths_mm, or leave them out (`within_reach`)"
            )

    def expected(self, numbers: Float[np.ndarray, "number"]) -> Float[np.ndarray, "row channel"]:
        """Changes of counts of all means, at their labelled forces; NaN where forces would not grow
        with depth."""
        spec, pressed = self.unknowns.spec, self.pressed
        assembly = self.unknowns.assembly(numbers)
        force, motion = self._assembled(assembly, self.unknowns.correction(numbers))
        place, motion = assembly.scene, motion.reshape(-1, *self.rest.shape)
        model = twin_model(spec, assembly, motion)
        still = counts_of(spec, place, self.rest[None], model, pressed.face)
        change = counts_of(spec, place, motion, model, pressed.face) - still
        change = change.reshape(*force.shape, -1)[..., pressed.channels]
        force, change = (
            np.concatenate([np.zeros_like(values[:, :1]), values], axis=1)
            for values in (force, change)
        )
        if np.diff(force, axis=1).min() <= 0:  # no object: a step that goes there is too long
            return np.full((pressed.force_n.size, len(pressed.channels)), np.nan)
        held = np.minimum(pressed.force_n, force[:, -1:])
        return monotone_cubic(force, change, held).reshape(-1, len(pressed.channels))

    def _assembled(
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
