"""Maximum likelihood by force: noisy frames of presses, each read by the best of many fits.

Shares with the product the interpolated signals alone, through the splines of its inversion.
"""

from functools import cached_property

import numpy as np
from scipy.interpolate import RectBivariateSpline

from estimator.information.fisher import disturbance_counts
from estimator.information.sensitivity import own_channels
from estimator.inversion.model.table import signal_table

_SHARES = np.geomspace(0.02, 1.0, 24)
"""Of the deepest press's force, where fits may begin."""
_STARTS, _APART_MM, _STEPS, _FRAMES = 4, 3.0, 15, 500
_LEAST_FORCE_N = 0.1


class FaceReader:
    """Reads one face's own channels, freshly zeroed: x, y and force, anywhere on its lattice.

    The lattice must be a whole rectangle.
    """

    def __init__(self, spec, signals, face):
        index = signals.faces.tolist().index(face)
        self.table = signal_table(signals).select_face(index)
        self.own = own_channels(signals, spec.sensors, face)
        self.sigma = disturbance_counts(spec.sensors, "fresh", signals.baseline_counts.size)[
            self.own
        ]
        self.lattice, self.reach_n = signals.lattice, signals.force_n[index, :, -1]
        if not signals.pressed[
            index
        ].all():  # splines over a part of it read any frame as one place
            raise ValueError(
                f"face {face} is not pressed on its whole lattice: this reader cannot read it"
            )

    def expected(self, contact):
        """Signals in standard deviations (n, channel), and their slopes (n, channel, 3)."""
        values = self.table.values(np.zeros(len(contact), int), contact)
        values = values[..., self.own].astype(float) / self.sigma
        return values[:, 0], values[:, 1:].swapaxes(1, 2)

    def within(self, contact):
        """Contacts moved to the lattice, and to forces that presses reach there."""
        x, y, force = contact.T
        x = x.clip(self.lattice.x_mm[0], self.lattice.x_mm[-1])
        y = y.clip(self.lattice.y_mm[0], self.lattice.y_mm[-1])
        return np.column_stack([x, y, force.clip(_LEAST_FORCE_N, self._reach.ev(x, y))])

    @cached_property
    def _reach(self):
        force = self.reach_n.reshape(self.lattice.shape)
        return RectBivariateSpline(self.lattice.x_mm, self.lattice.y_mm, force)

    @cached_property
    def _starts(self):
        xy = np.repeat(self.lattice.xy_mm, len(_SHARES), axis=0)
        contact = np.column_stack([xy, np.outer(self.reach_n, _SHARES).ravel()])
        return contact, self.expected(contact)[0]

    def read(self, frames):
        """Contacts (n, 3) that fit frames (n, channel) best."""
        parts = [frames[start : start + _FRAMES] for start in range(0, len(frames), _FRAMES)]
        return np.concatenate([self._read(part) for part in parts])

    def _read(self, frames):
        contact, signals = self._starts
        misfit = (signals**2).sum(axis=1) - 2 * frames @ signals.T
        best, least = np.zeros((len(frames), 3)), np.full(len(frames), np.inf)
        for _ in range(_STARTS):
            start = contact[misfit.argmin(axis=1)]
            found, rest = self._fitted(frames, start)
            better = rest < least
            best[better], least[better] = found[better], rest[better]
            away = np.linalg.norm(contact[None, :, :2] - start[:, None, :2], axis=2)
            misfit[away < _APART_MM] = np.inf
        return best

    def _fitted(self, frames, contact):
        """Levenberg and Marquardt's method within limits."""
        damping = np.full(len(contact), 1e-3)
        value, slopes = self.expected(contact)
        rest = ((frames - value) ** 2).sum(axis=1)
        for _ in range(_STEPS):
            gradient = np.einsum("nci,nc->ni", slopes, frames - value)
            # what the limits hold is left out of the step
            held = self.within(contact + 1e-6 * np.sign(gradient)) == contact
            matrix = np.einsum("nci,ncj->nij", slopes, slopes)
            matrix[held[:, :, None] | held[:, None, :]] = 0.0
            diagonal = damping[:, None] * np.diagonal(matrix, axis1=1, axis2=2) + held + 1e-9
            matrix = matrix + diagonal[:, :, None] * np.eye(3)
            step = np.linalg.solve(matrix, np.where(held, 0.0, gradient)[..., None])[..., 0]
            tried = self.within(contact + step)
            new, new_slopes = self.expected(tried)
            new_rest = ((frames - new) ** 2).sum(axis=1)
            better = new_rest <= rest
            contact = np.where(better[:, None], tried, contact)
            value = np.where(better[:, None], new, value)
            slopes = np.where(better[:, None, None], new_slopes, slopes)
            rest = np.where(better, new_rest, rest)
            damping = np.where(better, damping / 5, damping * 6)
        return contact, rest


def simulated_errors_mm(reader, contact, draws, rng):
    """Root mean square distance of what is read of contacts (n, 3), its standard error, and the distances
    (n, draw)."""
    signals, _ = reader.expected(contact)
    frames = signals[:, None] + rng.standard_normal((len(contact), draws, signals.shape[1]))
    read = reader.read(frames.reshape(-1, signals.shape[1])).reshape(len(contact), draws, 3)
    distance = np.linalg.norm(read[..., :2] - contact[:, None, :2], axis=2)
    rms = np.sqrt((distance**2).mean(axis=1))
    return rms, (distance**2).std(axis=1) / np.sqrt(draws) / (2 * rms), distance
