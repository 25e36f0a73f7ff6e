"""Random layouts of the paper's cube in one batch, and the specification that each is."""

import numpy as np
import torch

from design.search.places import polarities
from design.search.space import params_at, search_space
from design.search.structure import with_structure
from design.spec_io import parse_spec
from estimator.layouts.vectors import layout_space

VARY = {
    "magnet_reach_mm": 15.0,
    "magnet_depth_mm": [1.6, 6.0],
    "magnet_tilt_deg": 25.0,
    "magnet_north": True,
    "sensor_reach_mm": 10.5,
}
COUNT = 40


def batch(seed=0, count=COUNT, wall_mm=0.8):
    """Random layouts of one structure: specification, space, tensors, variables, polarities, units."""
    search = {"vary": VARY}
    printer = {"wall_mm": wall_mm}
    spec = parse_spec({"name": "cube", "printer": printer, "search": search}, "made up")
    space = search_space(spec)
    units = np.random.default_rng(seed).random((count, len(space.variables)))
    params = [params_at(space, unit) for unit in units]
    structured = with_structure(spec, params[0])
    tensors = layout_space(space, structured, torch.float64)
    flags = [not v.choices for v in space.variables]
    poles = torch.tensor([polarities(structured, one) for one in params], dtype=torch.float64)
    return spec, tensors, params, poles, torch.as_tensor(units[:, flags])
