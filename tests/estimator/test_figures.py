"""Figures that decide what users are told: thresholds of findings, priors and units, in one table.

Nothing but their choice makes them right, so that no oracle notices a changed one. They were read
beside the docstrings and the pages that explain them; who changes one changes these too.
"""

import numpy as np
import pytest

import benchmarks.rig.least_possible
import estimator.bringup.asking.asked
import estimator.bringup.asking.held_magnet
import estimator.bringup.asking.hold_places
import estimator.bringup.diagnosis.channels
import estimator.bringup.diagnosis.chip_findings
import estimator.bringup.diagnosis.chip_fit
import estimator.bringup.diagnosis.earth
import estimator.bringup.diagnosis.findings
import estimator.bringup.diagnosis.health
import estimator.bringup.diagnosis.levenberg_marquardt
import estimator.bringup.diagnosis.poles
import estimator.bringup.simulated
import estimator.bringup.verdict
import estimator.calibration.known_travel.agreement
import estimator.calibration.known_travel.bound
import estimator.calibration.known_travel.fit
import estimator.calibration.known_travel.model
import estimator.calibration.known_travel.places
import estimator.calibration.known_travel.suspects
import estimator.calibration.pose_fit
import estimator.calibration.recorded_presses
import estimator.calibration.twin.digital_twin
import estimator.calibration.twin.discrepancy
import estimator.calibration.twin.grasp_twin
import estimator.calibration.twin.least_known
import estimator.calibration.twin.like_forces
import estimator.calibration.twin.pressed_cases
import estimator.calibration.twin.pressed_places
import estimator.calibration.twin.pretraining
import estimator.calibration.twin.unknowns
import estimator.calibration.validation
import estimator.deploy.export
import estimator.deploy.zeroing
import estimator.evaluation.baselines
import estimator.field.models
import estimator.field.sources
import estimator.frames.collection_recipe
import estimator.frames.contact_cases
import estimator.frames.dataset
import estimator.frames.face_data
import estimator.frames.heatmap
import estimator.frames.press_protocol
import estimator.frames.splits
import estimator.information.contact_sets
import estimator.information.cross_face
import estimator.information.fisher
import estimator.information.identifiability
import estimator.information.shear
import estimator.information.weak_areas
import estimator.inversion.blind_start
import estimator.inversion.inversion
import estimator.inversion.model.dictionary
import estimator.inversion.model.forward
import estimator.inversion.model.noise
import estimator.inversion.model.table
import estimator.inversion.posterior
import estimator.inversion.priors
import estimator.inversion.readings
import estimator.inversion.search
import estimator.inversion.tracking
import estimator.layouts.cross_face
import estimator.layouts.limits.parts
import estimator.layouts.near_field
import estimator.layouts.polish
import estimator.layouts.presses.basis
import estimator.layouts.presses.compression
import estimator.layouts.scoring
import estimator.metrics.contacts
import estimator.metrics.heatmaps
import estimator.networks.defaults
import estimator.networks.ensemble
import estimator.networks.face_model
import estimator.networks.forest
import estimator.networks.intervals.coverage
import estimator.networks.intervals.held_out
import estimator.networks.network
import estimator.networks.prediction
import estimator.networks.training.data
import estimator.networks.training.face
import estimator.networks.training.fitting
import estimator.networks.training.losses
import estimator.recordings.boards.growing
import estimator.recordings.boards.lines
import estimator.recordings.boards.link
import estimator.recordings.checks.faults
import estimator.recordings.checks.labels
import estimator.recordings.checks.limits
import estimator.recordings.checks.turned
import estimator.recordings.drift
import estimator.recordings.formats.files
import estimator.recordings.formats.generic
import estimator.recordings.formats.travel
import estimator.recordings.presses
import estimator.recordings.reading
import estimator.recordings.table
import estimator.recordings.zeros
import estimator.signals.continuation
import estimator.signals.hall
import estimator.signals.press_states
import estimator.signals.surroundings
import estimator.tolerances.budget
import estimator.tolerances.result
import estimator.tolerances.selftest
import estimator.tolerances.virtual_object
import studies.paper.bayes_optimum
import studies.paper.false_alarms
import studies.paper.slip_recovery
import studies.recorded.cycle_laws
import studies.recorded.interface_fits
import studies.recorded.resting_conventions
from estimator.layouts.near_field import Reach
from estimator.networks.defaults import Choice
from estimator.networks.training.data import Augmentation

