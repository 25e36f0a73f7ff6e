"""A cube with two tilted magnets per face, off the symmetry planes, on a mesh of few elements."""

from functools import cache

from design.spec.object import ObjectSpec
from tests.support.mechanics.fem_cases import YOUNGS_MODULUS_MPA
from tests.support.shared import shared_mesh


def small_spec(interface="bonded", **slip):
    return ObjectSpec.model_validate(
        {
            "name": "small",
            "silicone": {"youngs_modulus_mpa": YOUNGS_MODULUS_MPA},
            "magnets": {"positions_mm": [[2.0, -1.0], [-9.0, 7.0]], "tilt_deg": [[8, -5], [0, 12]]},
            "mesh": {
                "surface_edge_mm": 3.5,
                "edge_mm": 8.0,
                "rim_edge_ratio": 1.0,
                "envelope_mm": 0.03,
            },
            "mechanics": {"interface": interface, "slip": slip},
            "press": {"depths_mm": [1.0, 2.0]},
        }
    )


@cache
def small_mesh():
    """Of any such specification: the mesh depends on none of the arguments."""
    return shared_mesh(small_spec())
