"""What the mesher is asked for, of objects off their symmetries, on record.

Surfaces and edge lengths by their means; where this fails after a deliberate change see
`tests/support/recorded_facts.py`.
"""

import pytest

from fem.mesh import tetrahedra
from fem.mesh.tetrahedra import magnet_free_mesh, tetrahedralize, tetrahedralize_for_press
from tests.support.objects.worked_objects import worked
from tests.support.recorded_facts import assert_on_record, told


class AskedError(Exception):
    """In place of meshing."""


def asked(monkeypatch, mesh):
    """Lines: what a function asks the mesher for."""

    def refuses(content):
        raise AskedError(content)

    monkeypatch.setattr(tetrahedra, "run_mesher", refuses)
    with pytest.raises(AskedError) as caught:
        mesh()
    content = caught.value.args[0]
    return [told(name, content[name]) for name in sorted(content)]


def even(spec):
    """The object, with edges at rims no finer than elsewhere: on a coarser grid."""
    return spec.changed(mesh=spec.mesh.changed(rim_edge_ratio=1.0))


@pytest.mark.parametrize("name", ["box", "reverse box", "pad", "cylinder", "hollow dome"])
def test_the_mesher_is_asked_as_on_record(monkeypatch, name):
    spec = worked(name)
    lines = asked(monkeypatch, lambda: tetrahedralize(even(spec)))
    assert_on_record("meshes", f"{name}, no finer at rims", lines, "fem")


@pytest.mark.parametrize("name", ["reverse box", "pad"])
def test_edges_at_rims_are_asked_as_on_record(monkeypatch, name):
    spec = worked(name)
    assert_on_record("meshes", name, asked(monkeypatch, lambda: tetrahedralize(spec)), "fem")


def test_a_mesh_without_magnets_is_asked_as_on_record(monkeypatch):
    lines = asked(monkeypatch, lambda: magnet_free_mesh(worked("pad")))
    assert_on_record("meshes", "pad without magnets", lines, "fem")


def test_a_mesh_for_a_press_is_asked_as_on_record(monkeypatch):
    spec = even(worked("box"))
    lines = asked(monkeypatch, lambda: tetrahedralize_for_press(spec, 3, 2.5, -4.0))
    assert_on_record("meshes", "box for a press", lines, "fem")
