"""Layers of different stiffness: shares of elements that they cut, energy of a layered column."""

import numpy as np
import pytest
from numpy.testing import assert_allclose
from pydantic import ValidationError

from design.spec.object import ObjectSpec
from fem.linear.elements import assemble, element_space
from fem.linear.layers import layer_stiffness
from fem.linear.material import lame_constants
from tests.support.mechanics.fem_cases import box_mesh

LAYERS = ((2.0, 5.0), (1.5, 0.2))


def pad(**changes):
    content = {
        "name": "pad",
        "body": {"kind": "pad", "size_mm": [20.0, 20.0, 12.0]},
        "shell": {"thickness_mm": 8.0},
        "silicone": {"poisson_ratio": 0.2, "layers": LAYERS},
        "mechanics": {"element": "p2"},
    }
    return ObjectSpec.model_validate(content | changes)


def test_an_element_has_the_mean_of_its_layers_by_volume():
    """Tetrahedra that fill a block from z −2 to 6: 4.5 mm of the body, 1.5 and 2 mm of the layers."""
    mesh = box_mesh((3, 3, 3), (6.0, 6.0, 8.0))
    corners = (mesh.p.T - [3.0, 3.0, 2.0])[mesh.t.T]
    ratio = layer_stiffness(corners, pad())
    volume = abs(np.linalg.det(corners[:, 1:] - corners[:, :1])) / 6
    assert_allclose(volume @ ratio / volume.sum(), (4.5 + 1.5 * 0.2 + 2 * 5) / 8, rtol=0.02)
    assert ratio.min() < 0.6 < 4.5 < ratio.max()
    assert layer_stiffness(corners, pad(silicone={"poisson_ratio": 0.2})) is None


@pytest.mark.parametrize(("element", "nu"), [("p2", -0.2), ("p2", 0.3), ("p2-p0", 0.3)])
def test_a_layered_column_costs_the_energy_of_each_layer(element, nu):
    """Squeezed without widening, each layer by its own strain: E (1 − ν)/((1 + ν)(1 − 2ν)) ε² each."""
    mesh, strains, ratios = box_mesh((2, 2, 4), (1.0, 1.4, 2.0)), [0.1, -0.3], [1.0, 7.0]
    space = element_space(mesh, element)
    upper = mesh.p[2, mesh.t].mean(axis=0) > 1
    z = space.nodes_mm[:, 2]
    u = np.zeros((3, len(z)))
    u[2] = strains[0] * np.minimum(z, 1) + strains[1] * np.maximum(z - 1, 0)
    stored = assemble(space, lame_constants(0.3, nu), np.where(upper, ratios[1], ratios[0]))
    confined = 0.3 * (1 - nu) / ((1 + nu) * (1 - 2 * nu))
    exact = 1.4 * confined * sum(r * e**2 for r, e in zip(ratios, strains, strict=True))
    assert_allclose(u.ravel() @ stored.stiffness @ u.ravel(), exact, rtol=1e-12)


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ({"mechanics": {}}, 'Use "p2-p0", or "p2"'),
        ({"shell": {"thickness_mm": 3.5}}, r"3\.5 mm thick together"),
    ],
)
def test_layers_that_cannot_be_are_refused(wrong, message):
    with pytest.raises(ValidationError, match=message):
        pad(**wrong)


def test_a_continuous_pressure_is_refused_between_layers():
    space = element_space(box_mesh((1, 1, 1)), "taylor-hood")
    with pytest.raises(ValueError, match="Take P2/P0 or P2"):
        assemble(space, lame_constants(0.3, 0.3), np.ones(space.mesh.nelements))
