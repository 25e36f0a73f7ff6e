"""Cells of tips, and pressures between unlike patches: a page that a person can judge."""

import numpy as np

from design.layout.pockets import Outline
from design.spec.object import IndenterSpec
from fem.candidates.cubic_convolution import axis_weights, extension
from fem.candidates.quadrature import outline_quadrature, skin_quadrature
from fem.contact.complementarity import complementary_pressures, contact_pressures
from fem.contact.half_space import HAT_OWN, Patches, joined, normal_compliance, traction_compliance
from fem.contact.indenter import tip_cells
from tests.support.physics_pages import assert_page

TIPS = {
    "hemisphere": {"radius_mm": 4.0},
    "flat punch": {"kind": "flat", "radius_mm": 3.0, "fillet_mm": 0.4},
    "leaning cuboid": {"kind": "cuboid", "size_mm": (5.0, 3.0), "turn_deg": (0.0, 3.0, -5.0)},
}


def patches(count, seed):
    rng = np.random.default_rng(seed)
    area = rng.uniform(0.2, 0.6, count)
    return Patches(area, rng.uniform(-4, 4, (count, 2)), area / 12, HAT_OWN)


def of_tips():
    for name, tip in TIPS.items():
        cells = tip_cells(IndenterSpec(**tip))
        yield f"{name}: areas of cells (mm²)", cells.patches.area_mm2
        yield f"{name}: places (mm)", cells.patches.centre_mm
        yield f"{name}: heights (mm)", cells.height_mm


def of_contact():
    """A bowl that is off the middle of scattered patches; one that cannot pull."""
    some = joined([patches(5, 1), patches(3, 2)])
    yield "normal compliance (mm/kN)", 1e3 * normal_compliance(some, some, 0.5, 0.4)
    yield "of tractions (mm/kN)", 1e3 * traction_compliance(some, patches(4, 3), 0.5, 0.4)
    some = patches(24, 4)
    compliance = normal_compliance(some, some, 0.5, 0.4)
    height = np.sum((some.centre_mm - [0.6, -0.4]) ** 2, axis=1) / 8
    moments, gap = height * some.area_mm2, (height - 0.7) * some.area_mm2
    pressures = contact_pressures(compliance, moments, some.area_mm2, np.array([0.3, 0.9, 1.6]))
    yield "pressures at 0.3, 0.9, 1.6 mm (kPa)", 1e3 * pressures
    yield "patches that touch", np.sum(pressures > 0, axis=1)
    yield "that cannot pull (kPa)", 1e3 * complementary_pressures(compliance, gap, gap < -0.3)


def of_candidates():
    disk, block = Outline((3.0, 3.0), True), Outline((2.5, 1.5), False)
    yield "points over a disk (mm)", outline_quadrature(disk, 2, 6)[0]
    for name, outline in (("disk", disk), ("block", block)):
        points, weights = skin_quadrature(outline, 1.5, 2, 6)
        yield f"points on the skin of a {name} (mm)", points
        yield "their weights", weights
    nodes = np.array([-3.0, -1.0, 1.0, 3.0, 5.0])
    yield "weights of neighbours", axis_weights(nodes, np.array([-2.7, 0.1, 1.0, 4.9]))[1]
    known = np.ones((5, 6), bool)
    known[0, :2] = known[4, 5] = False
    yield "extension beyond known places", extension(known).toarray()


def test_the_page_of_contact():
    assert_page("fem/contact", [*of_tips(), *of_contact(), *of_candidates()])
