"""Proofs of the contact finer than the mesh: a flat punch on blocks of growing size, refinement."""

from functools import cache

import numpy as np

from fem.contact import refined as refined_contact
from fem.presses import table
from fem.presses.table import press_face
from tests.support.mechanics import block_cases
from tests.support.mechanics.fem_cases import YOUNGS_MODULUS_MPA
from tests.support.verification.proof import Check, Curve, Fault, Measured

POISSON_RATIO = 0.4999


@cache
def coarse_block(half_width_mm):
    return block_cases.block_response(POISSON_RATIO, half_width_mm, half_width_mm, 2.0, 1)


def flat_punch():
    """F = 2 a E* δ on blocks of growing size, by cells finer than the mesh."""
    sizes, radius, depth = np.array([5.0, 10.0, 20.0, 40.0, 80.0]), 1.0, np.array([0.2])
    spec = block_cases.spec_of(POISSON_RATIO, kind="flat", radius_mm=radius)
    exact = 2 * radius * YOUNGS_MODULUS_MPA / (1 - POISSON_RATIO**2) * depth[0]
    force = [
        float(press_face(spec, coarse_block(size), 0, np.zeros((1, 2)), depth).force_n[0, 0])
        for size in sizes
    ]
    off = np.array(force) / exact - 1
    words = (
        f"Disk of radius 1 mm on blocks as high as half their width, cells of 2 mm in the middle. Force "
        f"{off[0]:+.1%} on the smallest block, {off[-1]:+.2%} on the largest. There the infinite "
        "pressure at the punch's edge is what the cells miss."
    )
    curve = Curve("force of the punch", sizes, np.array(force), np.full(len(sizes), exact))
    return Measured(float(abs(off[-1])), words, (curve,))


@cache
def layer(cell_mm):
    return block_cases.block_response(0.5, 40.0, 8.0, cell_mm, int(4 / cell_mm), layers=6)


def refinement():
    """Force of the sphere on the layer of 8 mm, at small depths and with coarse surfaces."""
    depths = np.array([0.25, 0.5, 1.0, 2.0])
    places = np.random.default_rng(3).uniform(-1.5, 1.5, (12, 2))
    coarse, middle, fine = (
        press_face(block_cases.spec_of(0.5), layer(cell), 0, places, depths).force_n.mean(axis=0)
        for cell in (2.0, 1.4, 0.8)
    )
    curves = (
        Curve("surface edges of 2 mm", depths, coarse, fine),
        Curve("surface edges of 1.4 mm", depths, middle, fine),
    )
    off = max(abs(force / fine - 1).max() for force in (coarse, middle))
    words = "Means of twelve places, against surface edges of 0.8 mm; ν 0.5, 80 mm wide."
    return Measured(float(off), words, curves)


def _hats_kept(patch):
    right = refined_contact.cells_compliance
    patch.setattr(refined_contact, "cells_compliance", lambda *a: 0 * right(*a))
    patch.setattr(
        table, "near_compliance", right
    )  # the indenter's own cells keep theirs; no pad here


CHECKS = (
    Check(
        "refinement",
        "Force of small contacts hardly depends on the mesh",
        "the same presses on a finer surface",
        0.03,
        refinement,
        Fault("near field of the mesh's own hat functions counted besides the cells'", _hats_kept),
        "values",
        ("depth, mm", "force, N"),
    ),
    Check(
        "flat_punch",
        "A flat punch on a large block",
        "F = 2 a E* δ on a half-space",
        0.01,
        flat_punch,
        Fault("near field of the mesh's own hat functions counted besides the cells'", _hats_kept),
        "values",
        ("half width of the block, mm", "force at 0.2 mm, N"),
        logarithmic_x=True,
    ),
)
