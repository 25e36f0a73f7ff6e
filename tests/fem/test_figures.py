"""Figures of the mechanics that were chosen or measured, in one table, and limits of a mesh's quality.

Nothing but their choice makes them right; each is told in its docstring or on a page.
"""

import pytest

import fem.candidates.motions
import fem.candidates.presses
import fem.candidates.rigid_body
import fem.candidates.tied_magnets
import fem.contact.complementarity
import fem.contact.half_space
import fem.contact.indenter
import fem.contact.lift_off
import fem.large_strain.linearity
import fem.large_strain.press
import fem.large_strain.single_press
import fem.linear.core_interface
import fem.linear.factorization
import fem.linear.material
import fem.mesh.edge_lengths
import fem.mesh.mesher
import fem.mesh.quality
import fem.mesh.support_line
import fem.mesh.surfaces
import fem.mesh.tetrahedra
import fem.presses.compliance_map
import fem.presses.discretisation
import fem.presses.sticking
import fem.presses.table
import fem.presses.to_force
import studies.loose_core.coulomb
import studies.loose_core.press

FIGURES = {
    fem.candidates.motions: {"_PITCH_MM": 2.0, "_DEPTH_STEP_MM": 1.0, "_MARGIN_MM": 1.5, "MM_PER_RAD": 4.0},
    fem.candidates.presses: {
        "FORCE_SHARES": (0.8, 1.2), "_LEAST_PRESSURE": 1e-7, "_LEAST_MODE": 3e-4,
    },
    fem.candidates.rigid_body: {
        "_CIRCLES": 2, "_AROUND": 8, "_OF_THE_COVER": 0.8, "_TOLD_APART": 1e-4,
    },
    fem.candidates.tied_magnets: {"DEGREE": 2, "INSET": 0.035, "MOST_INSET": 0.2},
    fem.contact.complementarity: {"_TOUCHES_BELOW": 0.6},
    fem.contact.half_space: {"SQUARE_OWN": 0.9505, "HAT_OWN": 0.9884},
    fem.contact.indenter: {"_CELLS": 150, "_LARGEST_CELL_MM": 1.2, "_FINE_BELOW_MM": 0.4},
    fem.contact.lift_off: {"HOLD": 1e-3},
    fem.large_strain.linearity: {
        "_THICKNESS_MM": 8.0, "_DEPTH_MM": (0.0, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0),
        "_FORCE_ERROR": (0.0, 0.025, 0.032, 0.042, 0.055, 0.075, 0.107, 0.137, 0.165),
        "_MOTION_ERROR": (0.0, 0.09, 0.113, 0.144, 0.205, 0.264, 0.312, 0.395, 0.485),
    },
    fem.large_strain.press: {"_LARGEST_STEP_MM": 0.5, "_SMALLEST_STEP_MM": 0.02},
    fem.large_strain.single_press: {"_MODULUS_TOLERANCE": 0.01},
    fem.linear.core_interface: {"WALLS": ((0, 1), (0, -1), (1, 1), (1, -1), (2, 1))},
    fem.linear.factorization: {"_LARGEST_RESIDUAL": 1e-6},
    fem.linear.material: {"LARGEST_POISSON_RATIO": 0.499999},
    studies.loose_core.coulomb: {"TOLERANCE": 1e-6, "_SITE_UNITS": 5.0},
    studies.loose_core.press: {"HOLD": 0.001},
    fem.mesh.edge_lengths: {
        "_STEP_MM": 2.0, "_STEP_AT_RIMS_MM": 1.0, "FINE_LAYER_MM": 0.5, "_RIM_GROWTH": 0.7,
    },
    fem.mesh.mesher: {"SECONDS": (300.0, 3600.0)},
    fem.mesh.quality: {
        "MIN_DIHEDRAL_DEG": 4.0, "MAX_VOLUME_ERROR": 2e-3, "MAX_MAGNET_VOLUME_ERROR": 0.03,
    },
    fem.mesh.support_line: {"LONGEST_EDGE": 4 / 3},
    fem.mesh.surfaces: {"ON_SURFACE_MM": 0.1},
    fem.mesh.tetrahedra: {
        "_NEAR_EDGE": 0.75, "_CONTACT_RADII": 0.75, "_NEAR_RADII": 0.6, "_FAR_RADII": 2.5,
        "_COARSE_EDGE_MM": 6.0, "SILICONE": -1,
    },
    fem.presses.compliance_map: {"DEPTH_MM": 1.0},
    fem.presses.discretisation: {
        "COARSENING": 1.5, "ORDER": 2.0, "_ROTATION_ARM_MM": 3.0, "_PLACES_PER_AXIS": 5,
        "_PATCH_RADIUS_MM": 5.0,
    },
    fem.presses.sticking: {"_LARGEST_STEP_MM": 0.1, "_LARGEST_SHARE": 0.8},
    fem.presses.table: {"_BORDER_MM": 0.001},
    fem.presses.to_force: {"_FORCE_TOLERANCE": 1e-6},
}  # fmt: skip


@pytest.mark.parametrize("module", FIGURES, ids=lambda module: module.__name__)
def test_figures_are_those_that_were_chosen(module):
    for name, value in FIGURES[module].items():
        assert getattr(module, name) == value, name