FIGURES = {
    estimator.bringup.asking.asked: {
        "STILL_S": 10.0, "HELD_S": 4.0, "FURTHER_S": 10.0, "STEP_S": 2.0, "POSE_S": 20.0,
        "MOST_FURTHER": 12, "_FEWEST_FRAMES": 10,
    },
    estimator.bringup.asking.held_magnet: {
        "HAND_MM": 6.0, "HAND_RAD": 0.5, "TURNED_COUNTS_UT": 50.0, "_LOWEST_MM": 0.5,
    },
    estimator.bringup.asking.hold_places: {
        "OVER_MM": 10.0, "BETWEEN_MM": 6.0, "_LEAST_COSINE": -0.1,
    },
    estimator.bringup.diagnosis.channels: {
        "_ROBUST": 4.0, "_TREMOR_COUNTS": 0.01, "OTHER_PLACE": 7.0, "OTHER_TURN": 7.0,
        "MIRRORED": 9.0, "TURNED_OVER": 5.0,
    },
    estimator.bringup.diagnosis.chip_findings: {
        "TURNED": 6.0, "GAIN": 4.2, "OFFSET": 5.0, "GAIN_TO_TELL": 0.1, "_SURELY": 2.0,
        "_EARTH_MISFIT": 3.0,
    },
    estimator.bringup.diagnosis.chip_fit: {
        "_OPEN": 0.3, "_DEAD_SHARE": 0.3, "_TREMOR_SHARE": 0.004,
    },
    estimator.bringup.diagnosis.earth: {
        "_LAID_RAD": np.deg2rad(8.0), "_OPEN_TURN": np.deg2rad(5.0), "EARTH_UT": (25.0, 65.0),
        "_OPEN_GAIN": 0.3, "_DRIFT_S": 900.0,
    },
    estimator.bringup.diagnosis.findings: {"HALF_95": 1.96},
    estimator.bringup.diagnosis.health: {
        "_SEQUENCES": 65536, "NOISY": 2.0, "SLOW": 0.9, "LOST": 0.01, "_BUS_ERRORS": 0.01,
    },
    estimator.bringup.diagnosis.levenberg_marquardt: {"_WORTH": 0.02},
    estimator.bringup.diagnosis.poles: {
        "_ROBUST": 4.0, "TURNED_UT": 100.0, "WEAK": 0.6, "STRONG": 1.6, "ABSENT": 0.2,
        "_MARGIN": 10.0,
    },
    estimator.bringup.simulated: {
        "HAND_MM": 3.0, "HAND_DEG": 15.0, "HEIGHT_MM": (4.0, 15.0), "TREMOR_MM": 0.3,
        "TREMOR_DEG": 1.0, "LAID_DEG": 5.0, "EARTH_UT": (25.0, 65.0), "_DRIFT_MS": 900_000,
        "_STUCK_COUNTS": 128.0,
    },
    estimator.bringup.verdict: {"LEAST_HOLDS": 3, "_BEYOND_LINEAR": 0.3},
    studies.recorded.interface_fits: {"DEPTHS_MM": (0.5, 1.0, 1.5, 2.0, 3.0, 4.0)},
    estimator.calibration.known_travel.agreement: {"SMALLEST_MT": 0.03},
    estimator.calibration.known_travel.bound: {"NEIGHBOURS_MM": 4.5, "LEAST_NEIGHBOURS": 12},
    studies.recorded.cycle_laws: {
        "STEP_S": 0.1,
        "LAGS_S": [-0.5, -0.4, -0.3, -0.2, -0.1, 0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9,
            1.0],
        "SHARES": (0.05, 0.1, 0.2, 0.3, 0.4, 0.5), "DEGREE": 7,
        "TIMES_S": (1.0, 3.0, 10.0, 30.0, 100.0), "_RETURNED": 0.02, "_FEWEST_CYCLES": 4,
    },
    estimator.calibration.known_travel.fit: {
        "POSE_SCALES": (1.0, 1.0, 0.05, 1.0), "_START_ABOVE_MM": 2.0, "MODEL_ERROR_MT": 0.05,
        "RESTING_ERROR_MT": 0.1, "MAGNET_SEAT_MM": 1.0, "MAGNET_TILT_RAD": 0.1, "STRENGTH": 0.1,
    },
    estimator.calibration.known_travel.model: {"_MARGIN_MM": 0.2, "_PLAY_MM": 3.0},
    estimator.calibration.known_travel.places: {
        "_NEIGHBOURS": 6, "TABLE_MM": (1.0, 0.5), "_LEAST_SHARE": 0.05,
    },
    estimator.calibration.known_travel.suspects: {
        "LEAN_RAD": 0.05, "TRAVEL_SHARE": 0.2, "CHIP_SHARE": 0.1,
    },
    estimator.calibration.pose_fit: {
        "GROUPS": {"pose of the core": (0, 1, 2, 3, 4, 5), "strength of the magnets": (6,),
            "modulus, that is depth": (7,)},
        "PRIOR": (1.0, 1.0, 1.0, 3.0, 3.0, 3.0, 0.02, 0.5),
        "BOUNDS": (3.0, 3.0, 3.0, 10.0, 10.0, 10.0, 0.1, 1.5), "_FLOOR_COUNTS": 20.0,
        "_MODEL_ERROR": 0.2, "LARGEST_SHIFT_MM": 3.0,
    },
    estimator.calibration.recorded_presses: {
        "RECORDED_FACES": 5, "LOADED_SHARE": 0.5, "LEAST_FRAMES": 5,
    },
    studies.recorded.resting_conventions: {
        "COMMON": {"nothing": (), "strength": (0,), "depth": (1,), "strength, depth": (0, 1),
            "core": (2, 3, 4, 5, 6, 7), "all": (0, 1, 2, 3, 4, 5, 6, 7)},
        "PRIOR": [0.3, 1.0, 1.0, 1.0, 1.0, 3.0, 3.0, 3.0],
        "BOUNDS": [1.5, 3.0, 3.0, 3.0, 3.0, 10.0, 10.0, 10.0], "MOST_CANDIDATES": 500_000,
        "_SPREAD_COUNTS": 300.0,
    },
    studies.paper.slip_recovery: {"_MODEL_ERROR": 0.1},
    estimator.calibration.twin.digital_twin: {
        "SIZES": (0.02, 0.05, 0.1, 0.2), "LENGTHS_MM": (6.0, 10.0, 16.0),
    },
    estimator.calibration.twin.discrepancy: {"_FORCE_SCALE_N": 10.0, "_FLOOR_COUNTS": 1.0},
    estimator.calibration.twin.grasp_twin: {
        "SIZES": (0.02, 0.05, 0.1, 0.2, 0.5, 1.0), "_CLEAR": 25.0,
    },
    estimator.calibration.twin.least_known: {"SHARES": (0.5, 1.0)},
    benchmarks.rig.least_possible: {"_POWER": 0.6},
    estimator.calibration.twin.like_forces: {"STEADY_NOISES": 3.0},
    estimator.calibration.twin.pressed_cases: {"LEAST_CASES": 3},
    estimator.calibration.twin.pressed_places: {
        "_STRAIGHT_NOISES": 4.0, "LEVELS": 16, "LEAST_PLACES": 4, "LEAST_FRAMES": 12,
        "MOST_PLACES": 150, "REACH": 0.8,
    },
    estimator.calibration.twin.pretraining: {
        "PRESSES_PER_PLACE": 3, "FRAMES_PER_PRESS": 12, "REST_FRAMES_PER_PRESS": 4,
        "VALIDATION_SHARE": 0.2,
    },
    estimator.calibration.twin.unknowns: {"STIFFENING": (0.7, 0.7, 0.5, 1.0, 0.5), "FARTHEST": 5.0},
    estimator.calibration.validation: {
        "SIGNIFICANCE": 0.05, "SIZE_BAND": 1.25, "_SIGN_SIGMAS": 3.0,
    },
    estimator.deploy.export: {
        "_PROBE_SCALES_COUNTS": (1.0, 4.0, 16.0, 64.0, 256.0, 1024.0, 4096.0, 16384.0, 65536.0),
        "OPSET": 18, "_PARITY": 1e-3,
    },
    estimator.deploy.zeroing: {
        "ZERO_FRAMES": 8, "STILL_RATIO": 1.3, "RETURN_SHARE": 0.15, "SETTLE_S": 5.0,
        "DRIFT_COUNTS_PER_S": 1.0, "LEAST_FORCE_N": 0.3, "PRESS_FORCE_N": 1.0,
        "_LEAST_FRAMES": 5, "_FRAME_S": 0.1, "_WINDOW_S": 0.6, "_JUDGED_EVERY_S": 0.08,
    },
    estimator.evaluation.baselines: {
        "MOST_FRAMES": 6000,
        "_NEIGHBOURS": 5, "_INTERVAL_PERCENT": (5.0, 95.0),
    },
    studies.paper.bayes_optimum: {"_ROUNDING_COUNTS": 12**-0.5},
    studies.paper.false_alarms: {"WANTED_RATE": 0.01},
    estimator.field.models: {"LOWEST_ORDER": 7, "HIGHEST_ORDER": 25, "HIGHEST_CHARGES": 8},
    estimator.frames.collection_recipe: {"_PERIOD_SPREAD": 0.05},
    estimator.frames.contact_cases: {
        "GRASP_POSES": (((0.0, 0.0, 0.0), (-7.5, -7.5, 0.0), (7.5, -7.5, 0.0), (-7.5, 7.5, 0.0),
            (7.5, 7.5, 0.0)), ((0.0, 0.0, 0.0), (0.0, -9.0, 0.0), (9.0, 0.0, 90.0)), ((0.0, -3.0,
            0.0), (0.0, 3.0, 180.0))),
        "DUAL_CASES": 100_000, "TRIPLE_CASES": 200_000, "GRASP_CASES": 300_000,
    },
    estimator.frames.dataset: {"NO_FACE": 0},
    estimator.frames.face_data: {"HISTORY": 100},
    estimator.frames.heatmap: {
        "LABEL_GRID": (10, 10), "LABEL_PITCH_MM": 3.0, "NO_CONTACT_LABELS": (0, 101),
    },
    estimator.frames.press_protocol: {
        "REST_PLACE_ID": -1, "PLACE_ID_STRIDE": 1000, "DRIFT_TIME_S": 900.0,
        "LEAST_FORCE_NOISES": 2.5,
    },
    estimator.frames.splits: {"DEFAULT_SHARES": (0.6, 0.2, 0.2)},
    estimator.information.contact_sets: {"_PLACES_AN_AXIS": 5},
    estimator.information.cross_face: {"LEAST_FALSE_FORCE_N": 0.01},
    estimator.information.fisher: {
        "_SMALLEST_FORCE_N": 1e-4, "_CLEARLY_SEEN": 1e-4, "DETECTION_DISTANCE": 5.0,
    },
    estimator.information.identifiability: {
        "_SENSOR_COUNTS": (1, 2, 3, 4, 5), "CONTACT_COUNTS": (1, 2, 3),
    },
    estimator.information.shear: {"_STEP_N": 0.2},
    estimator.information.weak_areas: {"_DIGITS": 5},
    estimator.inversion.blind_start: {"FRAMES": 100, "_LEAST_FORCE_N": 0.1},
    estimator.inversion.inversion: {"KNOWN_FORCE_SPREAD": 0.3},
    estimator.inversion.model.dictionary: {
        "_PITCH_MM": 3.0, "_FORCES_N": (0.7, 3.0, 10.0), "_PROBE_FORCES_N": (1.0, 5.0),
        "_SCALES": (0.3, 2.5), "_APART_MM": 6.0,
    },
    estimator.inversion.model.forward: {"NONE": -1, "_NEARER_MM": 1.0},
    estimator.inversion.model.noise: {
        "_ROUNDING": 12**-0.5, "SUM_ERROR": 0.006, "MESH_ERROR": 0.02, "MOST_ERROR": 0.25,
        "BLIND": 1e9,
    },
    estimator.inversion.model.table: {"FORCE_NODES": 14, "_NEAR_ZERO_N": 0.5},
    estimator.inversion.posterior: {
        "_LONGEST": [4.0, 4.0, 6.0], "_SAME_SIGMA": 0.02, "_SETTLED": 0.001,
    },
    estimator.inversion.priors: {
        "_ROOT": np.sqrt(2 * np.pi), "_OVERLAP_MM": 0.5, "SPACING_SIGMA_MM": 0.2,
        "_UNPAIRED": np.log(1e-3),
    },
    estimator.inversion.readings: {"COVERAGE": 0.9, "UNEXPLAINED": 1e-3, "_LEAST_ODDS": 1e-3},
    estimator.inversion.search: {
        "_QUIET": 0.75, "_HOPELESS": 2.0, "_EQUAL": 0.05, "_VISITS": 2, "_BETTER": 1.0, "_HALF_MM": 6.0,
        "_HALVED_BY": [
            [6.0, 0.0, 0.0], [0.0, 6.0, 0.0],
            [6 * 0.5**0.5, 6 * 0.5**0.5, 0.0], [6 * 0.5**0.5, -6 * 0.5**0.5, 0.0],
        ],
    },
    estimator.inversion.tracking: {
        "_CHANGE": np.log(0.1), "_FAINT": 3.0, "_STRAINED": 0.02, "_LONGEST_PAUSE": 8,
        "_WORSE": 0.1,
    },
    estimator.layouts.cross_face: {"_MOST_SHARE": 2.0, "CROSS_FACE_FORCE_N": 10.0},
    estimator.layouts.limits.parts: {"SLACK_MM": 0.02},
    estimator.layouts.near_field: {"OWN": Reach(15, 1.4), "OTHER": Reach(7, 2.0)},
    estimator.layouts.polish: {"PENALTY_PER_MM": 10.0, "_MM_PER_EXCESS": 10.0},
    estimator.layouts.presses.basis: {
        "OTHER_RANK": 40,
        "OWN_RANK_PER_PLACE": 1.3, "LEAST_OWN_RANK": 60, "MORE_RANK": 1.2, "STRAIN_RANK": 96,
    },
    estimator.layouts.presses.compression: {"TURN_RANK": 64},
    estimator.layouts.scoring: {"_FORCE_VARIANCE": 1 / 8, "_CURVE_VARIANCE": 1 / 128},
    estimator.metrics.contacts: {
        "FAR_MM": 5.0, "FORCE_BANDS_N": ((0.0, 1.0), (1.0, 4.0), (4.0, float("inf"))),
    },
    estimator.metrics.heatmaps: {"NON_CONTACT_SHARE": 0.9, "LEAST_SIMILARITY": 0.3},
    estimator.networks.defaults: {
        "PLAIN": Choice(0, 1, 0, False), "SMALL": Choice(9, 4, 50, True), "SMALL_PRESSES": 60,
    },
    estimator.networks.face_model: {"MODEL_FORMAT": 6, "_LONGEST_HISTORY": 100},
    estimator.networks.forest: {"LEAST_FRAMES_OF_LEAF": 2, "MOST_LEVELS": 14},
    estimator.networks.intervals.coverage: {
        "SIGMA_SPAN": 3.0, "KNOWN_SHARE": 0.95, "WHOLLY_NEW_FROM": 2.0,
    },
    estimator.networks.intervals.held_out: {
        "SHARPNESS": (1.0, 2.0, 4.0, 8.0, 16.0), "FAINT": (0.05, 0.2, 0.4),
        "STEPS_OF_SHARES": 4, "LEAST_RADIUS_PITCHES": 0.1,
    },
    estimator.networks.network: {
        "SIGMA_SPAN": 3.0, "LINEAR_SIGMA_SPAN": 30.0, "DOUBT_POWER": 2, "GATHER_MM": 9.0,
        "SPLAT_PITCHES": 0.3,
    },
    estimator.networks.prediction: {"NOVEL_FROM": 1.0},
    estimator.networks.training.data: {
        "NEGATIVES_PER_CONTACT": 0.3,
        "AUGMENTATION": {"simulated": Augmentation(10.0, 1.0, 0.0), "recorded": Augmentation(25.0,
            1.0, 0.0)},
    },
    estimator.networks.training.face: {
        "FINE_TUNING_RATE": 0.3, "_WEIGHT_DECAY": 1e-3, "_OTHER_FACES": 0.5,
    },
    estimator.networks.training.fitting: {
        "_SAVE_EVERY_S": 5.0, "_WARM_UP_EPOCHS": 2.0, "_LEAST_BATCH_FRAMES": 16,
    },
    estimator.networks.training.losses: {
        "_FORCE_WEIGHT": 8.0, "_CENTRE_WEIGHT": 0.3, "_SPREAD_WEIGHT": 0.1,
    },
    estimator.recordings.boards.growing: {"_SYNC_S": 1.0},
    estimator.recordings.boards.lines: {
        "FORMAT_VERSION": 1, "_SEQUENCES": 65536, "_RESTART_GAP": 10_000, "_LONGEST_LINE": 4096,
        "_LARGEST_MV": 60_000, "_LARGEST_C": 300.0,
    },
    estimator.recordings.boards.link: {
        "BAUD": 115_200, "PATIENCE_S": 10.0, "LONGEST_PAUSE_S": 3.0, "_CLOCK": 2**32,
        "_DISORDER_MS": 1000,
    },
    estimator.recordings.checks.faults: {
        "NOISY_FACTOR": 3.0, "JUMP_COUNTS": 500.0, "_OPPOSITE_MM": 6.0, "_MOVED_COUNTS": 150.0,
        "_DOUBT_FACTOR": 3.0,
    },
    estimator.recordings.checks.labels: {
        "LEAST_FRAMES": 5, "_HIDDEN_SIGMAS": 6.0, "_SILENT_SHARE": 0.1, "_SILENT_SIGMAS": 5.0,
        "_PRESSED_SHARE": 0.3, "_LOADED_SHARE": 0.5, "_OWN_DISTANCE": 0.4,
        "_DISTANCE_RATIO": 2.5,
    },
    estimator.recordings.checks.limits: {
        "_CONVERTER_COUNTS": 32768.0, "_FEW_READINGS": 0.05, "_FAR_FACTOR": 3.0,
    },
    estimator.recordings.checks.turned: {
        "_ALIKE": 0.5, "_ANSWERS": 0.1, "_REST_AGREES": 0.25, "_EXCHANGE_GAIN": 4.0,
    },
    estimator.recordings.drift: {
        "LEAST_FRAMES": 5, "LARGEST_DRIFT_NOISES": 6.0, "LONGEST_GAP_S": 120.0, "USUAL_S": 3.0,
        "_LEAST_S": 0.5, "_LONGEST_S": 30.0, "_CONTACT_FRAMES": 3, "_TOUCH_FRAMES": 2,
        "_LEAST_NOISE_COUNTS": 0.3,
    },
    estimator.recordings.formats.files: {
        "_FILE_FACES": (5, 3, 1, 2, 4), "_TRAINING_TIPS": {12: 1, 14: 2, 15: 3},
        "NEWTON_PER_GRAM_FORCE": 9.8e-3,
    },
    estimator.recordings.formats.generic: {"_NEWTON_PER_GRAM": 9.80665e-3},
    estimator.recordings.formats.travel: {
        "_LARGEST_LAG_S": 1.0, "_LARGEST_UT": 1e6, "_LARGEST_MM": 1e4, "_NO_LOAD": -1.0,
    },
    estimator.recordings.presses: {
        "_CURVE_DEGREE": 3, "PAUSE_S": 5.0, "CONTACT_FORCE_N": 0.3, "_STEADY_REST_N": 0.15,
        "LAGS": range(-10, 26), "_LEAST_PRESS_FRAMES": 5, "LAG_FRAMES": 75,
    },
    estimator.recordings.reading: {
        "NOMINAL_RATE_HZ": 10.5,
        "REST_FORCE_N": {"gripper": 0.05, "training": 0.15, "generic": 0.15},
    },
    estimator.recordings.table: {
        "FACES": (1, 2, 3, 4, 5), "LARGEST_COUNT": 2.0**24, "LARGEST_FORCE_N": 1000.0,
        "LARGEST_PLACE_MM": 300.0, "_SLOWEST_FRAME_S": 5.0,
    },
    estimator.recordings.zeros: {"ZERO_FRAMES": 20, "LEAST_ZERO_FRAMES": 5},
    estimator.signals.continuation: {"_THIRD_DIFFERENCE": (-1.0, 3.0, -3.0, 1.0), "_REACH": 6},
    estimator.signals.hall: {"LARGEST_COUNT": 32767},
    estimator.signals.press_states: {"ASIDE_MM": 0.1, "_FORCE_STEP": 0.01},
    estimator.signals.surroundings: {"TYPICAL_EARTH_UT": 50.0},
    estimator.tolerances.budget: {"_NEARER_MM": 1.0, "_STEP": 0.05},
    estimator.tolerances.result: {"REACH_SHARE": 0.7},
    estimator.tolerances.selftest: {
        "_NEARER_MM": 1.0, "_STEP": 0.05, "PRIOR_PROBABILITY": 1e-3, "POOR_FIT": 1e-3,
    },
    estimator.tolerances.virtual_object: {"_NEARER_MM": 1.0},
}  # fmt: skip


@pytest.mark.parametrize("module", FIGURES, ids=lambda module: module.__name__)
def test_figures_are_those_that_were_chosen(module):
    for name, value in FIGURES[module].items():
        found = getattr(module, name)
        assert (found.tolist() if isinstance(found, np.ndarray) else found) == value, name
