"""Electromagnets switched on face by face: a face feels its own alone; a coil's field as a magnet's."""

import numpy as np
import pytest

from estimator.field.sources import magnet_source
from estimator.signals.field_setup import scene
from estimator.signals.presses import press_signals
from studies.electromagnets import (
    CURRENT_A,
    HOLE_MM,
    TURNS,
    coil_polarization_t,
    coil_remanence_t,
    face_by_face,
    run_electromagnets,
)
from tests.support.mechanics.synthetic_presses import coarse_spec, synthetic_presses


def wound():
    return coarse_spec(magnets={"grade": None, "remanence_t": coil_remanence_t(coarse_spec())})


def test_wound_magnets_have_the_polarization_of_the_winding():
    polarization_t = magnet_source(wound().magnets).polarization_t
    assert polarization_t == pytest.approx(coil_polarization_t(coarse_spec()), rel=1e-12)


def test_a_face_feels_its_own_electromagnets_alone():
    """Presses of a neighbour disturb less, and what all faces' magnets make is the sum of each face's."""
    spec = wound()
    presses = synthetic_presses(spec)
    apart, together = face_by_face(spec, *presses), press_signals(spec, *presses)
    face = scene(spec).sensors.face
    others = face != 3
    alone, all_on = (
        np.sqrt(np.mean(signals.delta_counts[2][:, :, others] ** 2))
        for signals in (apart, together)
    )
    assert alone < 0.6 * all_on
    own = [np.abs(signals.delta_counts[2][:, :, ~others]).max() for signals in (apart, together)]
    assert own[0] == pytest.approx(own[1], rel=0.1)


@pytest.mark.parametrize(("away_mm", "off"), [(8.0, -0.072), (10.0, -0.048), (15.0, -0.022)])
def test_a_magnet_with_the_moment_of_a_winding_has_nearly_its_field(away_mm, off):
    """Beside 400 × 200 current loops on the axis, B = μ0 I r² / 2 (r² + z²)^1.5 each."""
    spec = coarse_spec()
    size = spec.magnets.sizes[0]
    outer, height = size.half_mm[0], size.height_mm
    radius = HOLE_MM / 2 + (outer - HOLE_MM / 2) * (np.arange(400) + 0.5) / 400
    above = away_mm - height * ((np.arange(200)[:, None] + 0.5) / 200 - 0.5)
    loops = 4e-4 * np.pi * TURNS * CURRENT_A * radius**2 / (2 * (radius**2 + above**2) ** 1.5)
    # on the axis of a uniformly polarized cylinder: J / 2 (difference of its ends' cosines)
    ends = away_mm + height / 2 * np.array([1.0, -1.0])
    far, near = ends / np.hypot(ends, outer)
    disk = coil_polarization_t(spec) / 2 * (far - near)
    assert disk / loops.mean() - 1 == pytest.approx(off, abs=2e-3)


def test_the_study_says_what_switching_gains(tmp_path, monkeypatch):
    """On presses of the synthetic object: less felt from neighbours, and much less signal than of magnets."""
    spec = coarse_spec()
    presses = synthetic_presses(spec)
    monkeypatch.setattr("instobj.stages.run.Run.read", lambda run, kind: presses)
    found = run_electromagnets(spec, tmp_path, False)
    bounds = [row["median place mm"] for row in found.rows]
    assert len(found.rows) == 3
    assert bounds[1] > 5 * bounds[0]
    assert (tmp_path / "scores.png").is_file()
