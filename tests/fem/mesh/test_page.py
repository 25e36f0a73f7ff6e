"""Surfaces and wanted edge lengths of objects off their symmetries: a page that a person can judge."""

from fem.mesh.edge_lengths import edge_length_field
from fem.mesh.surfaces import all_surfaces
from tests.support.objects.worked_objects import worked
from tests.support.physics_pages import assert_page


def of_mesh(name):
    spec = worked(name)
    surface = all_surfaces(spec)
    yield f"{name}: silicone and bodies in it (mm³, mm²)", [surface.volume, surface.area]
    lengths = edge_length_field(spec)
    yield f"{name}: wanted edges (mm)", lengths.length_mm
    yield f"{name}: where (mm)", lengths.points_mm


def test_the_page_of_meshes():
    names = ("box", "reverse box", "pad", "cylinder", "hollow dome")
    assert_page("fem/mesh", [line for name in names for line in of_mesh(name)])
