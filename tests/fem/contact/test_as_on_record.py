"""Cells of tips, and pressures between unlike patches, on record.

Where this fails after a deliberate change see `tests/support/recorded_facts.py`.
"""

import numpy as np
import pytest

from design.layout.pockets import Outline
from design.spec.object import IndenterSpec
from fem.candidates.cubic_convolution import axis_weights, extension
from fem.candidates.quadrature import outline_quadrature, skin_quadrature
from fem.contact.complementarity import complementary_pressures, contact_pressures
from fem.contact.half_space import HAT_OWN, Patches, joined, normal_compliance, traction_compliance
from fem.contact.indenter import tip_cells
from tests.support.recorded_facts import assert_on_record, told, told_whole

TIPS = {
    "hemisphere": {"radius_mm": 4.0},
    "flat punch": {"kind": "flat", "radius_mm": 3.0, "fillet_mm": 0.4},
    "leaning cuboid": {"kind": "cuboid", "size_mm": (5.0, 3.0), "tilt_deg": (3.0, -5.0)},
}


def on_record(section, lines):
    assert_on_record("presses", section, lines, "fem")


def patches(count, seed):
    rng = np.random.default_rng(seed)
    area = rng.uniform(0.2, 0.6, count)
    return Patches(area, rng.uniform(-4, 4, (count, 2)), area / 12, HAT_OWN)


@pytest.mark.parametrize("name", TIPS)
def test_cells_of_a_tip_are_as_on_record(name):
    on_record(f"cells of a {name}", told_whole("cells", tip_cells(IndenterSpec(**TIPS[name]))))


def test_compliances_of_patches_are_as_on_record():
    some = joined([patches(5, 1), patches(3, 2)])
    lines = [
        told("normal", 1e3 * normal_compliance(some, some, 0.5, 0.4)),
        told("tractions", 1e3 * traction_compliance(some, patches(4, 3), 0.5, 0.4)),
    ]
    on_record("patches", lines)


def test_pressures_of_contact_are_as_on_record():
    """A bowl that is off the middle of scattered patches; one that cannot pull."""
    some = patches(24, 4)
    compliance = normal_compliance(some, some, 0.5, 0.4)
    height = np.sum((some.centre_mm - [0.6, -0.4]) ** 2, axis=1) / 8
    moments, gap = height * some.area_mm2, (height - 0.7) * some.area_mm2
    pressures = contact_pressures(compliance, moments, some.area_mm2, np.array([0.3, 0.9, 1.6]))
    lines = [
        told("pressures", 1e3 * pressures),
        told("touching", np.sum(pressures > 0, axis=1)),
        told("complementary", 1e3 * complementary_pressures(compliance, gap, gap < -0.3)),
    ]
    on_record("contact", lines)


def test_means_over_outlines_and_weights_of_candidates_are_as_on_record():
    disk, block = Outline((3.0, 3.0), True), Outline((2.5, 1.5), False)
    nodes = np.array([-3.0, -1.0, 1.0, 3.0, 5.0])
    index, weight = axis_weights(nodes, np.array([-2.7, 0.1, 1.0, 4.9]))
    known = np.ones((5, 6), bool)
    known[0, :2] = known[4, 5] = False
    lines = [
        *(told(f"means {k}", one) for k, one in enumerate(outline_quadrature(disk, 2, 6))),
        *(told(f"of a skin {k}", one) for k, one in enumerate(skin_quadrature(disk, 1.5, 2, 6))),
        *(told(f"of a block {k}", one) for k, one in enumerate(skin_quadrature(block, 1.5, 2, 6))),
        told("neighbours", index),
        told("weights", weight),
        told("extension", extension(known).toarray()),
    ]
    on_record("means", lines)
