"""The estimator that inverts calibrated twins, on an object off the design."""

from dataclasses import dataclass, replace

import numpy as np
import pytest
from numpy.testing import assert_allclose

from estimator.calibration.twin.inverted_twin import inverted_twin
from estimator.inversion.model.noise import SUM_ERROR, design_error
from estimator.signals.presses import Signals
from estimator.tolerances.virtual_object import drawn_assembly, twin_signals
from tests.support.mechanics.inverted import SPEC, presses
from tests.support.physics_pages import assert_page, chosen

FACE, ROW = 3, 2


@dataclass(frozen=True)
class Known:
    """A twin whose signals are known, as `CalibratedTwin` gives those of one face."""

    every: Signals
    modulus_error: float = 0.02

    def signals(self) -> Signals:
        one = slice(ROW, ROW + 1)
        return replace(
            self.every,
            faces=self.every.faces[one],
            force_n=self.every.force_n[one],
            delta_counts=self.every.delta_counts[one],
        )


@pytest.fixture(scope="module")
def built():
    forces, motions, _ = presses()
    return twin_signals(SPEC, drawn_assembly(SPEC, 4), forces, motions)


@pytest.fixture(scope="module")
def estimator(built):
    forces, motions, _ = presses()
    return inverted_twin(SPEC, forces, motions, {FACE: Known(built)}, {FACE: 0.03})


def read(estimator, signals, row):
    """Distances (mm) to presses of one face's lattice, undisturbed, at the deepest step but one."""
    inner = np.flatnonzero(np.all(abs(signals.lattice.xy_mm) < 9, axis=1))[::7]
    counts = signals.delta_counts[row, inner, -2].reshape(len(inner), -1)
    found, _ = estimator.read(counts)
    on_face = (found.face == signals.faces[row]) & (found.number == 1)[:, None]
    away = found.xy_mm - signals.lattice.xy_mm[inner][:, None]
    return np.where(on_face, np.linalg.norm(away, axis=2), np.nan)


def test_the_twins_face_is_read_as_it_was_built(estimator, built):
    assert np.nanmax(read(estimator, built, ROW)) < 0.1
    _, _, design = presses()
    assert np.nanmedian(read(estimator, design, ROW)) > 0.15


def test_other_faces_stay_those_of_the_design(estimator):
    _, _, design = presses()
    assert np.nanmax(read(estimator, design, 0)) < 0.1


def test_errors_are_the_twins_on_its_face_and_the_designs_on_others(estimator):
    design_motion = design_error(SPEC, *presses())
    error = estimator.disturbances.model_error.reshape(5, -1)
    assert_allclose(error[ROW], np.hypot(0.03, SUM_ERROR))
    assert_allclose(error[0], np.hypot(design_motion, SUM_ERROR))


def test_without_a_twin_of_every_face_forces_are_as_uncertain_as_the_modulus(estimator, built):
    assert estimator.disturbances.force_error == SPEC.tolerances.modulus_relative
    forces, motions, _ = presses()
    known = dict.fromkeys(range(1, 6), Known(built))
    noise = np.array([3.0, 50.0, 70.0])
    residual = dict.fromkeys(range(1, 6), 0.03)
    every = inverted_twin(SPEC, forces, motions, known, residual, noise_counts=noise)
    assert every.disturbances.force_error == 0.02
    assert_allclose(every.disturbances.noise_counts, np.tile(noise, 15))
    assert_allclose(
        estimator.disturbances.noise_counts, np.tile(np.array(SPEC.sensors.noise_counts), 15)
    )


def test_what_the_twin_s_estimator_reads_is_as_on_the_page(estimator, built):
    inner = np.flatnonzero(np.all(abs(built.lattice.xy_mm) < 9, axis=1))[::11]
    counts = built.delta_counts[list(built.faces).index(FACE), inner, -2].reshape(len(inner), -1)
    best, _ = estimator.read(counts)
    lines = [*chosen(best, "xy_mm", "force_n"), *chosen(estimator.disturbances, "model_error")]
    assert_page("estimator/calibration", lines, "inverted twin, ")
