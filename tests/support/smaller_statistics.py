"""Smaller statistics for tests that do not ask how good they are; their own tests have them in full."""

from contextlib import contextmanager

from estimator.calibration.twin import digital_twin
from estimator.evaluation import baselines
from estimator.networks.intervals import coverage
from instobj.stages.makers import inversion

SMALLER = {
    (coverage, "PLACE_TREES"): 8,
    (coverage, "PLACE_GROUPS"): 3,
    (baselines, "TREES"): 20,
    (baselines, "BOOSTS"): 30,
    (baselines, "FRAMES_OF_KERNEL"): 100,
    (baselines, "MOST_FRAMES_OF_PROCESS"): 400,
    (digital_twin, "FOLDS"): 2,
    (inversion, "MOST_FRAMES"): 160,
}
"""Trees at places left out took more of a small network's training than the network, and frames that
the inversion reads a third of a small run."""
FULL = {(module, name): getattr(module, name) for module, name in SMALLER}


def install():
    """From now on."""
    _set(SMALLER)


@contextmanager
def in_full():
    """As users have them."""
    _set(FULL)
    yield
    _set(SMALLER)


def _set(values):
    for (module, name), value in values.items():
        setattr(module, name, value)
