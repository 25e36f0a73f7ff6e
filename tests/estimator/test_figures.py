"""Figures that decide what users are told: thresholds of findings, priors and units, in one table.

Nothing but their choice makes them right, so that no oracle notices a changed one. They were read
beside the docstrings and the pages that explain them; who changes one changes these too.
"""

import pytest

import estimator.bringup.asking.held_magnet
import estimator.bringup.asking.hold_places
import estimator.bringup.diagnosis.channels
import estimator.bringup.diagnosis.chip_findings
import estimator.bringup.diagnosis.chip_fit
import estimator.bringup.diagnosis.earth
import estimator.bringup.diagnosis.health
import estimator.bringup.diagnosis.poles
import estimator.bringup.verdict
import estimator.calibration.known_travel.agreement
import estimator.calibration.known_travel.bound
import estimator.calibration.known_travel.fit
import estimator.calibration.known_travel.suspects
import estimator.calibration.pose_fit
import estimator.calibration.recorded_presses
import estimator.calibration.resting_conventions
import estimator.calibration.slip_recovery
import estimator.calibration.twin.discrepancy
import estimator.calibration.twin.pressed_cases
import estimator.calibration.twin.pressed_places
import estimator.calibration.twin.pretraining
import estimator.calibration.twin.unknowns
import estimator.calibration.validation
import estimator.deploy.export
import estimator.deploy.zeroing
import estimator.frames.contact_cases
import estimator.frames.heatmap
import estimator.frames.press_protocol
import estimator.information.contact_sets
import estimator.information.fisher
import estimator.information.two_contacts
import estimator.inversion.inversion
import estimator.inversion.priors
import estimator.inversion.readings
import estimator.inversion.tracking
import estimator.layouts.cross_face
import estimator.layouts.limits.parts
import estimator.layouts.polish
import estimator.layouts.robustness
import estimator.layouts.scoring
import estimator.metrics.contacts
import estimator.metrics.heatmaps
import estimator.networks.intervals.coverage
import estimator.networks.prediction
import estimator.networks.training.face
import estimator.networks.training.losses
import estimator.recordings.boards.link
import estimator.recordings.checks.faults
import estimator.recordings.drift
import estimator.recordings.formats.files
import estimator.recordings.formats.generic
import estimator.recordings.formats.travel
import estimator.recordings.presses
import estimator.recordings.reading
import estimator.recordings.zeros
import estimator.signals.hall
import estimator.signals.surroundings
import estimator.tolerances.localisation_bias
import estimator.tolerances.result
import estimator.tolerances.selftest

