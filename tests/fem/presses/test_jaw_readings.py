"""Jaws read from frames: force, centre of pressure and tilt of both, and which kind of contact it was.

Frames come from presses of tilted indenters, solved jointly: no table, pattern or sum of motions is in them.
"""

import numpy as np
import pytest

from design.spec.object import ContactGridSpec, IndenterSpec, MeshSpec
from estimator.information.jaws import signals_of_motions
from estimator.inversion.inversion import inversion
from estimator.inversion.jaws import JawReader, jaw_table
from estimator.signals.presses import press_signals
from fem.linear.response import build_response
from fem.mesh.tetrahedra import tetrahedralize
from fem.presses.jaws import jaw_faces
from fem.presses.joint import Tip, press_tips
from fem.presses.table import simulate_lattice

GROUPS = [(3,), (5,), (3, 5)]
POSES = (((0.0, 0.0), 0.8), ((0.5, 0.0), 1.1), ((0.0, -1.0), 1.3), ((0.7, 0.7), 1.5))
"""Tilts (degrees) and depth (mm) of what touches first: 50 N and more, of which noise hides 2 %."""


@pytest.fixture(scope="module")
def spec(rigid_spec):
    return rigid_spec.changed(contact_grid=ContactGridSpec(count=(3, 3), pitch_mm=10.0))


@pytest.fixture(scope="module")
def reader(spec, rigid_response):
    forces, motions = simulate_lattice(spec, rigid_response)
    model = inversion(spec, forces, motions, press_signals(spec, forces, motions), 0.03, 0.0)
    tables = tuple(jaw_table(jaw) for jaw in jaw_faces(spec, rigid_response, [3, 5]))
    return JawReader(model, tables, 400.0)


def frame_of(spec, response, tips, depth_mm, **indenter):
    """Noisy counts, and the press."""
    press = press_tips(
        spec.changed(indenter=IndenterSpec(**indenter)),
        response,
        tips,
        np.full(len(tips), depth_mm),
    )
    counts = signals_of_motions(spec, press.motion[None]).delta_counts[0, 0].ravel()
    noise = np.tile(np.asarray(spec.sensors.noise_counts), len(counts) // 3)
    return counts + noise * np.random.default_rng(3).normal(size=len(counts)), press


def judged(spec, reader, response):
    """Errors of force (relative), centre (mm) and tilt (degrees), the largest of all jaws."""
    worst = np.zeros(3)
    for tilt, depth in POSES:
        tips = [Tip(3, 0.0, 0.0), Tip(5, 0.0, 0.0)]
        jaw = {"kind": "cuboid", "size_mm": (63.0, 63.0), "tilt_deg": tilt}
        counts, press = frame_of(spec, response, tips, depth, **jaw)
        (found,) = reader.read(counts[None], GROUPS)
        assert found.kind == "jaws"
        assert found.faces == (3, 5)
        assert found.p_value > 1e-3
        off = (
            abs(found.force_n / press.force_n - 1).max(),
            np.linalg.norm(found.centre_mm - press.centre_mm, axis=1).max(),
            abs(found.tilt_deg - tilt).max(),
        )
        worst = np.maximum(worst, off)
    return worst


def test_two_jaws_are_read_and_are_no_tips(spec, reader, rigid_response):
    assert (judged(spec, reader, rigid_response) < [0.05, 1.0, 2.0]).all()


def test_tips_are_no_jaws(spec, reader, rigid_response):
    for tips in ([Tip(3, 5.0, -4.0)], [Tip(3, 5.0, -4.0), Tip(5, -6.0, 3.0)]):
        counts, _ = frame_of(spec, rigid_response, tips, 1.0)
        assert reader.read(counts[None], GROUPS)[0].kind == "tips"


@pytest.mark.slow
def test_jaws_on_another_mesh_are_read(spec, reader):
    """Force within 5 %, centre of pressure within 1 mm, tilt within 2°."""
    other = spec.changed(mesh=MeshSpec(surface_edge_mm=1.8, edge_mm=4.4))
    response = build_response(tetrahedralize(other), other)
    assert (judged(spec, reader, response) < [0.05, 1.0, 2.0]).all()
