"""What `instobj new` says of what comes next: memory, numbers of parts that help, time."""

import re

import numpy as np
import pytest

from design.placement.objects import COARSE, SHELL_VARIANTS, Request, first_fit, spec_of
from instobj.commands.outlook import next_step_text, parts_that_help, with_edges_that_fit
from instobj.report.weak_areas import far_share
from instobj.stages.resources import needed_gib


def placed(request):
    tables = first_fit(request, SHELL_VARIANTS[:1], COARSE)
    assert tables is not None
    return tables


@pytest.fixture(scope="module")
def big():
    request = Request("box", (150.0, 120.0, 90.0), sensors=1, magnets=1)
    return request, placed(request)


def test_edges_of_the_mesh_follow_the_size_so_that_memory_is_enough(big):
    """Both edges alike, as little as needed; a body that fits keeps the usual ones."""
    request, tables = big
    assert needed_gib("response", spec_of(tables)) > 30
    spec = spec_of(with_edges_that_fit(request, tables))
    usual = spec_of(tables).mesh
    ratios = [spec.mesh.edge_mm / usual.edge_mm, spec.mesh.surface_edge_mm / usual.surface_edge_mm]
    np.testing.assert_allclose(ratios[0], ratios[1], rtol=5e-3)
    assert 9 < needed_gib("response", spec) <= 12
    assert "instead of 1.7 mm, so that the mechanics fit into 12 GiB" in next_step_text(spec)
    assert with_edges_that_fit(request, tables, most_gib=1e3) is tables


def test_more_parts_are_named_that_leave_fewer_locations_too_far():
    """What is named is asked for, and keeps what was said of it."""
    request = Request("box", (70.0, 50.0, 35.0), sensors=2)
    tables = placed(request)
    told = parts_that_help(request, tables)
    asked = {key: int(count) for key, count in re.findall(r"--(sensors|magnets) (\d+)", told)}
    said = int(re.search(r"about (\d+) % of", told)[1])
    more = placed(Request("box", request.size_mm, **{"sensors": 2} | asked))
    after = far_share(spec_of(more))
    assert round(100 * after) == said
    assert after < 0.75 * far_share(spec_of(tables))


def test_no_number_of_parts_is_promised_where_none_helps(big):
    assert parts_that_help(*big).startswith("no number of parts tried here")