FIGURES = {
    estimator.bringup.asking.held_magnet: {"HAND_MM": 6.0, "HAND_RAD": 0.5, "TURNED_COUNTS_UT": 50.0},
    estimator.bringup.asking.hold_places: {"OVER_MM": 10.0, "BETWEEN_MM": 6.0, "_LEAST_COSINE": -0.1},
    estimator.bringup.diagnosis.channels: {
        "OTHER_PLACE": 7.0, "OTHER_TURN": 7.0, "MIRRORED": 9.0, "TURNED_OVER": 5.0,
    },
    estimator.bringup.diagnosis.chip_findings: {
        "TURNED": 6.0, "GAIN": 4.2, "OFFSET": 5.0, "GAIN_TO_TELL": 0.1, "_SURELY": 2.0,
        "_EARTH_MISFIT": 3.0,
    },
    estimator.bringup.diagnosis.chip_fit: {"_OPEN": 0.3, "_DEAD_SHARE": 0.3, "_TREMOR_SHARE": 0.004},
    estimator.bringup.diagnosis.earth: {"EARTH_UT": (25.0, 65.0), "_OPEN_GAIN": 0.3, "_DRIFT_S": 900.0},
    estimator.bringup.diagnosis.health: {"NOISY": 2.0, "SLOW": 0.9, "LOST": 0.01, "_BUS_ERRORS": 0.01},
    estimator.bringup.diagnosis.poles: {
        "TURNED_UT": 100.0, "WEAK": 0.6, "STRONG": 1.6, "ABSENT": 0.2, "_MARGIN": 10.0,
    },
    estimator.bringup.verdict: {"LEAST_HOLDS": 3, "_BEYOND_LINEAR": 0.3},
    estimator.calibration.known_travel.agreement: {"SMALLEST_MT": 0.03},
    estimator.calibration.known_travel.bound: {"NEIGHBOURS_MM": 4.5, "LEAST_NEIGHBOURS": 12},
    estimator.calibration.known_travel.fit: {
        "MODEL_ERROR_MT": 0.05, "RESTING_ERROR_MT": 0.1, "MAGNET_SEAT_MM": 1.0,
        "MAGNET_TILT_RAD": 0.1, "STRENGTH": 0.1,
    },
    estimator.calibration.known_travel.suspects: {
        "LEAN_RAD": 0.05, "TRAVEL_SHARE": 0.2, "CHIP_SHARE": 0.1,
    },
    estimator.calibration.pose_fit: {
        "PRIOR": (1.0, 1.0, 1.0, 3.0, 3.0, 3.0, 0.02, 0.5),
        "BOUNDS": (3.0, 3.0, 3.0, 10.0, 10.0, 10.0, 0.1, 1.5),
        "_FLOOR_COUNTS": 20.0, "_MODEL_ERROR": 0.2,
    },
    estimator.calibration.recorded_presses: {"LOADED_SHARE": 0.5, "LEAST_FRAMES": 5},
    estimator.calibration.resting_conventions: {"MOST_CANDIDATES": 500_000, "_SPREAD_COUNTS": 300.0},
    estimator.calibration.slip_recovery: {"_MODEL_ERROR": 0.1},
    estimator.calibration.twin.discrepancy: {"_FORCE_SCALE_N": 10.0, "_FLOOR_COUNTS": 1.0},
    estimator.calibration.twin.pressed_cases: {"LEAST_CASES": 3},
    estimator.calibration.twin.pressed_places: {
        "LEVELS": 16, "LEAST_PLACES": 4, "LEAST_FRAMES": 12, "MOST_PLACES": 150, "REACH": 0.8,
    },
    estimator.calibration.twin.pretraining: {
        "PRESSES_PER_PLACE": 3, "FRAMES_PER_PRESS": 12, "REST_FRAMES_PER_PRESS": 4,
        "VALIDATION_SHARE": 0.2,
    },
    estimator.calibration.twin.unknowns: {"STIFFENING": (0.7, 0.7, 0.5, 1.0, 0.5), "FARTHEST": 5.0},
    estimator.calibration.validation: {"SIGNIFICANCE": 0.05, "SIZE_BAND": 1.25, "_SIGN_SIGMAS": 3.0},
    estimator.deploy.export: {"OPSET": 18, "_PARITY": 1e-3},
    estimator.deploy.zeroing: {
        "ZERO_FRAMES": 8, "STILL_RATIO": 1.3, "RETURN_SHARE": 0.15, "SETTLE_S": 5.0,
        "DRIFT_COUNTS_PER_S": 1.0, "LEAST_FORCE_N": 0.3, "PRESS_FORCE_N": 1.0,
    },
    estimator.frames.contact_cases: {
        "DUAL_CASES": 100_000, "TRIPLE_CASES": 200_000, "GRASP_CASES": 300_000,
    },
    estimator.frames.heatmap: {
        "LABEL_GRID": (10, 10), "LABEL_PITCH_MM": 3.0, "NO_CONTACT_LABELS": (0, 101),
    },
    estimator.frames.press_protocol: {
        "PLACE_ID_STRIDE": 1000, "DRIFT_TIME_S": 900.0, "LEAST_FORCE_NOISES": 2.5,
    },
    estimator.information.contact_sets: {"_PLACES_AN_AXIS": 5},
    estimator.information.fisher: {"DETECTION_DISTANCE": 5.0},
    estimator.information.two_contacts: {"PERCENT": 95.0},
    estimator.inversion.inversion: {"KNOWN_FORCE_SPREAD": 0.3},
    estimator.inversion.priors: {"_OVERLAP_MM": 0.5, "SPACING_SIGMA_MM": 0.2},
    estimator.inversion.readings: {"COVERAGE": 0.9, "UNEXPLAINED": 1e-3},
    estimator.inversion.tracking: {"_FAINT": 3.0, "_STRAINED": 0.02},
    estimator.layouts.cross_face: {"CROSS_FACE_FORCE_N": 10.0},
    estimator.layouts.limits.parts: {"SLACK_MM": 0.02},
    estimator.layouts.polish: {"PENALTY_PER_MM": 10.0, "_MM_PER_EXCESS": 10.0},
    estimator.layouts.robustness: {"SLIP_MM": 1.0},
    estimator.layouts.scoring: {"_FORCE_VARIANCE": 1 / 8},
    estimator.metrics.contacts: {"FAR_MM": 5.0},
    estimator.metrics.heatmaps: {"NON_CONTACT_SHARE": 0.9, "LEAST_SIMILARITY": 0.3},
    estimator.networks.intervals.coverage: {"KNOWN_SHARE": 0.95, "WHOLLY_NEW_FROM": 2.0},
    estimator.networks.prediction: {"NOVEL_FROM": 1.0},
    estimator.networks.training.face: {"FINE_TUNING_RATE": 0.3, "_WEIGHT_DECAY": 1e-3},
    estimator.networks.training.losses: {
        "_FORCE_WEIGHT": 8.0, "_CENTRE_WEIGHT": 0.3, "_SPREAD_WEIGHT": 0.1,
    },
    estimator.recordings.boards.link: {"BAUD": 115_200, "PATIENCE_S": 10.0, "LONGEST_PAUSE_S": 3.0},
    estimator.recordings.checks.faults: {"NOISY_FACTOR": 3.0, "JUMP_COUNTS": 500.0, "_OPPOSITE_MM": 6.0},
    estimator.recordings.drift: {
        "LEAST_FRAMES": 5, "LARGEST_DRIFT_NOISES": 6.0, "LONGEST_GAP_S": 120.0, "USUAL_S": 3.0,
    },
    estimator.recordings.formats.files: {"NEWTON_PER_GRAM_FORCE": 9.8e-3},
    estimator.recordings.formats.generic: {"_NEWTON_PER_GRAM": 9.80665e-3},
    estimator.recordings.formats.travel: {
        "_LARGEST_LAG_S": 1.0, "_LARGEST_UT": 1e6, "_LARGEST_MM": 1e4, "_NO_LOAD": -1.0,
    },
    estimator.recordings.presses: {"PAUSE_S": 5.0, "CONTACT_FORCE_N": 0.3, "_STEADY_REST_N": 0.15},
    estimator.recordings.reading: {
        "NOMINAL_RATE_HZ": 10.5,
        "REST_FORCE_N": {"gripper": 0.05, "training": 0.15, "generic": 0.15},
    },
    estimator.recordings.zeros: {"ZERO_FRAMES": 20, "LEAST_ZERO_FRAMES": 5},
    estimator.signals.hall: {"LARGEST_COUNT": 32767},
    estimator.signals.surroundings: {"TYPICAL_EARTH_UT": 50.0},
    estimator.tolerances.localisation_bias: {"OBJECTS": 12},
    estimator.tolerances.result: {"REACH_SHARE": 0.7},
    estimator.tolerances.selftest: {"PRIOR_PROBABILITY": 1e-3, "POOR_FIT": 1e-3},
}  # fmt: skip


@pytest.mark.parametrize("module", FIGURES, ids=lambda module: module.__name__)
def test_figures_are_those_that_were_chosen(module):
    for name, value in FIGURES[module].items():
        assert getattr(module, name) == value, name
