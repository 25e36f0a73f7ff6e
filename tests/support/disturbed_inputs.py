"""Inputs disturbed by a millionth or so, where `INSTOBJ_TESTS_DISTURBED` says by how much."""

import os

import numpy as np

SWITCH = "INSTOBJ_TESTS_DISTURBED"


def disturbed(values: np.ndarray, seed: int = 0) -> np.ndarray:
    """Each value times 1 ± the share; the values themselves without one."""
    share = float(os.environ.get(SWITCH, 0.0))
    if not share:
        return values
    signs = np.random.default_rng(seed).choice([-1.0, 1.0], values.shape)
    return (values * (1 + share * signs)).astype(values.dtype)
